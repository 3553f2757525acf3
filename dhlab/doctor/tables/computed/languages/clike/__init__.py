"""Programs in C, C++, C#, Java and JavaScript, said in Python's grammar."""
