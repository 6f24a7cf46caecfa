"""How to use the cut parts: a plain-text page that travels with the sheets."""

from collections.abc import Sequence

from actuators.design.slab import SlabDesign
from actuators.fabrication.slab_mould import DOWEL_MM, SlabMoulds
from actuators.materials import material


def mould_guide(design: SlabDesign, moulds: SlabMoulds, sheets: Sequence[str]) -> str:
    """Parts, order of assembly, amounts to pour and what the stock changes."""
    pours = {"A": design.bottom_material, "B": design.top_material}
    lines = [
        f"Moulds of {design.title} {design.planform}, design {design.digest[:12]}",
        "",
        f"Sheets to cut: {', '.join(sheets)}",
        "Run the layers in this order: engrave lines, engrave text, cut inside, cut outline.",
        "Outlines are nominal; the laser's kerf is not compensated.",
        f"Dowels: {DOWEL_MM:g} mm through the corner holes; the cut-off corners lie in one pile.",
        "",
    ]
    for mould in moulds.moulds:
        rubber = material(pours[mould.name])
        grams = mould.pour_ml * rubber.density * 1e-3
        lines += [f"Mould {mould.name}: {mould.casts}"]
        lines += [f"  {part.name}" for part in mould.parts]
        lines += [
            f"  {mould.pour_ml:.1f} ml, {grams:.1f} g of {rubber.name}",
            "",
        ]
    lines += [
        "1. Stack each mould on its base in the order of the numbers, over the dowels.",
        "2. Glue the core sheets on each other and on base B, inside the engraved outline.",
        "3. Pour, degas, strike off level with the top frame, cure.",
        "4. Take the parts out, turn part B over so that its chambers open downwards,",
        "   and bond it on part A with a thin film of the top material.",
    ]
    inlet, wall = moulds.bottom_thickness + moulds.chamber_height / 2, design.root_wall * 1e3
    lines += [
        f"5. The moulds leave no air inlet: pierce the root wall ({wall:.4g} mm) on the middle",
        f"   plane, {inlet:.4g} mm above the underside, and glue a tube in.",
    ]
    if moulds.notes:
        lines += ["", "Mind:", *(f"- {note}" for note in moulds.notes)]
    if design.assumptions():
        lines += ["", "Assumed dimensions:", *(f"- {a}" for a in design.assumptions())]
    return "\n".join(lines) + "\n"
