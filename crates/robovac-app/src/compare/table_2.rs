//! Table 2 of Emu & Obaida's thesis (000, section 5.2), to be shown beside our numbers in a room of as many cells.

use super::RoomChoice;

/// A row of the printed table.
#[derive(Debug, Clone, Copy)]
pub struct PrintedRow {
    /// The algorithm's name in the thesis.
    pub algorithm: &'static str,
    /// Turns; a reversal is one.
    pub turns: u32,
    /// Revisits.
    pub revisits: u32,
    /// Length, m.
    pub length_m: f64,
    /// Id of the planner here.
    pub planner: &'static str,
}

/// The table. The running text has the lengths of the genetic and of the proposed algorithm the other way round.
pub const TABLE_2: [PrintedRow; 3] = [
    PrintedRow { algorithm: "genetic", turns: 81, revisits: 0, length_m: 45.2, planner: "genetic" },
    PrintedRow { algorithm: "spiral", turns: 100, revisits: 51, length_m: 56.8, planner: "spiral" },
    PrintedRow { algorithm: "proposed", turns: 37, revisits: 5, length_m: 48.0, planner: "snake" },
];

/// Our room with as many cells, of [`TABLE_2_CELL`] m.
pub const TABLE_2_ROOM: &str = "thesis226";
/// Side of the thesis' cells, m.
pub const TABLE_2_CELL: f64 = 0.2;

impl PrintedRow {
    /// The row of a planner in a room with cells of `cell_size` m; `None` but in [`TABLE_2_ROOM`].
    pub fn find(planner: &str, room: RoomChoice, cell_size: f64) -> Option<&'static Self> {
        let is_there = room == RoomChoice::Shipped(TABLE_2_ROOM) && cell_size == TABLE_2_CELL;
        TABLE_2.iter().find(|row| is_there && row.planner == planner)
    }

    /// The printed value of a number of the tables, by its id.
    pub fn value(&self, metric: &str) -> Option<f64> {
        match metric {
            "direction_changes" => Some(self.turns.into()),
            "revisits" => Some(self.revisits.into()),
            "length" => Some(self.length_m),
            _ => None,
        }
    }
}
