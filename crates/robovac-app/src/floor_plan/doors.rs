//! Rooms that extend through open doors, and their size with these doors closed.

use floor_drawing::{DrawingError, DrawingRegion, Traced, Tracing};
use robovac_core::geometry::Point;
use serde::Serialize;

/// Widths of openings that are taken as doors, m (ours): inner doors are 0.6 to 1 m wide, front doors up to 1.2 m.
const DOORS: [f64; 2] = [0.6, 1.2];
/// Tolerance of these widths, cells: openings are measured between the centres of cells, and walls fill whole cells.
const CELLS: f64 = 1.0;
/// Steps per metre of the gap's slider.
const STEPS: f64 = 20.0;
/// Least share of the floor behind doors for a hint.
const BEHIND: f64 = 0.05;

/// Effect of closing doors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Doors {
    /// Openings that would be closed in addition.
    pub count: usize,
    /// Gap setting that closes them, m.
    pub gap: f64,
    /// Free floor of the room then, m².
    pub floor_m2: f64,
}

impl Doors {
    /// Searches for doors through which the room `now`, with `floor` m² free, extends; `None` for `now` if tracing
    /// failed but would succeed with closed doors. `how` are the tracing parameters, `trace` traces with
    /// others, `free` computes the free floor.
    pub(super) fn of(
        trace: impl Fn(&Tracing) -> Result<Traced, DrawingError>,
        how: &Tracing,
        now: Option<(&Traced, f64)>,
        free: impl Fn(&Traced) -> f64,
    ) -> Option<Self> {
        if !matches!(how.region, DrawingRegion::Room(_)) || how.gap >= DOORS[1] {
            return None;
        }
        let with = |gap: f64| {
            let traced = trace(&Tracing { gap, ..how.clone() }).ok()?;
            let floor = free(&traced);
            let is_less = now.is_none_or(|(_, before)| floor < (1.0 - BEHIND) * before);
            is_less.then_some((traced, floor))
        };
        let full = with(DOORS[1])?;
        let width = |&[a, b]: &[Point; 2]| (b - a).norm() + CELLS * how.resolution;
        let widest = full.0.gaps.iter().map(width).fold(how.gap, f64::max);
        // The smallest sufficient gap, so that wider openings stay open.
        let least = (widest.max(DOORS[0]) * STEPS - 1e-6).ceil() / STEPS;
        let narrow = if least < DOORS[1] { with(least).map(|closed| (least, closed)) } else { None };
        let (gap, (closed, floor_m2)) = narrow.unwrap_or((DOORS[1], full));
        let is_new = |[a, b]: &&[Point; 2]| (*b - *a).norm() > how.gap;
        let count = closed.gaps.iter().filter(is_new).count().max(1);
        Some(Self { count, gap, floor_m2 })
    }
}
