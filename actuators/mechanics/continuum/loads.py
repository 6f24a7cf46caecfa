"""What of a scene the three-dimensional solver can carry."""

from actuators.errors import QuestionError
from actuators.mechanics.scene import Scene


def check_loads(scene: Scene) -> None:
    """Refuse what this solver does not compute."""
    missing = {
        "plate": scene.plate is not None,
        "cylinder": scene.cylinder is not None,
        "self_contact": scene.self_contact == "on",
    }
    for name, there in missing.items():
        if there:
            raise QuestionError(
                f"{name} of this scene is not something this version computes: it knows "
                f"pressure, volume, weight, outside pressure and tip force. Leave {name} out.",
                field=name, mend=f"Leave {name} out.",
            )  # fmt: skip
