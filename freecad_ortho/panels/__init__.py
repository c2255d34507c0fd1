"""Task panels: they ask for numbers and call the document functions."""
