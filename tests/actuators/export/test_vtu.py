"""Fields for ParaView, read back by meshio."""

import io
import json
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

from actuators.design import preset
from actuators.export import ModelQuestion, write
from actuators.export.vtu import NODE_ORDER, surface_series
from actuators.mechanics.continuum.volume_fields import VolumeFields
from actuators.mechanics.response import SurfaceFields
from actuators.mechanics.scene import Plate, Scene

# where VTK's vtkTriQuadraticHexahedron has its nodes, as VTK 9 prints them
VTK_NODES = np.array(
    [
        (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
        (0.5, 0, 0), (1, 0.5, 0), (0.5, 1, 0), (0, 0.5, 0), (0.5, 0, 1), (1, 0.5, 1), (0.5, 1, 1),
        (0, 0.5, 1), (0, 0, 0.5), (1, 0, 0.5), (1, 1, 0.5), (0, 1, 0.5), (0, 0.5, 0.5),
        (1, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 1, 0.5), (0.5, 0.5, 0), (0.5, 0.5, 1), (0.5, 0.5, 0.5),
    ]
)  # fmt: skip


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    question = ModelQuestion(Scene(2e3, steps=2), mesh="coarse")
    return write(preset("slab-rectangle-low").design, "vtu", question)


@pytest.fixture(scope="module")
def last(files: dict[str, bytes], tmp_path_factory: pytest.TempPathFactory) -> Any:
    file = tmp_path_factory.mktemp("vtu") / "last.vtu"
    file.write_bytes(files[max(name for name in files if name.endswith(".vtu"))])
    return meshio.read(file)


def test_the_series_lists_every_point_with_its_pressure(files: dict[str, bytes]) -> None:
    entries = list(ET.parse(io.BytesIO(files["answer.pvd"])).iter("DataSet"))
    assert [e.attrib["file"] for e in entries] == sorted(n for n in files if n.endswith(".vtu"))
    assert [float(e.attrib["timestep"]) for e in entries] == pytest.approx([0.0, 1.0, 2.0])
    document = json.loads(files["answer.json"])
    assert document["outcome"] == "converged"
    assert len(document["path"]) == len(entries)


def test_components_are_named(files: dict[str, bytes]) -> None:
    found = ET.parse(io.BytesIO(files["answer-000.vtu"])).iter("DataArray")
    stress = next(a for a in found if a.attrib["Name"] == "cauchy_stress_kPa").attrib
    names = [stress[f"ComponentName{k}"] for k in range(6)]
    assert names == ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]


def test_cells_are_the_rubber(last: Any) -> None:
    """Volume of both halves by Gauss points and VTK's own node places."""
    assert [block.type for block in last.cells] == ["hexahedron27"]
    cells = raw_connectivity(last)
    low, high = last.points[cells].min(axis=1), last.points[cells].max(axis=1)
    expected = low[:, None, :] + VTK_NODES * (high - low)[:, None, :]
    np.testing.assert_allclose(last.points[cells], expected, atol=1e-9)
    design = preset("slab-rectangle-low").design
    assert last.points[:, 0].max() == pytest.approx(design.length * 1e3)
    assert last.points[:, 1].min() == pytest.approx(-last.points[:, 1].max()), "both halves"
    assert set(last.cell_data["region"][0].tolist()) == {0, 1}


def raw_connectivity(mesh: Any) -> np.ndarray:
    """Cells in VTK's order, which meshio turns into its own."""
    from meshio._vtk_common import vtk_to_meshio_order

    order = vtk_to_meshio_order("hexahedron27", 3)
    cells = mesh.cells[0].data
    if order is None:
        return cells
    back = np.empty_like(cells)
    back[:, order] = cells
    return back


def test_fields_are_those_of_the_answer(files: dict[str, bytes], last: Any) -> None:
    tip = json.loads(files["answer.json"])["path"][-1]["tip_displacement_mm"]
    at = np.argmin(np.linalg.norm(last.points - [last.points[:, 0].max(), 0, 0], axis=1))
    np.testing.assert_allclose(last.point_data["displacement_mm"][at], tip, rtol=1e-6, atol=1e-9)
    stretches = last.point_data["principal_stretches"]
    assert (np.diff(stretches, axis=1) <= 1e-6).all(), "largest first"
    stress = last.point_data["cauchy_stress_kPa"]
    np.testing.assert_allclose(
        last.point_data["pressure_kPa"], -stress[:, :3].mean(axis=1), rtol=1e-4, atol=1e-3
    )
    inside = np.median(np.prod(stretches, axis=1))
    assert inside == pytest.approx(1.0, abs=2e-3), "nearly incompressible"


