"""Patch test: with its surface displaced linearly, a distorted block strains uniformly inside."""

import math
from dataclasses import replace

import numpy as np
import pytest

from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import mesh_body
from tests.actuators.continuum.boxes import LAWS, block, rubber, skewed

GRADIENT = np.array([[1.15, 0.1, 0.0], [-0.05, 0.93, 0.12], [0.08, 0.0, 1.02]])


@pytest.mark.parametrize("volume", [1.0, 1.002], ids=["same volume", "growing"])
@pytest.mark.parametrize("name", LAWS)
def test_uniform_strain_is_found_to_the_last_digits(name: str, volume: float) -> None:
    # a volume that grows has an answer for finite kappa only
    ratios = (1e3, math.inf) if volume == 1.0 else (1e3,)
    gradient = GRADIENT * (volume / np.linalg.det(GRADIENT)) ** (1 / 3)
    mesh = mesh_body(block(skewed, cavity=False))
    exact = mesh.nodes @ (gradient - np.eye(3)).T
    free = np.ones_like(mesh.nodes, dtype=bool)
    free[mesh.outer_faces.nodes] = False
    for ratio in ratios:
        material = replace(rubber(LAWS[name]), bulk_to_shear=ratio)
        system = ContinuumSystem(mesh, [material], free=free)
        start = exact + 1e-5 * np.random.default_rng(4).standard_normal(exact.shape) * free
        found = solve_equilibrium(
            system,
            open_solver(system.indptr, system.indices),
            State(start, system.rest().pressure),
            Target(0.0),
            tolerance=1e-12,
            most_iterations=30,
        )
        assert isinstance(found, Equilibrium)
        assert system.unknowns == 3 * (np.count_nonzero(free[:, 0]) - len(mesh.elements))
        assert np.abs(found.state.displacement - exact).max() < 1e-10 * np.abs(exact).max()
        # one pressure everywhere, but for the constant that incompressible rubber leaves open
        pressure = found.state.pressure
        spread = np.ptp(pressure[:, 0]) + np.abs(pressure[:, 1:]).max()
        assert spread < 1e-7 * max(material.shear_modulus, np.abs(pressure).max())
