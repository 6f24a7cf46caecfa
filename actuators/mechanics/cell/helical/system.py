"""The discrete problem of one pitch: sites and rod strains instead of free nodes.

The continuum's own equations of the mesh, on which nothing is held, are reduced to the sites
(:mod:`.domain`) and to the rod strains, in the unknowns of a :class:`.numbering.Numbering`.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from actuators.materials import Material
from actuators.mechanics.cell.helical.caps import CapVolume, cap_volume, rim_of
from actuators.mechanics.cell.helical.contact import WallContact
from actuators.mechanics.cell.helical.domain import Domain, Image, carried
from actuators.mechanics.cell.helical.numbering import (
    NO_BLOCKS,
    Blocks,
    Numbering,
    Parity,
    lay_out,
    number_unknowns,
)
from actuators.mechanics.cell.helical.reduce import WIDTH, reduce_pairs, reduce_stiffness
from actuators.mechanics.cell.helical.screw import STRAINS, Motion
from actuators.mechanics.continuum.contact.interaction import Touch
from actuators.mechanics.continuum.system import Balance, ContinuumSystem, State


@dataclass(frozen=True, eq=False)
class CellState:
    """``nodes``: state of the free mesh, its ties obeyed; ``place``: (s, 3) of the sites [m];
    ``strain``: (4,); ``hold``: (h,) forces of the conditions on the mean motion."""

    nodes: State
    place: np.ndarray
    strain: np.ndarray
    hold: np.ndarray


@dataclass(frozen=True, eq=False)
class Reduced:
    """A tangent: ``values`` of the sparse part, ``border`` (count, b), ``corner`` (b, b)."""

    values: np.ndarray
    border: np.ndarray
    corner: np.ndarray


@dataclass(frozen=True, eq=False)
class _Seen:
    state: CellState
    motions: tuple[Motion, ...]
    caps: CapVolume
    walls: np.ndarray
    touch: Touch
    of_nodes: dict[tuple[int, ...], np.ndarray]


class CellSystem:
    """Half a pitch with its materials, and with ``walls`` that touch the next chamber's."""

    def __init__(
        self,
        domain: Domain,
        materials: Sequence[Material],
        walls: WallContact | None = None,
    ) -> None:
        self.domain, self.walls = domain, walls
        mesh = domain.mesh
        free = np.ones((len(mesh.nodes), 3), dtype=bool)
        self.free = ContinuumSystem(mesh, materials, free=free)
        outer = np.ones(len(mesh.nodes), dtype=bool)
        outer[mesh.centre_nodes] = False
        self._outer = np.flatnonzero(outer)
        self._site = domain.site[self._outer]
        self._image = domain.image[self._outer]
        if walls is not None:  # behind the mesh's own nodes: the walls', which its sites move too
            self._site = np.concatenate([self._site, walls.site])
            self._image = np.concatenate([self._image, walls.image])
        self._still = self._image == Image.ITSELF
        images = {Image(n) for n in np.unique(self._image).tolist()} - {Image.ITSELF}
        self._moved = [(n, np.flatnonzero(self._image == n)) for n in sorted(images)]
        rank = np.cumsum(outer) - 1
        self._rim = rim_of(domain)
        self._rim_rank = rank[self._rim.nodes]
        self.size = float(np.ptp(mesh.nodes, axis=0).max())
        self._numberings: dict[Parity, Numbering] = {}
        self._seen: _Seen | None = None

    def rest(self) -> CellState:
        """Undeformed state."""
        return CellState(self.free.rest(), self.domain.place.copy(), np.zeros(STRAINS), np.zeros(1))

    def placed(self, nodes: State, place: np.ndarray, strain: np.ndarray, hold: np.ndarray
               ) -> CellState:  # fmt: skip
        """The state with these unknowns: every tied node is put where its site takes it."""
        count = len(self._outer)
        at = carried(place, self._site[:count], self._image[:count], self.domain.motions(strain))
        displacement = nodes.displacement.copy()
        displacement[self._outer] = at - self.domain.mesh.nodes[self._outer]
        return CellState(State(displacement, nodes.pressure, nodes.sheet), place, strain, hold)

    def balance(self, state: CellState, pressure: float) -> Balance:
        """Forces on the free nodes; what caps and walls add is in :meth:`forces`."""
        return self._touching(state, self.free.balance(state.nodes, pressure))

    def linearise(
        self, state: CellState, pressure: float, *, near: bool = True, sheets_flat: bool = False
    ) -> Balance:
        """As :meth:`balance`, and the tangent of the free nodes, which :meth:`reduced` takes.
        ``near``: whether contact pressures are to be believed; ``sheets_flat``: whether
        sheets under compression are held flat."""
        nodes = self.free.linearise(state.nodes, pressure, sheets_flat=sheets_flat)
        balance = self._touching(state, nodes)
        if self.walls is not None and balance.admissible:
            self.walls.linearise(self.wall_positions(state), near=near)
        return balance

    def _touching(self, state: CellState, balance: Balance) -> Balance:
        """With what the walls touch."""
        if self.walls is None or not balance.admissible:
            return balance
        touch = self._geometry(state).touch
        return replace(balance, touches=(touch,), admissible=not touch.blind)

    def wall_positions(self, state: CellState) -> np.ndarray:
        """(m, 3) of the nodes of walls in contact; none where there are no such walls."""
        if self.walls is None:
            return np.empty((0, 3))
        return self.walls.positions(state.place, self._geometry(state).motions)

    def volume(self, state: CellState) -> float:
        """Cavity of the half pitch [m3]."""
        return self.free.volume(state.nodes)[0] + self._caps(state).volume

    def volume_gradient(self, state: CellState, numbering: Numbering) -> np.ndarray:
        """(count + border,) derivative of :meth:`volume`."""
        caps = self._caps(state)
        forces = self.free.volume(state.nodes)[1].reshape(-1, 3)
        forces[self._rim_rank] += caps.gradient
        reduced = _folded(forces, self._motion(state, numbering), numbering)
        strains = slice(numbering.count, numbering.count + len(numbering.strains))
        reduced[strains] += caps.rate[list(numbering.strains)]
        return reduced

    def forces(
        self, state: CellState, balance: Balance, pressure: float, numbering: Numbering
    ) -> np.ndarray:
        """(count + border,) residual, inner unknowns condensed with the tangent last filled.

        What they add is folded as that tangent was: its solution obeys the volume of every element
        only along its own motions, and a bulk modulus makes a pressure of whatever is missed.
        """
        caps = self._caps(state)
        forces = balance.residual[self._outer]
        condensed = self.free.reduce(balance).reshape(-1, 3) - forces
        forces[self._rim_rank] -= pressure * caps.gradient
        forces = np.concatenate([forces, self._geometry(state).walls])
        reduced = _folded(forces, self._motion(state, numbering), numbering)
        reduced += _folded(condensed, self._condensed_motion(state, numbering), numbering)
        strains = slice(numbering.count, numbering.count + len(numbering.strains))
        reduced[strains] -= pressure * caps.rate[list(numbering.strains)]
        return reduced + numbering.mean @ state.hold

    def held(self, state: CellState, numbering: Numbering) -> np.ndarray:
        """(h,) violation of the conditions on the mean motion [m]."""
        moved = (state.place - self.domain.place).ravel()
        kept = numbering.of_site.ravel() >= 0
        return numbering.mean[numbering.of_site.ravel()[kept]].T @ moved[kept]

    def expand(
        self, state: CellState, solution: np.ndarray, balance: Balance | None, numbering: Numbering
    ) -> tuple[State, np.ndarray, np.ndarray]:
        """Change of the free nodes' state, of the sites' places and of the strains (4,); inner
        unknowns with the tangent last filled, as in :meth:`forces`."""
        count = len(self._outer)
        motion = self._condensed_motion(state, numbering)[:count]
        padded = np.append(solution, 0.0)  # unknown -1 is held
        moved = np.einsum("nik,nk->ni", motion, padded[numbering.unknown[:count]])
        change = self.free.expand(moved.ravel(), balance)
        strain = np.zeros(STRAINS)
        first = numbering.count
        strain[list(numbering.strains)] = solution[first : first + len(numbering.strains)]
        return change, padded[numbering.of_site], strain

    def reduced(self, state: CellState, balance: Balance, pressure: float, numbering: Numbering
                ) -> Reduced:  # fmt: skip
        """The tangent last filled by :meth:`linearise`, in the unknowns of ``numbering``."""
        mesh, walls = self._blocks()
        if numbering.node_entries != (len(mesh.indices), len(walls.indices)):
            lay_out(numbering, mesh, walls)
        out = Reduced(
            np.zeros(len(numbering.indices)),
            np.zeros((numbering.count, numbering.border)),
            np.zeros((numbering.border, numbering.border)),
        )
        motion = numbering.motion = self._motion(state, numbering)
        for blocks, places in ((mesh, numbering.places), (walls, numbering.wall_places)):
            nodes = blocks.nodes
            reduce_stiffness(
                blocks.indptr, blocks.indices, blocks.values, motion[nodes], self._still[nodes],
                numbering.unknown[nodes], numbering.count, places, out.values, out.border,
                out.corner,
            )  # fmt: skip
        caps = self._caps(state)
        rank = self._rim_rank
        reduce_pairs(
            rank[self._rim.first], rank[self._rim.second], -pressure * caps.bend, motion,
            numbering.unknown, numbering.count, numbering.indptr, numbering.indices, out.values,
            out.border, out.corner,
        )  # fmt: skip
        self._add_geometric(state, balance, pressure, caps, numbering, motion, out)
        return out

    def _add_geometric(
        self, state: CellState, balance: Balance, pressure: float, caps: CapVolume,
        numbering: Numbering, motion: np.ndarray, out: Reduced,
    ) -> None:  # fmt: skip
        """What the ties' own curvature and the caps' dependence on the strains add."""
        strains, count = list(numbering.strains), numbering.count
        force = balance.residual[self._outer]
        force[self._rim_rank] -= pressure * caps.gradient
        force = np.concatenate([force, self._geometry(state).walls])
        motions = self._geometry(state).motions
        wide = np.zeros((count + numbering.border + 1, len(strains)))  # the last row takes the held
        for image, mine in self._moved:
            m, sign = motions[image], numbering.sign[image]
            rows = numbering.unknown[mine, :3]
            turned = sign * np.einsum("kji,nj->nik", m.turn_rate[strains], force[mine])
            np.add.at(wide, rows, turned)
            at = state.place[self._site[mine]]
            second = m.turn_second[np.ix_(strains, strains)]
            shift = m.shift_second[np.ix_(strains, strains)]
            corner = out.corner[: len(strains), : len(strains)]
            corner += np.einsum("ni,klij,nj->kl", force[mine], second, at, optimize=True)
            corner += np.einsum("ni,kli->kl", force[mine], shift)
        first = slice(0, len(strains))
        out.corner[first, first] -= pressure * caps.second[np.ix_(strains, strains)]
        mixed = -pressure * caps.mixed[..., strains]
        carried = np.einsum("nik,nis->nks", motion[self._rim_rank], mixed)
        np.add.at(wide, numbering.unknown[self._rim_rank], carried)
        out.border[:, first] += wide[:count]
        rest = wide[count:-1]
        out.corner[:, first] += rest
        out.corner[first, :] += rest.T

    def _motion(self, state: CellState, numbering: Numbering) -> np.ndarray:
        """(outer nodes and walls', 3, 7) G of :mod:`.reduce`."""
        seen = self._geometry(state)
        kept = seen.of_nodes.get(numbering.strains)
        if kept is not None:
            return kept
        motion = np.zeros((len(self._site), 3, WIDTH))
        motion[:, :, :3] = np.eye(3)
        motions = seen.motions
        for image, mine in self._moved:
            m: Motion = motions[image]
            motion[mine, :, :3] = numbering.sign[image] * m.rotation
            at = state.place[self._site[mine]]
            motion[mine, :, 3:] = np.einsum("kij,nj->nik", m.turn_rate, at) + m.shift_rate.T
        seen.of_nodes[numbering.strains] = motion
        return motion

    def _condensed_motion(self, state: CellState, numbering: Numbering) -> np.ndarray:
        """G at the state of the tangent last reduced in this numbering; at ``state`` before one
        was."""
        return self._motion(state, numbering) if numbering.motion is None else numbering.motion

    def _geometry(self, state: CellState) -> "_Seen":
        """Motions and caps of a state; kept until another is asked for."""
        if self._seen is None or self._seen.state is not state:
            motions = self.domain.motions(state.strain)
            positions = self.domain.mesh.nodes + state.nodes.displacement
            caps = cap_volume(self._rim, positions, motions[Image.CARRIED], motions[Image.MIDWAY])
            forces, touch = np.empty((0, 3)), Touch()
            if self.walls is not None:
                forces, touch = self.walls.press(self.walls.positions(state.place, motions))
            self._seen = _Seen(state, motions, caps, forces, touch, {})
        return self._seen

    def _blocks(self) -> tuple[Blocks, Blocks]:
        """Of the mesh's tangent and of the walls', last filled."""
        free, walls, nodes = self.free, self.walls, np.arange(len(self._outer))
        mesh = Blocks(free.indptr, free.indices, free.values, nodes, self._site[nodes])
        if walls is None:
            return mesh, NO_BLOCKS
        nodes = len(nodes) + walls.coupled
        return mesh, Blocks(walls.indptr, walls.indices, walls.values, nodes, self._site[nodes])

    def _caps(self, state: CellState) -> CapVolume:
        return self._geometry(state).caps

    def numbering(self, parity: Parity) -> Numbering:
        """The unknowns of this parity; made once."""
        if parity not in self._numberings:
            count = len(self._outer)
            made = number_unknowns(self.domain, self._site, self._image, count, parity)
            lay_out(made, *self._blocks())
            self._numberings[parity] = made
        return self._numberings[parity]


def _folded(forces: np.ndarray, motion: np.ndarray, numbering: Numbering) -> np.ndarray:
    """(count + border,) G^T of forces on the first nodes (n, 3)."""
    unknown = numbering.unknown[: len(forces)]
    local = np.einsum("nik,ni->nk", motion[: len(forces)], forces)
    return np.bincount(
        np.where(unknown < 0, numbering.count + numbering.border, unknown).ravel(),
        weights=local.ravel(), minlength=numbering.count + numbering.border + 1,
    )[:-1]  # fmt: skip
