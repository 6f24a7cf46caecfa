"""The outer walls that face each other across the gap between this chamber and the next.

Only half a pitch is meshed. Of the next chamber's left side the meshed half is carried on by a
pitch, g; the other half is the image of this chamber's right side under half a turn about the axis
midway between the two, g h; and this chamber's own right side goes on, beyond the middle plane, as
its left side turned by h. Half a turn about that axis exchanges the two sides of the gap, so that
forces on the meshed half of this side and on the carried half of the next are all there are.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.domain import Domain, Image, carried
from actuators.mechanics.continuum.contact.points import WALL_POINTS, contact_areas
from actuators.mechanics.continuum.contact.search import frames
from actuators.mechanics.continuum.contact.surface import ContactSurface

SIDEWAYS = 0.1
"""Least component along X1 of the normal of a wall that can meet the next chamber's."""

_CARRIED = {
    Image.ITSELF: Image.CARRIED,
    Image.TURNED: Image.TURNED_AND_CARRIED,
    Image.MIDWAY_BEFORE: Image.MIDWAY,
}
_TURNED = {
    Image.ITSELF: Image.TURNED,
    Image.TURNED: Image.ITSELF,
    Image.MIDWAY_BEFORE: Image.MIDWAY,
}
_TURNED_AND_CARRIED = {
    Image.ITSELF: Image.TURNED_AND_CARRIED,
    Image.TURNED_AND_CARRIED: Image.ITSELF,
    Image.CARRIED: Image.TURNED,  # g h g = h: half a turn runs the screw backwards
    Image.MIDWAY: Image.MIDWAY,
}


@dataclass(frozen=True, eq=False)
class Walls:
    """Both sides of one gap. ``site``, ``image``: (m,) of their nodes, as :class:`.domain.Domain`
    has them; ``surface``: faces and undeformed places of these nodes. The faces' areas are 0 on
    the sides' other halves, which only hold what is pressed against them."""

    site: np.ndarray
    image: np.ndarray
    surface: ContactSurface


def gap_walls(domain: Domain) -> Walls | None:
    """None where no walls face each other."""
    mesh = domain.mesh
    faces = mesh.outer_faces.nodes.astype(np.int64)
    along = frames(mesh.nodes, faces)[1][:, 0]
    right, left = faces[along > SIDEWAYS], faces[along < -SIDEWAYS]
    if len(right) == 0 or len(left) == 0:
        return None
    identity = {image: image for image in Image}
    sides = [(right, identity), (left, _CARRIED), (right, _TURNED_AND_CARRIED), (left, _TURNED)]
    site = np.concatenate([domain.site[nodes] for nodes, _ in sides]).astype(np.int64)
    image = np.concatenate([_through(domain.image[nodes], table) for nodes, table in sides])
    keys, number = np.unique(image * len(domain.place) + site, return_inverse=True)
    image, site = np.divmod(keys, len(domain.place))
    rest = carried(domain.place, site, image, domain.motions(np.zeros(4)))
    own = np.ascontiguousarray(number.reshape(-1, 9), dtype=np.int64)
    areas = contact_areas(rest, own, WALL_POINTS)
    areas[len(right) + len(left) :] = 0.0
    return Walls(site.astype(np.int32), image, ContactSurface(rest, own, areas, WALL_POINTS))


def _through(image: np.ndarray, table: dict[Image, Image]) -> np.ndarray:
    """Images of nodes after one motion more."""
    out = np.empty_like(image)
    for kind in np.unique(image):
        out[image == kind] = table[Image(kind)]
    return out
