"""Meshes as binary glTF 2.0: unlit triangles with a colour per vertex, and dark edge lines."""

import json
import struct
from typing import Any

import numpy as np

# signed colours are beyond the glTF standard, but what three.js draws; see `shading`
_FLOAT, _UINT, _USHORT, _SHORT = 5126, 5125, 5123, 5122
_TRIANGLES, _LINES = 4, 1


def coloured_body(
    positions: np.ndarray,
    triangles: np.ndarray,
    colours: np.ndarray,
    edges: np.ndarray,
    *,
    factor: float,
    edge_colour: tuple[float, float, float, float],
    opacity: float = 1.0,
    take: str = "",
) -> bytes:
    """One body. ``positions`` (n, 3) float32; ``triangles`` (m, 3); ``colours`` (n, 4) int16,
    where 32767 stands for ``factor`` in linear light; ``edges`` (e, 2) vertices joined by lines;
    ``take``: kept in the node's extras, where the page reads which bodies it has loaded."""
    writer = _Writer()
    position = writer.positions(positions)
    colour = writer.add(colours, _SHORT, "VEC4", normalized=True)
    faces = writer.indices(triangles, len(positions))
    primitives = [
        {"attributes": {"POSITION": position, "COLOR_0": colour}, "indices": faces, "material": 0,
         "mode": _TRIANGLES},
    ]  # fmt: skip
    if len(edges):
        lines = writer.indices(edges, len(positions))
        primitives.append(
            {"attributes": {"POSITION": position}, "indices": lines, "material": 1, "mode": _LINES}
        )
    materials = [
        _unlit((factor, factor, factor, opacity), blend=opacity < 1.0),
        _unlit(edge_colour, blend=edge_colour[3] < 1.0),
    ]
    return writer.file(
        {"nodes": [{"mesh": 0, "extras": {"take": take}}], "meshes": [{"primitives": primitives}],
         "materials": materials}
    )  # fmt: skip


def _unlit(factor: tuple[float, float, float, float], *, blend: bool) -> dict[str, Any]:
    material: dict[str, Any] = {
        "pbrMetallicRoughness": {"baseColorFactor": list(factor)},
        "extensions": {"KHR_materials_unlit": {}},
        "doubleSided": not blend,
    }
    if blend:
        material["alphaMode"] = "BLEND"
    return material


class _Writer:
    """Collects arrays into one buffer."""

    def __init__(self) -> None:
        self._chunks: list[bytes] = []
        self._size = 0
        self._views: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []

    def positions(self, points: np.ndarray) -> int:
        bounds = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
        return self.add(points.astype(np.float32, copy=False), _FLOAT, "VEC3", **bounds)

    def indices(self, cells: np.ndarray, vertices: int) -> int:
        small = vertices < 65535
        flat = cells.ravel().astype(np.uint16 if small else np.uint32)
        return self.add(flat, _USHORT if small else _UINT, "SCALAR")

    def add(self, array: np.ndarray, component: int, kind: str, **more: Any) -> int:
        data = np.ascontiguousarray(array).tobytes()
        padding = -len(data) % 4
        self._views.append({"buffer": 0, "byteOffset": self._size, "byteLength": len(data)})
        self._chunks += [data, b"\0" * padding]
        self._size += len(data) + padding
        self._accessors.append(
            {"bufferView": len(self._views) - 1, "componentType": component, "type": kind,
             "count": len(array), **more}
        )  # fmt: skip
        return len(self._accessors) - 1

    def file(self, content: dict[str, Any]) -> bytes:
        document = {
            "asset": {"version": "2.0", "generator": "Pneustudio"},
            "extensionsUsed": ["KHR_materials_unlit"],
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "buffers": [{"byteLength": self._size}],
            "bufferViews": self._views,
            "accessors": self._accessors,
            **content,
        }
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        body = b"".join(self._chunks)
        return b"".join(
            [struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(body)),
             struct.pack("<I4s", len(text), b"JSON"), text,
             struct.pack("<I4s", len(body), b"BIN\0"), body]
        )  # fmt: skip
