"""What surrounds the body: the clamp, a ground with a scale, axes, camera and background."""

import math

import numpy as np
import viser

CLAMP_MM = 4.0
FOV = math.radians(32)
_VIEWPOINTS = {
    # direction from the body towards the camera
    "three-quarter": (0.55, -1.0, 0.5),
    "side": (0.0, -1.0, 0.0),
    "top": (0.0, -1e-3, 1.0),
    "below": (0.0, -1e-3, -1.0),
    "front": (1.0, 0.0, 0.0),
}
_LIGHT = {"cell": (226, 230, 234), "section": (196, 203, 210), "clamp": (128, 138, 148)}
_DARK = {"cell": (44, 50, 57), "section": (66, 74, 84), "clamp": (112, 122, 133)}


class Stage:
    """Fixed things of one room; changed only when they must be."""

    def __init__(self, server: viser.ViserServer, *, dark: bool) -> None:
        self._server = server
        self._dark = dark
        self._box = np.array([[0.0, -20.0, -60.0], [100.0, 20.0, 20.0]])
        self._clamp = np.array([[-20.0, 0.0], [20.0, 20.0]])
        self._drawn: tuple[object, ...] = ()
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(True, cast_shadow=False)
        server.initial_camera.fov = FOV
        server.gui.configure_theme(
            dark_mode=dark, show_logo=False, show_share_button=False, control_width="small"
        )
        self._fresh = True

    def fit(self, box: np.ndarray, clamp: np.ndarray) -> None:
        """Set the stage for bodies inside ``box`` (2, 3) held by a clamp over ``clamp`` (2, 2: X2
        and X3) [mm]. The camera of open pages stays where the viewer put it."""
        before = _size(self._box)
        self._box, self._clamp = box, clamp
        self._draw()
        if self._fresh or not 0.6 < _size(box) / before < 1.6:
            self._aim_initially()
            if not self._fresh:
                self.move_camera("three-quarter")
            self._fresh = False

    def set_dark(self, dark: bool) -> None:
        """Background and colours."""
        if dark != self._dark:
            self._dark = dark
            self._server.gui.configure_theme(
                dark_mode=dark, show_logo=False, show_share_button=False, control_width="small"
            )
            self._draw()

    def move_camera(self, name: str) -> None:
        """Move every open page's camera."""
        position, target = self._viewpoint(name)
        for client in self._server.get_clients().values():
            with client.atomic():
                client.camera.position = position
                client.camera.look_at = target
                client.camera.up_direction = (0.0, 0.0, 1.0)

    def _aim_initially(self) -> None:
        position, target = self._viewpoint("three-quarter")
        camera, size = self._server.initial_camera, _size(self._box)
        camera.position, camera.look_at = position, target
        camera.near, camera.far = size / 200, size * 50

    def _viewpoint(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        centre = self._box.mean(axis=0)
        direction = np.array(_VIEWPOINTS[name])
        direction /= np.linalg.norm(direction)
        distance = 0.62 * _size(self._box) / math.tan(FOV / 2)
        return centre + distance * direction, centre

    def _draw(self) -> None:
        """Ground and clamp, drawn again only when they change."""
        section = _section(_size(self._box))
        floor = math.floor((float(self._box[0, 2]) - 0.2 * section) / section * 2) * section / 2
        clamp = tuple(float(f"{v:.4g}") for v in self._clamp.ravel())
        reach = math.ceil(float(np.abs(self._box[:, :2]).max()) * 1.3 / section) * section
        wanted = (section, floor, clamp, reach, self._dark)
        if wanted == self._drawn:
            return
        self._drawn = wanted
        colours = _DARK if self._dark else _LIGHT
        scene = self._server.scene
        scene.add_grid(
            "/ground", width=2 * reach, height=2 * reach, plane="xy", cell_size=section / 2,
            section_size=section, cell_color=colours["cell"], section_color=colours["section"],
            position=(0.0, 0.0, floor), shadow_opacity=0.0, fade_distance=6 * reach,
            fade_strength=1.0,
        )  # fmt: skip
        scene.add_label(
            "/scale", f"grid {section:g} mm", position=(-section, 0.0, floor),
            font_screen_scale=0.8, anchor="center-center",
        )  # fmt: skip
        (low_y, low_z), (high_y, high_z) = np.array(clamp).reshape(2, 2)
        margin = 0.25 * (high_z - low_z)
        scene.add_box(
            "/clamp", color=colours["clamp"],
            dimensions=(CLAMP_MM, high_y - low_y + 2 * margin, high_z - low_z + 2 * margin),
            position=(-CLAMP_MM / 2, (low_y + high_y) / 2, (low_z + high_z) / 2),
            cast_shadow=False, receive_shadow=False,
        )  # fmt: skip


def _size(box: np.ndarray) -> float:
    return float(np.linalg.norm(box[1] - box[0]))


def _section(size: float) -> float:
    """Size of the ground's squares [mm]: 1, 2 or 5 times a power of ten, about a quarter of the
    body."""
    rough = size / 3
    decade = 10.0 ** math.floor(math.log10(rough))
    return max(step * decade for step in (1, 2, 5) if step * decade <= rough)
