"""Which physical effects a question calls for, decided by the instant rungs before any 3D solve."""

from actuators.mechanics.effects.afterwards import checked
from actuators.mechanics.effects.decision import Decision, EffectPlan
from actuators.mechanics.effects.forecast import without_layer
from actuators.mechanics.effects.plan import plan

__all__ = ["Decision", "EffectPlan", "checked", "plan", "without_layer"]
