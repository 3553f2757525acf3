"""The mistakes by theme: each function yields the changes of one mistake."""
