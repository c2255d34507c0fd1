"""Document objects: nets and structures. All their state lives in properties."""
