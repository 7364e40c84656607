"""ezdxf 1.4.5, which knows nothing of this project, writes drawings that are read here, and reads what is written here."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

import ezdxf
from ezdxf import path as ezpath, recover, units
from ezdxf.math import Matrix44

RELEASES = ["R12", "R2000", "R2004", "R2010", "R2018"]
# Chords are within 0.1 % of the radius from curves, and splines bend with up to 700 units.
TOLERANCE = 0.7


def draw(release, name, fmt):
    """A drawing with all that is read, in millimetres."""
    document = ezdxf.new(release)
    document.units = units.MM
    is_old = release == "R12"
    furniture = "MOEBEL" if is_old else "Möbel"
    for layer, colour in [("WALL", 3), (furniture, 30)]:
        document.layers.add(layer, color=colour)
    model = document.modelspace()
    on_wall, on_furniture = {"layer": "WALL"}, {"layer": furniture}
    model.add_line((0, 0), (1000, 0), dxfattribs=on_wall)
    model.add_circle((500, 500), 100, dxfattribs=on_furniture)
    model.add_circle((500, 500), 100, dxfattribs=on_furniture | {"extrusion": (0, 0, -1)})
    model.add_arc((100, 200), 50, 30, 200, dxfattribs=on_furniture)
    model.add_arc((100, 200), 50, 300, 20, dxfattribs=on_furniture | {"extrusion": (0, 0, -1)})
    bulged = [(0, 0, 0.5), (100, 0, 0), (100, 100, -1), (0, 100, 0)]
    model.add_polyline2d(bulged, format="xyb", close=True, dxfattribs=on_wall)
    model.add_polyline3d([(0, 0, 1), (5, 5, 2), (9, 5, 3)], dxfattribs=on_wall)
    model.add_solid([(0, 0), (10, 0), (0, 10), (10, 10)], dxfattribs=on_wall)
    model.add_3dface([(0, 0), (10, 0), (20, 20), (0, 10)], dxfattribs=on_wall)
    if not is_old:
        model.add_lwpolyline(bulged, format="xyb", close=True, dxfattribs=on_wall)
        model.add_lwpolyline(bulged, format="xyb", dxfattribs=on_wall | {"extrusion": (0, 0, -1)})
        model.add_ellipse((10, 20), (100, 50), 0.4, 0.5, 4, dxfattribs=on_furniture)
        model.add_ellipse((10, 20), (100, 50), 0.4, 0.5, 4, dxfattribs=on_furniture | {"extrusion": (0, 0, -1)})
        controls = [(0, 0, 0), (100, 200, 0), (300, 100, 0), (400, -50, 0), (500, 0, 0)]
        model.add_open_spline(controls, dxfattribs=on_wall)
        model.add_rational_spline(controls, [1, 2, 3, 1, 1], dxfattribs=on_wall)
        model.add_spline(dxfattribs=on_wall).set_closed(controls)
    inner = document.blocks.new("INNER", base_point=(5, 5))
    inner.add_line((0, 0), (10, 0))
    inner.add_circle((5, 5), 3, dxfattribs=on_furniture)
    outer = document.blocks.new("OUTER")
    outer.add_blockref("INNER", (20, 30), dxfattribs={"xscale": 2, "yscale": -1, "rotation": 30})
    outer.add_line((0, 0), (0, 7))
    model.add_blockref("OUTER", (1000, 2000), dxfattribs=on_wall | {"xscale": -1.5, "yscale": 0.5, "rotation": 75})
    array = {"row_count": 2, "column_count": 3, "row_spacing": 50, "column_spacing": 70, "rotation": 20}
    model.add_blockref("INNER", (3000, 2000), dxfattribs=on_furniture | array)
    model.add_blockref("INNER", (3000, 2000), dxfattribs=on_furniture | {"extrusion": (0, 0, -1), "rotation": 20})
    model.add_text("left out")
    document.layout("Layout1").add_line((0, 0), (9, 9))
    document.saveas(name, fmt=fmt)


def expected(document):
    """Every entity of model space with blocks resolved, as (layer, points), flattened and placed by ezdxf itself.

    Its virtual_entities() can't shear what is turned within a block that is scaled unevenly; its matrices can.
    """
    lines = []

    def add(entity, layer, matrix):
        kind = entity.dxftype()
        if kind == "INSERT":
            for insert in entity.multi_insert() if entity.mcount > 1 else [entity]:
                for inner in insert.block():
                    # Layer 0 stands for the insert's.
                    inner_layer = layer if inner.dxf.layer == "0" else inner.dxf.layer
                    add(inner, inner_layer, insert.matrix44() @ matrix)
        elif kind in ("SOLID", "3DFACE"):
            corners = entity.wcs_vertices()
            lines.append((layer, [(p.x, p.y) for p in matrix.transform_vertices(corners + corners[:1])]))
        elif kind == "SPLINE" and entity.closed:
            # Its flattening() goes beyond the first and last knots that count.
            tool = entity.construction_tool()
            low, high = entity.knots[entity.dxf.degree], entity.knots[-1 - entity.dxf.degree]
            points = tool.points(low + (high - low) * i / 1000 for i in range(1001))
            lines.append((layer, [(p.x, p.y) for p in matrix.transform_vertices(points)]))
        elif kind != "TEXT":
            flat = ezpath.make_path(entity).transform(matrix).flattening(0.01)
            lines.append((layer, [(p.x, p.y) for p in flat]))

    for entity in document.modelspace():
        add(entity, entity.dxf.layer, Matrix44())
    return lines


def gap(point, line):
    """Distance of a point from a polyline."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(line, line[1:]):
        dx, dy = bx - ax, by - ay
        length = dx * dx + dy * dy
        share = 0 if length == 0 else max(0, min(1, ((point[0] - ax) * dx + (point[1] - ay) * dy) / length))
        best = min(best, math.hypot(point[0] - ax - share * dx, point[1] - ay - share * dy))
    return best


