//! Rooms that extend through open doors, and their size with these doors closed.

use super::FaultMark;
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

/// Most widths of openings that are tried, the narrowest first: each is traced.
const TRIED: usize = 4;

/// Effect of closing doors.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Doors {
    /// Openings that would be closed in addition; 0 if it isn't known where.
    pub count: usize,
    /// Gap setting that closes them, m.
    pub gap: f64,
    /// Free floor of the room then, m².
    pub floor_m2: f64,
    /// Where they are.
    #[serde(skip)]
    pub(super) openings: Vec<FaultMark>,
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
        let steps = |gap: f64| (gap.max(DOORS[0]) * STEPS - 1e-6).ceil() as u32;
        let mut gaps: Vec<u32> = full.0.gaps.iter().map(|gap| steps(width(gap))).collect();
        gaps.sort_unstable();
        gaps.dedup();
        let narrower =
            gaps.into_iter().map(|steps| f64::from(steps) / STEPS).filter(|&gap| how.gap < gap && gap < DOORS[1]);
        let closed = narrower.take(TRIED).filter_map(|gap| with(gap).map(|closed| (gap, closed)));
        // The narrowest that part the room from others. Wider ones may lie beside furniture: they take less than they leave.
        let chosen = closed.chain([(DOORS[1], full)]).reduce(|chosen, wider| {
            let (floor, less) = (chosen.1.1, wider.1.1);
            if less < 0.5 * floor { wider } else { chosen }
        });
        let (gap, (closed, floor_m2)) = chosen?;
        let is_new = |[a, b]: &&[Point; 2]| (*b - *a).norm() > how.gap;
        let openings = closed.gaps.iter().filter(is_new).map(|gap| {
            let middle = 0.5 * (gap[0].coords + gap[1].coords);
            FaultMark { at: Point::from(closed.corner + middle / closed.metre), width: width(gap) }
        });
        let openings: Vec<_> = openings.collect();
        Some(Self { count: openings.len(), gap, floor_m2, openings })
    }
}
