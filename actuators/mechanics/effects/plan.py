"""Effect by effect, whether the 3D solver needs it, from dimensionless estimates of the instant
rungs.

Several effects left out add up, so they share half of the accuracy asked for: the k effects with
the smallest estimates are left out where each changes the tip by less than a k-th of it. Contact
needs no such trust: what is expected to stay apart is watched, and switched on when it does not.
"""

from collections.abc import Sequence
from dataclasses import replace

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.geometry import build_body
from actuators.mechanics.choices import NAMES, Choice, field_of
from actuators.mechanics.effects.contacts import OBSTACLES, obstacle_contact, self_contact
from actuators.mechanics.effects.decision import Decision, EffectPlan
from actuators.mechanics.effects.expected import Expectations, without
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.effects.words import forced
from actuators.mechanics.scene import Scene
from actuators.quantities import about, percent

BUDGET = 0.5
"""Part of the accuracy asked for that effects left out may cost; the rest is the mesh's."""
COST_FACTORS = {
    "gravity": 1.05, "tip_force": 1.05, "outside_pressure": 1.1, "finite_strain": 4.0,
    "hyperelasticity": 1.0, "inextensible_layer": 1.25, "symmetry": 0.45,
}  # fmt: skip
"""Time of a 3D solve with the effect over the time without (docs/effects.md says how measured)."""
OGDEN_COST = 1.4


def plan(design: Design, scene: Scene, accuracy: float = 0.05) -> EffectPlan:
    """Decisions for ``design`` in ``scene``. ``accuracy``: of the answer, as a fraction.

    Raises :class:`QuestionError` where the scene forces an effect that this design cannot have.
    """
    expected = Expectations(design, scene)
    forecast = expected.of("")
    _refuse_impossible(design, scene, forecast)
    estimated = _estimated(scene, expected)
    threshold = shared_threshold(
        [d.change or 0.0 for d in estimated if scene.choice(d.name) == "auto"], BUDGET * accuracy
    )
    found = {d.name: _decided(d, scene.choice(d.name), threshold) for d in estimated}
    contacts = [self_contact(forecast)]
    contacts += [obstacle_contact(expected.of(name), name) for name in OBSTACLES]
    for contact in contacts:
        found[contact.name] = _chosen(contact, scene.choice(contact.name))
    _settle_finite_strain(found, scene)
    found["volume_control"] = _volume_control(scene)
    settled = without(scene, {name: d.on or d.watched for name, d in found.items()})
    found["symmetry"] = _symmetry(design, settled, scene.choice("symmetry"))
    decisions = tuple(_with_cost(found[name]) for name in NAMES)
    turned = forecast.rotation_share / forecast.travel if forecast.travel > 0.0 else 0.0
    return EffectPlan(design, scene, accuracy, threshold, forecast.pressure, turned, decisions)


def shared_threshold(changes: Sequence[float], budget: float) -> float:
    """Change below which effects are left out so that together they stay within ``budget``."""
    real = sorted(change for change in changes if change > 0.0)
    count = max((n for n, change in enumerate(real, start=1) if change <= budget / n), default=0)
    share = budget / max(count, 1)
    beyond = count < len(real) and real[count] <= share
    return real[count - 1] if beyond else share


def _estimated(scene: Scene, expected: Expectations) -> list[Decision]:
    """Effects that are decided by how much they change the tip; ``on`` says whether they exist."""
    forecast = expected.of("")
    layer = forecast.layer_share
    hyper = forecast.hyperelastic_share
    return [
        _load("gravity", "its own weight", expected, any(scene.gravity or ())),
        _load("outside_pressure", "the pressure outside", expected, scene.outside_pressure != 0.0),
        _load("tip_force", "the force", expected, scene.tip_force is not None),
        Decision(
            "finite_strain", True,
            f"strain reaches {about(forecast.strain)} and one linear solution would miss "
            f"the tip by {about(forecast.finite_strain_share + hyper)} of its way",
            change=forecast.finite_strain_share + hyper,
        ),
        Decision(
            "hyperelasticity", hyper > 0.0,
            f"at a strain of {about(forecast.strain)} the laws differ by {percent(hyper)} "
            "from neo-Hookean ones of the same modulus"
            if hyper > 0.0 else "the materials' laws are neo-Hookean",
            change=hyper,
            cost_factor=OGDEN_COST if hyper > 0.0 and forecast.has_ogden else None,
        ),
        Decision(
            "inextensible_layer", layer is not None,
            "the design has none" if layer is None
            else f"without the layer the tip would move {percent(layer)} otherwise",
            change=layer or 0.0,
        ),
    ]  # fmt: skip


