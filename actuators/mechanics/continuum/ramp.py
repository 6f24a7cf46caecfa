"""The loads of a scene, all raised together by one share before anything is inflated."""

from actuators.mechanics.continuum.newton import Equilibrium, Target
from actuators.mechanics.continuum.prediction import growth
from actuators.mechanics.continuum.system import State
from actuators.mechanics.continuum.tracer import Tracer
from actuators.mechanics.response import Outcome

SMALLEST_SHARE = 1 / 256
SMALLEST_OF_FIRST = 1 / 16
"""Of the first share where that is smaller still: a very floppy body begins with a thousandth."""


def apply_loads(tracer: Tracer) -> Equilibrium:
    """State under its loads at zero pressure, in shares small enough to turn by. Where the whole of
    them cannot be put on, the last state found, at worst the undeformed one: the path's ``loads``
    says under what share of them it is, its outcome why. On the way everything is passable."""
    rest = tracer.system.rest()
    volume, _ = tracer.system.volume(rest)
    found = Equilibrium(rest, 0.0, volume, 0, None)
    states: list[tuple[float, State]] = [(0.0, rest)]
    step = _first_share(tracer)
    smallest = min(SMALLEST_SHARE, SMALLEST_OF_FIRST * step)
    while True:
        done = states[-1][0]
        share = done + step if done + 1.2 * step < 1.0 else 1.0
        start = states[-1][1]
        if len(states) > 1:
            (earlier, before), (_, last) = states[-2:]
            start = tracer.system.onward(before, last, (share - done) / (done - earlier))
        result = tracer.solve(start, Target(0.0, loads=share), passable=True)
        if isinstance(result, Equilibrium):
            if share == 1.0:
                return result
            found = result
            states.append((share, result.state))
            step = (share - done) * growth(result.iterations)
        elif tracer.stopped():
            tracer.path.loads = done
            return found
        else:
            step = (share - done) / 2
            if step < smallest:
                tracer.path.outcome = Outcome.STALLED
                tracer.path.reason = f"weight and outer loads beyond {done:.0%}: {result.reason}"
                tracer.path.loads = done
                return found


def _first_share(tracer: Tracer) -> float:
    """Share whose linear answer is a small move."""
    system = tracer.system
    balance = system.linearise(system.rest(), 0.0)
    system.factorize(tracer.solver)
    tracer.path.iterations += 1
    return min(1.0, tracer.share_of_first_move(tracer.solver.solve(-system.reduce(balance))))
