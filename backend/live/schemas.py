"""What the live channel sends."""

from typing import Literal

from pydantic import Field

from backend.documents import Answer
from backend.simulations.schemas import Job


class LiveEvent(Answer):
    """One message of /api/live and of /api/events.

    `hello` comes first and tells where the channel starts. `job` carries the job as it is now;
    several changes within 0.1 s come as one. `history` says that designs or versions changed.
    `beat` comes every 15 s without news and shows that the channel is alive.
    """

    seq: int = Field(description="Pass as ?after= when connecting again")
    kind: Literal["hello", "job", "history", "beat"]
    job: Job | None = None
    design_id: str | None = Field(default=None, description="Design a history event speaks of")
