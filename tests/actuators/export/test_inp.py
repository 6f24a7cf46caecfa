"""Decks, run by CalculiX."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.export import ModelQuestion, write
from actuators.export.inp import deck
from actuators.export.inp_contact import wall_pairs
from actuators.export.inp_lines import ELEMENTS, middles
from actuators.export.inp_material import material_card
from actuators.export.inp_sheet import sheet_cards
from actuators.geometry import Membrane, build_body
from actuators.materials import CATALOGUE, Material, Ogden, material
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.solve import solve
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.scene import Cylinder, Scene
from actuators.meshing import HexMesh, mesh_body
from benchmarks.mini_pneu_net import GRAVITY, MATERIALS, mini_pneu_net
from tests.actuators.export.calculix import needs_ccx, run_ccx, sections

MOONEY = [key for key, m in CATALOGUE.items() if m.law.model == "mooney-rivlin"]


@needs_ccx
@pytest.mark.parametrize(
    "key",
    ["elastosil-m4601", "ecoflex-00-30", "ninjaflex-ogden-002", "ninjaflex-ogden-005", *MOONEY],
)
def test_calculix_reads_each_law_as_we_mean_it(key: str, tmp_path: Path) -> None:
    material, stretch = CATALOGUE[key], 1.6
    corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    text = [
        "*NODE, NSET=NALL", *(f"{n}, {x}, {y}, {z}" for n, (x, y, z) in enumerate(corners, 1)),
        "*ELEMENT, TYPE=C3D8, ELSET=E", "1, 1,2,3,4,5,6,7,8",
        *material_card(material, "M"), "*SOLID SECTION, ELSET=E, MATERIAL=M",
        "*NSET, NSET=X0", "1,4,5,8", "*NSET, NSET=X1", "2,3,6,7",
        "*NSET, NSET=Y0", "1,2,5,6", "*NSET, NSET=Z0", "1,2,3,4",
        "*BOUNDARY", "X0,1,1", "Y0,2,2", "Z0,3,3",
        "*STEP, NLGEOM, INC=500", "*STATIC", "0.05, 1., 1e-6, 0.1",
        "*BOUNDARY", f"X1,1,1,{stretch - 1}",
        "*NODE PRINT, NSET=X1, TOTALS=ONLY", "RF", "*END STEP",
    ]  # fmt: skip
    force = run_ccx(tmp_path, "\n".join(text) + "\n")[-1][0] * 1e6
    expected = float(material.law.nominal_uniaxial_stress(np.array(stretch)))
    # what is left is the bulk modulus: kappa/mu is 1000, and the closed form is incompressible
    assert force == pytest.approx(expected, rel=3e-3)


def own_tip(mesh: HexMesh, pressure: float) -> np.ndarray:
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    solver = open_solver(system.indptr, system.indices)
    path = PathFollower(system, solver).follow(pressure, None)
    return path.points[-1].state.displacement[mesh.underside_line[-1]]


def calculix_tip(mesh: HexMesh, pressure: float, element: str, folder: Path) -> np.ndarray:
    rows = run_ccx(folder, deck(mesh, MATERIALS, Scene(pressure), element=element))
    return np.array(rows[-1][1:4]) * 1e-3


@needs_ccx
def test_calculix_bends_the_mini_pneu_net_as_we_do(tmp_path: Path) -> None:
    """On 61 elements C3D20R is stiffer than our element (it has no pressure of its own)."""
    mesh = mesh_body(mini_pneu_net().half())
    ours, theirs = own_tip(mesh, 1e3), calculix_tip(mesh, 1e3, "C3D20R", tmp_path)
    difference = np.linalg.norm(theirs - ours) / np.linalg.norm(ours)
    assert difference < 0.10
    assert theirs[2] > ours[2], "the stiffer element bends less"


@needs_ccx
@pytest.mark.slow
def test_calculix_comes_nearer_on_finer_meshes(tmp_path: Path) -> None:
    differences: list[float] = []
    for layers in ((0, 0, 0), (1, 0, 0), (1, 0, 1)):
        mesh = mesh_body(mini_pneu_net().half(), layers=layers)
        ours, theirs = own_tip(mesh, 1e3), calculix_tip(mesh, 1e3, "C3D20R", tmp_path)
        differences.append(float(np.linalg.norm(theirs - ours) / np.linalg.norm(ours)))
    assert differences[0] > differences[1] > differences[2]
    assert differences[2] < 0.02


@needs_ccx
def test_calculix_bends_a_body_on_a_sheet_as_we_do(tmp_path: Path) -> None:
    """The sheet halves the bending; what is left is the element's difference."""
    stiffness = 1000 * MATERIALS[0].youngs_modulus * 0.5e-3
    body = replace(mini_pneu_net(), membranes=(Membrane("sheet", 0.0, stiffness),)).half()
    mesh = mesh_body(body)
    assert len(mesh.membrane_faces) > 0
    ours, theirs = own_tip(mesh, 1e3), calculix_tip(mesh, 1e3, "C3D20R", tmp_path)
    without = own_tip(mesh_body(mini_pneu_net().half()), 1e3)
    difference = np.linalg.norm(theirs - ours) / np.linalg.norm(ours)
    assert difference < 0.10
    assert np.linalg.norm(without - ours) > 2 * np.linalg.norm(theirs - ours)