def test_contact_pressure_is_where_the_body_presses(tmp_path: Path) -> None:
    scene = Scene(6e3, steps=1, gravity=None, plate=Plate(5e-3, (0.0, 0.0, 1.0)))
    made = write(preset("slab-rectangle-low").design, "vtu", ModelQuestion(scene, mesh="coarse"))
    document = json.loads(made["answer.json"])
    assert document["path"][-1]["plate_force_N"] > 0
    free, pressed = (name for name in sorted(made) if name.endswith(".vtu"))
    for name in (free, pressed):
        (tmp_path / name).write_bytes(made[name])
    assert meshio.read(tmp_path / free).point_data["contact_pressure_kPa"].max() == 0.0
    mesh = meshio.read(tmp_path / pressed)
    pressure = mesh.point_data["contact_pressure_kPa"]
    height = (mesh.points + mesh.point_data["displacement_mm"])[:, 2]
    assert pressure.max() > 0
    assert height[pressure > 0].max() < -4.5, "on the plate, 5 mm below the underside"


def test_a_stretched_bar_has_the_stress_of_the_closed_form() -> None:
    """Uniform stretch l along X1 of a neo-Hookean half body, the rest incompressible: Cauchy
    stress mu (l^2 - 1/l) along X1, nothing across."""
    from actuators.mechanics.continuum.newton import Equilibrium
    from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
    from actuators.meshing import mesh_body
    from benchmarks.mini_pneu_net import MATERIALS, mini_pneu_net

    mesh = mesh_body(mini_pneu_net().half())
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh))
    stretch, turn = 1.5, np.radians(30)
    f = np.diag([stretch, stretch**-0.5, stretch**-0.5])
    rotation = np.array(
        [[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]]
    )
    displacement = mesh.nodes @ (rotation @ f - np.eye(3)).T
    mu = np.array([m.shear_modulus for m in MATERIALS])[mesh.region]
    # the deviator leaves -p = mu (1/l - l^2) / 3 across: the element's pressure takes it away
    pressure = np.zeros((len(mesh.elements), 4))
    pressure[:, 0] = mu * (stretch**2 - 1 / stretch) / 3
    fields = VolumeFields(system)
    (state,) = fields.states([Equilibrium(State(displacement, pressure), 0.0, 0.0, 0, None)])
    np.testing.assert_allclose(state.stretches[:, 0], stretch, rtol=1e-9)
    np.testing.assert_allclose(state.stretches[:, 1:], stretch**-0.5, rtol=1e-9)
    bottom = np.flatnonzero(fields.mesh.nodes[:, 2] == 0.0)
    tension = MATERIALS[0].shear_modulus * (stretch**2 - 1 / stretch)
    expected = tension * np.outer(rotation[:, 0], rotation[:, 0])
    xx, yy, zz, xy, yz, xz = state.stress[bottom].T
    for component, i, j in ((xx, 0, 0), (yy, 1, 1), (zz, 2, 2), (xy, 0, 1), (yz, 1, 2), (xz, 0, 2)):
        np.testing.assert_allclose(component, expected[i, j], atol=1e-6 * tension)


def test_the_node_order_is_a_permutation() -> None:
    assert sorted(NODE_ORDER) == list(range(27))


def test_a_mirrored_half_stays_right_handed(last: Any) -> None:
    cells = raw_connectivity(last)
    a, b, c, d = (last.points[cells[:, k]] for k in (0, 1, 3, 4))
    assert (np.einsum("ni,ni->n", np.cross(b - a, c - a), d - a) > 0).all()


def test_a_stored_surface_is_a_series_of_triangles(tmp_path: Path) -> None:
    """A tetrahedron that is pulled along X1 and pressed at one corner."""
    vertices = np.array([[0, 0, 0], [0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]], dtype=np.float32)
    triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    grow = np.array([0.0, 0.1])[:, None]
    move = np.zeros((2, 4, 3), dtype=np.float32)
    move[..., 0] = grow * vertices[:, 0]
    ones = np.ones((2, 4), dtype=np.float32)
    pressed = np.array([[0, 0, 0, 0], [0, 2e3, 0, 0]], dtype=np.float32)
    surface = SurfaceFields(vertices, triangles, move, 1 + grow * ones, 5e3 * ones, pressed)
    files = surface_series(surface, [0.0, 3e3], "tetrahedron")
    (tmp_path / "last.vtu").write_bytes(files["answer-001.vtu"])
    read = meshio.read(tmp_path / "last.vtu")
    np.testing.assert_array_equal(read.cells_dict["triangle"], triangles)
    np.testing.assert_allclose(read.points, vertices * 1e3, atol=1e-6)
    np.testing.assert_allclose(read.point_data["displacement_mm"][1], [1.0, 0, 0], atol=1e-6)
    np.testing.assert_allclose(read.point_data["contact_pressure_kPa"], [0, 2, 0, 0])
    times = [e.attrib["timestep"] for e in ET.fromstring(files["answer.pvd"]).iter("DataSet")]
    assert times == ["0", "3"]
