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
        description="What loads and surrounds an actuator. One of `pressure_kPa` and `volume_ml`: "
        "{`to`: end of the path, `steps`: whole number or 'auto'}; a pressure below 0 is suction, "
        "a volume is the whole cavity's. `gravity_m_s2`: three numbers or null, [0, 0, -9.81] when "
        "left out. `outside_pressure_kPa` acts on the underside. `tip_force_N`: three numbers, a "
        "dead load on the free end. Rigid and frictionless: `plate`: {`gap_mm`, `normal`: from the "
        "plate to the actuator}, `cylinder`: {`radius_mm`, `centre_mm`, `axis`}. `effects`: "
        "'auto', 'on' or 'off' by name, as POST /api/effects lists them; 'auto' when left out.",
        examples=[
            {"pressure_kPa": {"to": 40, "steps": 20}, "gravity_m_s2": [0, 0, -9.81]},
            {"volume_ml": {"to": 40}, "plate": {"gap_mm": 5, "normal": [0, 0, 1]}},
        ],
    ),
]
Name = Annotated[str, Field(min_length=1, max_length=200, pattern=r"\S")]
Note = Annotated[str, Field(max_length=2000)]
Point = Annotated[list[float], Field(min_length=2, max_length=2, description="[mm, mm]")]
Triple = Annotated[list[float | None], Field(min_length=3, max_length=3)]
