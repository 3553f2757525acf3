"""Programs of strangers, computed without being executed: what their products are made of."""
