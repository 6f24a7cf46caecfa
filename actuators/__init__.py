"""The science of Pneustudio: designs in, responses out; no web, database, queue or viewer."""

__version__ = "0.1.0"
