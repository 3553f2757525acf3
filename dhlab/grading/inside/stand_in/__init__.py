"""What stands in, inside the cage, for the parts of dhlab that know answers or draw pictures."""
