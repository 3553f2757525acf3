"""The search for the slips that turn the right program into the one at hand."""
