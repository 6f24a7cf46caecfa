"""What the instant rungs expect of a design in a scene: the numbers that decide which effects the
3D solver needs."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from actuators.design import Design, PrintedDesign
from actuators.geometry.volumes import exact_volumes
from actuators.materials import material
from actuators.materials.neo_hooke import NeoHooke
from actuators.materials.ogden import Ogden
from actuators.mechanics.cell.row import ChamberRow, chamber_row, row_cells
from actuators.mechanics.cell.shear import sideways_shear
from actuators.mechanics.rod import Rod, follow_pressures, rod_of
from actuators.mechanics.rod.equilibrium import shape
from actuators.mechanics.scene import Scene

STATIONS = 12
"""Equal pressure steps at which obstacles are looked for."""
STRAIN_SHARE = 1.3
"""Change of the bending, over the largest strain, that finite strain makes: measured 13 % at 10 %
(oblique-90, whose walls stiffen as they bulge)."""


@dataclass(frozen=True, eq=False)
class Loads:
    """Resultants S (s, 4) that the loads of a scene make in the undeformed rod, and what they do:
    ``strain`` (s, 4), ``tip`` (3,) small displacement of the tip point [m], ``sheared`` (3,) what
    of it shear makes, which the strains do not hold."""

    strain: np.ndarray
    tip: np.ndarray
    sheared: np.ndarray


class Forecast:
    """Linear cells and the rod of a design, asked about one scene. Everything is of the path's end
    where not said otherwise."""

    def __init__(self, design: Design, scene: Scene) -> None:
        self.design, self.scene = design, scene
        self.row: ChamberRow = chamber_row(design)
        self.rod: Rod = rod_of(design, self.row, self.row.free)
        self.pressure = self._pressure()

    def _pressure(self) -> float:
        """Pressure [Pa] at the path's end; for a volume, where the linear cavity has it."""
        if self.scene.volume_to is None:
            return self.scene.pressure_to or 0.0
        growth = self.scene.volume_to - exact_volumes(self.design).cavity
        return float(growth / self.row.cavity_compliance.sum())

    @cached_property
    def height(self) -> float:
        """Of the body [m]."""
        return float(getattr(self.design, "height"))  # noqa: B009 (every family has one)

    @cached_property
    def width(self) -> float:
        """Largest, of the body [m]."""
        return float(getattr(self.design, "width"))  # noqa: B009 (every family has one)

    @cached_property
    def middles(self) -> np.ndarray:
        """X1 of the pieces' middles (s,) [m]."""
        return (self.rod.stations[:-1] + self.rod.stations[1:]) / 2

    def _resultants(self, force: np.ndarray, at: np.ndarray) -> np.ndarray:
        """Resultants (s, 4) of forces (m, 3) [N] at positions (m, 3) [m] of the straight rod, by
        the virtual work of the rod strains."""
        beyond = (at[:, 0] > self.middles[:, None]).astype(float)
        arm = np.clip(at[:, 0] - self.middles[:, None], 0.0, None)
        f1, f2, f3 = force.T
        y, z = at[:, 1], at[:, 2]
        return np.stack(
            [
                beyond @ f1,
                beyond @ (y * f3 - z * f2),
                beyond @ (z * f1) - arm @ f3,
                arm @ f2 - beyond @ (y * f1),
            ],
            axis=-1,
        )

    def _answer(self, force: np.ndarray, at: np.ndarray) -> Loads:
        strain = np.einsum("sij,sj->si", self.rod.compliance, self._resultants(force, at))
        beyond = (at[:, 0] > self.middles[:, None]).astype(float)
        sheared = np.array([0.0, self.sideways @ (beyond @ force[:, 1]), 0.0])
        return Loads(strain, self._small_tip(strain) + sheared, sheared)

    @cached_property
    def sideways(self) -> np.ndarray:
        """How far the pieces shear along X2 per force (s,) [m/N]. The rod's own law knows no shear,
        and sideways that may be most: a bar on a sheet that keeps its length hardly bends there."""
        cells, weights = row_cells(self.design)
        materials = [tuple(material(r.material) for r in cell.regions) for cell in cells]
        stiffness = [sideways_shear(*each) for each in zip(cells, materials, strict=True)]
        centres = self.row.start + self.row.pitch / 2
        return self.rod.length / np.interp(self.middles, centres, weights @ stiffness)

    def _small_tip(self, strain: np.ndarray) -> np.ndarray:
        """Displacement (3,) of the tip point that small rod strains (s, 4) make [m]."""
        return np.einsum("sia,si,s->a", self._levers, strain, self.rod.length)

    @cached_property
    def _levers(self) -> np.ndarray:
        """(s, 4, 3): resultants of unit forces on the tip point, along each axis."""
        tip = np.array([[self.design.length, 0.0, 0.0]])
        return np.stack([self._resultants(row[None], tip) for row in np.eye(3)], axis=-1)

    @cached_property
    def weight(self) -> Loads:
        """Of the body itself."""
        pull = np.array(self.scene.gravity or (0.0, 0.0, 0.0))
        at = np.zeros((len(self.middles), 3))
        at[:, 0], at[:, 2] = self.middles, self.rod.mass_height
        return self._answer(self.rod.mass[:, None] * pull, at)

    @cached_property
    def force(self) -> Loads:
        """Of the force on the tip, at the middle of the free end."""
        force = np.array([self.scene.tip_force or (0.0, 0.0, 0.0)])
        return self._answer(force, np.array([[self.design.length, 0.0, self.height / 2]]))

    @cached_property
    def outside(self) -> Loads:
        """Of the pressure on the underside."""
        up = self.scene.outside_pressure * self.width * self.rod.length
        at = np.zeros((len(self.middles), 3))
        at[:, 0] = self.middles
        return self._answer(up[:, None] * np.array([0.0, 0.0, 1.0]), at)

    @cached_property
    def inflation(self) -> np.ndarray:
        """Rod strains (s, 4) of the pressure alone."""
        return self.pressure * self.rod.free

    @cached_property
    def path(self) -> np.ndarray | None:
        """Rod strains (k, s, 4) along the path under weight and pressure, other loads added as
        small ones; None where the rod finds no equilibrium."""
        pressures = np.linspace(0.0, self.pressure, STATIONS + 1)
        found = follow_pressures(self.rod, pressures, self.scene.gravity)
        if len(found.strains) < len(pressures):
            return None
        return found.strains + self.force.strain + self.outside.strain

    @cached_property
    def _rest(self) -> np.ndarray:
        return np.array([self.design.length, 0.0, 0.0])

    def _tip(self, strain: np.ndarray) -> np.ndarray:
        return shape(np.ascontiguousarray(strain), self.rod.length)[0][-1]

    @cached_property
    def travel(self) -> float:
        """Farthest that the tip comes from its place at rest [m], along the whole path."""
        if self.path is None:
            return self.design.length
        ends = [self._tip(strain) for strain in self.path]
        return max(float(np.linalg.norm(x - self._rest)) for x in ends)

    def share(self, displacement: np.ndarray) -> float:
        """Size of a tip displacement (3,) over the tip's travel; infinite where it has none."""
        size = float(np.linalg.norm(displacement))
        if size == 0.0:
            return 0.0
        return size / self.travel if self.travel > 0.0 else np.inf

    @cached_property
    def weight_share(self) -> float:
        """What leaving out gravity changes at the tip: two walks along the rod, with and without,
        at the path's end and at its beginning."""
        if self.path is None:
            return np.inf
        other = self.force.strain + self.outside.strain
        pairs = ((self.path[-1], self.inflation + other), (self.path[0], other))
        sheared = self.weight.sheared
        return max(
            self.share(self._tip(heavy) - self._tip(light) + sheared) for heavy, light in pairs
        )

    @cached_property
    def rotation_share(self) -> float:
        """What small rotations get wrong: the rod's shape with the loads' small-strain answer, as
        pieces of helix against the sum of small displacements."""
        strain = self.inflation + self.weight.strain + self.force.strain + self.outside.strain
        small = self._small_tip(strain)
        size = float(np.linalg.norm(small))
        if size == 0.0:
            return 0.0
        return float(np.linalg.norm(self._tip(strain) - self._rest - small)) / size

    @cached_property
    def strain(self) -> float:
        """Largest principal strain: the cell's, mean over an element, under pressure, and that of
        the bending by all other loads."""
        free = self.row.largest_strain * abs(self.pressure)
        if self.path is None:
            return free + 1.0
        loads = np.abs(self.path - np.linspace(0.0, 1.0, STATIONS + 1)[:, None, None]
                       * self.inflation)  # fmt: skip
        bent = loads[..., 0] + loads[..., 2] * self.height / 2 + loads[..., 3] * self.width / 2
        return free + float(bent.max())

    @cached_property
    def finite_strain_share(self) -> float:
        """What one linear solution gets wrong at the tip."""
        return self.rotation_share + STRAIN_SHARE * self.strain

    @cached_property
    def hyperelastic_share(self) -> float:
        """How far the laws have left the neo-Hookean ones of the same modulus at the largest
        strain, by their uniaxial stress; 0 for neo-Hookean ones."""
        stretch = np.array([1.0 + min(max(self.strain, 1e-6), 9.0)])
        found = 0.0
        for key in self.design.layer_materials:
            law = material(getattr(self.design, key)).law
            plain = NeoHooke(law.initial_shear_modulus).nominal_uniaxial_stress(stretch)
            ratio = float((law.nominal_uniaxial_stress(stretch) / plain)[0])
            found = max(found, abs(ratio - 1.0))
        return found if found > 1e-9 else 0.0

    @property
    def has_ogden(self) -> bool:
        """Whether a law is worked in principal axes, which takes longer."""
        keys = [getattr(self.design, name) for name in self.design.layer_materials]
        return any(isinstance(material(key).law, Ogden) for key in keys)

    @cached_property
    def layer_share(self) -> float | None:
        """What leaving out the layer that keeps its length changes at the tip under pressure
        alone; None where there is no such layer."""
        bare = without_layer(self.design)
        if bare is None:
            return None
        row = chamber_row(bare)
        rod = rod_of(bare, row, row.free)
        loose = self._tip_of(rod, self.pressure * rod.free)
        held = self._tip(self.inflation)
        size = float(np.linalg.norm(held - self._rest))
        change = float(np.linalg.norm(loose - held))
        return change / size if size > 0.0 else np.inf

    def _tip_of(self, rod: Rod, strain: np.ndarray) -> np.ndarray:
        return shape(np.ascontiguousarray(strain), rod.length)[0][-1]


def without_layer(design: Design) -> Design | None:
    """The design without the sheet that keeps its length; None where it has none."""
    if isinstance(design, PrintedDesign) and design.layer == "inextensible":
        return design.model_copy(update={"layer": "none"})
    return None
