"""What the columns and rows of a pasted table mean: order, units, and which joint each row has."""
