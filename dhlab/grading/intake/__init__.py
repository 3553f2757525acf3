"""What came back: whose file it is, from when, and of which lesson."""
