"""Failed seams cut anew: where, with which pixels, and what the new cuts keep."""
