"""The teacher's page: each answer beside its verdict, and what is decided about it."""
