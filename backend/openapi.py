"""Write openapi.json, from which the page's client is generated: ``python -m backend.openapi``."""

import json
from pathlib import Path
from typing import Any

from fastapi import FastAPI

from actuators import __version__
from backend import api

PATH = Path(__file__).resolve().parent.parent / "openapi.json"


def document() -> dict[str, Any]:
    """The OpenAPI document of the API."""
    app = FastAPI(
        title="Pneustudio",
        version=__version__,
        summary="Design studio for pneumatic soft actuators",
        generate_unique_id_function=api.operation_name,
    )
    app.include_router(api.router())
    return app.openapi()


def text() -> str:
    """What belongs into openapi.json."""
    return json.dumps(document(), indent=1, sort_keys=True) + "\n"


if __name__ == "__main__":
    PATH.write_text(text())
