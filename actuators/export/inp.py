"""The finite-element model as an Abaqus input deck that CalculiX runs too.

Two steps, as the solver takes them: all loads but inflation first, then the cavity's pressure on
top. Node n of a mesh is node n + 1 of its deck; the nodes that a 20- or 8-node element does not
have are left out.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from actuators.design.base import Design
from actuators.errors import QuestionError
from actuators.export.inp_contact import (
    WallPair,
    deck_law,
    interaction_cards,
    wall_cards,
    wall_pairs,
)
from actuators.export.inp_inflation import Inflation, inflation_of
from actuators.export.inp_lines import ELEMENTS, MM, MPA, SIDES, node_rows, rows
from actuators.export.inp_material import material_card
from actuators.export.inp_obstacle import (
    RigidSolid,
    force_requests,
    force_set,
    obstacle_cards,
    rigid_solids,
)
from actuators.export.inp_sheet import sheet_cards
from actuators.materials import Material
from actuators.mechanics.continuum.contact import ContactLaw
from actuators.mechanics.continuum.contact.build import obstacles
from actuators.mechanics.scene import Scene
from actuators.meshing import Faces, HexMesh


def deck(
    mesh: HexMesh,
    materials: Sequence[Material],
    scene: Scene,
    *,
    element: str = "C3D20R",
    heading: Sequence[str] = (),
    inflation: Inflation | None = None,
    law: ContactLaw | None = None,
) -> str:
    """The deck's text. ``inflation``: pressures over the last step, where the scene prescribes a
    volume; ``law``: how hard surfaces are, None as our solver takes them. Raises
    :class:`QuestionError` for what a deck cannot carry."""
    _refuse_element(element)
    inflation = inflation or inflation_of(scene)
    law = law or deck_law(mesh, materials, scene)
    obstacles(mesh, law, scene)  # refuses what stands in the body
    solids = rigid_solids(mesh, scene)
    chosen = mesh.elements[:, ELEMENTS[element]]
    kept = np.unique(chosen)
    names = [_name(region.name) for region in mesh.regions]
    walls = () if scene.self_contact == "off" else wall_pairs(mesh)
    lines = [*_heading(heading, mesh, element, inflation, walls, solids), "*NODE, NSET=NALL"]
    lines += node_rows(kept + 1, mesh.nodes[kept])
    for number, name in enumerate(names):
        lines.append(f"*ELEMENT, TYPE={element}, ELSET={name}")
        for m in np.flatnonzero(mesh.region == number):
            lines += rows([m + 1, *(chosen[m] + 1)], 16)
    lines += ["*ELSET, ELSET=EALL", *rows(names, 1)]
    for name, nodes in _node_sets(mesh).items():
        present = np.intersect1d(nodes, kept) + 1
        if len(present):
            lines += [f"*NSET, NSET={name}", *rows(present, 16)]
    cavity = _face_sets("CAVITY", mesh.cavity_faces, mesh)
    loaded = dict(cavity)
    if scene.outside_pressure:
        loaded |= _face_sets("UNDERSIDE", _underside(mesh), mesh)
    for name, (_, elements) in loaded.items():
        lines += [f"*ELSET, ELSET={name}", *rows(elements + 1, 16)]
    for name, region, material in zip(names, mesh.regions, materials, strict=True):
        card = f"M-{name}"[:80]
        lines += [f"** region: {region.name}", *material_card(material, card)]
        lines.append(f"*SOLID SECTION, ELSET={name}, MATERIAL={card}")
    held = sum(len(solid.elements) for solid in solids)
    lines += sheet_cards(mesh, element, len(mesh.elements) + held + 1)
    if walls or solids:
        lines += [*interaction_cards(law), *wall_cards(walls)]
    lines += obstacle_cards(mesh, solids, len(mesh.nodes) + 1, len(mesh.elements) + 1)
    lines += ["*BOUNDARY", "CLAMP, 1, 3"]
    if mesh.is_half:
        lines.append("SYMMETRY, 2, 2")
    lines += inflation.amplitude
    before = _loads_before(mesh, scene, loaded, element)
    if before:
        lines += ["** step 1: what acts before inflation", *_step(before, solids)]
    lines += ["** inflation: the pressure turns and stretches with the walls"]
    pressures = _pressures("CAVITY", cavity, inflation.pressure * MPA)
    lines += _step([inflation.load, *pressures], solids)
    return "\n".join(lines) + "\n"


_OWN_DIFFERENCE = {
    "C3D20R": (
        "** Our own answers come from another element. On equal meshes the tip of this one moved",
        "** up to 9 % differently on coarsest meshes and up to 2 % on finer ones, in CalculiX on",
        "** bodies without contact (docs/performance.md): compare on medium or finer.",
    )
}
"""What a deck says of its element beside ours: the largest of ``benchmarks.peers``."""


def _refuse_element(element: str) -> None:
    if element not in ELEMENTS:
        raise QuestionError(
            f"element is {element!r}; a deck has {', '.join(ELEMENTS)}.",
            field="element", value=element, mend=f"Use one of {', '.join(ELEMENTS)}.",
        )  # fmt: skip


def _heading(
    lines: Sequence[str],
    mesh: HexMesh,
    element: str,
    inflation: Inflation,
    walls: Sequence[WallPair],
    solids: Sequence[RigidSolid],
) -> list[str]:
    return [
        "*HEADING", *(lines or ["Pneumatic actuator"]),
        "** Units: N, mm, MPa, tonne, s (density in tonne/mm3, acceleration in mm/s2).",
        "** X1 from the clamp along the body, X2 across, X3 up from the underside.",
        f"** {len(mesh.elements)} elements {element}"
        + ("; half model, X2 = 0 is a plane of symmetry." if mesh.is_half else "."),
        "** CalculiX: ccx NAME (without .inp). Abaqus: C3D20RH in place of C3D20R suits nearly",
        "** incompressible rubber better.",
        *_OWN_DIFFERENCE.get(element, ()),
        *_said_of_contact(mesh, walls, solids),
        *inflation.heading,
    ]  # fmt: skip


def _said_of_contact(
    mesh: HexMesh, walls: Sequence[WallPair], solids: Sequence[RigidSolid]
) -> list[str]:
    lines = ["** No contact of the body with itself: surfaces that meet pass through each other."]
    if walls:
        lines = [
            f"** Contact without friction: {len(walls)} pairs of walls that face each other across "
            "a gap;",
            "** left out are other surfaces of the body that meet (a curled underside, walls of",
            "** the cavity): they pass through each other.",
        ]
    for solid in solids:
        half = ", of half the body" if mesh.is_half else ""
        lines += [
            f"** Rigid {solid.name.lower()} without friction, every node held: it ends where the "
            "body cannot reach.",
            f"** The force on it is the sum of the reactions RF of the node set {force_set(solid)}"
            f"{half}.",
        ]
    return lines


def _name(text: str) -> str:
    return "".join(c if c.isalnum() else "_" for c in text.upper())


def _node_sets(mesh: HexMesh) -> dict[str, np.ndarray]:
    return {
        "CLAMP": mesh.clamp_nodes,
        "SYMMETRY": mesh.symmetry_nodes,
        "FREE_END": mesh.tip_nodes,
        "TIP": mesh.underside_line[-1:],
        "UNDERSIDE_LINE": mesh.underside_line,
    }


def _face_sets(prefix: str, faces: Faces, mesh: HexMesh) -> dict[str, tuple[int, np.ndarray]]:
    """Abaqus's side number and the elements of each set, by the set's name."""
    return {
        f"{prefix}_P{side}": (side, np.unique(faces.element[faces.local == local]))
        for local, side in enumerate(SIDES)
        if (faces.local == local).any()
    }


def _underside(mesh: HexMesh) -> Faces:
    faces = mesh.outer_faces
    down = (faces.local == 4) & (mesh.box[faces.element, 2] == 0)
    return Faces(faces.element[down], faces.local[down], faces.nodes[down])


def _pressures(
    prefix: str, sets: Mapping[str, tuple[int, np.ndarray]], pressure: float
) -> list[str]:
    return [
        f"{name}, P{side}, {pressure:.9g}"
        for name, (side, _) in sets.items()
        if name.startswith(prefix)
    ]


def _loads_before(
    mesh: HexMesh,
    scene: Scene,
    sets: Mapping[str, tuple[int, np.ndarray]],
    element: str,
) -> list[str]:
    distributed: list[str] = []
    size = float(np.linalg.norm(scene.gravity)) if scene.gravity is not None else 0.0
    if scene.gravity is not None and size > 0:
        x, y, z = (g / size for g in scene.gravity)
        distributed.append(f"EALL, GRAV, {size * MM:.9g}, {x:.9g}, {y:.9g}, {z:.9g}")
    if scene.outside_pressure:
        distributed += _pressures("UNDERSIDE", sets, scene.outside_pressure * MPA)
    lines = ["*DLOAD", *distributed] if distributed else []
    if scene.tip_force is not None:
        lines += ["*CLOAD", *_tip_loads(mesh, np.array(scene.tip_force), element)]
    return lines


def _tip_loads(mesh: HexMesh, force: np.ndarray, element: str) -> list[str]:
    """Nodal forces of a traction that is even over the free end."""
    faces = mesh.outer_faces
    at_end = (faces.local == 1) & (mesh.box[faces.element, 0] == len(mesh.lines[0]) - 2)
    nodes = faces.nodes[at_end]
    corner = mesh.nodes[nodes]
    area = np.linalg.norm(
        np.cross(corner[:, 8] - corner[:, 0], corner[:, 6] - corner[:, 2]), axis=-1
    )
    # integrals of the shape functions over a face, in our 3 x 3 order
    share = {8: (3, 0, 3, 0, 0, 0, 3, 0, 3), 20: (-1, 4, -1, 4, 0, 4, -1, 4, -1)}
    weights = np.array(share[len(ELEMENTS[element])]) / 12
    total = np.zeros(len(mesh.nodes))
    np.add.at(total, nodes, area[:, None] * weights)
    whole = force * (0.5 if mesh.is_half else 1.0) / total.sum()
    return [
        f"{n + 1}, {d + 1}, {total[n] * whole[d]:.9g}"
        for n in np.flatnonzero(total)
        for d in range(3)
        if whole[d] != 0.0
    ]


def _step(loads: Sequence[str], solids: Sequence[RigidSolid]) -> list[str]:
    return [
        "*STEP, NLGEOM, INC=2000",
        "*STATIC",
        "0.1, 1., 1e-6, 0.25",
        *loads,
        "*NODE FILE",
        "U",
        "*EL FILE",
        "S, E",
        *force_requests(solids),
        "*NODE PRINT, NSET=TIP",
        "U",
        "*END STEP",
    ]


def abaqus_deck(
    design: Design,
    mesh: HexMesh,
    materials: Sequence[Material],
    scene: Scene,
    element: str,
    inflation: Inflation | None = None,
) -> dict[str, bytes]:
    """``model.inp``."""
    heading = [f"{design.title}, design {design.digest[:12]}, scene {scene.digest[:12]}"]
    notes = [f"** Assumed: {text}" for text in design.assumptions()]
    text = deck(
        mesh, materials, scene, element=element, heading=[*heading, *notes], inflation=inflation
    )
    return {"model.inp": text.encode("ascii", "replace")}
