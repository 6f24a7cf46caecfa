"""The web service: a JSON API under /api, the live channel, the 3D viewer's rooms and the page."""
