"""The whole inflated body for ParaView and its kin: one ``.vtu`` per path point, and a ``.pvd``
that lists them as a series.

27-node cells keep the solver's own interpolation. Lengths in mm, stresses in kPa.
"""

import base64
import itertools
import xml.etree.ElementTree as ET
import zlib
from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.volume_fields import VolumeMesh, VolumeState
from actuators.mechanics.response import SurfaceFields

TRIANGLE, TRIQUADRATIC_HEXAHEDRON = 5, 29
NODE_ORDER = (
    0, 2, 8, 6, 18, 20, 26, 24,
    1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15,
    12, 14, 10, 16, 4, 22, 13,
)  # fmt: skip
"""Our local node i + 3 j + 9 k at each of VTK's: corners, edges, faces (x-, x+, y-, y+, z-, z+) and
the middle."""
_COMPONENTS = {
    "displacement_mm": ("X", "Y", "Z"),
    "principal_stretches": ("largest", "middle", "smallest"),
    "cauchy_stress_kPa": ("XX", "YY", "ZZ", "XY", "YZ", "XZ"),
}
_BLOCK = 1 << 20
_NAMES = {"f8": "Float64", "f4": "Float32", "i8": "Int64", "i4": "Int32", "u1": "UInt8"}


def collection(names: Sequence[str], pressures: Sequence[float]) -> bytes:
    """A ``.pvd`` of files that stand beside it. The series runs over the ``pressures`` [Pa], told
    in kPa, or over the files' numbers where the pressure does not rise throughout."""
    rising = all(later > earlier for earlier, later in itertools.pairwise(pressures))
    times = (
        [pressure * 1e-3 for pressure in pressures] if rising else [*map(float, range(len(names)))]
    )
    root = ET.Element("VTKFile", {"type": "Collection", "version": "1.0"})
    collection = ET.SubElement(root, "Collection")
    for name, time in zip(names, times, strict=True):
        ET.SubElement(collection, "DataSet", {"timestep": f"{time:.9g}", "file": name})
    return _document(root)


def surface_series(
    surface: SurfaceFields, pressures: Sequence[float], title: str
) -> dict[str, bytes]:
    """``answer.pvd`` and a ``.vtu`` of triangles for every path point of a stored answer, which
    keeps the fields on its surface only. ``pressures``: (k,) [Pa]."""
    points = surface.vertices.astype("<f8") * 1e3
    count = len(surface.triangles)
    files: dict[str, bytes] = {}
    for number in range(len(pressures)):
        root, piece = _grid(title, pressures[number], len(points), count)
        data = ET.SubElement(piece, "PointData", {"Vectors": "displacement_mm"})
        _array(data, "displacement_mm", surface.displacement[number].astype("<f8") * 1e3)
        _array(data, "largest_principal_stretch", surface.stretch[number].astype("<f4"))
        _array(data, "largest_principal_stress_kPa", (surface.stress[number] * 1e-3).astype("<f4"))
        if surface.contact_pressure is not None:
            pressed = (surface.contact_pressure[number] * 1e-3).astype("<f4")
            _array(data, "contact_pressure_kPa", pressed)
        _array(ET.SubElement(piece, "Points"), "points_mm", points)
        cells = ET.SubElement(piece, "Cells")
        _array(cells, "connectivity", surface.triangles.ravel().astype("<i8"))
        _array(cells, "offsets", 3 * np.arange(1, count + 1, dtype="<i8"))
        _array(cells, "types", np.full(count, TRIANGLE, dtype="u1"))
        files[f"answer-{number:03d}.vtu"] = _document(root)
    return {"answer.pvd": collection(list(files), pressures), **files}


def unstructured_grid(
    mesh: VolumeMesh, regions: Sequence[str], state: VolumeState, title: str
) -> bytes:
    """One state as a VTK XML file with compressed inline data."""
    named = ", ".join(f"{number} {name}" for number, name in enumerate(regions))
    count = len(mesh.elements)
    root, piece = _grid(f"{title}; regions: {named}", state.pressure, len(mesh.nodes), count)
    data = ET.SubElement(piece, "PointData", {"Vectors": "displacement_mm"})
    for name, values in _point_data(state).items():
        _array(data, name, values, components=_COMPONENTS.get(name, ()))
    _array(ET.SubElement(piece, "CellData"), "region", mesh.region.astype("<i4"))
    _array(ET.SubElement(piece, "Points"), "points_mm", mesh.nodes * 1e3)
    cells = ET.SubElement(piece, "Cells")
    _array(cells, "connectivity", mesh.elements[:, NODE_ORDER].ravel().astype("<i8"))
    _array(cells, "offsets", 27 * np.arange(1, count + 1, dtype="<i8"))
    _array(cells, "types", np.full(count, TRIQUADRATIC_HEXAHEDRON, dtype="u1"))
    return _document(root)


def _grid(title: str, pressure: float, points: int, cells: int) -> tuple[ET.Element, ET.Element]:
    """A document, and the piece in it that takes the arrays."""
    root = ET.Element("VTKFile", {
        "type": "UnstructuredGrid", "version": "1.0", "byte_order": "LittleEndian",
        "header_type": "UInt64", "compressor": "vtkZLibDataCompressor",
    })  # fmt: skip
    root.append(ET.Comment(f" {title}; mm and kPa "))
    grid = ET.SubElement(root, "UnstructuredGrid")
    _array(ET.SubElement(grid, "FieldData"), "cavity_pressure_kPa",
           np.array([pressure * 1e-3]), tuples=1)  # fmt: skip
    sizes = {"NumberOfPoints": str(points), "NumberOfCells": str(cells)}
    return root, ET.SubElement(grid, "Piece", sizes)


def _point_data(state: VolumeState) -> dict[str, np.ndarray]:
    stress = state.stress * 1e-3
    data = {
        "displacement_mm": state.displacement * 1e3,
        "principal_stretches": state.stretches.astype("<f4"),
        "cauchy_stress_kPa": stress.astype("<f4"),
        "pressure_kPa": (-stress[:, :3].mean(axis=1)).astype("<f4"),
    }
    if state.contact_pressure is not None:
        data["contact_pressure_kPa"] = (state.contact_pressure * 1e-3).astype("<f4")
    return data


def _array(
    parent: ET.Element,
    name: str,
    values: np.ndarray,
    tuples: int | None = None,
    components: Sequence[str] = (),
) -> None:
    attributes = {"type": _NAMES[values.dtype.str[1:]], "Name": name, "format": "binary"}
    if values.ndim == 2:
        attributes["NumberOfComponents"] = str(values.shape[1])
    for number, component in enumerate(components):
        attributes[f"ComponentName{number}"] = component
    if tuples is not None:
        attributes["NumberOfTuples"] = str(tuples)
    ET.SubElement(parent, "DataArray", attributes).text = _packed(values)


def _packed(values: np.ndarray) -> str:
    """Base64 of zlib blocks after a header of their number and sizes, as VTK packs them."""
    raw = np.ascontiguousarray(values).tobytes()
    blocks = [raw[k : k + _BLOCK] for k in range(0, len(raw), _BLOCK)]
    packed = [zlib.compress(block) for block in blocks]
    last = len(raw) % _BLOCK
    header = np.array([len(blocks), _BLOCK, last, *map(len, packed)], dtype="<u8").tobytes()
    return (base64.b64encode(header) + base64.b64encode(b"".join(packed))).decode()


def _document(root: ET.Element) -> bytes:
    ET.indent(root)
    return ET.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"
