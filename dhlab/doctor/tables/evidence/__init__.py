"""What a text says beside its rows: of their order, their matrix, their convention and units."""
