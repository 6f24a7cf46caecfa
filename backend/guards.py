"""Who may ask: only under our own name, only from our own pages. And what answers carry.

The embedded studio has no login, so a foreign page in the same browser must get nothing: a Host
that is not ours is refused (DNS rebinding), and so is every unsafe request and every websocket
whose Origin is not the address it was sent to.
"""

import ipaddress
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from backend.problems import problem

SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
PAGE_POLICY = (
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self'; frame-src 'self'; "
    "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'"
)
API_POLICY = "default-src 'none'; frame-ancestors 'none'"
ANSWER_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
}


class Guard:
    """Host and Origin checks, security headers."""

    def __init__(self, app: ASGIApp, host_names: tuple[str, ...]) -> None:
        self.app = app
        self.host_names = frozenset(name.lower() for name in host_names)
        self.embedded = "localhost" in self.host_names

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        reason = self._refusal(scope)
        if scope["type"] == "websocket":
            if reason:
                await receive()
                await send({"type": "websocket.close", "code": 1008, "reason": reason})
            else:
                await self.app(scope, receive, send)
            return
        answer = _with_headers(send, scope["path"])
        if reason:
            mend = "Open the studio under the address it printed."
            await problem(403, reason, field="origin", mend=mend)(scope, receive, answer)
        else:
            await self.app(scope, receive, answer)

    def _is_ours(self, name: str) -> bool:
        return name in self.host_names or (self.embedded and _is_loopback(name))

    def _refusal(self, scope: Scope) -> str:
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        if not self._is_ours(_host_name(host)):
            return "The studio does not answer under this host name."
        if scope["type"] == "http" and scope["method"] in SAFE_METHODS:
            return ""
        origin = headers.get("origin")
        if origin is not None and not is_own_origin(origin, host):
            return "A page of another origin may not use the studio."
        if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
            return "A page of another site may not use the studio."
        return ""


def _is_loopback(name: str) -> bool:
    """An address of this machine itself; no name server can make another name look like it."""
    try:
        return ipaddress.ip_address(name).is_loopback
    except ValueError:
        return False


def is_own_origin(origin: str, host: str) -> bool:
    """Whether ``Origin`` is the address that the request was sent to (its ``Host``)."""
    parts = urlsplit(origin)
    return parts.scheme in ("http", "https") and parts.netloc.lower() == host.lower()


def _host_name(host: str) -> str:
    """Name without the port: ``localhost:8000`` and ``[::1]:8000``."""
    host = host.strip().lower()
    if host.startswith("["):
        return host[1:].partition("]")[0]
    return host.rpartition(":")[0] or host


def _with_headers(send: Send, path: str) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in ANSWER_HEADERS.items():
                headers.setdefault(name, value)
            is_api = path.startswith("/api/")
            headers.setdefault("Content-Security-Policy", API_POLICY if is_api else PAGE_POLICY)
            if is_api:
                headers.setdefault("Cache-Control", "no-store")
        await send(message)

    return sending
