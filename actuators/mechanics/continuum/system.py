"""The discrete problem of one mesh: unknowns, loads, residual and tangent."""

import threading
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.contact import Interaction, Tangent
from actuators.mechanics.continuum.kernel.assemble import assemble
from actuators.mechanics.continuum.kernel.cavity import cavity_volume
from actuators.mechanics.continuum.kernel.condense import (
    INNER,
    OUTER,
    condense_residual,
    expand_correction,
)
from actuators.mechanics.continuum.kernel.pattern import (
    merge_neighbours,
    node_neighbours,
    scatter_map,
    upper_rows,
)
from actuators.mechanics.continuum.outer_loads import FacePlaces, OuterLoads, face_places
from actuators.mechanics.continuum.sheets import by_element, sheets_of
from actuators.mechanics.continuum.state import Balance, State
from actuators.mechanics.continuum.turning import Turning
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.meshing import CENTRE, FACE_NODES, HexMesh

__all__ = ["Balance", "ContinuumSystem", "State", "clamped"]

# numba's simplest threading layer must not be entered by two threads at once
_PARALLEL = threading.Lock()


class ContinuumSystem:
    """A mesh with materials, loads and ``interactions`` of its outside; ``free`` (n, 3) says
    which displacements are unknown.

    Holds the memory of one tangent: :meth:`linearise` fills it, :meth:`reduce` and
    :meth:`expand` go between the full state and the condensed unknowns with it.
    """

    def __init__(
        self,
        mesh: HexMesh,
        materials: Sequence[Material],
        *,
        free: np.ndarray,
        gravity: tuple[float, float, float] | None = None,
        interactions: Sequence[Interaction] = (),
        outer_loads: OuterLoads | None = None,
    ) -> None:
        self.mesh = mesh
        self._outer_loads = outer_loads
        self.interactions = tuple(interactions)
        self.materials = tuple(materials)
        self._free = free
        can_turn = np.array_equal(free, clamped(mesh))
        self._turning = Turning(mesh) if can_turn else None
        unknown = free.copy()
        unknown[mesh.centre_nodes] = False
        self.dof = np.full(unknown.shape, -1, dtype=np.int32)
        self.dof[unknown] = np.arange(np.count_nonzero(unknown), dtype=np.int32)
        self.unknowns = int(np.count_nonzero(unknown))
        self._outer = np.ascontiguousarray(np.delete(mesh.elements, CENTRE, axis=1))
        self._coupled: set[bytes] = set()
        self._lay_out(node_neighbours(self._outer, len(mesh.nodes)))
        self._set_materials(gravity)
        self._set_faces()
        count = len(mesh.elements)
        self._recover = np.zeros((count, INNER, OUTER))
        self._inverse = np.zeros((count, INNER, INNER))
        self._least = np.zeros(count)

    def _lay_out(self, neighbours: tuple[np.ndarray, np.ndarray]) -> None:
        """The matrix for these neighbours of every node (CSR lists)."""
        self._neighbours = neighbours
        self.indptr, self.indices = upper_rows(*neighbours, self.dof, self.unknowns)
        with _PARALLEL:
            self._scatter = scatter_map(self._outer, self.dof, self.indptr, self.indices)
        self.values = np.zeros(len(self.indices))
        self._outer_places: FacePlaces | None = None

    def _widen(self, positions: np.ndarray) -> None:
        """Make room in the matrix for surfaces that have come near each other."""
        for interaction in self.interactions:
            sets = np.ascontiguousarray(interaction.couples(positions), dtype=np.int32)
            new = [nodes for nodes in sets if nodes.tobytes() not in self._coupled]
            if new:
                self._coupled.update(nodes.tobytes() for nodes in new)
                more = node_neighbours(np.array(new), len(positions))
                self._lay_out(merge_neighbours(*self._neighbours, *more))

    def overlap(self, state: State) -> float:
        """Deepest penetration of surfaces over the distance in which contact sets in; 0 where
        nothing touches."""
        if not self.interactions:
            return 0.0
        positions = self.mesh.nodes + state.displacement
        return max(interaction.overlap(positions) for interaction in self.interactions)

    def factorize(self, solver: SymmetricSolver) -> None:
        """Factorise the tangent last filled; a pattern widened since is adopted first."""
        if solver.entries != len(self.indices):
            solver.adopt(self.indptr, self.indices)
        solver.factorize(self.values)

    def _set_materials(self, gravity: tuple[float, float, float] | None) -> None:
        laws = [m.law for m in self.materials]
        width = max(len(law.coefficients) for law in laws)
        self.coefficients = np.zeros((len(laws), width))
        for row, law in zip(self.coefficients, laws, strict=True):
            row[: len(law.coefficients)] = law.coefficients
        self.codes = np.array([law.code for law in laws], dtype=np.int64)
        self.counts = np.array([len(law.coefficients) for law in laws], dtype=np.int64)
        self.kappa = np.array([m.bulk_modulus for m in self.materials])
        # an element's constant pressure can be condensed only where kappa is finite: the equations
        # keep the true one, the tangent does not, and each correction leaves about mu/kappa of the
        # tangent's of what was missing
        tangent = np.array([m.finite_bulk_modulus for m in self.materials])
        self._compliance = 1 / np.stack([self.kappa, tangent], axis=1)
        density = np.array([m.density for m in self.materials])
        self.weight = density[:, None] * np.array(gravity or (0.0, 0.0, 0.0))

    def _set_faces(self) -> None:
        mesh, count = self.mesh, len(self.mesh.elements)
        self._face_start, order = by_element(mesh.cavity_faces, count)
        self._face_local = mesh.cavity_faces.local[order].astype(np.int64)
        self._sheets = sheets_of(mesh)
        colour = (mesh.box % 2) @ np.array([1, 2, 4])
        self._colour_order = np.argsort(colour, kind="stable").astype(np.int64)
        per_colour = np.bincount(colour, minlength=8)
        self._colour_start = np.concatenate([[0], np.cumsum(per_colour)]).astype(np.int64)

    def rest(self) -> State:
        """Undeformed state."""
        return State(
            np.zeros_like(self.mesh.nodes),
            np.zeros((len(self.mesh.elements), 4)),
            self._sheets.no_force,
        )

    def balance(self, state: State, pressure: float, *, loads: float = 1.0) -> Balance:
        """Residual at cavity ``pressure`` [Pa] and this share of weight and outer loads."""
        return self._assemble(state, pressure, loads, False)

    def linearise(
        self,
        state: State,
        pressure: float,
        *,
        loads: float = 1.0,
        near: bool = True,
        sheets_flat: bool = False,
    ) -> Balance:
        """Residual, and the tangent kept in :attr:`values` (upper triangle). ``near``: whether
        ``state`` is so near to equilibrium that its contact pressures are to be believed.
        ``sheets_flat``: whether sheets under compression are held flat, against wrinkles."""
        return self._assemble(state, pressure, loads, True, near, sheets_flat)

    def _assemble(
        self,
        state: State,
        pressure: float,
        loads: float,
        tangent: bool,
        near: bool = True,
        sheets_flat: bool = False,
    ) -> Balance:
        mesh = self.mesh
        residual = np.zeros_like(mesh.nodes)
        inner = np.zeros((len(mesh.elements), 4))
        sheets, gap = self._sheets, self._sheets.no_force
        positions = mesh.nodes + state.displacement
        if tangent:
            self._widen(positions)
        with _PARALLEL:
            assemble(
                mesh.nodes, state.displacement, state.pressure, mesh.elements, mesh.region,
                self.codes, self.counts, self.coefficients, self._compliance, loads * self.weight,
                pressure, self._face_start, self._face_local, FACE_NODES, sheets.start,
                sheets.local, sheets.stiffness,
                state.sheet if len(state.sheet) else sheets.no_force, self._colour_start,
                self._colour_order, self._scatter, tangent, sheets_flat, residual, inner,
                self.values, self._recover, self._inverse, self._least, gap, sheets.area,
                sheets.gradient,
            )  # fmt: skip
        self._add_outer_loads(positions, loads, residual, tangent=tangent)
        sound = bool(self._least.min() > 0.0) and bool(np.isfinite(residual).all())
        if not sound:
            return Balance(residual, inner, gap, False)
        matrix = None
        if tangent:
            matrix = Tangent(self.dof, self.indptr, self.indices, self.values, near)
        touches = tuple(i.add(positions, residual, matrix) for i in self.interactions)
        return Balance(residual, inner, gap, not any(t.blind for t in touches), touches)

    def _add_outer_loads(
        self, positions: np.ndarray, share: float, residual: np.ndarray, *, tangent: bool
    ) -> None:
        loads = self._outer_loads
        if loads is None:
            return
        loads.add_residual(positions, share, residual)
        if tangent and loads.pressure != 0.0:
            if self._outer_places is None:
                self._outer_places = face_places(loads.faces, self.dof, self.indptr, self.indices)
            self._outer_places.add(loads.tangent(positions, share), self.values)

    def reduce(self, balance: Balance) -> np.ndarray:
        """Condensed residual (unknowns,) with the tangent last filled."""
        out = np.empty(self.unknowns)
        residual = balance.residual
        if len(self._sheets):
            residual = residual.copy()
            np.add.at(residual, self._sheets.nodes, self._sheets.condensed(balance.sheet))
        condense_residual(self.mesh.elements, residual, balance.inner, self._recover, self.dof, out)
        return out

    def expand(self, solution: np.ndarray, balance: Balance | None) -> State:
        """Full correction from the condensed one; ``balance`` None for a load on the unknowns."""
        if balance is None:
            balance = Balance(
                np.zeros_like(self.mesh.nodes), np.zeros((len(self.mesh.elements), 4)),
                self._sheets.no_force, True,
            )  # fmt: skip
        du = np.empty_like(self.mesh.nodes)
        dq = np.empty((len(self.mesh.elements), 4))
        expand_correction(
            self.mesh.elements, balance.residual, balance.inner, self._recover, self._inverse,
            self.dof, solution, du, dq,
        )  # fmt: skip
        return State(du, dq, self._sheets.correction(du, balance.sheet))

    def moved(self, state: State, factor: float, step: State) -> State:
        """``state`` after this part of a correction, along arcs where the body can turn."""
        straight = state.moved(factor, step)
        if self._turning is None:
            return straight
        nodes = self.mesh.nodes
        ahead = self._turning.moved(nodes + state.displacement, factor * step.displacement)
        return self._held(straight, ahead)

    def onward(self, before: State, last: State, ratio: float) -> State:
        """Extrapolation: ``last`` moved on by ``ratio`` times the way from ``before``."""
        straight = last.moved(ratio, last.moved(-1.0, before))
        if self._turning is None:
            return straight
        nodes = self.mesh.nodes
        ahead = self._turning.extrapolated(
            nodes + before.displacement, nodes + last.displacement, ratio
        )
        return self._held(straight, ahead)

    def _held(self, straight: State, positions: np.ndarray) -> State:
        """``straight`` with these positions, but where it is held."""
        displacement = np.where(self._free, positions - self.mesh.nodes, straight.displacement)
        return replace(straight, displacement=displacement)

    def unknowns_of(self, state: State) -> np.ndarray:
        """Displacements (unknowns,) that are not held [m]."""
        values = np.empty(self.unknowns)
        kept = self.dof >= 0
        values[self.dof[kept]] = state.displacement[kept]
        return values

    def volume(self, state: State) -> tuple[float, np.ndarray]:
        """Cavity volume [m3] and its derivative (unknowns,) [m2]. A half model's is that of its
        half."""
        gradient = np.empty_like(self.mesh.nodes)
        total = cavity_volume(
            self.mesh.nodes + state.displacement, self.mesh.cavity_faces.nodes, gradient
        )
        reduced = np.zeros(self.unknowns)
        kept = self.dof >= 0
        reduced[self.dof[kept]] = gradient[kept]
        return float(total), reduced


def clamped(mesh: HexMesh) -> np.ndarray:
    """``free`` (n, 3) of an actuator clamped at X1 = 0, X2 held on the middle plane of a half."""
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    free[mesh.clamp_nodes] = False
    free[mesh.symmetry_nodes, 1] = False
    return free
