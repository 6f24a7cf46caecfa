"""The only module that touches viser's private names; the version is pinned, and a test holds it.

viser has no authentication. Its server listens on loopback, every connection must bring the room's
key in a header (which no page in a browser can send), and its share tunnel is taken out.
"""

import secrets
import warnings
from importlib.resources import files

import rich
import viser
import viser.infra
from viser import _messages

PINNED = "1.1.1"
KEY_HEADER = "X-Pneustudio-Room"
SUBPROTOCOL = f"viser-v{PINNED}"


# viser announces every server and its end on the console; rooms come and go by the minute
rich.get_console().quiet = True


class GuardedServer:
    """A viser server that serves nobody but our own proxy."""

    def __init__(self) -> None:
        if viser.__version__ != PINNED:
            raise RuntimeError(f"viser is {viser.__version__}, but {PINNED} was examined")
        self.key = secrets.token_urlsafe(24)
        self.server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
        sockets = self.server._websock_server  # pyright: ignore[reportPrivateUsage]
        # first of all callbacks: no message is sent, no state is kept, before the key was seen
        sockets._client_connect_cb.insert(0, self._admit)  # pyright: ignore[reportPrivateUsage]
        for message in (_messages.ShareUrlRequest, _messages.ShareUrlDisconnect):
            sockets.unregister_handler(message)
        self._sockets = sockets

    @property
    def address(self) -> str:
        """Where the proxy connects to."""
        return f"ws://127.0.0.1:{self.server.get_port()}"

    @property
    def connections(self) -> int:
        """Pages that look at this room now."""
        return len(self._sockets._live_connections)  # pyright: ignore[reportPrivateUsage]

    def forget_removed(self) -> None:
        """Forget what is kept about removed bodies; viser does so only when a page connects."""
        self.server._run_garbage_collector()  # pyright: ignore[reportPrivateUsage]

    @property
    def kept_messages(self) -> int:
        """Messages that a page which connects now would be sent."""
        buffer = self._sockets._broadcast_buffer  # pyright: ignore[reportPrivateUsage]
        return len(buffer.message_from_id)

    @property
    def handled_messages(self) -> list[str]:
        """Kinds of messages from pages that anything here listens to."""
        handlers = self._sockets._incoming_handlers  # pyright: ignore[reportPrivateUsage]
        return [kind.__name__ for kind in handlers]

    async def _admit(self, client: viser.infra.WebsockClientConnection) -> None:
        live = self._sockets._live_connections  # pyright: ignore[reportPrivateUsage]
        connection = live[client.client_id]
        given = connection.request.headers.get(KEY_HEADER, "") if connection.request else ""
        if not secrets.compare_digest(given.encode(), self.key.encode()):
            connection.close_timeout = 0.2
            await connection.close(1008, "not admitted")

    def stop(self) -> None:
        """End the server and its threads; blocks for a moment."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # messages to connections that close meanwhile
            self.server.stop()


def client_page() -> str:
    """viser's own page: one self-contained document."""
    return (files("viser") / "client" / "build" / "index.html").read_text()
