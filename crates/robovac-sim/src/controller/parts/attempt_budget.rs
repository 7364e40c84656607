//! Counts attempts at places, so that no place is tried for ever.

use crate::mapping::TiledLayer;
use robovac_core::{geometry::Point, grid::Cell};

/// Cost of attempts at which a place is given up (ours).
const MOST: u8 = 8;
/// Costs of starting towards a place, of passing it, and of being stopped before it.
const SET_OUT: u8 = 1;
const CAME_BY: u8 = 2;
const STOPPED: u8 = 3;
/// Side of the cells in which attempts at points are counted, m.
const SIDE: f64 = 0.1;
/// Distance at which a point counts as reached, m.
pub(in crate::controller) const THERE: f64 = 0.4;

/// Cost of attempts so far, cell by cell. It guarantees that attempts end.
#[derive(Debug, Clone, Default)]
pub(in crate::controller) struct AttemptBudget(TiledLayer<u8>);

impl AttemptBudget {
    /// The cell in which attempts at a point are counted.
    pub(in crate::controller) fn cell(point: Point) -> Cell {
        Cell::at(point, SIDE)
    }

    /// Counts a start towards a cell.
    pub(in crate::controller) fn set_out(&mut self, cell: Cell) {
        self.spend(cell, SET_OUT);
    }

    /// Counts a passed cell: if it isn't clean by now, it hardly ever will be.
    pub(in crate::controller) fn came_by(&mut self, cell: Cell) {
        self.spend(cell, CAME_BY);
    }

    /// Counts a stop on the way to a cell.
    pub(in crate::controller) fn stopped(&mut self, cell: Cell) {
        self.spend(cell, STOPPED);
    }

    /// Counts a stop `at` a point on the way to a goal; only if they are near, the goal can't be reached.
    pub(in crate::controller) fn stopped_at(&mut self, at: Point, goal: Point) {
        if (at - goal).norm() < THERE {
            self.stopped(Self::cell(goal));
        }
    }

    /// Whether a cell is given up.
    pub(in crate::controller) fn is_spent(&self, cell: Cell) -> bool {
        self.0.get(cell) >= MOST
    }

    /// Gives cells that were given up one more chance.
    pub(in crate::controller) fn forgive(&mut self) {
        let spent: Vec<Cell> = self.0.iter().filter(|&(_, cost)| cost >= MOST).map(|(cell, _)| cell).collect();
        for cell in spent {
            self.0.update(cell, |_| MOST - STOPPED);
        }
    }

    fn spend(&mut self, cell: Cell, cost: u8) {
        self.0.update(cell, |spent| spent.saturating_add(cost));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_is_done_for_a_cell_ends() {
        let cell = Cell::new(3, -2);
        for (spend, times) in [
            (AttemptBudget::set_out as fn(&mut AttemptBudget, Cell), 8),
            (AttemptBudget::came_by, 4),
            (AttemptBudget::stopped, 3),
        ] {
            let mut budget = AttemptBudget::default();
            let needed = (1..20).find(|_| {
                spend(&mut budget, cell);
                budget.is_spent(cell)
            });
            assert_eq!(needed, Some(times));
            budget.forgive();
            assert!(!budget.is_spent(cell));
            budget.stopped(cell);
            assert!(budget.is_spent(cell) && !budget.is_spent(Cell::new(3, -1)));
        }
    }

    #[test]
    fn a_place_is_given_up_sooner_by_those_who_were_there() {
        let (place, far) = (Point::new(1.0, 1.0), Point::new(3.0, 1.0));
        let cell = AttemptBudget::cell(place);
        let tries_until = |at: Point| {
            let mut budget = AttemptBudget::default();
            (1..20).find(|_| {
                budget.set_out(cell);
                budget.stopped_at(at, place);
                budget.is_spent(cell)
            })
        };
        assert_eq!((tries_until(place), tries_until(far)), (Some(2), Some(8)));
        assert!(!AttemptBudget::default().is_spent(cell));
    }
}
