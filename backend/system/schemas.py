"""What the service says of itself."""

from datetime import datetime
from typing import Literal

from pydantic import Field

from backend.documents import Answer


class WorkerState(Answer):
    """Whether a worker has been heard of lately."""

    alive: bool
    last_seen: datetime | None


class Health(Answer):
    """`degraded` means that no worker answers: instant answers work, jobs wait."""

    status: Literal["ok", "degraded"]
    version: str
    page_built: bool = Field(description="Whether the page's files are there")
    worker: WorkerState
