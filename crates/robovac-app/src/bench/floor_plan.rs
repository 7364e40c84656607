//! Benchmarks of the sweeping planner of 001, its obstacle map, and large drawings.

use super::Bench;
use crate::floor_plan::DrawingSession;
use coverage_planners::sweep::{SweepSetup, sweep};
use robovac_core::{
    cspace::{ConfigurationSpace, Outline},
    floor_plan::{SourceFile, room},
    math,
    robot::model,
};
use std::{fmt::Write, ops::ControlFlow};

/// Entities of the large drawing.
const ENTITIES: usize = 100_000;
/// Side of the cells, m: 001's hall in cells of 10 cm, and in as many as give a map of 1000 x 1000.
const CELL: f64 = 0.1;
const FINE_CELL: f64 = 0.02;
/// Headings of the large obstacle map: one every five degrees.
const HEADINGS: usize = 72;

/// 001's case (20 m x 20 m, seven obstacles, an octagon) in a freshly loaded program, and again; an obstacle map of
/// 1000 x 1000 x 72; a drawing of 100,000 entities.
pub fn floor_plan(bench: &mut Bench<'_>) {
    let go_on = &mut |_| ControlFlow::Continue(());
    let (Some(hall), Some(octagon)) = (room("hall20"), model("octagon")) else { return };
    let (hall, outline) = ((hall.build)(), Outline::of(octagon));
    let setup = SweepSetup::new(outline.clone(), CELL);
    bench.once("sweep the hall of 001, the first time", || drop(sweep(&hall, &setup, go_on)));
    bench.take("sweep the hall of 001", &mut || drop(sweep(&hall, &setup, go_on)), None);
    let name = format!("obstacle map of 1000 x 1000 x {HEADINGS}");
    bench.take(&name, &mut || drop(ConfigurationSpace::new(&hall, &outline, FINE_CELL, HEADINGS)), None);
    let entities = bench.size(ENTITIES, ENTITIES / 50);
    let files = [SourceFile { name: "office.dxf".to_owned(), bytes: office_drawing(entities) }];
    let mut board = None;
    bench.take(
        &format!("read and trace {},000 entities", entities / 1000),
        &mut || board = DrawingSession::open(&files).ok(),
        None,
    );
    // Most of it is the number of rooms, which is the same in any case.
    if let Some(mut board) = board.filter(|_| !bench.once) {
        bench.take("sweep the room of that drawing", &mut || drop(board.sweep(go_on)), None);
    }
}

/// A DXF in millimetres: an office floor of 100 m x 72 m with corridors and 228 rooms of 5 m x 5 m, in each a door, two
/// desks, a round table and chairs; the rest of the `entities` are the pattern of the floor. 100,000 make 10.1 MB.
pub fn office_drawing(entities: usize) -> Vec<u8> {
    let mut sheet = BenchSheet { text: HEADER.to_owned(), handle: 0x100 };
    for room in 0..ROOMS {
        let (column, row) = (room % COLUMNS, room / COLUMNS);
        // Rows of rooms face each other across a corridor of 2 m.
        let (x, low, up) = (5000.0 * column as f64, 6000.0 * row as f64, row % 2 == 0);
        let (back, front) = if up { (low, low + 5000.0) } else { (low + 6000.0, low + 1000.0) };
        let into = if up { 1.0 } else { -1.0 };
        if up && (column == 0 || column + 1 == COLUMNS) {
            let end = if column == 0 { x } else { x + 5000.0 };
            sheet.chain("A-WALL", &[[end, low + 5000.0], [end, low + 7000.0]]);
        }
        let is_outside = row == 0 || row + 1 == ROOMS / COLUMNS;
        if column != CROSSING || is_outside {
            sheet.chain("A-WALL", &[[x, back], [x + 5000.0, back]]);
        }
        if column == CROSSING {
            continue;
        }
        sheet.chain("A-WALL", &[[x + 50.0, front], [x + 50.0, back + into * 50.0], [x + 4950.0, back + into * 50.0]]);
        sheet.chain("A-WALL", &[[x + 4950.0, back + into * 50.0], [x + 4950.0, front]]);
        for (from, to) in [(0.0, 2000.0), (3000.0, 5000.0)] {
            sheet.rectangle("A-WALL", [x + from, front], [x + to, front + into * 100.0]);
        }
        sheet.circle("A-DOOR", [x + 2000.0, front], 900.0);
        for desk in [600.0, 3000.0] {
            sheet.rectangle("A-FURN", [x + desk, back + into * 500.0], [x + desk + 1600.0, back + into * 1300.0]);
            sheet.circle("A-FURN", [x + desk + 800.0, back + into * 1700.0], 250.0);
        }
        sheet.circle("A-FURN", [x + 1200.0, back + into * 3500.0], 500.0);
        let begun = sheet.handle - 0x100;
        let tiles = (entities * (room + 1) / ROOMS).saturating_sub(begun);
        for tile in 0..tiles {
            let (i, j) = ((tile % 20) as f64, (tile / 20) as f64);
            let at = [x + 100.0 + 240.0 * i, low + 100.0 + 240.0 * j];
            sheet.chain("A-FLOR-PATT", &[at, [at[0] + 200.0, at[1] + 200.0]]);
        }
    }
    sheet.text.push_str("0\nENDSEC\n0\nEOF\n");
    sheet.text.into_bytes()
}

