"""What presses on the outside of the body: rigid obstacles, and the body itself."""

from actuators.mechanics.continuum.contact.interaction import Interaction, Tangent

__all__ = ["Interaction", "Tangent"]
