"""Hypothesis on a shared machine: the same examples every time, and no verdict from the clock."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "studio", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("studio")
