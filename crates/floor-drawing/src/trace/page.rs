//! Tells the frame of a sheet and its title block from walls.

use super::{
    frame::{BoundingBox, RasterFrame},
    openings,
    raster::RasterCanvas,
};
use crate::{
    Drawing, Role,
    model::{DrawingLayer, drop_empty_layers},
    roles::says_wall,
};
use robovac_core::{
    geometry::{Point, Vector},
    grid::Cell,
    math::ceil,
};

/// Longer by shorter side of a frame: sheets have the square root of 2 (ISO 216), with margins a little more or less.
const ASPECT: [f64; 2] = [1.36, 1.48];
/// Tolerance of lengths, as a share of the drawing's longer side.
const NEAR: f64 = 0.004;
/// Least size of a second frame within the first, as a share of it.
const NESTED: f64 = 0.85;
/// Most lines that may be the left or right side of a frame: more are hatching.
const MOST_SIDES: usize = 40;
/// Largest area of a title block, as a share of the frame's.
const TITLE_BLOCK: f64 = 0.25;
/// Least floor that walls within a frame enclose, as a share of the frame's area: without a building it is a room. A flat of 50 m² at
/// 1:100 is a twelfth of an A4 sheet.
const BUILDING: f64 = 0.05;
/// Cells along the longer side for that, and openings that are closed for it, in cells: doors, and wide ones of walls that are
/// called so.
const CELLS: f64 = 200.0;
const DOOR: f64 = 6.0;
const WIDE_DOOR: f64 = 18.0;

/// The drawing with a page's frame and title block on layers of their own, which are ignored. What lies on layers that
/// are called walls, and a rectangle around anything but a building, stays; so does one without the sides of a sheet, unless the
/// building's walls are called so.
pub(crate) fn without_page(mut drawing: Drawing) -> Drawing {
    let Some((frame, title)) = found(&drawing) else { return drawing };
    for (name, strokes) in [("page frame", frame), ("title block", title)] {
        if strokes.is_empty() {
            continue;
        }
        let colour = drawing.layers[drawing.strokes[strokes[0]].layer as usize].colour;
        let layer = drawing.layers.len() as u32;
        drawing.layers.push(DrawingLayer {
            name: name.to_owned(),
            colour,
            strokes: strokes.len(),
            role: Role::Ignored,
        });
        for stroke in strokes {
            let old = &mut drawing.strokes[stroke].layer;
            drawing.layers[*old as usize].strokes -= 1;
            *old = layer;
        }
    }
    drop_empty_layers(&mut drawing.layers, &mut drawing.strokes);
    drawing
}

