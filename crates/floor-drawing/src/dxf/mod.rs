//! DXF drawings: text and binary, of every release since R10.
//!
//! [`scan`] reads the file once and checks every group code and number that is drawn, so that messages can name the
//! line. Entities become polylines as they are read ([`draw`]), and blocks are inserted afterwards ([`expand`]). Only
//! model space is drawn, seen from above.

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
