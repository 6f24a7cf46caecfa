"""Where the page is served: a loopback address and a free port."""

import http.client
import ipaddress
import socket
import time
import urllib.error
import urllib.request
from collections.abc import Callable

PORT = 8000
_PORTS_TRIED = 50


class NoAddressError(Exception):
    """The page cannot be served there."""


def loopback(host: str) -> str:
    """``host`` if it is this machine alone. There are no accounts yet: nobody else may get in."""
    try:
        fine = host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        fine = False
    if not fine:
        raise NoAddressError(
            f"--host is {host!r}, but this studio has no accounts and answers this machine only. "
            "Use 127.0.0.1; to reach it from elsewhere, forward the port over SSH."
        )
    return host


def free_port(host: str, wanted: int) -> int:
    """``wanted``, or the next port that nobody listens on; 0 takes any."""
    last = wanted + _PORTS_TRIED - 1
    for port in range(wanted, min(last, 65535) + 1):
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        with socket.socket(family, socket.SOCK_STREAM) as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind((host, port))
            except PermissionError as error:
                raise NoAddressError(
                    f"--port is {port}, which this account may not use. Use 1024 or higher."
                ) from error
            except OSError:
                continue
            return probe.getsockname()[1]
    raise NoAddressError(f"Ports {wanted} to {last} are all taken. Give a free one with --port.")


def url(host: str, port: int) -> str:
    """Address of the page."""
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def answers(address: str, *, timeout_s: float, meanwhile: Callable[[], bool]) -> bool:
    """Wait until the web process answers; ``meanwhile`` returns False to stop waiting."""
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline and meanwhile():
        try:
            with opener.open(f"{address}/api/health", timeout=2) as reply:
                if reply.status == 200:
                    return True
        except (urllib.error.URLError, OSError, http.client.HTTPException):
            # a free port may also connect to itself, and hand the question back
            time.sleep(0.05)
    return False
