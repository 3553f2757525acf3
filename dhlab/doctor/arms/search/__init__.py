"""The search for the one or two changes that bring an arm's poses to the measured ones."""
