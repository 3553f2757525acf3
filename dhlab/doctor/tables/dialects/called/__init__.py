"""Links that are calls: of a toolbox's class, or of the text's own link function."""
