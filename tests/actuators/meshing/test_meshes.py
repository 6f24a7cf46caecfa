"""Meshes: volumes, counts, faces, nesting."""

import dataclasses

import numpy as np
import pytest

from actuators.design import PRESETS, preset
from actuators.geometry import Membrane, build_body, build_cell
from actuators.mechanics.continuum.kernel.cavity import cavity_volume
from actuators.mechanics.continuum.kernel.shape import CUBE_SLOPES, CUBE_WEIGHTS
from actuators.meshing import (
    CENTRE,
    HexMesh,
    mesh_body,
    prolong_nodes,
    prolong_pressure,
    subdivide,
)
from benchmarks.mini_pneu_net import mini_pneu_net


def region_volumes(mesh: HexMesh) -> np.ndarray:
    jacobian = np.einsum("mni,gdn->mgid", mesh.nodes[mesh.elements], CUBE_SLOPES)
    volume = np.linalg.det(jacobian) @ CUBE_WEIGHTS
    assert (np.linalg.det(jacobian) > 0).all()
    return np.bincount(mesh.region, volume, minlength=len(mesh.regions))


def enclosed(mesh: HexMesh, faces: np.ndarray) -> float:
    return cavity_volume(mesh.nodes, faces, np.empty_like(mesh.nodes))


@pytest.mark.parametrize(
    ("layers", "count"),
    [((0, 0, 0), 61), ((1, 0, 0), 177), ((1, 1, 0), 354), ((1, 0, 1), 403), ((1, 1, 1), 806),
     ((2, 1, 1), 1334), ((2, 2, 2), 3123)],
)  # fmt: skip
def test_mini_pneu_net_has_the_published_element_counts(layers, count) -> None:
    assert len(mesh_body(mini_pneu_net().half(), layers=layers).elements) == count


@pytest.mark.parametrize("name", PRESETS)
def test_rubber_and_air_volumes_add_up(name: str) -> None:
    design = preset(name).design
    mesh = mesh_body(build_body(design))
    cavity = enclosed(mesh, mesh.cavity_faces.nodes)
    body = -enclosed(mesh, mesh.outer_faces.nodes)
    # same quadratic geometry on both sides: equal to rounding
    assert region_volumes(mesh).sum() + cavity == pytest.approx(body, rel=1e-12)


@pytest.mark.parametrize("name", ["slab-rectangle-low", "slab-triangle-high"])
def test_volumes_equal_the_exact_ones_of_straight_planforms(name: str) -> None:
    design = preset(name).design
    mesh = mesh_body(build_body(design))
    x = np.linspace(0, design.length, 100_001)
    area = 2 * np.trapezoid(design.half_width(x), x)
    assert region_volumes(mesh)[0] == pytest.approx(design.bottom_thickness * area, rel=1e-9)
    assert -enclosed(mesh, mesh.outer_faces.nodes) == pytest.approx(design.height * area, rel=1e-9)


def test_volume_of_the_ellipse_is_right_to_the_order_of_its_arcs() -> None:
    design = preset("slab-ellipse-low").design
    x = np.linspace(0, design.length, 200_001)
    area = 2 * np.trapezoid(design.half_width(x), x)
    mesh = mesh_body(build_body(design))
    # quadratic nodes on the arc: relative error 3e-5 or less
    assert region_volumes(mesh)[0] == pytest.approx(design.bottom_thickness * area, rel=3e-5)


def test_half_has_half_the_volume_and_its_own_plane() -> None:
    body = build_body(preset("slab-rectangle-low").design)
    whole, half = mesh_body(body), mesh_body(body.half())
    assert region_volumes(half) * 2 == pytest.approx(region_volumes(whole), rel=1e-12)
    assert half.is_half
    assert not whole.is_half
    assert np.all(half.nodes[half.symmetry_nodes, 1] == 0.0)
    assert enclosed(half, half.cavity_faces.nodes) * 2 == pytest.approx(
        enclosed(whole, whole.cavity_faces.nodes), rel=1e-12
    )


