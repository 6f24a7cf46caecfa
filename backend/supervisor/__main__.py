"""``python -m backend.supervisor [--data DIR] [--port N] [--host LOOPBACK] [--workers N]``."""

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from backend.supervisor.address import PORT, NoAddressError, free_port, loopback, url
from backend.supervisor.child import ChildGaveUpError
from backend.supervisor.folder import DataFolder, FolderInUseError
from backend.supervisor.studio import Studio
from storage import NewerDatabaseError
from storage.deployment import deployment


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the studio; 0 after Ctrl-C, 1 when it cannot run, 2 for bad arguments."""
    chosen = _parser().parse_args(arguments)
    if chosen.data is not None:
        os.environ["PNEUSTUDIO_DATA"] = str(chosen.data)
    places = deployment()
    try:
        host = loopback(chosen.host)
        port = free_port(host, chosen.port)
        if chosen.port not in (0, port):
            _say(f"Port {chosen.port} is taken; using {port}.")
        studio = Studio(
            places, DataFolder(places.data), host=host, port=port, workers=chosen.workers,
            address=url(host, port), say=_say,
        )  # fmt: skip
        _say(f"Starting; data in {places.data}")
        studio.run()
    except (NoAddressError, FolderInUseError, ChildGaveUpError, NewerDatabaseError) as error:
        print(f"pneustudio: {error}", file=sys.stderr)
        return 1
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pneustudio serve", description="Run the studio on this machine."
    )
    parser.add_argument("--data", type=Path, help="folder of designs and results")
    parser.add_argument("--port", type=_port, default=PORT, help=f"default {PORT}, or the next")
    parser.add_argument("--host", default="127.0.0.1", help="loopback address to serve on")
    parser.add_argument("--workers", type=_count, default=1, help="worker processes (default 1)")
    return parser


def _port(text: str) -> int:
    port = int(text)
    if not 0 <= port <= 65535:
        raise argparse.ArgumentTypeError(f"port is {port}; use 0 (any) to 65535")
    return port


def _count(text: str) -> int:
    count = int(text)
    if not 1 <= count <= 64:
        raise argparse.ArgumentTypeError(f"workers is {count}; use 1 to 64")
    return count


def _say(line: str) -> None:
    print(f"pneustudio: {line}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
