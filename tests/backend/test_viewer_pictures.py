"""What the viewer draws: skins, sweeping, colours, GLB."""

import io

import numpy as np
import pytest
import trimesh

from actuators.design import Design, SlabDesign, parse_design, preset
from actuators.geometry import build_body
from actuators.geometry.surface import body_surface
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Centreline, Outcome, Response, SurfaceFields
from actuators.mechanics.scene import Cylinder, Plate, Scene
from backend.viewer import colour_maps, shading
from backend.viewer.film import chosen_frames, instant_film, stored_film
from backend.viewer.obstacles import cylinder_mesh, plate_mesh
from backend.viewer.picture import picture
from backend.viewer.skin import skin
from backend.viewer.sweep import swept
from storage.response_arrays import pack
from tests.backend.conftest import SLAB

BOX = trimesh.creation.box((2.0, 3.0, 4.0))
PRESETS = ["slab-rectangle-low", "slab-ellipse-high", "oblique-15", "oblique-45", "oblique-90",
           "printed-14", "bellows-9-1.6"]  # fmt: skip


def no_stamp(_: str) -> None:
    return None


def test_a_box_keeps_its_twelve_edges_and_24_corners_sharp() -> None:
    made = skin(np.asarray(BOX.vertices), np.asarray(BOX.faces))
    assert len(made.points) == 24
    assert len(made.edges) == 12
    normals = made.normals(made.points[None])[0]
    # every corner belongs to one side, so its normal is an axis, and points away from the middle
    assert np.allclose(np.sort(np.abs(normals), axis=1), [0, 0, 1], atol=1e-6)
    assert np.all((normals * made.points).sum(axis=1) > 0)


def test_a_sphere_has_no_sharp_edges_and_radial_normals() -> None:
    ball = trimesh.creation.icosphere(subdivisions=3)
    made = skin(np.asarray(ball.vertices), np.asarray(ball.faces))
    assert (len(made.points), len(made.edges)) == (len(ball.vertices), 0)
    assert np.allclose(made.normals(made.points[None])[0], made.points, atol=0.02)


@pytest.mark.parametrize("name", PRESETS)
def test_a_straight_rod_leaves_the_body_where_it_was(name: str) -> None:
    design = preset(name).design
    surface = body_surface(build_body(design))
    made = skin(surface.vertices, surface.triangles)
    stations = np.linspace(0, design.length, 11)
    positions = np.stack([stations, 0 * stations, 0 * stations], axis=-1)[None]
    frames = np.broadcast_to(np.eye(3), (1, 11, 3, 3))
    moved = swept(made.points, Centreline(stations, positions, frames), np.array([0]))
    assert np.allclose(moved[0], made.points, atol=1e-12)


def test_a_rod_moved_rigidly_moves_the_body_rigidly() -> None:
    design = preset("oblique-45").design
    surface = body_surface(build_body(design))
    turn = trimesh.transformations.euler_matrix(0.3, -0.8, 1.1)[:3, :3]
    stations = np.linspace(0, design.length, 7)
    line = np.stack([stations, 0 * stations, 0 * stations], axis=-1)
    frames = np.broadcast_to(turn, (1, 7, 3, 3))
    rigid = Centreline(stations, (line @ turn.T)[None], frames)
    moved = swept(surface.vertices, rigid, np.array([0]))[0]
    assert np.allclose(moved, surface.vertices @ turn.T, atol=1e-12)


@pytest.mark.parametrize("name", PRESETS)
def test_the_swept_tip_is_the_answers_tip(name: str) -> None:
    chosen = preset(name)
    film = instant_film(chosen.design, Scene(chosen.pressure_to), no_stamp)
    answer = predict(chosen.design, Scene(chosen.pressure_to, steps=20))
    tip = np.array([chosen.design.length, 0.0, 0.0])
    nearest = int(np.argmin(np.linalg.norm(film.skin.points - tip, axis=1)))
    offset = film.skin.points[nearest] - tip
    # the drawn vertex next to the tip point moves with the tip's section: distances are kept
    for k in (0, 10, 20):
        given = film.points[k, nearest] - np.array(answer.path[k].tip)
        assert np.linalg.norm(given) == pytest.approx(np.linalg.norm(offset), abs=2e-5)


