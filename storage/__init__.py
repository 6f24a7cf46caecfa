"""The database behind the studio: the only room that knows SQLAlchemy."""

from storage.body_files import BodyFiles
from storage.errors import HistoryError, NewerDatabaseError, NotFoundError, StoreAway
from storage.parts import Part
from storage.rows import (
    ClaimedJob,
    DesignRow,
    EventRow,
    Hold,
    JobRow,
    JobState,
    ResultRow,
    TimingRow,
    VersionRow,
    WorkerRow,
)
from storage.store import Store, open_store

__all__ = [
    "BodyFiles", "ClaimedJob", "DesignRow", "EventRow", "HistoryError", "Hold", "JobRow",
    "JobState", "NewerDatabaseError", "NotFoundError", "Part", "ResultRow", "Store", "StoreAway",
    "TimingRow", "VersionRow", "WorkerRow", "open_store",
]  # fmt: skip
