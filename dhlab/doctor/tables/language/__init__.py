"""What the texts of all dialects share: letters, expressions, brackets and calls, assignments."""
