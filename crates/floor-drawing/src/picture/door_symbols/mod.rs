//! Symbols of doors in a picture: a leaf from the hinge, and the arc along which it swings. They are no walls.

mod contacts;
mod marking;
mod strokes;
mod swing;
#[cfg(test)]
mod tests;

use super::thickness::{ReducedPicture, erase_reduced};
use contacts::contacts;
use robovac_core::{geometry::Point, grid::Grid};
use strokes::Strokes;
use swing::Swing;

/// Widths of strokes that are too thin for a wall, as shares of the usual thickness of walls, and the least, pixels:
/// partitions can be much thinner than outer walls, and lines nearly as thick as partitions. In small pictures walls are hardly
/// thicker than lines.
const THIN: [(f64, f64); 3] = [(0.5, 4.0), (0.5, 3.0), (0.25, 2.0)];
/// Least width of a doorway in pixels, and in thicknesses of walls.
const NARROWEST: f64 = 14.0;
const NARROWEST_IN_WALLS: f64 = 1.3;
/// Greatest width of a doorway, as a share of the picture's longer side, and in thicknesses of walls.
const WIDEST: f64 = 0.3;
const WIDEST_IN_WALLS: f64 = 20.0;
/// Most places where lines meet walls: a picture with more is no plan but noise or hatching.
const MOST_CONTACTS: usize = 12_000;
/// Widths of the first leaf of two, as shares of the doorway.
const SPLITS: [f64; 3] = [0.5, 0.65, 0.35];

/// Removes the symbols of doors, and the lines of their thresholds.
pub(super) fn remove(walls: &mut Grid<bool>) {
    let Some(ReducedPicture { by, cells: reduced, usual }) = ReducedPicture::new(walls) else { return };
    let mut found = FoundDoors { doors: Vec::new(), pixels: reduced.map(|_| false) };
    // Thick lines first: of those, the other look sees only the thinnest parts.
    let mut before = u16::MAX;
    for side in THIN.map(|(share, least)| (share * usual).round().max(least) as u16) {
        if side < before && f64::from(side) < usual {
            found.add(&reduced, side, usual);
        }
        before = side;
    }
    if found.doors.is_empty() {
        return;
    }
    erase_reduced(walls, by, &found.pixels);
}

/// Doors that were found, and the pixels of their lines.
struct FoundDoors {
    doors: Vec<DoorSymbol>,
    pixels: Grid<bool>,
}

impl FoundDoors {
    /// Adds the doors of lines narrower than `side` pixels between walls, which are `usual` pixels thick.
    fn add(&mut self, walls: &Grid<bool>, side: u16, usual: f64) {
        let strokes = Strokes::new(walls, side, usual);
        let contacts = contacts(&strokes);
        if contacts.len() > MOST_CONTACTS {
            return;
        }
        let least = NARROWEST.max(NARROWEST_IN_WALLS * usual);
        let most = (WIDEST * walls.width().max(walls.height()) as f64).min(WIDEST_IN_WALLS * usual);
        let mut doors: Vec<DoorSymbol> = Vec::new();
        contacts::for_pairs(&contacts, [least, most], |a, b| {
            if strokes.is_doorway(a, b) {
                doors.extend([true, false].into_iter().filter_map(|is_left| DoorSymbol::fit(&strokes, a, b, is_left)));
            }
        });
        // Pixels beside the true jambs give nearly the same door, not as well.
        doors.sort_by(|a, b| b.drawn().total_cmp(&a.drawn()));
        for door in doors {
            if !self.doors.iter().any(|other| door.overlaps(other)) {
                door.mark(&strokes, &mut self.pixels);
                self.doors.push(door);
            }
        }
    }
}

/// The symbol of a door: one leaf, or two.
struct DoorSymbol {
    swings: Vec<Swing>,
    jambs: [Point; 2],
    /// Whether it opens to the left of the way from jamb to jamb.
    is_left: bool,
}

impl DoorSymbol {
    /// The door between two jambs that opens to the left or to the right of the way from `a` to `b`.
    fn fit(strokes: &Strokes, a: Point, b: Point, is_left: bool) -> Option<Self> {
        if !strokes.is_floor(a, b, !is_left) {
            return None;
        }
        let door = |swings| Some(Self { swings, jambs: [a, b], is_left });
        let single = Swing::fit(strokes, a, b, is_left).or_else(|| Swing::fit(strokes, b, a, !is_left));
        if let Some(single) = single {
            return door(vec![single]);
        }
        for share in SPLITS {
            let meet = a + (b - a) * share;
            let first = Swing::fit(strokes, a, meet, is_left);
            if let Some(pair) = first.and_then(|first| Some(vec![first, Swing::fit(strokes, b, meet, !is_left)?])) {
                return door(pair);
            }
        }
        None
    }

    /// How well it is drawn, 0 to 1.
    fn drawn(&self) -> f64 {
        self.swings.iter().map(|swing| swing.drawn).sum::<f64>() / self.swings.len() as f64
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.swings.iter().any(|swing| other.swings.iter().any(|other| swing.overlaps(other)))
    }

    /// Marks its lines.
    fn mark(&self, strokes: &Strokes, found: &mut Grid<bool>) {
        for swing in &self.swings {
            swing.mark(strokes, found);
        }
        marking::mark_threshold(strokes, self.jambs, self.is_left, found);
    }
}
