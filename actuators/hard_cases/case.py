"""What one entry of the catalogue says.

An entry asks one question, of one rung or of several, and says what must come out::

    [[case]]
    name = "nu-exactly-0.5"
    hard = "1 - 2 nu vanishes: nothing may divide by it"
    rungs = ["energy", "fe"]
    slow = ["fe"]                      # rungs left to the long run; true for all
    design = {preset = "slab-rectangle-low", chamber_count = 2, top_material = "...@nu=0.5"}
    scene = {pressure_kPa = {to = 4}, gravity_m_s2 = "none"}
    mesh = "coarse"                    # or accuracy = 0.05; rung fe only
    outcome = "converged"              # or a list of those that are allowed, or {fe = "stalled"}
    refused = "pressure"               # instead: bad input about this field
    says = "Drucker"                   # a note or the advice contains this
    budget = {seconds = 60, iterations = 400, memory_MiB = 3000}
    [[case.check]]
    quantity = "bending_angle_deg"     # of the last point; at = 0 for the first
    value = 12.5                       # or above / below, or like
    tolerance = 0.01
    source = "where the number comes from, or why the tolerance is what it is"

A ``design`` is a preset with changes in border units by plain name, or a whole document with its
``family``. In a ``scene``, "none" stands for null, which TOML has not. ``like`` compares with a
second question: what it changes of the first (``rung``, ``mesh``, ``design``, ``scene``), and
``scaled = {length = 1e-3, modulus = 1e4}`` (the same body in other units, where every answer
follows from dimensional analysis), ``disturbed = 1e-12`` (every length and load, at random),
``shuffled = true`` (nodes and elements in another order), ``threads = 2``. It must end as the case
itself may, or as its ``outcome`` says. ``factor`` multiplies the second answer. Every case is
checked besides for what must hold always, see :mod:`verdict`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from actuators.mechanics.response import Outcome


@dataclass(frozen=True)
class Budget:
    """What a run may take: processor ``seconds``, iterations, memory of the process."""

    seconds: float = 60.0
    iterations: int = 2000
    memory_mib: float = 4000.0


@dataclass(frozen=True)
class Scaling:
    """Other units: every length and every modulus multiplied."""

    length: float = 1.0
    modulus: float = 1.0


@dataclass(frozen=True)
class Variation:
    """What a second question changes of the first. ``outcome``: how it ends; None as the case."""

    rung: str | None = None
    mesh: str | None = None
    design: Mapping[str, Any] = field(default_factory=dict[str, Any])
    scene: Mapping[str, Any] = field(default_factory=dict[str, Any])
    scaled: Scaling | None = None
    disturbed: float = 0.0
    shuffled: bool = False
    threads: int | None = None
    outcome: str | None = None


@dataclass(frozen=True)
class Check:
    """One expectation of a number. ``tolerance`` is a fraction of what is expected, or, with
    ``absolute``, in the quantity's unit."""

    quantity: str
    source: str
    at: int = -1
    value: float | tuple[float, ...] | None = None
    above: float | None = None
    below: float | None = None
    like: Variation | None = None
    factor: float = 1.0
    tolerance: float = 0.0
    absolute: bool = False
    rungs: tuple[str, ...] = ()


@dataclass(frozen=True)
class Case:
    """One question to one rung, and what must come out. ``name`` is unique with the rung."""

    topic: str
    name: str
    rung: str
    hard: str
    design: Mapping[str, Any]
    scene: Mapping[str, Any]
    slow: bool = False
    mesh: str | None = None
    accuracy: float | None = None
    outcomes: tuple[Outcome, ...] = (Outcome.CONVERGED,)
    refused: str = ""
    says: str = ""
    budget: Budget = Budget()
    checks: tuple[Check, ...] = ()

    @property
    def title(self) -> str:
        """``name @ rung``."""
        return f"{self.name} @ {self.rung}"
