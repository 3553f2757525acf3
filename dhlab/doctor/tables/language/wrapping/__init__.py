"""What a text is wrapped in, taken off: a notebook, a page, a mail, a drawing, comments."""