def _with_cost(decision: Decision) -> Decision:
    """Priced by :data:`COST_FACTORS`, where there is something to have."""
    if decision.cost_factor is not None or not (decision.on or decision.change):
        return decision
    return replace(decision, cost_factor=COST_FACTORS.get(decision.name))


def _load(name: str, what: str, expected: Expectations, there: bool) -> Decision:
    if not there:
        return Decision(name, False, "the scene has none", change=0.0)
    change, narrowed = expected.of_load(name)
    way = "the way that obstacles leave it" if narrowed else "its way"
    return Decision(
        name, True, f"{what} moves the tip by {percent(change)} of {way}", change=change
    )


def _decided(estimate: Decision, choice: Choice, threshold: float) -> Decision:
    """An estimate held against the threshold, or the scene's own choice."""
    if not estimate.on:  # there is nothing to leave out
        return replace(estimate, forced=choice)
    if choice != "auto":
        return forced(estimate, choice)
    change = estimate.change or 0.0
    if change <= threshold:
        reason = f"{estimate.reason}, less than the {percent(threshold)} that may be left out"
        return replace(estimate, on=False, reason=reason)
    reason = f"{estimate.reason}, more than the {percent(threshold)} that may be left out"
    return replace(estimate, reason=reason)


def _chosen(contact: Decision, choice: Choice) -> Decision:
    if choice == "auto" or (choice == "off" and not (contact.on or contact.watched)):
        return replace(contact, forced=choice)
    return replace(forced(contact, choice), watched=False)


def _settle_finite_strain(found: dict[str, Decision], scene: Scene) -> None:
    """One linear solution knows neither contact nor a law's curve."""
    finite = found["finite_strain"]
    contacts = ("self_contact", *OBSTACLES)
    if finite.on:
        return
    touching = [name for name in contacts if found[name].on]
    if finite.forced == "auto" and touching:
        reason = f"{touching[0].replace('_', ' ')} is no linear problem"
        found["finite_strain"] = replace(finite, on=True, reason=reason)
        return
    by_linear = "the linear solution has no use for it"
    for name in (*contacts, "hyperelasticity"):
        if found[name].on:
            found[name] = replace(found[name], on=False, reason=by_linear)
        if finite.forced == "off":
            found[name] = replace(found[name], watched=False)


def _volume_control(scene: Scene) -> Decision:
    by_volume = scene.volume_to is not None
    reason = "a volume ends the path" if by_volume else "a pressure ends the path"
    return Decision("volume_control", by_volume, reason, forced=scene.choice("volume_control"))


def _symmetry(design: Design, scene: Scene, choice: Choice) -> Decision:
    possible = build_body(design).symmetric and scene.symmetric
    half = "body and loads are their own mirror images: half of the body is computed"
    if possible:
        decision = Decision("symmetry", True, half, change=0.0)
        if choice == "off":
            return replace(
                decision, on=False, forced=choice, reason="the whole body is computed by choice"
            )
        return replace(decision, forced=choice)
    what = "a load or an obstacle is" if build_body(design).symmetric else "the body is"
    reason = f"{what} not its own mirror image: the whole body is computed"
    if choice == "on":
        raise _impossible("symmetry", reason)
    return Decision("symmetry", False, reason, forced=choice)


def _refuse_impossible(design: Design, scene: Scene, forecast: Forecast) -> None:
    if scene.choice("inextensible_layer") == "on" and forecast.layer_share is None:
        raise _impossible("inextensible_layer", f"this {design.family} design has no such layer")


def _impossible(name: str, why: str) -> QuestionError:
    mend = f"Leave {name} to 'auto'."
    return QuestionError(
        f"{name.replace('_', ' ')} is switched on, but {why}. {mend}",
        field=field_of(name), value="on", mend=mend,
    )  # fmt: skip
