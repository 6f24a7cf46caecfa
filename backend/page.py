"""The built page: one document for every address that the page itself understands."""

from pathlib import Path

from fastapi import APIRouter
from fastapi.responses import FileResponse, HTMLResponse, Response
from starlette.exceptions import HTTPException

NOT_BUILT = """<!doctype html><html lang="en"><meta charset="utf-8">
<title>Pneustudio: the page is not built</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:40rem;margin:15vh auto;padding:0 1rem}
code{background:#8882;padding:.1em .35em;border-radius:.25em}</style>
<h1>The page is not built</h1>
<p>The studio runs, but the files of its page are missing. Build them with
<code>make setup</code> (or <code>npm ci &amp;&amp; npm run build</code> in <code>frontend</code>)
and load this page again.</p>
<p>The API works meanwhile: <a href="/api/openapi.json">/api/openapi.json</a>.</p></html>
"""
# names of built assets hold a hash of their content: they never change
FOR_EVER = "public, max-age=31536000, immutable"


def router(folder: Path) -> APIRouter:
    """Serves files of ``folder``; any other address that looks like the page's own gets its
    document. Register it last."""
    pages = APIRouter(include_in_schema=False)
    root = folder.resolve()

    @pages.api_route("/{path:path}", methods=["GET", "HEAD"])
    def page(path: str) -> Response:
        if path == "api" or path.startswith(("api/", "viewer/")):
            raise HTTPException(404)
        found = _file(root, path)
        if found is not None:
            headers = {"Cache-Control": FOR_EVER if path.startswith("assets/") else "no-cache"}
            return FileResponse(found, headers=headers)
        if "." in path.rpartition("/")[2]:
            raise HTTPException(404)  # a file that is not there, not an address of the page
        document = root / "index.html"
        if not document.is_file():
            return HTMLResponse(NOT_BUILT, status_code=503, headers={"Cache-Control": "no-store"})
        return FileResponse(document, headers={"Cache-Control": "no-cache"})

    return pages


def _file(root: Path, path: str) -> Path | None:
    """A file inside ``root``, never outside it."""
    if not path or "\x00" in path:
        return None
    found = (root / path).resolve()
    return found if found.is_relative_to(root) and found.is_file() else None
