"""Requests that the stored data cannot serve."""

from actuators.errors import InputError


class NotFoundError(InputError):
    """No row has this id; the web answers 404."""

    def __init__(self, what: str, value: str) -> None:
        super().__init__(
            f"There is no {what} {value!r}.",
            field=f"{what}_id", value=value, mend=f"Look the {what} up in the list again.",
        )  # fmt: skip


class HistoryError(InputError):
    """A change that a design's history cannot take."""
