"""Every error of the API in one form: what is wrong, with which entry, and how to mend it."""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from pydantic import BaseModel, Field
from starlette.exceptions import HTTPException

from actuators.errors import Change, DesignError, InputError, QuestionError, SceneError
from storage import NotFoundError, StoreAway

Kind = Literal["design", "scene", "question", ""]
AS_ANSWER = "refusal=answer"
"""Value of the header Prefer (RFC 7240) of a client that wants the refusal of its input with status
200: in the same form, and marked by Preference-Applied."""
_KINDS: Mapping[type[InputError], Kind] = {
    DesignError: "design", SceneError: "scene", QuestionError: "question",
}  # fmt: skip


class ProposedChange(BaseModel):
    """A new value of one parameter."""

    field: str = Field(description="The parameter's name in documents, with its unit: length_mm")
    value: float = Field(description="In that unit")


class ProblemDetail(BaseModel):
    """What is wrong."""

    message: str = Field(description="One or two sentences, ready to be shown")
    field: str = Field(description="Name of the offending entry, or empty")
    value: str = Field(description="What was given, in border units, or empty")
    mend: str = Field(description="What to do about it, or empty")
    kind: Kind = Field(
        default="",
        description="What was refused: a design that cannot be built, a scene that cannot be, a "
        "question that this rung or this file cannot answer; empty for anything else",
    )
    changes: list[ProposedChange] = Field(
        default=[], description="Changes of which each by itself mends it, the smallest first"
    )


class Problem(BaseModel):
    """Body of every 4xx and 5xx answer."""

    detail: ProblemDetail


class Busy(Exception):
    """The studio cannot serve this now, but later or after something was closed."""

    def __init__(self, message: str, *, mend: str) -> None:
        super().__init__(message)
        self.mend = mend


PROBLEMS: dict[int | str, dict[str, Any]] = {
    404: {"model": Problem, "description": "There is no such thing"},
    422: {"model": Problem, "description": "Input that cannot be used"},
}


def problem(
    status: int,
    message: str,
    *,
    field: str = "",
    value: str = "",
    mend: str = "",
    kind: Kind = "",
    changes: Sequence[Change] = (),
) -> JSONResponse:
    """The one form of an error answer."""
    proposed = [ProposedChange(field=each.field, value=each.value) for each in changes]
    detail = ProblemDetail(
        message=message, field=field, value=value[:200], mend=mend, kind=kind, changes=proposed
    )
    return JSONResponse(Problem(detail=detail).model_dump(), status_code=status)


def install(app: FastAPI) -> None:
    """Bring every exception to the one form."""

    def on_input(request: Request, error: Exception) -> JSONResponse:
        if not isinstance(error, InputError):
            raise error
        status = 404 if isinstance(error, NotFoundError) else 422
        # what a designer tries on the way is no error of the page's, and browsers log each 4xx
        preferred = status == 422 and request.headers.get("prefer") == AS_ANSWER
        kinds: list[Kind] = [kind for base, kind in _KINDS.items() if isinstance(error, base)]
        answer = problem(
            200 if preferred else status,
            str(error),
            field=error.field,
            value=error.value,
            mend=error.mend,
            kind=kinds[0] if kinds else "",
            changes=error.changes,
        )
        if preferred:
            answer.headers["Preference-Applied"] = AS_ANSWER
        return answer

    def on_validation(_: Request, error: Exception) -> JSONResponse:
        if not isinstance(error, RequestValidationError):
            raise error
        return _of_validation(error)

    def on_busy(_: Request, error: Exception) -> JSONResponse:
        if not isinstance(error, Busy):
            raise error
        return problem(503, str(error), mend=error.mend)

    def on_store_away(_: Request, __: Exception) -> JSONResponse:
        return problem(503, "The studio's database does not answer.", mend="Try again in a moment.")

    def on_http(request: Request, error: Exception) -> JSONResponse:
        if not isinstance(error, HTTPException):
            raise error
        message, mend = str(error.detail), ""
        if error.status_code == 404:
            message = f"There is nothing at {request.url.path}."
            mend = "The API is described at /api/openapi.json."
        elif error.status_code == 405:
            message = f"{request.url.path} does not take {request.method}."
            mend = "The API is described at /api/openapi.json."
        answer = problem(error.status_code, message, mend=mend)
        answer.headers.update(error.headers or {})
        return answer

    def on_crash(_: Request, __: Exception) -> JSONResponse:
        return problem(
            500, "The studio failed to answer; nothing was stored.",
            mend="Try again; the server's log holds the reason.",
        )  # fmt: skip

    app.add_exception_handler(InputError, on_input)
    app.add_exception_handler(RequestValidationError, on_validation)
    app.add_exception_handler(Busy, on_busy)
    app.add_exception_handler(StoreAway, on_store_away)
    app.add_exception_handler(HTTPException, on_http)
    app.add_exception_handler(Exception, on_crash)


def _of_validation(error: RequestValidationError) -> JSONResponse:
    errors = error.errors()
    first = errors[0]
    path = _place(first, error.body)
    field = ".".join(path) or "body"
    given = first.get("input")
    reasons = (str(e["msg"]).rstrip(".") for e in errors if _place(e, error.body) == path)
    reason = "; or: ".join(dict.fromkeys(reasons))
    missing = first["type"] == "missing"
    shown = "" if missing else repr(given)[:120]
    message = f"{field} is missing." if missing else f"{field} is {shown}: {reason}."
    mend = f"Give {field}." if missing else f"Correct {field}; see /api/openapi.json."
    if first["type"] == "extra_forbidden":
        mend = f"Remove {field}."
    return problem(422, message, field=field, value=shown, mend=mend)


def _place(error: Mapping[str, Any], body: Any) -> list[str]:
    """Where in the request an error is. Past the value itself, pydantic names the branch of a union
    that it tried; a caller knows no such place."""
    where, *rest = error["loc"]
    if where != "body":
        inside = rest if where in ("query", "path", "header") else error["loc"]
        return [str(part) for part in inside]
    place, value = [], body
    for part in rest:
        try:
            value = value[part]
        except (TypeError, LookupError):
            if error["type"] == "missing":
                place.append(str(part))
            break
        place.append(str(part))
    return place
