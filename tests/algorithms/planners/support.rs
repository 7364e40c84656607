//! Rooms that the tests of planners share.

use coverage_planners::{CoverageJob, PLANNERS, Planner, PlannerInfo};
use robovac_core::{
    floor_plan::{
        ROOMS,
        generate::{random_clutter, random_hall},
    },
    grid::{Cell, Direction, Grid, from_picture},
    registry::{ParamKind, ParamSpec, ParamValue, Params},
    robot::model,
};
use robovac_sim::experiment::planning::RoomSetup;
use std::{fs, path::PathBuf, sync::LazyLock};

/// Free cells from which on tests don't look for something better: what holds at the least effort and with full effort in
/// small rooms is worth more than the minutes.
pub const LARGE: usize = 120;

/// The planners that walk from cell to cell; others plan in metres.
pub fn walking() -> impl Iterator<Item = &'static PlannerInfo> + Clone {
    PLANNERS.iter().copied().filter(|info| !info.is_in_metres())
}

/// The planner with its default parameters, with the least effort for a large room.
pub fn build(info: &PlannerInfo, cells: usize) -> Box<dyn Planner> {
    let mut params = Params::defaults(info.params);
    if let Some(&ParamSpec { id, kind: ParamKind::Number { min, .. }, .. }) = info.effort().filter(|_| cells > LARGE) {
        params.set(info.params, id, ParamValue::Number(min)).expect("the least is in range");
    }
    info.build(&params)
}

/// A room to plan in.
pub struct Scenario {
    pub name: String,
    pub free: Grid<bool>,
    /// Where plans start.
    pub starts: Vec<Cell>,
    pub headings: Vec<Direction>,
}

impl Scenario {
    /// A room tried from every corner of its free cells and from its middle.
    pub fn new(name: impl Into<String>, free: Grid<bool>) -> Self {
        let cells: Vec<Cell> = free.iter().filter(|&(_, &f)| f).map(|(cell, _)| cell).collect();
        let middle = cells[cells.len() / 2];
        let extreme = |key: fn(&Cell) -> i32| cells.iter().copied().max_by_key(key).unwrap_or(middle);
        let mut starts = vec![
            extreme(|c| c.y - c.x),
            extreme(|c| c.x + c.y),
            extreme(|c| -c.x - c.y),
            extreme(|c| c.x - c.y),
            middle,
        ];
        starts.sort_unstable();
        starts.dedup();
        Self { name: name.into(), free, starts, headings: Direction::ALL.to_vec() }
    }

    /// A room tried once.
    pub fn once(name: impl Into<String>, free: Grid<bool>, start: Cell) -> Self {
        Self { name: name.into(), free, starts: vec![start], headings: vec![Direction::Right] }
    }

    /// Every start with every heading.
    pub fn jobs(&self) -> impl Iterator<Item = CoverageJob> + '_ {
        let starts = self.starts.iter();
        starts.flat_map(|&start| self.headings.iter().map(move |&heading| (start, heading))).map(|(start, heading)| {
            CoverageJob::new(&self.free, start, heading).unwrap_or_else(|| panic!("{}: {start} isn't free", self.name))
        })
    }
}

/// Rooms drawn by hand, each for something that is easily got wrong.
const DRAWN: &[(&str, &str)] = &[
    ("single cell", "."),
    ("corridor", "........."),
    ("shaft", ".\n.\n.\n.\n."),
    ("square", "....\n....\n....\n...."),
    ("the thesis' room", EIGHT),
    (
        "spiral corridor",
        "
        .........
        .#######.
        .#.....#.
        .#.###.#.
        .#.#...#.
        .#.#####.
        .#.......",
    ),
    (
        "comb",
        "
        .#.#.#.#.
        .#.#.#.#.
        .#.#.#.#.
        .........",
    ),
    (
        "comb lying on its side",
        "
        ......
        .#####
        ......
        .#####
        ......
        .#####",
    ),
    (
        "islands",
        "
        ...........
        .##..#..##.
        .##.....##.
        ....###....
        .#..###..#.
        ....###....
        .##.....##.
        ...........",
    ),
    (
        "C",
        "
        .......
        .......
        ..#####
        ..#####
        .......
        .......",
    ),
    (
        "dead ends",
        "
        ####.####
        ####.####
        ...#.#...
        ##.....##
        ##.....##
        ...#.#...
        ####.####",
    ),
    (
        "door between two rooms",
        "
        .....#.....
        .....#.....
        ...........
        .....#.....
        .....#.....",
    ),
    (
        "slanted walls",
        "
        ....######
        .....#####
        ......####
        #......###
        ##......##
        ###......#
        ####......
        #####....#
        ######..##",
    ),
];

/// The thesis' own room (Emu & Obaida 2020, Appendix B).
pub const EIGHT: &str = "
    ...##...
    ...##...
    ...##...
    ........
    ........
    ........
    ##......
    ##......";

/// A drawn room.
pub fn drawn(text: &str) -> Grid<bool> {
    from_picture(text, |c| c == '.').expect("the picture is a rectangle")
}

