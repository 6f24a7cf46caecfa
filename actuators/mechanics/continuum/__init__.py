"""3D finite elements of the inflated body: nonlinear, nearly incompressible, with gravity."""

from actuators.mechanics.continuum.assembly import LinearSystem, linear_system
from actuators.mechanics.continuum.progress import Progress
from actuators.mechanics.continuum.solve import solve

__all__ = ["LinearSystem", "Progress", "linear_system", "solve"]
