"""Documents and identifiers that several features carry."""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field


class Body(BaseModel):
    """A request body: closed, no NaN or Infinity."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class Answer(BaseModel):
    """A response body. Every field is always present; what is not known is null."""

    model_config = ConfigDict(
        json_schema_serialization_defaults_required=True, validate_by_name=True,
        validate_by_alias=True,
    )  # fmt: skip


DesignDocument = Annotated[
    dict[str, Any],
    Field(
        description="A design: `family` and its parameters in border units, each named with its "
        "unit (`bottom_thickness_mm`, `theta_deg`), as GET /api/families lists them as "
        "`border_name`. Missing entries take the family's defaults."
    ),
]
SceneDocument = Annotated[
    dict[str, Any],
    Field(
        description="A scene: `pressure_kPa`: {`to`: kPa, `steps`: whole number or 'auto'}; "
        "`gravity_m_s2`: three numbers [m/s2] or null, [0, 0, -9.81] when left out.",
        examples=[{"pressure_kPa": {"to": 40, "steps": 20}, "gravity_m_s2": [0, 0, -9.81]}],
    ),
]
Name = Annotated[str, Field(min_length=1, max_length=200, pattern=r"\S")]
Note = Annotated[str, Field(max_length=2000)]
Point = Annotated[list[float], Field(min_length=2, max_length=2, description="[mm, mm]")]
Triple = Annotated[list[float | None], Field(min_length=3, max_length=3)]
