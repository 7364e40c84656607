//! DXF drawings: text and binary, of every release since R10.
//!
//! [`scan`] goes through the file once and checks every group code and number that is drawn; so a message can name its
//! line. Entities become polylines as they come ([`draw`]), and what the blocks hold is put where they are inserted
//! ([`expand`]). Model space alone is drawn, seen from above.

mod draw;
mod entity;
mod expand;
mod local;
mod pairs;
mod scan;
mod units;

pub(super) use pairs::{Form, Pairs, code_page, is_dxf};

use super::{Drawing, DrawingError, error::bad};
use robovac_core::floor_plan::SourceFile;

/// Reads a DXF.
pub(super) fn read(file: &SourceFile) -> Result<Drawing, DrawingError> {
    let stopped = |(place, flaw): scan::Stopped| bad(&file.name, &place, flaw);
    let mut scanned = scan::scan(&file.bytes).map_err(stopped)?;
    expand::expand(&mut scanned).map_err(stopped)?;
    scanned.builder.finish(&file.name, scanned.metre)
}
