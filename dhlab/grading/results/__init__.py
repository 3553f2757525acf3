"""What became of a submission and of a class: marks, the gradebook, feedback, the report."""
