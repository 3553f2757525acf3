"""Every small change of a program's text that may be what its writer meant."""
