//! Attempts at places are counted, so that no place is tried for ever.

use crate::mapping::TiledLayer;
use robovac_core::{geometry::Point, grid::Cell};

/// Attempts' cost at which a place is given up (ours).
const MOST: u8 = 8;
/// What it costs to set out for a place, to come by, and to be stopped before it.
const SET_OUT: u8 = 1;
const CAME_BY: u8 = 2;
const STOPPED: u8 = 3;
/// Side of the cells that attempts at points are counted in, m.
const SIDE: f64 = 0.1;
/// How near to a point counts as there, m.
pub(in crate::controller) const THERE: f64 = 0.4;

/// What attempts have cost so far, cell by cell. Whatever happens, so much comes to an end.
#[derive(Debug, Clone, Default)]
pub(in crate::controller) struct AttemptBudget(TiledLayer<u8>);

impl AttemptBudget {
    /// The cell in which attempts at a point are counted.
    pub(in crate::controller) fn cell(point: Point) -> Cell {
        Cell::at(point, SIDE)
    }

    /// The robot sets out for a cell.
    pub(in crate::controller) fn set_out(&mut self, cell: Cell) {
        self.spend(cell, SET_OUT);
    }

    /// It has come to a cell: if that isn't clean by now, it hardly ever will be.
    pub(in crate::controller) fn came_by(&mut self, cell: Cell) {
        self.spend(cell, CAME_BY);
    }

    /// Something has stopped it on the way to a cell.
    pub(in crate::controller) fn stopped(&mut self, cell: Cell) {
        self.spend(cell, STOPPED);
    }

    /// It was stopped `at` a point on its way to a goal: only if that is near, the goal can't be reached.
    pub(in crate::controller) fn stopped_at(&mut self, at: Point, goal: Point) {
        if (at - goal).norm() < THERE {
            self.stopped(Self::cell(goal));
        }
    }

    /// Whether a cell is given up.
    pub(in crate::controller) fn is_spent(&self, cell: Cell) -> bool {
        self.0.get(cell) >= MOST
    }

    /// Cells that were given up get another chance, one.
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
