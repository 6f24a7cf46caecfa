"""The service itself: health."""
