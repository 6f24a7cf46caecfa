"""The JSON API: every feature's endpoints under /api."""

from fastapi import APIRouter
from fastapi.routing import APIRoute

from backend.designs.endpoints import router as designs
from backend.effects.endpoints import router as effects
from backend.fabrication.endpoints import router as fabrication
from backend.history.endpoints import router as history
from backend.live.endpoints import router as live
from backend.materials.endpoints import router as materials
from backend.problems import PROBLEMS
from backend.simulations.endpoints import router as simulations
from backend.system.endpoints import router as system
from backend.viewer.endpoints import router as viewer


def operation_name(route: APIRoute) -> str:
    """Operation identifiers are the functions' names, so that generated clients read well."""
    return route.name


def router() -> APIRouter:
    """All endpoints."""
    api = APIRouter(prefix="/api", responses=PROBLEMS)
    for feature in (
        system, designs, materials, simulations, effects, history, fabrication, live, viewer,
    ):  # fmt: skip
        api.include_router(feature)
    return api
