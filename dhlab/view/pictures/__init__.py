"""The pictures, a module each."""
