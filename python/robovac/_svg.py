"""Pictures for notebooks: what is drawn over the drawing of a room."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

#: Width and height of a picture at most, pixels.
_MOST = (720.0, 520.0)


def fitted(svg: str, width_m: float, height_m: float, over: str = "") -> str:
    """``svg``, in millimetres, as large as a notebook has room for, with ``over`` drawn over it in metres, y up."""
    scale = min(_MOST[0] / width_m, _MOST[1] / height_m)
    size = f'width="{width_m * scale:.0f}" height="{height_m * scale:.0f}" style="max-width:100%;height:auto"'
    svg = re.sub(r'width="[^"]*mm" height="[^"]*mm"', size, svg, count=1)
    if not over:
        return svg
    group = f'<g transform="matrix(1000,0,0,-1000,0,{1000 * height_m:.0f})">{over}</g>\n</svg>\n'
    head, _, _ = svg.rpartition("</svg>")
    return head + group


def cells(grid: np.ndarray, side_m: float, colour: str) -> str:
    """The cells of ``grid`` that are set, as runs."""
    import numpy as np

    padded = np.zeros((grid.shape[0], grid.shape[1] + 2), dtype=np.int8)
    padded[:, 1:-1] = grid
    rows, columns = np.nonzero(np.diff(padded, axis=1))
    runs = [
        f"M{x0 * side_m:.3f} {(row + 0.5) * side_m:.3f}H{x1 * side_m:.3f}"
        for row, x0, x1 in zip(rows[::2], columns[::2], columns[1::2])
    ]
    return f'<path fill="none" stroke="{colour}" stroke-width="{side_m}" d="{"".join(runs)}"/>' if runs else ""


def line(points: np.ndarray, colour: str, width_m: float) -> str:
    """A line through points in metres."""
    if len(points) < 2:
        return ""
    corners = " ".join(f"{x:.3f},{y:.3f}" for x, y in points)
    return (
        f'<polyline fill="none" stroke="{colour}" stroke-width="{width_m}" stroke-linejoin="round" '
        f'stroke-linecap="round" points="{corners}"/>'
    )


def disc(x: float, y: float, radius_m: float, colour: str) -> str:
    """A filled disc."""
    return f'<circle cx="{x:.3f}" cy="{y:.3f}" r="{radius_m}" fill="{colour}"/>'
