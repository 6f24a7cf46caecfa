"""What a scene may not hold if an input deck is to be made of it.

Apart from the deck's own module, which needs the mesher: the page asks this before it offers one.
"""

from actuators.errors import QuestionError
from actuators.mechanics.scene import Scene


def not_in_a_deck(scene: Scene) -> QuestionError | None:
    """The refusal of a deck of ``scene``, or None where it can be written."""
    if scene.volume_to is not None:
        mend = "Prescribe the pressure that predict --rung fe finds for this volume."
        return QuestionError(
            f"what is inp, and the scene prescribes a volume: CalculiX has no cavity of given "
            f"volume. {mend}",
            field="volume_ml", value="inp", mend=mend,
        )  # fmt: skip
    for name, obstacle in (("plate", scene.plate), ("cylinder", scene.cylinder)):
        if obstacle is not None:
            mend = f"Leave the {name} out, or export vtu."
            return QuestionError(
                f"what is inp, and the scene has a {name}, which a deck does not carry. {mend}",
                field=name, value="inp", mend=mend,
            )  # fmt: skip
    return None
