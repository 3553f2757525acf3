"""The closed list of what programs of strangers may call."""
