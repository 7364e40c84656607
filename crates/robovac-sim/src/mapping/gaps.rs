//! Gaps between the lanes of a map.

use robovac_core::grid::{Grid, Occupancy, clearance};

/// Half the width of gaps of unknown cells that count as floor, m: a robot that crosses a room in lanes would have met
/// an obstacle there.
const GAP: f64 = 0.125;

/// Makes floor of unknown cells, which are `side` metres wide, in gaps of known floor (closing, as of mathematical morphology:
/// what is farther from floor than half a gap stays unknown, and so does what is not farther from that).
pub fn close_gaps(occupancy: &mut Grid<Occupancy>, side: f64) {
    let reach = (GAP / side) as f32;
    let floor = occupancy.map(|&what| what == Occupancy::Free);
    let far = clearance(&floor, reach + 2.0).map(|&cells| cells > reach);
    let kept = clearance(&far, reach + 2.0);
    for (value, &room) in occupancy.values_mut().iter_mut().zip(kept.values()) {
        if *value == Occupancy::Unknown && room > reach {
            *value = Occupancy::Free;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::Cell;

    #[test]
    fn a_gap_between_lanes_is_floor_and_what_is_wider_or_occupied_is_not() {
        // Lanes of four cells; between them are two cells, one of which is occupied, and eight.
        let mut map = Grid::filled(22, 12, Occupancy::Unknown);
        for x in (0..4).chain(6..10).chain(18..22) {
            (0..12).for_each(|y| map[Cell::new(x, y)] = Occupancy::Free);
        }
        map[Cell::new(4, 6)] = Occupancy::Occupied;
        close_gaps(&mut map, 0.05);
        let at = |x: i32, y: i32| map[Cell::new(x, y)];
        assert_eq!([at(4, 5), at(5, 5), at(5, 6)], [Occupancy::Free; 3]);
        assert_eq!((at(4, 6), at(14, 5)), (Occupancy::Occupied, Occupancy::Unknown));
    }
}
