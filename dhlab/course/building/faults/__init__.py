"""What keeps a lesson from being handed out: faults of its source, cells, exercises and runs."""
