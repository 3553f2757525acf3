"""Configurations found by damped least squares from many starts, equal ones merged, and those that
belong to one continuous family told as one.
"""