def test_periodic_cell_has_no_outer_faces_at_its_ends() -> None:
    mesh = mesh_body(build_cell(preset("oblique-45").design, 0))
    ends = set(mesh.on_first_plane(0)) | set(mesh.on_last_plane(0))
    assert all(set(face) - ends for face in mesh.outer_faces.nodes)
    first, last = mesh.on_first_plane(0), mesh.on_last_plane(0)
    assert mesh.nodes[last] - mesh.nodes[first] == pytest.approx(
        np.tile([mesh.period, 0, 0], (len(first), 1)), abs=1e-15
    )


def test_tip_point_is_the_middle_of_the_free_end_bottom_edge() -> None:
    for name in ("slab-ellipse-low", "oblique-30", "oblique-90"):
        design = preset(name).design
        body = build_body(design)
        for mesh in (mesh_body(body), mesh_body(body, layers=(1, 1, 1))):
            assert mesh.nodes[mesh.underside_line[-1]] == pytest.approx(
                [design.length, 0, 0], abs=1e-15
            )


def test_subdivisions_are_nested() -> None:
    lines = np.array([0.0, 1.0, 1.5, 4.0])
    coarser = subdivide(lines)
    for layers in (1, 2, 3):
        finer = subdivide(lines, layers=layers, graded_last=False)
        assert np.all(np.diff(finer) > 0)
        assert np.isclose(coarser[:, None], finer, atol=1e-14).any(axis=1).all()
        coarser = finer


def test_prolongation_reproduces_quadratic_displacement_and_linear_pressure() -> None:
    body = build_body(preset("oblique-45").design.changed(chamber_count=2, length=40))
    coarse, fine = mesh_body(body), mesh_body(body, layers=(1, 0, 1))

    def lattice(mesh: HexMesh, at: np.ndarray) -> np.ndarray:
        columns = []
        for d in range(3):
            line = mesh.lines[d]
            both = np.sort(np.concatenate([line, (line[:-1] + line[1:]) / 2]))
            columns.append(both[at[:, d]])
        return np.stack(columns, axis=-1) * 1e2

    def field(x: np.ndarray) -> np.ndarray:
        return 1 + x[:, 0] ** 2 - x[:, 1] * x[:, 2] ** 2 + x[:, 0] * x[:, 1]

    at_coarse, at_fine = (lattice(m, m.node_index) for m in (coarse, fine))
    interpolated = prolong_nodes(coarse, fine) @ field(at_coarse)
    assert interpolated == pytest.approx(field(at_fine), abs=1e-12)

    def pressure(mesh: HexMesh) -> np.ndarray:
        values = lattice(mesh, mesh.node_index)[:, 0]
        corners = values[mesh.elements]
        middle = values[mesh.elements[:, CENTRE]]
        out = np.zeros((len(mesh.elements), 4))
        out[:, 0], out[:, 1] = middle, (corners[:, 14] - corners[:, 12]) / 2
        return out

    assert prolong_pressure(coarse, fine, pressure(coarse)) == pytest.approx(
        pressure(fine), abs=1e-12
    )


def sheet_area(mesh: HexMesh) -> float:
    """Area seen from above, from the corners of each patch."""
    corner = mesh.nodes[mesh.membrane_faces.nodes[:, [0, 2, 8, 6]]]
    return float(
        np.abs(np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1])).sum() / 2
    )


@pytest.mark.parametrize("plane", [0, 1])
def test_an_embedded_sheet_is_one_layer_of_faces(plane: int) -> None:
    """In the body or on its underside, whole, half and refined: the planform once."""
    plain = build_body(preset("oblique-90").design.changed(chamber_count=2, length=20))
    height = float(plain.lines[2][plane])
    body = dataclasses.replace(plain, membranes=(Membrane("sheet", height, 7.0),))
    for model, share in ((body, 1.0), (body.half(), 0.5)):
        for layers in (0, 1):
            mesh = mesh_body(model, layers=(layers, 0, layers))
            nodes = mesh.nodes[mesh.membrane_faces.nodes]
            assert nodes[..., 2] == pytest.approx(height, abs=1e-15)
            assert sheet_area(mesh) == pytest.approx(share * 20e-3 * 15e-3)
            assert np.all(mesh.membrane_stiffness == 7.0)
            assert len(mesh.membrane_stiffness) == len(mesh.membrane_faces)
    assert len(mesh_body(plain).membrane_faces) == 0
