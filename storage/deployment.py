"""Where a studio keeps its things, as web, worker and supervisor must agree on it.

PNEUSTUDIO_DATA is the folder of an embedded studio; PNEUSTUDIO_DATABASE (SQLAlchemy address) and
PNEUSTUDIO_BROKER (Celery address, ``redis://...`` or ``filesystem:///folder``) default to places
inside it. PNEUSTUDIO_QUEUE names the queue, for studios that share one Redis.
"""

import json
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from actuators.places import data_folder

TASK = "pneustudio.solve"
QUEUE = "pneustudio"
_WRITTEN_S = 0.2  # by then a note that is being written is whole


@dataclass(frozen=True)
class Deployment:
    """``database`` and ``broker`` are addresses, ``data`` the folder."""

    data: Path
    database: str
    broker: str

    @property
    def embedded(self) -> bool:
        """Everything in the data folder: one machine, no server."""
        return self.database.startswith("sqlite") and self.broker.startswith("filesystem")

    @property
    def environment(self) -> dict[str, str]:
        """What child processes need in order to find the same places."""
        return {
            "PNEUSTUDIO_DATA": str(self.data),
            "PNEUSTUDIO_DATABASE": self.database,
            "PNEUSTUDIO_BROKER": self.broker,
        }


def deployment(environment: Mapping[str, str] | None = None) -> Deployment:
    """Read the environment (of this process if None)."""
    env = os.environ if environment is None else environment
    data = data_folder(env)
    queue = (data / "queue").as_uri().replace("file", "filesystem", 1)
    return Deployment(
        data=data,
        database=env.get("PNEUSTUDIO_DATABASE") or f"sqlite:///{data / 'pneustudio.sqlite'}",
        broker=env.get("PNEUSTUDIO_BROKER") or queue,
    )


def celery_settings(broker: str) -> dict[str, Any]:
    """Settings that sender and worker share: ``Celery("pneustudio").conf.update(...)``.

    The task is sent by name: ``app.send_task(TASK, args=[job_id])``. A message only wakes a
    worker; a lost or a doubled one does no harm (see ``storage.claims``).
    """
    settings: dict[str, Any] = {
        "broker_url": broker,
        "task_default_queue": os.environ.get("PNEUSTUDIO_QUEUE") or QUEUE,
        "task_ignore_result": True,
        "task_serializer": "json",
        "accept_content": ["json"],
        "broker_connection_retry_on_startup": True,
    }
    if urlsplit(broker).scheme == "filesystem":
        folder = Path(unquote(urlsplit(broker).path))
        messages, taken, control = folder / "messages", folder / "taken", folder / "control"
        for each in (messages, taken, control):
            each.mkdir(parents=True, exist_ok=True)
        _mend(control)
        settings |= {
            "broker_url": "filesystem://localhost//",
            "broker_transport_options": {
                "data_folder_in": str(messages),
                "data_folder_out": str(messages),
                # taken messages are kept: moving within one folder is atomic, and the
                # alternative is the machine's temporary folder
                "store_processed": True,
                "processed_folder": str(taken),
                "control_folder": str(control),
                "polling_interval": 0.2,
            },
        }
    return settings


def _mend(control: Path) -> None:
    """A process killed while it notes which queues there are leaves half a note, and no later one
    would come past it. Without a note the next one writes it anew."""
    torn = [note for note in control.glob("*.exchange") if not _is_whole(note)]
    if torn:
        time.sleep(_WRITTEN_S)
    for note in torn:
        if not _is_whole(note):
            note.unlink(missing_ok=True)


def _is_whole(note: Path) -> bool:
    try:
        json.loads(note.read_bytes())
    except FileNotFoundError:
        return True
    except ValueError:
        return False
    return True
