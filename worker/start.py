"""Start of one worker process group."""

import argparse
import logging
import os
import socket
from collections.abc import Sequence

from worker.app import app
from worker.presence import announce


def main(arguments: Sequence[str] | None = None) -> None:
    """``python -m worker [--name NAME] [--concurrency N]``; place of things: see
    ``storage.deployment``."""
    parser = argparse.ArgumentParser(prog="python -m worker", description="Compute queued jobs.")
    parser.add_argument("--name", default=f"worker-{os.getpid()}", help="unique on this machine")
    parser.add_argument("--concurrency", type=int, default=1, help="jobs at once (default 1)")
    chosen = parser.parse_args(arguments)
    logging.basicConfig(
        level=logging.INFO, format="%(asctime)s %(levelname)s %(name)s: %(message)s"
    )
    name = chosen.name if "@" in chosen.name else f"{chosen.name}@{socket.gethostname()}"
    announce(name)
    options = ["--pool=prefork", f"--concurrency={chosen.concurrency}", f"--hostname={name}"]
    options += ["--without-gossip", "--without-mingle", "--without-heartbeat", "-Ofair"]
    app.worker_main(["--quiet", "worker", *options, "--loglevel=INFO"])
