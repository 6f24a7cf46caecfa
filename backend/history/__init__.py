"""Versions of designs: what changed, what they answered, two side by side."""
