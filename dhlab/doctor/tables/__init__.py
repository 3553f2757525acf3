"""Tables as text: pasted from anywhere, in other dialects, compared row by row."""
