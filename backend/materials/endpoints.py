"""GET /api/materials."""

from fastapi import APIRouter

from backend.materials import service
from backend.materials.schemas import MaterialInfo

router = APIRouter(tags=["materials"])


@router.get("/materials")
def list_materials() -> list[MaterialInfo]:
    """The catalogue of materials with their sources."""
    return service.catalogue()
