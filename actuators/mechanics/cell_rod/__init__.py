"""Periodic cell and rod: the inflated chamber's own law, carried by a geometrically exact rod."""
