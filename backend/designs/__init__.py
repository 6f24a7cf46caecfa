"""Designs: families, presets, checking a design, keeping it under a name."""
