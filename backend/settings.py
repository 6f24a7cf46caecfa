"""Settings of the web process, from the environment."""

import getpass
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from storage.deployment import Deployment, deployment

LOOPBACK_NAMES = ("localhost",)
"""Names of the embedded studio; loopback addresses are served besides."""
BUILT_PAGE = Path(__file__).resolve().parent.parent / "frontend" / "dist"


@dataclass(frozen=True)
class Settings:
    """``deployment``: where database, broker and data are. ``author``: who saves; in the embedded
    studio the local account. ``host_names``: names under which the studio may be addressed; any
    other Host is refused, so that a foreign name that leads to this machine gets nothing (DNS
    rebinding). ``page``: folder of the built page."""

    deployment: Deployment
    author: str
    host_names: tuple[str, ...] = LOOPBACK_NAMES
    page: Path = BUILT_PAGE


def from_environment(environment: Mapping[str, str] | None = None) -> Settings:
    """Besides the deployment's: PNEUSTUDIO_HOSTS (names, comma-separated), PNEUSTUDIO_AUTHOR,
    PNEUSTUDIO_PAGE (folder)."""
    env = os.environ if environment is None else environment
    names = [name.strip() for name in env.get("PNEUSTUDIO_HOSTS", "").split(",") if name.strip()]
    page = env.get("PNEUSTUDIO_PAGE")
    return Settings(
        deployment=deployment(env),
        author=env.get("PNEUSTUDIO_AUTHOR") or _local_account(),
        host_names=tuple(names) or LOOPBACK_NAMES,
        page=Path(page) if page else BUILT_PAGE,
    )


def _local_account() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # a container's user may have no name
        return "designer"
