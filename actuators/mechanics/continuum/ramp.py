"""The loads of a scene, all raised together by one share before anything is inflated."""

from actuators.mechanics.continuum.newton import Equilibrium, Target
from actuators.mechanics.continuum.prediction import growth
from actuators.mechanics.continuum.system import State
from actuators.mechanics.continuum.tracer import Tracer
from actuators.mechanics.response import Outcome

SMALLEST_SHARE = 1 / 256


def apply_loads(tracer: Tracer) -> Equilibrium | None:
    """State under its loads at zero pressure, in shares small enough to turn by."""
    rest = tracer.system.rest()
    states: list[tuple[float, State]] = [(0.0, rest)]
    step = _first_share(tracer)
    while True:
        done = states[-1][0]
        share = done + step if done + 1.2 * step < 1.0 else 1.0
        start = states[-1][1]
        if len(states) > 1:
            (earlier, before), (_, last) = states[-2:]
            start = tracer.system.onward(before, last, (share - done) / (done - earlier))
        result = tracer.solve(start, Target(0.0, loads=share))
        if isinstance(result, Equilibrium):
            if share == 1.0:
                return result
            states.append((share, result.state))
            step = (share - done) * growth(result.iterations)
        elif tracer.stopped():
            return None
        else:
            step = (share - done) / 2
            if step < SMALLEST_SHARE:
                tracer.path.outcome = Outcome.STALLED
                tracer.path.reason = f"weight and outer loads beyond {done:.0%}: {result.reason}"
                return None


def _first_share(tracer: Tracer) -> float:
    """Share whose linear answer is a small move."""
    system = tracer.system
    balance = system.linearise(system.rest(), 0.0)
    system.factorize(tracer.solver)
    tracer.path.iterations += 1
    return min(1.0, tracer.share_of_first_move(tracer.solver.solve(-system.reduce(balance))))