@pytest.mark.parametrize("element", ELEMENTS)
def test_springs_of_a_sheet_hold_its_whole_stiffness(element: str) -> None:
    """Of springs k = K w / l on strips of length l and width w, the sum of k l^2 is K times the
    area."""
    stiffness = 3e4
    body = replace(mini_pneu_net(), membranes=(Membrane("sheet", 3.5e-3, stiffness),)).half()
    mesh = mesh_body(body)
    lines = sheet_cards(mesh, element, 1000)
    values = iter([float(lines[k + 2]) for k, line in enumerate(lines) if line[:7] == "*SPRING"])
    total, here = 0.0, 0.0
    squares: list[float] = []
    for line in [*lines, "*ELEMENT"]:
        if line.startswith("*SPRING"):
            here = next(values)
            total += here * sum(squares)
            squares = []
        elif line[:1].isdigit() and line.count(",") == 2:
            a, b = (mesh.nodes[int(n) - 1] for n in line.split(",")[1:])
            assert a[1] == b[1], "a spring lies along X1"
            squares.append(float(np.sum((b - a) ** 2)))
    # the mini pneu-net's sheet is 80 mm long and 10 mm wide in its half
    assert total == pytest.approx(stiffness * 1e-3 * 80e-3 * 10e-3, rel=1e-5)


@needs_ccx
@pytest.mark.slow
def test_calculix_stops_walls_that_meet_as_we_do(tmp_path: Path) -> None:
    """Two chambers on a sheet at 100 kPa: their walls push each other apart and bend the body
    more (27 %) than walls that pass through each other."""
    design = preset("printed-14").design.changed(chamber_count=2, length=20, gap=0.3)
    mesh = mesh_body(build_body(design).half())
    materials = [material(region.material) for region in mesh.regions]
    pairs = wall_pairs(mesh)
    assert len(pairs) == 3, "two chambers stand between two solid ends"
    rows = run_ccx(tmp_path, deck(mesh, materials, Scene(100e3)))
    theirs = np.array(rows[-1][1:4]) * 1e-3
    touching, passing = (
        np.array(solve(design, Scene(100e3, self_contact=how), mesh="coarse").path[-1]
                 .tip_displacement) for how in ("on", "off")
    )  # fmt: skip
    assert np.linalg.norm(theirs - touching) < 0.06 * np.linalg.norm(touching)
    assert np.linalg.norm(theirs - touching) < 0.3 * np.linalg.norm(passing - touching)


@pytest.mark.parametrize(("name", "gaps"), [("oblique-45", 4), ("bellows-9-1.6", 8),
                                            ("slab-rectangle-low", 0)])  # fmt: skip
