//! Finds the opening by which the outside reaches floor that walls enclose otherwise.

use super::{
    EnclosedFloor, OUTER_DOOR, OutsideLeak, RoomTracer,
    behind::{OpenRoom, open_rooms},
    cut_frame, openings,
};
use crate::{DrawingFlaw, Tracing, picture::PictureSampler};
use robovac_core::{
    geometry::Point,
    grid::Cell,
    math::{ceil, floor},
};

/// How many times wider than those that are closed openings are that are looked for (ours): the size of the drawing can be
/// wrong.
const LEAKS: [f64; 4] = [1.4, 2.0, 4.0, 8.0];
/// Widest opening that is looked for, as a share of the drawing's longer side.
const WIDEST: f64 = 0.5;
/// Least floor behind a leak, as a share of the floor that is enclosed without it.
const LEAKED: f64 = 0.1;
/// Share of that floor that has to be indoors for the leak to be closed: cells beside walls can differ.
const MOST_OF_IT: f64 = 0.9;
/// Steps per metre of widths that are told.
const STEPS: f64 = 20.0;

/// Most of them by which it can be told too wide, so that closing openings up to it closes it.
const MORE_STEPS: i32 = 2;

/// Floor that is enclosed only with wider openings closed.
struct OpenedFloor {
    /// Its cells, in the drawing.
    places: Vec<Point>,
    floor_m2: f64,
    /// Its widest opening: the middle, and the width, m.
    at: Point,
    width: f64,
}

impl RoomTracer<'_> {
    /// The opening by which the outside reaches most floor that walls enclose otherwise, beside the floor `enclosed`.
    pub(super) fn outside_leak(&self, enclosed: Option<&EnclosedFloor>) -> Result<Option<OutsideLeak>, DrawingFlaw> {
        let closed = self.outer().max(0.5 * OUTER_DOOR);
        let most = WIDEST * (self.bounds.high - self.bounds.low).max() * self.how.metre;
        let enclosed_m2 = enclosed.map_or(0.0, |found| found.inside.count() as f64 * self.how.resolution.powi(2));
        let mut found: Option<OpenedFloor> = None;
        let mut before = 1.1;
        let cut = self
            .picture
            .zip(enclosed)
            .and_then(|(sampler, floor)| cut_frame::without(sampler.picture, floor, self.side));
        let cut = cut.as_ref().map(PictureSampler::new);
        let picture = cut.as_ref().or(self.picture);
        for times in LEAKS.map(|times| times.min(most / closed)) {
            if times <= before {
                continue;
            }
            before = times;
            // In narrower rooms than such an opening, too. Coarser cells for wider openings take as long as the first search at most.
            let how = Tracing { resolution: times * self.how.resolution, ..self.how.clone() };
            let coarse =
                RoomTracer { how: &how, picture, side: times * self.side, bridges: self.bridges.clone(), ..*self };
            let Some(with) = coarse.enclosed_with(times * closed, 0.0)? else { continue };
            let least = found.as_ref().map_or(LEAKED * enclosed_m2, |leak| (1.0 + LEAKED) * leak.floor_m2);
            let opened = with.opened(enclosed, how.resolution);
            if let Some(opened) = opened.filter(|opened| opened.floor_m2 > least) {
                found = Some(opened);
            }
        }
        found.map(|opened| self.measured(opened)).transpose()
    }

    /// The leak with its width as measured in the cells of the room.
    fn measured(&self, OpenedFloor { places, floor_m2, at, width }: OpenedFloor) -> Result<OutsideLeak, DrawingFlaw> {
        let step = |width: f64| ceil(width * STEPS - 1e-6);
        let metres = |steps: i32| f64::from(steps) / STEPS;
        // The opening that is closed then, if all the floor behind it is inside: not only that behind a narrower inner door.
        let closing = |steps: i32| -> Result<Option<(Point, f64)>, DrawingFlaw> {
            let Some(found) = self.enclosed_by(metres(steps))? else { return Ok(None) };
            let inside = places.iter().filter(|&&place| found.has(place)).count();
            if (inside as f64) < MOST_OF_IT * places.len() as f64 {
                return Ok(None);
            }
            let lines = found.openings(self.how.resolution);
            let nearest = lines.into_iter().min_by(|a, b| (a.0 - at).norm().total_cmp(&(b.0 - at).norm()));
            Ok(Some(nearest.unwrap_or((at, width))))
        };
        let told = |at: Point, width: f64, closes: bool| OutsideLeak { at, width, floor_m2, closes, to_garden: false };
        let Some((at, width)) = closing(step(1.2 * width + self.how.resolution))? else {
            return Ok(told(at, metres(step(width)), false));
        };
        // Walls fill whole cells: an opening is as much wider.
        let width = step(width + self.how.resolution);
        for more in 0..=MORE_STEPS {
            if closing(width + more)?.is_some() {
                return Ok(told(at, metres(width + more), true));
            }
        }
        Ok(told(at, metres(width), false))
    }
}

impl EnclosedFloor {
    /// The widest opening of a building that may stand in a garden: as long as it isn't closed, the garden is floor, too.
    pub(super) fn garden_leak(&self, resolution: f64) -> Option<OutsideLeak> {
        let building = self.in_doubt.as_ref()?;
        let widest = |room: &OpenRoom| room.widest().map_or(0.0, |(_, width)| width);
        let room = building.behind.iter().max_by(|a, b| widest(a).total_cmp(&widest(b)))?;
        let ([a, b], width) = room.widest()?;
        Some(OutsideLeak {
            at: self.frame.point(Point::from(0.5 * (a.coords + b.coords))),
            width: f64::from(ceil((width + 1.0) * resolution * STEPS - 1e-6)) / STEPS,
            floor_m2: room.cells.len() as f64 * resolution * resolution,
            closes: true,
            to_garden: true,
        })
    }

    /// Whether a point of the drawing is on this floor.
    pub(super) fn has(&self, point: Point) -> bool {
        let at = self.frame.cells(point);
        self.inside.is_set(Cell::new(floor(at.x), floor(at.y)))
    }

    /// Middle in the drawing, and width, m, of the openings in its walls.
    fn openings(&self, resolution: f64) -> Vec<(Point, f64)> {
        let lines = openings::openings(&self.walls, &self.inside).into_iter();
        lines
            .map(|[a, b]| {
                (self.frame.point(Point::from(0.5 * (a.coords + b.coords))), ((b - a).norm() + 1.0) * resolution)
            })
            .collect()
    }

    /// The largest connected piece of this floor that isn't on the floor `before`, and has an opening that is narrower.
    fn opened(&self, before: Option<&Self>, resolution: f64) -> Option<OpenedFloor> {
        let mut rest = self.inside.clone();
        for index in 0..rest.len() {
            let cell = rest.cell(index);
            rest[cell] &= before.is_none_or(|before| !before.has(self.frame.point(cell.centre(1.0))));
        }
        let rooms = open_rooms(&self.walls, &self.inside, rest);
        // The first of those that are as large.
        let room = rooms.into_iter().rev().max_by_key(|room| room.cells.len())?;
        let ([a, b], width) = room.widest()?;
        Some(OpenedFloor {
            places: room.cells.iter().map(|cell| self.frame.point(cell.centre(1.0))).collect(),
            floor_m2: room.cells.len() as f64 * resolution * resolution,
            at: self.frame.point(Point::from(0.5 * (a.coords + b.coords))),
            width: width * resolution,
        })
    }
}
