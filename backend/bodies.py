"""What a request may carry: JSON of sane size that means the same everywhere.

Python's reader takes NaN, Infinity, 1e999, lone surrogates and nesting without end; none of them
may reach the science, the database or an answer.
"""

import json
from typing import Any

from starlette.datastructures import Headers
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from backend.problems import problem

LARGEST_BODY = 1_000_000
LARGEST_NUMBER = 1e30
DEEPEST = 32


class BodyGuard:
    """Reads the body once, refuses what cannot be used, and hands the rest on unchanged."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http" or scope["method"] in ("GET", "HEAD", "OPTIONS"):
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        body = await _read(headers, receive)
        if body is None:
            await _too_large()(scope, receive, send)
            return
        refusal = _refusal(body, headers.get("content-type", ""))
        if refusal is not None:
            await refusal(scope, receive, send)
            return
        await self.app(scope, _replay(body, receive), send)


async def _read(headers: Headers, receive: Receive) -> bytes | None:
    declared = headers.get("content-length", "0")
    if not declared.isdigit() or int(declared) > LARGEST_BODY:
        return None
    chunks: list[bytes] = []
    size = 0
    while True:
        message = await receive()
        if message["type"] != "http.request":  # the client went away
            return b"".join(chunks)
        chunk = message.get("body", b"")
        size += len(chunk)
        if size > LARGEST_BODY:
            return None
        chunks.append(chunk)
        if not message.get("more_body", False):
            return b"".join(chunks)


def _replay(body: bytes, receive: Receive) -> Receive:
    pending = True

    async def replay() -> Message:
        nonlocal pending
        if pending:
            pending = False
            return {"type": "http.request", "body": body, "more_body": False}
        return await receive()

    return replay


def _too_large() -> JSONResponse:
    return problem(
        413, f"The request is larger than {LARGEST_BODY // 1000} kB.", field="body",
        mend="Send less; a design and a scene need a few kB.",
    )  # fmt: skip


def _refusal(body: bytes, content_type: str) -> JSONResponse | None:
    if not body:
        return None
    kind = content_type.partition(";")[0].strip().lower()
    if kind != "application/json":
        return problem(
            415, f"The body is {kind or 'of no stated type'}; it must be JSON.",
            field="content-type", value=kind, mend="Send Content-Type: application/json.",
        )  # fmt: skip
    try:
        document = json.loads(body, parse_constant=_no_constant)
        _check(document, DEEPEST)
    except UnicodeDecodeError:
        return _malformed("The body is not UTF-8.")
    except RecursionError:
        return _malformed(f"The body is nested deeper than {DEEPEST} levels.")
    except ValueError as error:
        return _malformed(f"The body cannot be used as JSON: {error}.")
    return None


def _malformed(message: str) -> JSONResponse:
    return problem(422, message, field="body", mend="Send valid JSON.")


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number JSON knows; use null for what is not known")


def _check(value: Any, depth: int) -> None:
    if depth == 0:
        raise ValueError(f"it is nested deeper than {DEEPEST} levels")
    if isinstance(value, str):
        _check_text(value)
    elif isinstance(value, int | float) and not abs(value) <= LARGEST_NUMBER:
        raise ValueError(f"a number is larger than {LARGEST_NUMBER:g}")
    elif isinstance(value, list):
        for entry in value:
            _check(entry, depth - 1)
    elif isinstance(value, dict):
        for key, entry in value.items():
            _check_text(key)
            _check(entry, depth - 1)


def _check_text(text: str) -> None:
    if "\x00" in text:
        raise ValueError("a text holds a NUL character")
    if any("\ud800" <= character <= "\udfff" for character in text):
        raise ValueError("a text holds half of a surrogate pair")
