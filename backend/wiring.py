"""What endpoints are handed: the store, the queue, the rooms, the feed, who is asking."""

from typing import Annotated

from fastapi import Depends
from starlette.requests import HTTPConnection

from backend.live.feed import EventFeed
from backend.settings import Settings
from backend.simulations.aside import Aside
from backend.simulations.queue import TaskQueue
from backend.viewer.rooms import RoomKeeper
from storage import Store


def _store(connection: HTTPConnection) -> Store:
    return connection.app.state.store


def _settings(connection: HTTPConnection) -> Settings:
    return connection.app.state.settings


def _author(connection: HTTPConnection) -> str:
    return _settings(connection).author


def _queue(connection: HTTPConnection) -> TaskQueue:
    return connection.app.state.queue


def _aside(connection: HTTPConnection) -> Aside:
    return connection.app.state.aside


def _rooms(connection: HTTPConnection) -> RoomKeeper:
    return connection.app.state.rooms


def _feed(connection: HTTPConnection) -> EventFeed:
    return connection.app.state.feed


Config = Annotated[Settings, Depends(_settings)]
Storage = Annotated[Store, Depends(_store)]
Author = Annotated[str, Depends(_author)]
Queue = Annotated[TaskQueue, Depends(_queue)]
Helper = Annotated[Aside, Depends(_aside)]
Rooms = Annotated[RoomKeeper, Depends(_rooms)]
Feed = Annotated[EventFeed, Depends(_feed)]
