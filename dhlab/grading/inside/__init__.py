"""What runs inside the cage. Nothing here, and nothing these modules import, knows a right
answer.
"""