def test_walls_are_paired_across_each_gap(name: str, gaps: int) -> None:
    design = preset(name).design
    mesh = mesh_body(build_body(design))
    pairs = wall_pairs(mesh)
    assert len(pairs) >= gaps if gaps else len(pairs) == 0
    for pair in pairs:
        back, _ = middles(mesh, pair.backward)
        front, normal = middles(mesh, pair.forward)
        assert (normal[:, 0] > 0).all()
        assert not np.intersect1d(pair.forward.nodes, pair.backward.nodes).size
        assert np.abs(back.mean(axis=0) - front.mean(axis=0))[0] < 5e-3


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize("name", ["slab-ellipse-low", "oblique-45", "bellows-9-1.6"])
def test_elements_are_right_handed_and_use_given_nodes_only(name: str, element: str) -> None:
    design = preset(name).design
    files = write(design, "inp", ModelQuestion(Scene(10e3), "coarse", element))
    text = files["model.inp"].decode()
    assert ("Our own answers come from another element" in text) is (element == "C3D20R")
    found = sections(text)
    nodes = {int(n): np.array([x, y, z], dtype=float) for n, x, y, z in
             (line.split(",") for line in found["*NODE, NSET=NALL"])}  # fmt: skip
    seen: set[int] = set()
    blocks = [rows for name, rows in found.items() if name.startswith(f"*ELEMENT, TYPE={element}")]
    assert len(blocks) > 1
    for rows in blocks:
        words = ",".join(rows).replace(" ", "")
        numbers = np.array([int(w) for w in words.split(",") if w])
        each = numbers.reshape(-1, 1 + len(ELEMENTS[element]))[:, 1:]
        seen |= set(each.ravel().tolist())
        a, b, c, d = (np.array([nodes[int(n)] for n in each[:, k]]) for k in (0, 1, 3, 4))
        assert (np.einsum("ni,ni->n", np.cross(b - a, c - a), d - a) > 0).all()
    assert seen == set(nodes)


def test_every_load_of_a_scene_is_in_the_deck() -> None:
    scene = Scene(
        20e3, gravity=(0.0, 0.0, -9.81), outside_pressure=500.0, tip_force=(0.0, 0.0, 0.1)
    )
    mesh = mesh_body(mini_pneu_net().half())
    for element in ELEMENTS:
        text = deck(mesh, MATERIALS, scene, element=element)
        assert text.count("*STEP") == 2
        first, second = text.split("*STEP")[1:]
        assert "EALL, GRAV, 9810, 0, 0, -1" in first
        assert "UNDERSIDE_P1, P1, 0.0005" in first
        loads = first.split("*CLOAD")[1].split("*")[0].split()
        assert sum(map(float, loads[2::3])) == pytest.approx(0.05), "half the force on half a body"
        assert "P4, 0.02" in second


def test_a_deck_says_its_units_and_what_was_assumed() -> None:
    design = preset("oblique-45").design
    assert design.assumptions()
    text = write(design, "inp", ModelQuestion(Scene(10e3), "coarse"))["model.inp"].decode()
    assert "Units: N, mm, MPa, tonne, s" in text
    assert design.digest[:12] in text
    for sentence in design.assumptions():
        assert sentence.encode("ascii", "replace").decode() in text


def test_classical_ogden_constants_are_abaqus_own() -> None:
    law = Ogden(((0.4e6, 1.3), (0.01e6, 5.0)), "classical")
    card = material_card(Material("m", "m", law, 1000.0, "test"), "M")
    assert "*HYPERELASTIC, OGDEN, N=2" in card
    numbers = [float(w) for w in card[3].split(",")]
    assert numbers[:4] == pytest.approx([0.4, 1.3, 0.01, 5.0])
    assert numbers[4] == pytest.approx(2 / (1000 * 0.41))


def test_what_a_deck_cannot_carry_is_refused() -> None:
    design = preset("oblique-45").design
    for question, field in (
        (ModelQuestion(Scene(volume_to=1e-5)), "volume_ml"),
        (ModelQuestion(Scene(10e3, cylinder=Cylinder(5e-3, (0.05, 0.0, 0.0)))), "cylinder"),
        (ModelQuestion(Scene(10e3), element="C3D4"), "element"),
        (ModelQuestion(Scene(10e3), mesh="huge"), "mesh"),
    ):
        with pytest.raises(QuestionError) as caught:
            write(design, "inp", question)
        assert caught.value.field == field
    with pytest.raises(QuestionError, match="made for one scene"):
        write(design, "inp")
