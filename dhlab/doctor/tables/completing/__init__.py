"""What the rest of a text adds to the rows that were read, and what they must account for."""
