"""How nets and structures look in the 3D view."""