def same(ours, theirs):
    """Whether two lines run where the other does."""
    return all(gap(p, theirs) < TOLERANCE for p in ours) and all(gap(p, ours) < TOLERANCE for p in theirs)


def strokes(seen):
    lines = []
    for stroke in seen["strokes"]:
        points = [tuple(point) for point in stroke["points"]]
        lines.append((stroke["layer"], points + points[:1] if stroke["closed"] else points))
    return lines


def compare(ours, theirs, what):
    assert len(ours) == len(theirs), (what, len(ours), len(theirs))
    left = list(theirs)
    for layer, line in ours:
        match = next((other for other in left if other[0].upper() == layer.upper() and same(line, other[1])), None)
        assert match is not None, (what, layer, line[:4])
        left.remove(match)


def audited(name):
    document = ezdxf.readfile(name)
    auditors = [document.audit()]
    if not pathlib.Path(name).read_bytes().startswith(b"AutoCAD Binary DXF"):
        # It takes files apart more strictly than it is called.
        auditors.append(recover.readfile(name)[1])
    problems = [problem for auditor in auditors for problem in auditor.errors + auditor.fixes]
    assert not problems, (name, [problem.message for problem in problems])
    return document


def main():
    robovac = pathlib.Path(sys.argv[1])
    probe = robovac.parent / "examples" / "drawing_strokes"
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for release in RELEASES:
            for fmt in ["asc", "bin"]:
                what = f"{release}-{fmt}"
                name, beside, alone = (str(folder / f"{what}{part}.dxf") for part in ["", "-beside", "-alone"])
                draw(release, name, fmt)
                shown = subprocess.run([probe, name, beside, alone], check=True, capture_output=True, text=True)
                seen = json.loads(shown.stdout)
                original = expected(ezdxf.readfile(name))
                compare(strokes(seen), original, what)
                assert seen["metre"] == (None if release == "R12" else 0.001), what
                assert "texts (1)" in seen["left_out"], (what, seen["left_out"])
                # What is written beside it: all is still there, and the path on layers of its own.
                document = audited(beside)
                paths = [line for line in expected(document) if line[0].upper().startswith(("SWEEP", "ÜBER", "_BER"))]
                rest = [line for line in expected(document) if line not in paths]
                compare(rest, original, what)
                zigzag = [(i * 100.25, i % 2 * 50.5) for i in range(5)]
                assert paths[0][1] == zigzag, (what, paths[0])
                assert len(paths) == 3 and paths[1][1] == zigzag[:3] + zigzag[:1], (what, paths)
                assert document.layers.get("SWEEP_PATH").color == 1, what
                fresh = audited(alone)
                assert fresh.units == units.M and len(fresh.modelspace()) == 1, what
                line = list(fresh.modelspace()[0].get_points("xy"))
                assert line == [(0.0, 0.0), (2.5, 1.5)], line
        # A room that ships, as a drawing: its walls enclose its floor.
        room = str(folder / "flat.dxf")
        subprocess.run([robovac, "convert", "--room", "flat", "--out", room], check=True)
        document = audited(room)
        walls = [line for line in document.modelspace() if line.dxf.layer == "WALLS"]
        assert walls and all(line.closed for line in walls)
        back = str(folder / "back.txt")
        subprocess.run([robovac, "convert", "--map", room, "--out", back], check=True)
        assert "." in pathlib.Path(back).read_text()
    print(f"ezdxf {ezdxf.__version__}: {len(RELEASES)} releases in text and binary, read and written")


main()
