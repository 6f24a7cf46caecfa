"""What the fabrication feature takes and gives."""

from typing import Literal

from pydantic import Field

from backend.documents import Answer, Body, DesignDocument, Name, SceneDocument

ExportKind = Literal["mould-svg", "actuator-stl", "inp"]
ResultKind = Literal["result-body", "result-vtu", "result-json", "result-csv"]
FileKind = Literal[ExportKind, ResultKind]


class FileInfo(Answer):
    """A file that can be downloaded, or why it cannot."""

    what: FileKind
    title: str
    file_name: str
    media_type: str
    url: str = Field(description="Address to download it from")
    available: bool
    reason: str | None = Field(description="Why it is not available")


class ExportRequest(Body):
    """A file of a design that is not saved."""

    design: DesignDocument
    what: ExportKind
    scene: SceneDocument | None = Field(
        default=None, description="What the model is loaded by; needed for inp"
    )
    name: Name = Field(default="actuator", description="Stem of the file's name")
