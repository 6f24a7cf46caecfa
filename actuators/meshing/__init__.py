"""Bodies to structured meshes of 27-node hexahedra."""

from actuators.meshing.block_mesh import mesh_body
from actuators.meshing.hex_mesh import CENTRE, FACE_NODES, Faces, HexMesh
from actuators.meshing.prolongation import prolong_nodes, prolong_pressure
from actuators.meshing.subdivision import FIRST_LAYER, LAYER_RATIO, subdivide

__all__ = [
    "CENTRE", "FACE_NODES", "FIRST_LAYER", "LAYER_RATIO", "Faces", "HexMesh", "mesh_body",
    "prolong_nodes", "prolong_pressure", "subdivide",
]  # fmt: skip
