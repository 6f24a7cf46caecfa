"""Laser-cut moulds: one SVG per sheet in true millimetres, and a page on how to use the parts.

Layers, in the order to run them: engrave lines, engrave text, cut inside (windows and holes), cut
outline; notes are for the reader only. Each has its own stroke colour and Inkscape layer.
"""

import xml.etree.ElementTree as ET
from collections.abc import Iterable

from shapely.geometry import LinearRing

from actuators.design.slab import SlabDesign
from actuators.export.mould_guide import mould_guide
from actuators.fabrication.sheet_layout import Placed, Sheet, lay_out
from actuators.fabrication.slab_mould import slab_moulds

SVG = "http://www.w3.org/2000/svg"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
ET.register_namespace("", SVG)
ET.register_namespace("inkscape", INKSCAPE)

STROKE_MM = 0.1
LAYERS = {
    "engrave lines": "#0000ff",
    "engrave text": "#000000",
    "cut inside": "#00a000",
    "cut outline": "#ff0000",
    "notes": "#808080",
}
TEXT_LAYERS = ("engrave text", "notes")


def mould_svg(design: SlabDesign) -> dict[str, bytes]:
    """``mould-4mm.svg`` for each thickness (a second sheet ``mould-4mm-2.svg``), and
    ``mould-guide.txt``."""
    moulds = slab_moulds(design)
    sheets = lay_out(moulds.parts)
    title = f"Mould, {design.title.lower()} {design.planform}, design {design.digest[:12]}"
    files: dict[str, bytes] = {}
    for sheet in sheets:
        name = f"mould-{sheet.thickness:g}mm"
        if f"{name}.svg" in files:
            name += f"-{sum(s.startswith(name) for s in files) + 1}"
        files[f"{name}.svg"] = sheet_svg(sheet, title)
    files["mould-guide.txt"] = mould_guide(design, moulds, list(files)).encode()
    return files


def sheet_svg(sheet: Sheet, title: str) -> bytes:
    """One sheet as an SVG document; user units are millimetres."""
    width, height = f"{sheet.width:g}", f"{sheet.height:g}"
    root = ET.Element(
        f"{{{SVG}}}svg",
        {"version": "1.1", "width": f"{width}mm", "height": f"{height}mm",
         "viewBox": f"0 0 {width} {height}"},
    )  # fmt: skip
    ET.SubElement(root, f"{{{SVG}}}title").text = f"{title}, sheet {sheet.thickness:g} mm"
    ET.SubElement(root, f"{{{SVG}}}desc").text = (
        f"Cut from {sheet.thickness:g} mm sheet. User units are millimetres. Outlines are nominal: "
        "the laser's kerf is not compensated."
    )
    layers = {name: _layer(root, name, colour) for name, colour in LAYERS.items()}
    for placed in sheet.placed:
        _draw(placed, sheet, layers)
    ET.indent(root)
    return ET.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def _layer(root: ET.Element, name: str, colour: str) -> ET.Element:
    paint = (
        {"fill": colour, "stroke": "none", "font-family": "sans-serif", "text-anchor": "middle"}
        if name in TEXT_LAYERS
        else {"fill": "none", "stroke": colour, "stroke-width": f"{STROKE_MM:g}"}
    )
    attributes = {
        "id": name.replace(" ", "-"),
        f"{{{INKSCAPE}}}groupmode": "layer",
        f"{{{INKSCAPE}}}label": name,
        **paint,
    }
    return ET.SubElement(root, f"{{{SVG}}}g", attributes)


def _draw(placed: Placed, sheet: Sheet, layers: dict[str, ET.Element]) -> None:
    part = placed.part
    key = part.name.split()[0]

    def path(layer: str, rings: Iterable[LinearRing], name: str) -> None:
        data = " ".join(_path_data(ring, placed, sheet) for ring in rings)
        if data:
            ET.SubElement(layers[layer], f"{{{SVG}}}path", {"id": f"{key}-{name}", "d": data})

    path("engrave lines", part.engraved, "marks")
    path("cut inside", part.cut.interiors, "inside")
    path("cut outline", [part.cut.exterior], "outline")
    label = part.label
    text = ET.SubElement(
        layers["engrave text" if part.label_engraved else "notes"],
        f"{{{SVG}}}text",
        {"id": f"{key}-label", "x": _number(label.x + placed.dx),
         "y": _number(sheet.height - label.y - placed.dy), "font-size": f"{label.height:g}"},
    )  # fmt: skip
    text.text = label.text


def _path_data(ring: LinearRing, placed: Placed, sheet: Sheet) -> str:
    points = [
        f"{_number(x + placed.dx)},{_number(sheet.height - y - placed.dy)}"
        for x, y in list(ring.coords)[:-1]
    ]
    return f"M {' L '.join(points)} Z"


def _number(value: float) -> str:
    return f"{value:.4f}".rstrip("0").rstrip(".")
