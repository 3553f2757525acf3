"""Arms that are told as chains of constant moves and joints, or by a controller."""
