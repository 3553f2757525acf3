"""The Denavit-Hartenberg procedure: from joint axes to frames to an arm, every step in words."""
