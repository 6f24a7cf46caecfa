"""Aligned plain-text tables."""

from collections.abc import Sequence

Cell = str | float | int | None


def table(headings: Sequence[str], rows: Sequence[Sequence[Cell]]) -> str:
    """Columns as wide as their widest cell, two spaces apart; numbers to the right with five
    significant digits, None as a dash."""
    texts = [[_text(cell) for cell in row] for row in rows]
    columns = range(len(headings))
    widths = [max(len(headings[c]), *(len(row[c]) for row in texts), 0) for c in columns]
    to_right = [any(isinstance(row[c], (int, float)) for row in rows) for c in columns]

    def line(cells: Sequence[str]) -> str:
        aligned = [
            cell.rjust(width) if right else cell.ljust(width)
            for cell, width, right in zip(cells, widths, to_right, strict=True)
        ]
        return "  ".join(aligned).rstrip()

    return "\n".join([line(headings), *map(line, texts)])


def _text(cell: Cell) -> str:
    if cell is None:
        return "-"
    if isinstance(cell, float):
        return f"{cell:.5g}"
    return str(cell)
