"""What a program holds while it is interpreted, what it may use, and what is done with it."""
