"""GET /api/health."""

from fastapi import APIRouter

from backend.system import service
from backend.system.schemas import Health
from backend.wiring import Config, Storage

router = APIRouter(tags=["system"])


@router.get("/health")
def get_health(store: Storage, settings: Config) -> Health:
    """Whether the service, its database and a worker answer."""
    return service.health(store, settings.page)
