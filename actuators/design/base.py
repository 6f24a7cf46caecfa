"""The base of all families: frozen, closed, hashable, in SI; documents carry border units."""

import hashlib
import json
import math
from collections.abc import Mapping
from typing import Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, ValidationError

from actuators.design.parameter import Parameter, describe
from actuators.errors import Change, DesignError


class Design(BaseModel):
    """Parameters of one actuator, in SI. Built by a family's class, :meth:`from_document`, or
    :func:`actuators.design.parse_design` when the family is not known beforehand.

    Raises :class:`DesignError` for a value out of its limits or an impossible combination.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False, allow_inf_nan=False)
    title: ClassVar[str] = ""
    layer_materials: ClassVar[tuple[str, str]] = ("bottom_material", "top_material")
    """Parameters that name the material of the bottom layer and of what stands on it."""

    family: str
    length: float

    def model_post_init(self, context: Any, /) -> None:
        for p in self.parameters():
            _check_limits(p, getattr(self, p.name))
        self.check()

    def check(self) -> None:
        """Raise :class:`DesignError` for an impossible combination of parameters."""

    @classmethod
    def parameters(cls) -> tuple[Parameter, ...]:
        """Every parameter, in the order a designer reads them."""
        return tuple(describe(n, f) for n, f in cls.model_fields.items() if n != "family")

    @classmethod
    def from_document(cls, document: Mapping[str, Any]) -> Self:
        """Read a document in border units (``length_mm``, ``theta_deg``); missing entries take
        the family's defaults."""
        known = {p.border_name: p for p in cls.parameters()}
        values: dict[str, Any] = {}
        for key, value in document.items():
            if key == "family":
                values["family"] = value
                continue
            if key not in known:
                raise _unknown(key, value, known)
            values[known[key].name] = _to_si(known[key], value)
        try:
            return cls(**values)
        except ValidationError as error:
            raise _translate(error) from error

    def to_document(self) -> dict[str, Any]:
        """Document in border units; the inverse of :meth:`from_document`."""
        document: dict[str, Any] = {"family": self.family}
        for p in self.parameters():
            value = getattr(self, p.name)
            if p.kind in ("length", "angle", "ratio"):
                # 12 digits: mm <-> m must not leave 7.300000000000001 behind
                value = float(f"{value / p.si_per_unit:.12g}")
            document[p.border_name] = value
        return document

    def changed(self, **border_values: Any) -> Self:
        """Copy with parameters replaced, given in border units by plain name."""
        document = self.to_document()
        known = {p.name: p for p in self.parameters()}
        for name, value in border_values.items():
            if name not in known:
                raise _unknown(name, value, known)
            document[known[name].border_name] = value
        return self.from_document(document)

    @property
    def digest(self) -> str:
        """sha256 of the document: equal for equal designs on every machine."""
        text = json.dumps(self.to_document(), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()

    def assumptions(self) -> tuple[str, ...]:
        """Dimensions that no source gives, as sentences."""
        return tuple(p.assumed for p in self.parameters() if p.assumed)


def _to_si(p: Parameter, value: Any) -> Any:
    if p.kind in ("choice", "material"):
        return value
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        unit = f" in {p.unit}" if p.unit else ""
        raise DesignError(
            f"{p.name} is {value!r}; it must be a finite number{unit}.",
            field=p.name, value=repr(value), mend=f"Give {p.name} as a number{unit}.",
        )  # fmt: skip
    if p.kind == "count":
        if value != int(value):
            raise DesignError(
                f"{p.name} is {value}; it must be a whole number.",
                field=p.name, value=str(value), mend=f"Use {round(value)}.",
            )  # fmt: skip
        return int(value)
    return value * p.si_per_unit


def _check_limits(p: Parameter, value: Any) -> None:
    if p.choices and value not in p.choices:
        raise DesignError(
            f"{p.name} is {value!r}, which is not one of {', '.join(p.choices)}.",
            field=p.name, value=str(value), mend=f"Choose one of {', '.join(p.choices)}.",
        )  # fmt: skip
    if p.kind in ("choice", "material"):
        return
    border = value / p.si_per_unit
    slack = 1e-9 * max(abs(border), 1.0)
    unit = f" {p.unit}" if p.unit else ""
    if p.lower is not None and border < p.lower - slack:
        raise DesignError(
            f"{p.name} is {border:.10g}{unit}, below its limit of {p.lower:g}{unit}.",
            field=p.name, value=f"{border:.10g}{unit}",
            mend=f"Raise {p.name} to {p.lower:g}{unit} or more.",
            changes=(Change(p.border_name, p.lower),),
        )  # fmt: skip
    if p.upper is not None and border > p.upper + slack:
        raise DesignError(
            f"{p.name} is {border:.10g}{unit}, above its limit of {p.upper:g}{unit}.",
            field=p.name, value=f"{border:.10g}{unit}",
            mend=f"Lower {p.name} to {p.upper:g}{unit} or less.",
            changes=(Change(p.border_name, p.upper),),
        )  # fmt: skip


def _unknown(key: str, value: Any, known: Mapping[str, Parameter]) -> DesignError:
    import difflib

    near = difflib.get_close_matches(key, known, n=1)
    hint = f"Did you mean {near[0]}?" if near else f"Known: {', '.join(sorted(known))}."
    return DesignError(
        f"{key} is not a parameter of this family. {hint}",
        field=key, value=repr(value), mend=hint,
    )  # fmt: skip


def _translate(error: ValidationError) -> DesignError:
    first = error.errors()[0]
    field = str(first["loc"][0]) if first["loc"] else "design"
    if first["type"] == "literal_error":
        choices = str(first.get("ctx", {}).get("expected", ""))
        return DesignError(
            f"{field} is {first['input']!r}, which is no choice. Use {choices}.",
            field=field, value=repr(first["input"]), mend=f"Use {choices}.",
        )  # fmt: skip
    return DesignError(
        f"{field} is {first['input']!r}: {first['msg']}.",
        field=field, value=repr(first["input"]), mend=f"{first['msg']}.",
    )  # fmt: skip
