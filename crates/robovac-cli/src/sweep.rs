//! `sweep`: the subgoal sweep of paper 001, for a robot of any outline.

use super::{drawing::DrawingOptions, failure::Failure, output, source::RoomSource};
use coverage_planners::{
    stage::LineEndContact,
    sweep::{LinkOrder, Sweep, SweepError, SweepSetup, planned_for, sweep},
};
use floor_drawing::{Traced, is_drawing, is_dxf};
use robovac_app::{
    export::{PathFormat, SavedPath},
    floor_plan::sweep_dxf,
};
use robovac_core::{
    cspace::{CspaceError, Outline},
    geometry::Point,
    robot::{RobotModel, WheelLayout, model},
};
use serde::Serialize;
use std::{
    fs,
    ops::ControlFlow,
    path::{Path, PathBuf},
    time::Instant,
};

/// Plan a sweep along scan lines for a robot of any outline
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: RoomSource,
    #[command(flatten)]
    drawing: DrawingOptions,
    /// Robot, see "robovac robots"; its body is the outline unless --outline is given
    #[arg(long, value_name = "ID", default_value = "octagon")]
    robot: String,
    /// Outline in metres: circle:RADIUS, rectangle:LENGTHxWIDTH or octagon:WIDTH
    #[arg(long, value_name = "SHAPE")]
    outline: Option<String>,
    /// Distance between scan lines in metres [default: half the outline's width]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    scan_width: Option<f64>,
    /// Cell size of the obstacle map in metres [default: a quarter of the outline's width]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    cell: Option<f64>,
    /// Order of the links: nearest point at the end of a line; printed, with the paper's steps 3 to 5; uncrossed, without
    /// crossings where the room allows it
    #[arg(long, value_name = "ORDER", default_value = "nearest", value_parser = LinkOrder::ALL.map(LinkOrder::id))]
    order: String,
    /// Distance to keep from everything in metres
    #[arg(long, value_name = "M", default_value_t = 0.0, allow_hyphen_values = true)]
    clearance: f64,
    /// Output file; can be repeated; its extension chooses the format: .csv table, .yaml ROS path, .mcap
    /// ROS 2 bag, .oi.txt Open Interface bytes for a Roomba 600, .txt program, .json all stages
    #[arg(long, value_name = "FILE")]
    out: Vec<PathBuf>,
}

/// The numbers of a sweep.
#[derive(Serialize)]
struct SweepReport<'a> {
    room: &'a str,
    robot: &'a str,
    /// What is kept free, in words.
    kept_free: String,
    width_m: f64,
    scan_width_m: f64,
    cell_m: f64,
    lines: u32,
    subgoals: usize,
    collisions: usize,
    resolved: usize,
    order: LinkOrder,
    crossings: usize,
    /// Crossings and length, m, in the order "nearest", for another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest: Option<(usize, f64)>,
    linked_share: f64,
    finishing_strokes: usize,
    finishing_length_m: f64,
    length_m: f64,
    coverage: f64,
    planning_s: f64,
}

/// All stages, for `.json`.
#[derive(Serialize)]
struct Stages<'a> {
    #[serde(flatten)]
    report: &'a SweepReport<'a>,
    points: Vec<StagePoint>,
    links: Vec<StageLink>,
    path: Vec<[f64; 2]>,
}

#[derive(Serialize)]
struct StagePoint {
    at: [f64; 2],
    status: LineEndContact,
    line: u32,
    obstacle: Option<u32>,
}

#[derive(Serialize)]
struct StageLink {
    from: usize,
    to: usize,
    collides: bool,
    way: Vec<[f64; 2]>,
}

/// Format of a file: a path, or `None` for all stages as JSON.
type SweepFormat = Option<PathFormat>;

