"""Bellows: areas in closed form, nodes on the arcs, elements that never turn inside out."""

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.integrate import quad

from actuators.design import BellowsDesign, DesignError, parse_design, preset
from actuators.geometry import build_body, build_cell
from actuators.geometry.volumes import exact_volumes
from actuators.mechanics.continuum.kernel.cavity import cavity_volume
from actuators.mechanics.continuum.kernel.shape import CUBE_SLOPES, CUBE_WEIGHTS
from actuators.meshing import HexMesh, mesh_body
from tests.actuators.design_space import bellows


def determinants(mesh: HexMesh) -> np.ndarray:
    """det J at the Gauss points, (m, g)."""
    return np.linalg.det(np.einsum("mni,gdn->mgid", mesh.nodes[mesh.elements], CUBE_SLOPES))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(bellows())
def test_no_element_turns_inside_out_and_volumes_are_nearly_exact(design: BellowsDesign) -> None:
    mesh = mesh_body(build_body(design).half())
    jacobian = determinants(mesh)
    assert jacobian.min() > 0
    assert (jacobian.min(axis=1) / jacobian.max(axis=1)).min() > 0.01
    exact = exact_volumes(design)
    # one quadratic arc a quarter circle: its sector is 0.5 % too small
    assert 2 * (jacobian @ CUBE_WEIGHTS).sum() == pytest.approx(exact.rubber, rel=0.02)
    air = 2 * cavity_volume(mesh.nodes, mesh.cavity_faces.nodes, np.empty_like(mesh.nodes))
    assert air == pytest.approx(exact.cavity, rel=0.02)


def test_volumes_converge_with_the_fourth_power_of_the_element() -> None:
    design = preset("bellows-11-2.0").design
    exact = exact_volumes(design).rubber
    errors = []
    for parts in (1, 2):
        mesh = mesh_body(build_body(design).half(), uniform=(parts, 1, 1))
        errors.append(abs(2 * (determinants(mesh) @ CUBE_WEIGHTS).sum() - exact) / exact)
    assert errors[1] < 3e-4
    assert errors[0] / errors[1] > 12


@settings(max_examples=30, deadline=None, derandomize=True)
@given(bellows())
def test_areas_of_the_profile_are_the_integrals_of_its_width(design: BellowsDesign) -> None:
    wave = design.wave

    def width(z: float, valley: float, crown: float) -> float:
        if z < wave.valley_centre - valley:
            return wave.pitch
        if z < wave.valley_centre:
            return wave.pitch - 2 * np.sqrt(valley**2 - (wave.valley_centre - z) ** 2)
        if z < wave.crown_centre:
            return 2 * crown
        return 2 * np.sqrt(max(crown**2 - (z - wave.crown_centre) ** 2, 0.0))

    for below, valley, crown, floor in (
        (wave.air_below, wave.valley, wave.crown, wave.floor),
        (wave.body_below, wave.gap / 2, wave.crown_outside, 0.0),
    ):
        top = wave.crown_centre + crown
        cuts = [wave.valley_centre - valley, wave.valley_centre, wave.crown_centre]
        for z in (wave.valley_centre, (wave.valley_centre + wave.crown_centre) / 2, top):
            inner = [c for c in cuts if floor < c < z]
            area, _ = quad(width, floor, z, args=(valley, crown), points=inner, epsabs=1e-13)
            assert float(below(np.array(z))) == pytest.approx(area, rel=1e-5)
    above = np.array([wave.height, 2 * wave.height])
    assert wave.body_below(above)[0] == wave.body_below(above)[1]


def test_the_skin_has_its_thickness_everywhere_and_its_nodes_lie_on_the_arcs() -> None:
    design = preset("bellows-9-1.6").design
    assert isinstance(design, BellowsDesign)
    wave = design.wave
    mesh = mesh_body(build_cell(design, 0))
    top = mesh.nodes[mesh.node_index[:, 2] == 8]
    inside = mesh.nodes[mesh.node_index[:, 2] == 6]
    np.testing.assert_allclose(np.linalg.norm(top - inside, axis=1), 1.6e-3, rtol=1e-9)
    for nodes, crown, valley in ((top, wave.crown_outside, wave.gap / 2),
                                 (inside, wave.crown, wave.valley)):  # fmt: skip
        x = np.minimum(nodes[:, 0], wave.pitch - nodes[:, 0])
        high, low = nodes[:, 2] > wave.crown_centre, nodes[:, 2] < wave.valley_centre
        radius = np.hypot(x - wave.pitch / 2, nodes[:, 2] - wave.crown_centre)
        np.testing.assert_allclose(radius[high], crown, rtol=1e-9)
        radius = np.hypot(x, nodes[:, 2] - wave.valley_centre)
        np.testing.assert_allclose(radius[low], valley, rtol=1e-9)
        assert high.sum() >= 15
        assert low.sum() >= 15


def test_bellows_reach_from_the_clamp_to_the_tip_and_neighbours_stand_a_gap_apart() -> None:
    design = preset("bellows-13-2.4").design
    assert isinstance(design, BellowsDesign)
    nodes = mesh_body(build_body(design)).nodes
    assert nodes.min(axis=0) == pytest.approx([0.0, -8.5e-3, 0.0], abs=1e-12)
    assert nodes.max(axis=0) == pytest.approx([115e-3, 8.5e-3, 20e-3], abs=1e-12)
    assert design.pitch - 2 * design.wave.crown_outside == pytest.approx(design.gap)


@pytest.mark.parametrize(
    ("document", "field"),
    [
        ({"wall_thickness_mm": 8.4}, "wall_thickness"),
        ({"chamber_count": 22}, "chamber_count"),
        ({"length_mm": 60}, "chamber_count"),
        ({"total_height_mm": 10.9}, "total_height"),
        ({"chamber_count": 3}, "total_height"),
    ],
)
def test_impossible_bellows_are_refused_with_a_mend(
    document: dict[str, object], field: str
) -> None:
    with pytest.raises(DesignError) as caught:
        parse_design({"family": "bellows", **document})
    assert caught.value.field == field
    assert caught.value.value
    assert caught.value.mend
