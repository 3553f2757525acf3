"""From a lesson's source to its notebooks: reading it, finding its faults, holding it to the
contract, writing.
"""
