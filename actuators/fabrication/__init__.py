"""Moulds and other things to cut, as parts with outlines in mm."""
