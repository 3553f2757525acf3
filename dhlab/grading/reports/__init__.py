"""What is shown of a graded class: feedback, the class report, what each student wrote, and whose
code is alike.
"""