/// Plans, writes the files, and returns the numbers that are to be printed.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let unknown = || Failure::unknown("robot", &arguments.robot, "robots");
    let robot = model(&arguments.robot).ok_or_else(unknown)?;
    // Unsupported formats are refused before planning.
    let formats: Vec<SweepFormat> = arguments.out.iter().map(|out| format_of(out)).collect::<Result<_, _>>()?;
    let outline = arguments.outline.as_deref().map_or_else(|| Ok(Outline::of(robot)), parse_outline)?;
    let file = arguments.source.file()?.filter(is_drawing);
    let room = match &file {
        Some(file) => arguments.drawing.trace(file)?,
        None => Traced::of_map(arguments.source.plan()?, 1.0),
    };
    let original = file.as_ref().filter(|file| is_dxf(file)).map(|file| file.bytes.as_slice());
    let plan = &room.plan;
    let width = outline.width();
    let planned = if outline == Outline::of(robot) { planned_for(robot) } else { outline.to_string() };
    // Two driven wheels turn the robot to where it drives; a circle is the same at every heading.
    let turns = robot.wheels == WheelLayout::Differential;
    let setup = SweepSetup {
        scan_width: arguments.scan_width,
        start: plan.start,
        order: LinkOrder::ALL.into_iter().find(|order| order.id() == arguments.order).unwrap_or_default(),
        turns,
        clearance: arguments.clearance,
        ..SweepSetup::new(outline, arguments.cell.unwrap_or(0.25 * width))
    };
    let begin = Instant::now();
    let found = sweep(plan, &setup, &mut |_| ControlFlow::Continue(()))?;
    let report = SweepReport {
        room: &plan.name,
        robot: robot.id,
        kept_free: found.outline.to_string(),
        width_m: width,
        scan_width_m: found.scan_width,
        cell_m: found.cell,
        lines: found.subgoals.iter().map(|point| point.line + 1).max().unwrap_or(0),
        subgoals: found.subgoals.len(),
        collisions: found.collisions,
        resolved: found.resolved,
        order: setup.order,
        crossings: found.crossings,
        nearest: found.nearest.map(|cost| (cost.crossings, cost.length)),
        linked_share: found.linked_share,
        finishing_strokes: found.finish.len(),
        finishing_length_m: found.finish_length,
        length_m: found.length,
        coverage: found.coverage,
        planning_s: begin.elapsed().as_secs_f64(),
    };
    // One that doesn't turn keeps the heading that the path was planned for.
    let heading = plan.start.filter(|_| turns).map_or(0.0, |start| start.heading);
    for (out, format) in arguments.out.iter().zip(formats) {
        let content = written(format, &found, &report, (&room, original), (robot, heading, &planned))?;
        fs::write(out, content).map_err(|error| Failure::io(out.display(), &error))?;
    }
    Ok(output::json(&report))
}

fn format_of(out: &Path) -> Result<SweepFormat, Failure> {
    if out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) {
        return Ok(None);
    }
    let format = PathFormat::of_file(out);
    format.map(Some).ok_or_else(|| unknown_ending(out, ".csv, .yaml, .mcap, .oi.txt, .txt, .json or .dxf"))
}

/// The failure of an output file whose ending isn't one of `endings`.
pub fn unknown_ending(out: &Path, endings: &str) -> Failure {
    Failure::usage(format!("--out {}: unknown file extension; use {endings}", out.display()))
}

fn written(
    format: SweepFormat,
    found: &Sweep,
    report: &SweepReport<'_>,
    (room, original): (&Traced, Option<&[u8]>),
    (robot, heading, planned): (&RobotModel, f64, &str),
) -> Result<Vec<u8>, Failure> {
    let Some(format) = format else { return Ok(output::json(&stages(found, report)).into_bytes()) };
    let path = SavedPath::with_stops(&found.path, heading);
    Ok(format.bytes(path, &room.plan, robot, planned, || sweep_dxf(found, room, original))?)
}

fn stages<'a>(found: &Sweep, report: &'a SweepReport<'a>) -> Stages<'a> {
    let pair = |p: &Point| [p.x, p.y];
    let points = found.subgoals.iter();
    let links = found.links.iter();
    Stages {
        report,
        points: points
            .map(|p| StagePoint { at: pair(&p.at), status: p.contact, line: p.line, obstacle: p.obstacle })
            .collect(),
        links: links
            .map(|link| StageLink {
                from: link.from,
                to: link.to,
                collides: link.collides,
                way: link.way.iter().map(pair).collect(),
            })
            .collect(),
        path: found.path.iter().map(pair).collect(),
    }
}

/// An outline as it is typed.
fn parse_outline(text: &str) -> Result<Outline, Failure> {
    let usage = || {
        let forms = "circle:RADIUS, rectangle:LENGTHxWIDTH or octagon:WIDTH in metres, e.g. octagon:0.36";
        Failure::usage(format!("--outline {text}: use {forms}"))
    };
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| usage());
    let (kind, size) = text.split_once(':').ok_or_else(usage)?;
    let outline = match kind {
        "circle" => Outline::circle(number(size)?),
        "octagon" => Outline::octagon(number(size)?),
        "rectangle" => {
            let (length, width) = size.split_once('x').ok_or_else(usage)?;
            Outline::rectangle(number(length)?, number(width)?)
        }
        _ => return Err(usage()),
    };
    outline.map_err(|error| SweepError::from(error).into())
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Value { .. } | SweepError::Cspace(CspaceError::Outline(_) | CspaceError::Cell(_)) => {
                Self::usage(error.to_string())
            }
            SweepError::FitsNowhere { .. } => Self::misfit(error.to_string()),
            SweepError::Cspace(CspaceError::TooLarge { .. }) | SweepError::Cancelled => {
                Self::planner(error.to_string())
            }
        }
    }
}
