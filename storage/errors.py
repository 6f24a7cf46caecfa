"""Requests that the stored data cannot serve."""

from sqlalchemy.exc import OperationalError

from actuators.errors import InputError

# the database is away, locked for too long, or broke the connection: worth trying again
StoreAway = OperationalError


class NotFoundError(InputError):
    """No row has this id; the web answers 404."""

    def __init__(self, what: str, value: str) -> None:
        super().__init__(
            f"There is no {what} {value!r}.",
            field=f"{what}_id", value=value, mend=f"Look the {what} up in the list again.",
        )  # fmt: skip


class HistoryError(InputError):
    """A change that a design's history cannot take."""


class NewerDatabaseError(Exception):
    """The database was written by a newer version of the studio."""
