"""Answers: the instant rungs at once, finite elements as jobs."""
