"""Running a learner's function: within a time limit, with what goes wrong put into words."""
