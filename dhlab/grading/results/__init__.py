"""What a submission and a class are worth: marks, decisions, standing, the gradebook."""
