"""What is wrong with a learner's program, found by calling it."""
