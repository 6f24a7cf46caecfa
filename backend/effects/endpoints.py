"""POST /api/effects."""

from fastapi import APIRouter

from backend.effects import service
from backend.effects.schemas import EffectDecisions, EffectsRequest

router = APIRouter(tags=["simulations"])


@router.post("/effects")
def decide_effects(body: EffectsRequest) -> EffectDecisions:
    """Which physical effects a 3D solve of this question has, decided by the instant models."""
    return service.decide(body)
