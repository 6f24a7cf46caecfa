"""The catalogue of materials."""