/// Rooms of the office floor and its corridor across, and of a row of them.
const ROOMS: usize = 240;
const COLUMNS: usize = 20;
/// The column that is a corridor across all others.
const CROSSING: usize = 10;
/// Sides of polygons that stand for circles.
const SIDES: u32 = 16;
const HEADER: &str =
    "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";

/// A drawing under construction.
struct BenchSheet {
    text: String,
    /// The last entity's handle.
    handle: usize,
}

impl BenchSheet {
    /// Lines from point to point.
    fn chain(&mut self, layer: &str, points: &[[f64; 2]]) {
        for ends in points.windows(2) {
            self.handle += 1;
            let (handle, [ax, ay], [bx, by]) = (self.handle, ends[0], ends[1]);
            // Writing to a string doesn't fail.
            let _ = write!(
                self.text,
                "  0\nLINE\n  5\n{handle:X}\n  8\n{layer}\n 10\n{ax:.3}\n 20\n{ay:.3}\n 30\n0.0\n 11\n{bx:.3}\n 21\n{by:.3}\n 31\n0.0\n"
            );
        }
    }

    fn rectangle(&mut self, layer: &str, [ax, ay]: [f64; 2], [bx, by]: [f64; 2]) {
        self.chain(layer, &[[ax, ay], [bx, ay], [bx, by], [ax, by], [ax, ay]]);
    }

    fn circle(&mut self, layer: &str, [x, y]: [f64; 2], radius: f64) {
        let corner = |i: u32| {
            let (sin, cos) = math::sin_cos(math::TAU * f64::from(i % SIDES) / f64::from(SIDES));
            [x + radius * cos, y + radius * sin]
        };
        let corners: Vec<_> = (0..=SIDES).map(corner).collect();
        self.chain(layer, &corners);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::floor_plan::FloorPlanSettings;

    #[test]
    fn office_has_as_many_entities_as_asked_and_can_be_swept() {
        let bytes = office_drawing(30_000);
        assert_eq!(bytes.windows(5).filter(|w| w == b"\nLINE").count(), 30_000);
        let mut board = DrawingSession::open(&[SourceFile { name: "office.dxf".to_owned(), bytes }]).unwrap();
        let plan = &board.room().unwrap().plan;
        assert!((plan.width_m() - 100.0).abs() < 1.0 && (plan.height_m() - 72.0).abs() < 1.0);
        assert!((5500.0..7000.0).contains(&board.floor_m2()), "{}", board.floor_m2());
        board.set(FloorPlanSettings { cell: 0.1, ..board.settings().clone() }).unwrap();
        board.sweep(&mut |_| ControlFlow::Continue(())).unwrap();
        let sweep = board.planned().unwrap();
        assert!(sweep.coverage > 0.99 && sweep.subgoals.len() > 5000, "{} {}", sweep.coverage, sweep.subgoals.len());
    }
}
