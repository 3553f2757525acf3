"""Frames to be placed on bare joint axes."""
