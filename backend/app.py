"""The web process: ``uvicorn --factory backend.app:create_app``."""

import asyncio
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager

from fastapi import FastAPI

from actuators import __version__
from backend import api, page, problems
from backend.bodies import BodyGuard
from backend.guards import Guard
from backend.live.feed import EventFeed
from backend.settings import Settings, from_environment
from backend.simulations.aside import Aside
from backend.simulations.instant import warm
from backend.simulations.past_jobs import read_record
from backend.simulations.queue import TaskQueue
from backend.viewer import front
from backend.viewer.rooms import RoomKeeper
from storage import open_store


def create_app(settings: Settings | None = None) -> FastAPI:
    """The application; settings come from the environment when left out."""
    chosen = settings or from_environment()
    app = FastAPI(
        title="Pneustudio",
        version=__version__,
        lifespan=_life,
        openapi_url="/api/openapi.json",
        docs_url=None,
        redoc_url=None,
        generate_unique_id_function=api.operation_name,
    )
    app.state.settings = chosen
    problems.install(app)
    app.add_middleware(BodyGuard)
    app.add_middleware(Guard, host_names=chosen.host_names)
    app.include_router(api.router())
    app.include_router(front.router())
    app.include_router(page.router(chosen.page))
    return app


@asynccontextmanager
async def _life(app: FastAPI) -> AsyncGenerator[None]:
    settings: Settings = app.state.settings
    store = open_store(settings.deployment.database)
    await asyncio.to_thread(store.migrate)
    queue = TaskQueue(settings.deployment.broker)
    feed = EventFeed(store)
    rooms = RoomKeeper()
    aside = Aside()
    app.state.store, app.state.queue = store, queue
    app.state.feed, app.state.rooms, app.state.aside = feed, rooms, aside
    await feed.start()
    tasks = [
        asyncio.create_task(queue.keep_publishing(store)),
        asyncio.create_task(rooms.keep_sweeping()),
        asyncio.create_task(asyncio.to_thread(warm)),
        asyncio.create_task(asyncio.to_thread(read_record)),
    ]
    try:
        yield
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await feed.stop()
        await asyncio.to_thread(rooms.close)
        await asyncio.to_thread(aside.close)
        queue.close()
        store.close()
