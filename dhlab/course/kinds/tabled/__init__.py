"""Tables to be written, copied, repaired or made from axes, and what is said of them."""
