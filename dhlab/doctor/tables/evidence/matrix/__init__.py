"""The link matrix that a text writes out, multiplies together, or moves by: what it computes."""
