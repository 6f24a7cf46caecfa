"""The store: everything the other rooms may ask of the database."""

from importlib.resources import as_file, files

from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory

from storage.designs import Designs
from storage.errors import NewerDatabaseError
from storage.losses import Losses
from storage.timings import Timings
from storage.workers import Workers


class Store(Designs, Losses, Timings, Workers):
    """Designs, jobs, results, events and workers in one database.

    Every method is one transaction and may be called from any thread or process. Those that wait
    for the database block: call them in a thread from async code.
    """

    def migrate(self) -> None:
        """Bring the tables up to date; several processes may do so at once. Raises
        NewerDatabaseError for a database that this version does not know."""
        with as_file(files("storage") / "migrations") as scripts, self._write() as connection:
            config = Config(attributes={"connection": connection})
            config.set_main_option("script_location", str(scripts).replace("%", "%%"))
            known = {
                script.revision for script in ScriptDirectory.from_config(config).walk_revisions()
            }
            there = MigrationContext.configure(connection).get_current_revision()
            if there is not None and there not in known:
                raise NewerDatabaseError(
                    f"{self.url} was written by a newer Pneustudio (its tables are at {there}). "
                    "Update this installation, or use another database."
                )
            command.upgrade(config, "head")


def open_store(url: str) -> Store:
    """Store on ``sqlite:////path/to/file`` or ``postgresql://user@host/database``.

    Connects lazily. Not to be carried across a fork: open a new one in the child.
    """
    return Store(url)
