"""The course for other graders, and the grades for other gradebooks."""