/// The strokes of the frame and of the title block.
fn found(drawing: &Drawing) -> Option<(Vec<usize>, Vec<usize>)> {
    let boxes: Vec<BoundingBox> = drawing
        .strokes
        .iter()
        .map(|stroke| BoundingBox::of(drawing.corners(stroke).iter().copied()))
        .collect::<Option<_>>()?;
    let is_wall = |index: usize| drawing.layers[drawing.strokes[index].layer as usize].role == Role::Wall;
    let walls: Vec<usize> = (0..boxes.len()).filter(|&index| is_wall(index)).collect();
    let all = BoundingBox::of(walls.iter().flat_map(|&index| [boxes[index].low, boxes[index].high]))?;
    let size = all.high - all.low;
    let (longer, shorter) = (size.max(), size.min());
    let near = NEAR * longer;
    if shorter <= 0.0 {
        return None;
    }
    let is_sheet = (ASPECT[0]..=ASPECT[1]).contains(&(longer / shorter));
    let is_large = |b: &BoundingBox| {
        let inside = b.high - b.low;
        inside.x >= NESTED * size.x && inside.y >= NESTED * size.y
    };
    let nameless = || {
        let is_nameless = |&index: &usize| !says_wall(&drawing.layers[drawing.strokes[index].layer as usize].name);
        walls.iter().copied().filter(is_nameless)
    };
    let is_frame = |&index: &usize| {
        let (stroke, b) = (&drawing.strokes[index], &boxes[index]);
        is_large(b) && is_rectangle(drawing.corners(stroke), stroke.is_closed, b, near)
    };
    let mut frames: Vec<BoundingBox> = Vec::new();
    let mut frame: Vec<usize> = nameless().filter(is_frame).collect();
    frames.extend(frame.iter().map(|&index| boxes[index]));
    let lines: Vec<(usize, BoundingBox)> = nameless()
        .filter(|&index| drawing.strokes[index].points.len() == 2)
        .map(|index| (index, boxes[index]))
        .collect();
    for (b, sides) in rectangles_of_lines(&lines, size, near) {
        frames.push(b);
        frame.extend(sides);
    }
    let is_outermost = |b: &BoundingBox| (b.low - all.low).amax() <= near && (b.high - all.high).amax() <= near;
    if !frames.iter().any(is_outermost) {
        return None;
    }
    // The innermost one is what a title block stands at.
    let inner = frames.iter().min_by(|a, b| area(a).total_cmp(&area(b)))?;
    let rest: Vec<usize> = walls.iter().copied().filter(|index| !frame.contains(index)).collect();
    let touches = |b: &BoundingBox| {
        let apart = (b.low - inner.low).inf(&(inner.high - b.high));
        apart.min() <= near
    };
    let mut block: Option<BoundingBox> = None;
    for &index in &rest {
        if touches(&boxes[index]) {
            block = Some(joined(block, &boxes[index]));
        }
    }
    let mut title = Vec::new();
    if let Some(block) = block {
        let (low, high) = (block.low - inner.low, inner.high - block.high);
        let is_in_corner = low.x.min(high.x) <= near && low.y.min(high.y) <= near;
        if !is_in_corner || area(&block) > TITLE_BLOCK * area(inner) {
            return None;
        }
        let is_in = |b: &BoundingBox| (b.low - block.low).min() >= -near && (block.high - b.high).min() >= -near;
        title = rest.iter().copied().filter(|&index| is_in(&boxes[index])).collect();
    }
    let house: Vec<usize> = rest.into_iter().filter(|index| !title.contains(index)).collect();
    // Walls that are called so are a building, however wide its doors.
    let is_named = house.iter().any(|&index| says_wall(&drawing.layers[drawing.strokes[index].layer as usize].name));
    let has_building = |door| Some(floor_share(drawing, &house, &all, longer, door)? >= BUILDING);
    let is_frame = if is_sheet { is_named || has_building(DOOR)? } else { is_named && has_building(WIDE_DOOR)? };
    is_frame.then_some((frame, title))
}

fn area(b: &BoundingBox) -> f64 {
    (b.high.x - b.low.x) * (b.high.y - b.low.y)
}

fn joined(one: Option<BoundingBox>, other: &BoundingBox) -> BoundingBox {
    one.map_or(*other, |one| BoundingBox { low: one.low.inf(&other.low), high: one.high.sup(&other.high) })
}

/// Whether the corners are those of their bounding box, in order.
fn is_rectangle(corners: &[Point], is_closed: bool, b: &BoundingBox, near: f64) -> bool {
    let returns = corners.len() == 5 && (corners[0] - corners[4]).norm() <= near;
    let at = |corner: &Point| {
        let side = |value: f64, low: f64, high: f64| {
            if (value - low).abs() <= near { Some(false) } else { ((value - high).abs() <= near).then_some(true) }
        };
        Some((side(corner.x, b.low.x, b.high.x)?, side(corner.y, b.low.y, b.high.y)?))
    };
    let sides: Option<Vec<(bool, bool)>> = corners.iter().take(4).map(at).collect();
    (is_closed && corners.len() == 4 || returns)
        && sides.is_some_and(|s| s.windows(2).all(|pair| (pair[0].0 != pair[1].0) != (pair[0].1 != pair[1].1)))
}

/// Large rectangles of four single lines, as some programs draw frames: each with its lines.
fn rectangles_of_lines(lines: &[(usize, BoundingBox)], size: Vector, near: f64) -> Vec<(BoundingBox, [usize; 4])> {
    let lies = |axis: usize| {
        let across = 1 - axis;
        lines.iter().filter(move |(_, b)| {
            b.high[across] - b.low[across] <= near && b.high[axis] - b.low[axis] >= NESTED * size[axis]
        })
    };
    let upright: Vec<_> = lies(1).collect();
    let mut found = Vec::new();
    if upright.len() > MOST_SIDES {
        return found;
    }
    for (left, l) in &upright {
        for (right, r) in &upright {
            if r.low.x - l.high.x < NESTED * size.x {
                continue;
            }
            let whole = BoundingBox { low: l.low.inf(&r.low), high: l.high.sup(&r.high) };
            // Both sides and both of the others end at its corners.
            let is_side = |b: &BoundingBox, axis: usize| {
                (b.low[axis] - whole.low[axis]).abs() <= near && (b.high[axis] - whole.high[axis]).abs() <= near
            };
            let at = |y: f64| lies(0).find(|(_, b)| is_side(b, 0) && (b.low.y - y).abs() <= near);
            if let (true, Some((foot, _)), Some((head, _))) =
                (is_side(l, 1) && is_side(r, 1), at(whole.low.y), at(whole.high.y))
            {
                found.push((whole, [*left, *right, *foot, *head]));
            }
        }
    }
    found
}

