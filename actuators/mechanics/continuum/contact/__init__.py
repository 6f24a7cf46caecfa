"""What presses on the outside of the body: rigid obstacles, and the body itself."""

from actuators.mechanics.continuum.contact.interaction import Interaction, Tangent, Touch
from actuators.mechanics.continuum.contact.obstacle import Obstacle
from actuators.mechanics.continuum.contact.self_contact import SelfContact
from actuators.mechanics.continuum.contact.surface import ContactLaw, contact_law, outside

__all__ = [
    "ContactLaw",
    "Interaction",
    "Obstacle",
    "SelfContact",
    "Tangent",
    "Touch",
    "contact_law",
    "outside",
]