/// All rooms of the contract: drawn, made up, and the shared grids where they exist. Laid out once for all tests.
pub fn scenarios() -> &'static [Scenario] {
    static ALL: LazyLock<Vec<Scenario>> = LazyLock::new(all_scenarios);
    &ALL
}

fn all_scenarios() -> Vec<Scenario> {
    let mut all: Vec<Scenario> = DRAWN.iter().map(|(name, text)| Scenario::new(*name, drawn(text))).collect();
    for (seed, share) in [0.05, 0.1, 0.2, 0.3, 0.4].into_iter().enumerate() {
        let free = random_clutter(18, 13, share, seed as u64);
        all.push(Scenario::new(format!("clutter of {share}"), free));
    }
    all.push(Scenario::once("hall of 200 x 200", random_hall(200, 200, 1), Cell::new(0, 0)));
    all.push(Scenario::once("clutter of 200 x 200", random_clutter(200, 200, 0.2, 1), Cell::new(0, 0)));
    all.extend(shipped_rooms());
    all.extend(shared_grids());
    all
}

/// The rooms that ship, on the planning grids of the robots that fit into all of them.
fn shipped_rooms() -> Vec<Scenario> {
    let robots = ["roomba600", "cell"].map(|id| model(id).expect("the robot ships"));
    let rooms = ROOMS.iter().flat_map(|room| robots.into_iter().map(move |robot| (room, robot)));
    rooms
        .map(|(room, robot)| {
            let prepared = RoomSetup::new(&(room.build)(), robot, robot.default_cell, None).expect("the robot fits");
            Scenario::once(format!("{} for {}", room.id, robot.id), prepared.job.free, prepared.job.start)
        })
        .collect()
}

/// Rooms that walks are measured in: our own, and those of [`shared_grids`].
pub fn measured_grids() -> Vec<Scenario> {
    let own = [
        ("own: empty", Grid::filled(18, 12, true)),
        ("own: clutter", random_clutter(14, 10, 0.15, 7)),
        ("own: hall", random_hall(30, 20, 3)),
    ];
    let own = own.map(|(name, free)| Scenario::once(name, free, Cell::new(0, 0)));
    own.into_iter().chain(shared_grids()).collect()
}

/// The measured rooms that a table has figures of, by the beginnings of their names; our own are among them.
pub fn measured<T: Copy>(table: &[(&str, T)]) -> Vec<(Scenario, T)> {
    let figures = |scenario: &Scenario| table.iter().find(|(start, _)| scenario.name.starts_with(start));
    let found: Vec<(Scenario, T)> =
        measured_grids().into_iter().filter_map(|scenario| figures(&scenario).map(|&(_, t)| (scenario, t))).collect();
    assert!(found.iter().filter(|(scenario, _)| scenario.name.starts_with("own")).count() == 3);
    found
}

/// Rooms of closed tours, and what the best one known costs: a step each, and 50 a quarter turn. Of our own, then those
/// shared on the machine where this was developed, if they're there.
pub fn measured_tours() -> Vec<(CoverageJob, usize)> {
    let own = [
        // To and fro over seven columns, and back along the eighth: 96 steps, and two turns a row.
        (Grid::filled(12, 8, true), 96 + 16 * 50),
        // Round once.
        (drawn(&format!("{0}\n{1}{0}", ".".repeat(10), ".########.\n".repeat(5))), 30 + 4 * 50),
        // There and back again.
        (Grid::filled(1, 9, true), 16 + 4 * 50),
    ];
    let shared = files("turncost").into_iter().map(|(_, text)| {
        let (_, known) = text.split_once("best_ip ").expect("the header tells the best tour");
        let known: f64 = known.split_whitespace().next().and_then(|known| known.parse().ok()).expect("a number");
        (picture_of(&text).map(|&c| c != '#'), known as usize)
    });
    own.into_iter()
        .chain(shared)
        .map(|(free, known)| {
            let start = free.iter().find(|&(_, &free)| free).expect("something is free").0;
            (CoverageJob::new(&free, start, Direction::Right).expect("the start is free"), known)
        })
        .collect()
}

/// Grids that other planners have been measured on; none where the folder doesn't exist.
pub fn shared_grids() -> Vec<Scenario> {
    let scenario = |(name, text): (String, String)| {
        let glyphs = picture_of(&text);
        let (start, _) = glyphs.iter().find(|&(_, &c)| c == 'S').expect("the grid has a start");
        Scenario::once(name, glyphs.map(|&c| c != '#'), start)
    };
    files("grids").into_iter().map(scenario).collect()
}

/// Names and texts of the files in a folder of maps beside the repository; none in a public clone.
fn files(folder: &str) -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/maps").join(folder);
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.sort();
    let name = |file: &PathBuf| file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    files.iter().map(|file| (name(file), fs::read_to_string(file).expect("it can be read"))).collect()
}

/// The rows of a grid file without its header.
fn picture_of(text: &str) -> Grid<char> {
    let rows: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
    from_picture(&rows.join("\n"), |c| c).expect("the grid is a rectangle")
}
