"""Strips along parameter lines and developable patches, unrolled: pure geometry."""
