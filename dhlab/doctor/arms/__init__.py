"""What is wrong with an arm's table, found from measured poses or from the motion of one joint at a
time.
"""
