//! Effort spent on goals, so that unreachable ones are given up.

use crate::mapping::Layer;
use robovac_core::grid::Cell;

/// How much is spent on a planning cell before it is given up (ours).
const MOST: u8 = 8;
/// What it costs to set out for it, to come by, and to be stopped before it.
const SET_OUT: u8 = 1;
const CAME_BY: u8 = 2;
const STOPPED: u8 = 3;

/// What was spent on planning cells. Whatever happens, so much comes to an end.
#[derive(Debug, Clone, Default)]
pub(super) struct Spent(Layer<u8>);

impl Spent {
    /// The robot sets out for a cell.
    pub fn set_out(&mut self, cell: Cell) {
        self.spend(cell, SET_OUT);
    }

    /// It has come to a cell: if that isn't clean by now, it hardly ever will be.
    pub fn came_by(&mut self, cell: Cell) {
        self.spend(cell, CAME_BY);
    }

    /// Something has stopped it on the way to a cell.
    pub fn stopped(&mut self, cell: Cell) {
        self.spend(cell, STOPPED);
    }

    /// Whether a cell is not to be gone for any more.
    pub fn is_up(&self, cell: Cell) -> bool {
        self.0.get(cell) >= MOST
    }

    /// Cells that were given up get another chance, one.
    pub fn forgive(&mut self) {
        let spent: Vec<Cell> = self.0.iter().filter(|&(_, spent)| spent >= MOST).map(|(cell, _)| cell).collect();
        for cell in spent {
            self.0.update(cell, |_| MOST - STOPPED);
        }
    }

    fn spend(&mut self, cell: Cell, much: u8) {
        self.0.update(cell, |spent| spent.saturating_add(much));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_is_done_for_a_cell_ends() {
        let cell = Cell::new(3, -2);
        for (spend, times) in [(Spent::set_out as fn(&mut Spent, Cell), 8), (Spent::came_by, 4), (Spent::stopped, 3)] {
            let mut spent = Spent::default();
            let needed = (1..20).find(|_| {
                spend(&mut spent, cell);
                spent.is_up(cell)
            });
            assert_eq!(needed, Some(times));
            spent.forgive();
            assert!(!spent.is_up(cell));
            spent.stopped(cell);
            assert!(spent.is_up(cell) && !spent.is_up(Cell::new(3, -1)));
        }
    }
}
