"""Steps that lead from an empty database to ``storage.tables``, run by ``Store.migrate``."""