/// The share of the area `all` that strokes enclose, with openings up to `door` cells closed.
fn floor_share(drawing: &Drawing, strokes: &[usize], all: &BoundingBox, longer: f64, door: f64) -> Option<f64> {
    let frame = RasterFrame::around(all, longer / CELLS, ceil(door) + 2);
    let mut canvas = RasterCanvas::new(frame.size);
    for &index in strokes {
        let stroke = &drawing.strokes[index];
        let corners = drawing.corners(stroke);
        let closing = stroke.is_closed.then(|| [corners.last(), corners.first()]);
        let ends = corners.windows(2).map(|pair| [pair[0], pair[1]]);
        let closing = closing.and_then(|[last, first]| Some([*last?, *first?]));
        for [a, b] in ends.chain(closing) {
            canvas.segment(frame.cells(a), frame.cells(b)).ok()?;
        }
    }
    let outside = openings::part(&canvas.cells, [Cell::new(0, 0)], door);
    let inside = outside.cells.values().iter().zip(canvas.cells.values());
    let inside = inside.filter(|&(&is_outside, &is_wall)| !is_outside && !is_wall).count();
    Some(inside as f64 * frame.side * frame.side / area(all))
}

#[cfg(test)]
mod tests {
    use crate::{DrawingLayer, Role, read};
    use robovac_core::floor_plan::SourceFile;

