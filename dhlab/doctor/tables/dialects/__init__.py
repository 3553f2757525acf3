"""One module for each way in which people write an arm down; each gives a Pasted table, or arms."""
