//! The frame of a sheet whose pen is nearly as wide as walls are thick: a closed rectangle along the picture's edge, round all
//! else.

use super::{
    marks::{PixelMark, erase, marks},
    thickness::usual_thickness,
};
use robovac_core::grid::{Cell, Grid};

/// Most distance of a side from the picture's edge, as a share of the picture's side (ours).
const AT_EDGE: f64 = 0.06;
/// Most width of its pen, as a share of the usual thickness of walls. A garden wall can be as thick as the house's.
const PEN: f64 = 0.85;
/// Share of a side that is drawn, at least: there is no opening.
const DRAWN: f64 = 0.99;
/// Least side of the building within, as a share of the frame's.
const WITHIN: f64 = 0.5;
/// How much the pen may vary, pixels: edges are smoothed.
const SMOOTHED: i32 = 1;

/// The frame, with its title block and all else that is drawn on to it; `None` if there is none.
pub(super) fn find(walls: &Grid<bool>) -> Option<PixelMark> {
    let all = marks(walls, |_| true);
    let frame = all.iter().find(|mark| is_at_edge(mark, walls))?;
    let size = frame.size().map(|side| WITHIN * f64::from(side));
    let is_building = |mark: &PixelMark| {
        let [width, height] = mark.size().map(f64::from);
        mark.low != frame.low && width >= size[0] && height >= size[1]
    };
    if !all.iter().any(is_building) {
        return None;
    }
    let mut within = walls.clone();
    erase(&mut within, [frame]);
    let most = (PEN * usual_thickness(&within)?).floor() as i32;
    (is_drawn(frame, walls, most)).then(|| frame.clone())
}

/// Whether all sides are near the picture's edge.
fn is_at_edge(mark: &PixelMark, walls: &Grid<bool>) -> bool {
    let [width, height] = [walls.width(), walls.height()].map(|side| side as f64);
    let [x, y] = [AT_EDGE * width, AT_EDGE * height];
    f64::from(mark.low.x) <= x
        && f64::from(mark.low.y) <= y
        && f64::from(mark.high.x) >= width - 1.0 - x
        && f64::from(mark.high.y) >= height - 1.0 - y
}

/// Whether the sides are straight, without openings, and drawn with a pen of at most so many pixels.
fn is_drawn(mark: &PixelMark, walls: &Grid<bool>, most: i32) -> bool {
    let Cell { x: left, y: bottom } = mark.low;
    let Cell { x: right, y: top } = mark.high;
    let sides = [
        (Cell::new(left, bottom), [1, 0], [0, 1]),
        (Cell::new(left, top), [1, 0], [0, -1]),
        (Cell::new(left, bottom), [0, 1], [1, 0]),
        (Cell::new(right, bottom), [0, 1], [-1, 0]),
    ];
    let [width, height] = mark.size();
    sides.into_iter().all(|(from, along, across)| {
        let count = if along[0] == 1 { width } else { height };
        let mut pens: Vec<i32> = (0..count)
            .map(|step| {
                let at = |depth: i32| {
                    Cell::new(
                        from.x + step * along[0] + depth * across[0],
                        from.y + step * along[1] + depth * across[1],
                    )
                };
                // The outermost pixel can be paper where the edge is smoothed.
                let first = (0..=SMOOTHED).find(|&depth| walls.is_set(at(depth))).unwrap_or(0);
                (first..=most + SMOOTHED + 1).take_while(|&depth| walls.is_set(at(depth))).count() as i32
            })
            .collect();
        pens.sort_unstable();
        let (usual, least) = (pens[pens.len() / 2], pens[((1.0 - DRAWN) * pens.len() as f64) as usize]);
        usual <= most && least >= 1.max(usual - SMOOTHED)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::drawn::{fill, frame as ring};

    /// A house with walls of 10 pixels on a sheet of 400 x 300 pixels with a frame at `edge`.
    fn sheet(edge: i32, pen: i32) -> Grid<bool> {
        let mut walls = Grid::filled(400, 300, false);
        ring(&mut walls, [80, 70, 320, 230], 10);
        fill(&mut walls, [180, 80, 190, 180]);
        ring(&mut walls, [edge, edge, 400 - edge, 300 - edge], pen);
        walls
    }

    #[test]
    fn a_frame_nearly_as_thick_as_walls_is_found_with_its_title_block() {
        for pen in [2, 5, 6, 7, 8] {
            let mut walls = sheet(6, pen);
            ring(&mut walls, [300, 6, 394, 50], 3);
            let found = find(&walls).unwrap_or_else(|| panic!("a pen of {pen} pixels"));
            assert_eq!((found.low, found.high), (Cell::new(6, 6), Cell::new(393, 293)), "a pen of {pen} pixels");
            assert!(found.cells.contains(&Cell::new(300, 40)), "the title block");
        }
    }

    #[test]
    fn outer_walls_are_no_frame() {
        assert!(find(&sheet(6, 9)).is_none(), "as thick as the walls within");
        assert!(find(&sheet(40, 6)).is_none(), "far from the edge of the picture");
        let mut walls = sheet(6, 6);
        (180..200).for_each(|x| (0..20).for_each(|y| walls[Cell::new(x, y)] = false));
        assert!(find(&walls).is_none(), "with a gate");
        let mut walls = Grid::filled(400, 300, false);
        ring(&mut walls, [6, 6, 394, 294], 6);
        fill(&mut walls, [200, 100, 210, 200]);
        assert!(find(&walls).is_none(), "the walls of a room, with a thicker partition in it");
        let mut walls = sheet(6, 6);
        fill(&mut walls, [320, 150, 394, 156]);
        assert!(find(&walls).is_none(), "walls connect it with the house");
    }
}