def test_near_its_limit_a_slab_is_drawn_without_a_fold() -> None:
    """The rod's laws shift the whole line within 3 mm of the clamp, and lift it at the tip; the
    drawn one comes from the clamp level, and is nowhere steeper than the path of its free end."""
    design = preset("slab-triangle-low").design
    assert isinstance(design, SlabDesign)
    rod = predict(design, Scene(10e3, gravity=None), rung="cell-rod").centreline
    assert rod is not None
    x = np.linspace(0.0, design.length, 200)
    # a line of the underside; the height of the body is read off its points
    points = np.zeros((400, 3))
    points[:, 0], points[200:, 2] = np.tile(x, 2), design.height
    line = swept(points, rod, np.array([0, 20]))[:, :200]
    steps = np.diff(line[1], axis=0)
    slope = np.degrees(np.arctan2(-steps[:, 2], steps[:, 0]))
    turn = np.degrees(np.arctan2(-rod.frames[20, -1, 2, 0], rod.frames[20, -1, 0, 0]))
    assert abs(slope[0]) < 0.2 * turn
    assert slope.min() > -1.0
    assert slope.max() < 1.5 * turn
    # both ends and the straight body stay what the answer says
    assert line[1, [0, -1]] == pytest.approx(rod.positions[20, [0, -1]], abs=1e-12)
    assert line[0] == pytest.approx(points[:200], abs=1e-12)


def srgb(linear: np.ndarray) -> np.ndarray:
    """Linear light to levels of the screen, 0..255."""
    curve = 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return 255 * np.where(linear <= 0.0031308, 12.92 * linear, curve)


@pytest.mark.parametrize("name", ["viridis", "cividis", "inferno"])
def test_the_screen_shows_the_legends_colour_times_the_light(name: str) -> None:
    colours, factor = shading.palette(name)
    lit = shading.to_linear(colour_maps.table(name))
    for shade, light in ((0, shading.DARKEST), (-1, shading.BRIGHTEST)):
        shown = shading.tone_curve(colours[shade, :, :3] / shading.FULL * factor)
        # one level for the rounding of colours to 16 bits, in the darkest blues
        assert np.abs(srgb(shown) - srgb(lit * light)).max() < 1.0


def test_colour_maps_rise_evenly_in_lightness() -> None:
    for name in ("viridis", "cividis", "inferno"):
        linear = shading.to_linear(colour_maps.table(name))
        luminance = linear @ [0.2126, 0.7152, 0.0722]
        lightness = 116 * np.cbrt(np.maximum(luminance, 0.008856)) - 16
        assert np.all(np.diff(lightness[8:]) > -0.3), name
        assert lightness[-1] - lightness[0] > 60


def test_a_frame_is_a_glb_in_millimetres_that_other_programs_read() -> None:
    design = preset("slab-rectangle-low").design
    shown = picture(instant_film(design, Scene(40e3), no_stamp), "displacement", undeformed=True)
    assert len(shown.bodies.frames) == 21
    scene = trimesh.load(io.BytesIO(shown.bodies.frames[0]), file_type="glb")
    high = np.asarray(scene.bounds)[1]  # type: ignore[union-attr]
    assert high[1] == pytest.approx(22.5, abs=1e-3)
    assert shown.bodies.undeformed is not None
    assert sum(map(len, shown.bodies.frames)) < 6_000_000


def test_the_legend_spans_what_is_shown() -> None:
    film = instant_film(preset("oblique-45").design, Scene(60e3), no_stamp)
    shown = picture(film, "displacement", undeformed=False)
    assert shown.legend is not None
    assert shown.legend.upper == pytest.approx(film.values["displacement"].max() * 1e3, rel=1e-3)
    assert shown.bodies.undeformed is None


