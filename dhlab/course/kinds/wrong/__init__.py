"""What is said of wrong answers: slips that any answer may have, their words, and a picture."""
