"""Hypothesis as in the science's own tests: the same examples every time, no verdict from the
clock."""

import tests.actuators.conftest  # noqa: F401  loads the profile