def test_a_plate_stands_at_its_gap_and_a_cylinder_at_its_radius() -> None:
    design = preset("slab-rectangle-low").design
    scene = Scene(4e3, plate=Plate(5e-3), cylinder=Cylinder(10e-3, (60e-3, 0.0, -30e-3)))
    shown = picture(instant_film(design, scene, no_stamp), "displacement", undeformed=False)
    plate, cylinder = (
        np.asarray(trimesh.load(io.BytesIO(glb), file_type="glb").bounds)  # type: ignore[union-attr]
        for glb in shown.bodies.obstacles
    )
    # the face towards the actuator, whose underside lies at 0
    assert plate[1, 2] == pytest.approx(-5.0, abs=1e-3)
    assert cylinder[:, 2] == pytest.approx([-40.0, -20.0], abs=1e-3)
    assert cylinder[0, 1] < -22.5
    assert cylinder[1, 1] > 22.5
    assert shown.bodies.box[0, 2] <= cylinder[0, 2]


def test_every_face_of_an_obstacle_looks_outward() -> None:
    box = np.array([[0.0, -20.0, -10.0], [100.0, 20.0, 20.0]])
    for points, triangles, _ in (
        plate_mesh(Plate(5e-3, (0.6, 0.0, 0.8)), box, box),
        cylinder_mesh(Cylinder(10e-3, (0.05, 0.0, -0.03), (0.0, 0.6, 0.8)), box),
    ):
        assert trimesh.Trimesh(points, triangles).is_watertight
        assert trimesh.Trimesh(points, triangles, process=False).volume > 0


def stored(design: Design, *, half: bool) -> bytes:
    """A response with fields on the surface: the body stretched along X1 by the pressure."""
    body = build_body(design)
    surface = body_surface(body.half() if half else body)
    triangles = surface.triangles
    if half:  # the solver's half model has no surface on the plane of symmetry
        cut = np.all(np.abs(surface.vertices[triangles][:, :, 1]) < 1e-9, axis=1)
        triangles = triangles[~cut]
    answer = predict(design, Scene(30e3, steps=3))
    k, n = len(answer.path), len(surface.vertices)
    grow = np.linspace(0, 0.1, k)[:, None]
    move = np.zeros((k, n, 3), dtype=np.float32)
    move[:, :, 0] = grow * surface.vertices[:, 0]
    stretch = np.broadcast_to(1 + grow, (k, n)).astype(np.float32)
    fields = SurfaceFields(
        surface.vertices.astype(np.float32), triangles, move, stretch, stretch * 1e5
    )
    return pack(Response(design, Scene(30e3), "fe", Outcome.CONVERGED, answer.path, surface=fields))


def test_a_stored_half_model_is_shown_whole() -> None:
    design = parse_design(SLAB)
    film = stored_film(stored(design, half=True), design, Scene(30e3), [10.0] * 4)
    assert film.skin.points[:, 1].min() == pytest.approx(-22.5e-3, abs=1e-6)
    assert film.skin.points[:, 1].max() == pytest.approx(22.5e-3, abs=1e-6)
    assert len(film.points) == 4
    assert film.points[-1, :, 0].max() == pytest.approx(1.1 * design.length, rel=1e-5)
    shown = picture(film, "stretch", undeformed=True)
    assert (shown.colour, shown.legend is not None) == ("stretch", True)
    assert shown.colours == ["displacement", "stretch", "stress", "none"]


def test_a_stored_full_model_is_shown_as_it_is_without_the_inside_of_its_cavity() -> None:
    design = preset("oblique-45").design
    film = stored_film(stored(design, half=False), design, Scene(30e3), [10.0] * 4)
    surface = body_surface(build_body(design))
    assert len(film.skin.triangles) == int((~surface.cavity).sum())


def test_frames_are_chosen_with_the_first_and_the_last() -> None:
    assert chosen_frames(3, 21).tolist() == [0, 1, 2]
    many = chosen_frames(101, 21)
    assert (many[0], many[-1], len(many)) == (0, 100, 21)