    type Rectangle = (&'static str, f64, f64, f64, f64);

    /// A DXF with rectangles: layer, left, bottom, right, top.
    fn layers(rectangles: &[Rectangle]) -> Vec<DrawingLayer> {
        layers_with(rectangles, "")
    }

    /// The same with other entities.
    fn layers_with(rectangles: &[Rectangle], others: &str) -> Vec<DrawingLayer> {
        let polyline = |&(layer, l, b, r, t): &Rectangle| {
            format!(
                "0\nLWPOLYLINE\n8\n{layer}\n70\n1\n10\n{l}\n20\n{b}\n10\n{r}\n20\n{b}\n10\n{r}\n20\n{t}\n10\n{l}\n20\n{t}\n"
            )
        };
        let entities: String = rectangles.iter().map(polyline).collect();
        let bytes = format!("0\nSECTION\n2\nENTITIES\n{entities}{others}0\nENDSEC\n0\nEOF\n").into_bytes();
        read(&SourceFile { name: "a.dxf".into(), bytes }).unwrap().layers
    }

    fn walls(layers: &[DrawingLayer]) -> usize {
        layers.iter().filter(|layer| layer.role == Role::Wall).map(|layer| layer.strokes).sum()
    }

    const PAGE: Rectangle = ("0", 0.0, 0.0, 420.0, 297.0);
    const INNER: Rectangle = ("0", 20.0, 10.0, 410.0, 287.0);
    const TITLE: Rectangle = ("0", 230.0, 10.0, 410.0, 60.0);
    const HOUSE: [Rectangle; 2] = [("0", 60.0, 90.0, 200.0, 260.0), ("0", 200.0, 90.0, 330.0, 260.0)];

    #[test]
    fn a_frame_with_a_title_block_is_no_wall_by_default() {
        let found = layers(&[PAGE, INNER, TITLE, ("0", 240.0, 20.0, 300.0, 40.0), HOUSE[0], HOUSE[1]]);
        let names: Vec<(&str, usize)> = found.iter().map(|layer| (layer.name.as_str(), layer.strokes)).collect();
        assert_eq!(names, [("0", 2), ("page frame", 2), ("title block", 2)]);
        assert_eq!(walls(&found), 2);
        // Frame and house on layers of their own: none is left empty.
        let apart = layers(&[("sheet A3", 0.0, 0.0, 420.0, 297.0), HOUSE[0], HOUSE[1]]);
        assert_eq!((apart.len(), walls(&apart)), (2, 2));
    }

    #[test]
    fn a_small_flat_stands_on_its_sheet() {
        // 7 x 5.6 m in two rooms, at 1:100 on A4: a fifteenth of the sheet.
        let flat = [("0", 60.0, 90.0, 95.0, 146.0), ("0", 95.0, 90.0, 130.0, 146.0)];
        let found = layers(&[("0", 5.0, 5.0, 292.0, 205.0), ("0", 200.0, 5.0, 292.0, 30.0), flat[0], flat[1]]);
        let names: Vec<(&str, usize)> = found.iter().map(|layer| (layer.name.as_str(), layer.strokes)).collect();
        assert_eq!(names, [("0", 2), ("page frame", 1), ("title block", 1)]);
    }

    #[test]
    fn a_frame_was_a_wall_if_the_door_of_the_house_stood_wide_open() {
        let frame = ("0", 5.0, 5.0, 292.0, 205.0);
        // Three sides, each as thick as a line.
        let open = |layer| {
            [(layer, 40.0, 165.0, 220.0, 166.0), (layer, 40.0, 25.0, 41.0, 165.0), (layer, 219.0, 25.0, 220.0, 165.0)]
        };
        let found = |layer| layers(&[[frame].as_slice(), &open(layer)].concat());
        assert_eq!(walls(&found("Waende")), 3);
        assert_eq!(walls(&found("0")), 4, "who knows what they are");
    }

    #[test]
    fn a_rectangle_of_any_shape_round_walls_that_are_called_so_is_a_frame() {
        let frame = ("0", 0.0, 0.0, 420.0, 400.0);
        let called = HOUSE.map(|(_, l, b, r, t)| ("Waende", l, b, r, t));
        assert_eq!(walls(&layers(&[frame, called[0], called[1]])), 2);
        assert_eq!(walls(&layers(&[frame, called[0]])), 1, "a single room");
        // Pillars in a hall, and partitions that reach its walls.
        assert_eq!(walls(&layers(&[frame, ("Waende", 90.0, 90.0, 110.0, 110.0)])), 2);
        assert_eq!(walls(&layers(&[frame, called[0], ("Waende", 0.0, 300.0, 420.0, 310.0)])), 3);
    }

    #[test]
    fn a_frame_of_four_single_lines_is_one() {
        let lines = |&(layer, l, b, r, t): &Rectangle| {
            let line = |[x, y, to_x, to_y]: [f64; 4]| {
                format!("0\nLINE\n8\n{layer}\n10\n{x}\n20\n{y}\n11\n{to_x}\n21\n{to_y}\n")
            };
            [[l, b, r, b], [r, b, r, t], [r, t, l, t], [l, t, l, b]].map(line).concat()
        };
        let frame = lines(&PAGE) + &lines(&INNER);
        let found = layers_with(&[TITLE, HOUSE[0], HOUSE[1]], &frame);
        let names: Vec<(&str, usize)> = found.iter().map(|layer| (layer.name.as_str(), layer.strokes)).collect();
        assert_eq!(names, [("0", 2), ("page frame", 8), ("title block", 1)]);
        // Of any shape, if walls are called so; and the walls of a house are none.
        let called = HOUSE.map(|(_, l, b, r, t)| ("Waende", l, b, r, t));
        assert_eq!(walls(&layers_with(&called, &lines(&("0", 0.0, 0.0, 420.0, 400.0)))), 2);
        assert_eq!(walls(&layers_with(&[], &(lines(&HOUSE[0]) + &lines(&HOUSE[1])))), 8);
    }

    #[test]
    fn a_room_is_no_frame() {
        // Pillars, not a building.
        let pillars = [("0", 90.0, 90.0, 110.0, 110.0), ("0", 300.0, 190.0, 320.0, 210.0)];
        assert_eq!(walls(&layers(&[PAGE, pillars[0], pillars[1]])), 3);
        // Called a wall.
        assert_eq!(walls(&layers(&[("Aussenwand", 0.0, 0.0, 420.0, 297.0), HOUSE[0], HOUSE[1]])), 3);
        // Partitions that reach the outer wall.
        let partition = ("0", 0.0, 100.0, 420.0, 110.0);
        assert_eq!(walls(&layers(&[PAGE, partition, HOUSE[0]])), 3);
        // Another shape than a sheet.
        assert_eq!(walls(&layers(&[("0", 0.0, 0.0, 420.0, 400.0), HOUSE[0], HOUSE[1]])), 3);
    }
}
