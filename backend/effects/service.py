"""Plans of effects over HTTP."""

from actuators.mechanics.effects import plan
from backend.designs.question import read_design, read_scene
from backend.effects.schemas import EffectDecisions, EffectsRequest


def decide(body: EffectsRequest) -> EffectDecisions:
    """Read the question and decide."""
    decided = plan(read_design(body.design), read_scene(body.scene), body.accuracy)
    return EffectDecisions.model_validate(decided.to_document())
