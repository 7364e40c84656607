//! Rooms and paths as files for other programs.

mod path_format;
mod recording_bag;
mod run_bag;
mod saved_path;
mod svg;

pub use path_format::{PathFileError, PathFormat};
pub use recording_bag::{LineTopics, recording_bag};
pub use run_bag::{BAG_TYPE, RunBag, path_bag};
pub use saved_path::SavedPath;
pub use svg::to_svg;

use self::path_format::ROOMBA;
use coverage_planners::sweep::planned_for;
use floor_drawing::DrawingError;
use robovac_core::{
    floor_plan::{FloorPlan, MapImage, OccupancyMode, RosMapError, Scenario, to_ascii, to_ros_map},
    geometry::Point,
    robot::RobotModel,
    trajectory::Trajectory,
};
use robovac_sim::experiment::planning::choose_robot;

/// A file to be saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExportFile {
    /// Its name.
    pub name: String,
    /// Its media type.
    pub kind: &'static str,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// A kind of file that a room or a path can be saved as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Format {
    /// Its name in links and on the command line.
    pub id: &'static str,
    /// Its name in menus.
    pub title: &'static str,
    /// Its purpose, in one sentence.
    pub note: &'static str,
    /// Whether it contains a path and so requires one.
    pub needs_path: bool,
}

/// All formats, in the order of the menus.
pub const FORMATS: &[Format] = &[
    Format {
        id: "scenario",
        title: "Scenario",
        note: "Everything: room, objects, robot, algorithm and seeds. Can be opened here again.",
        needs_path: false,
    },
    Format {
        id: "text",
        title: "Text map",
        note: "One character per cell, easy to read and edit by hand; objects are left out.",
        needs_path: false,
    },
    Format {
        id: "ros_pgm",
        title: "ROS map, PGM",
        note: "An image and its YAML file for map_server and Nav2; furniture becomes wall.",
        needs_path: false,
    },
    Format {
        id: "ros_png",
        title: "ROS map, PNG",
        note: "The same as PNG, which any image viewer opens, and its YAML file; furniture becomes wall.",
        needs_path: false,
    },
    Format {
        id: "svg",
        title: "SVG drawing",
        note: "Walls, furniture and path for papers and web pages; one unit is one millimetre.",
        needs_path: false,
    },
    Format {
        id: "dxf",
        title: "DXF drawing",
        note: "Walls, furniture and path on separate layers, in metres, for CAD programs.",
        needs_path: false,
    },
    Format {
        id: "path_csv",
        title: "Path, CSV table",
        note: "Position, heading, distance and time at every corner and along curves, in metres, radians and seconds. \
            Origin: the map's, or the room's lower left corner.",
        needs_path: true,
    },
    Format {
        id: "path_ros",
        title: "Path, ROS poses",
        note: "A nav_msgs/Path in YAML, in the map's frame.",
        needs_path: true,
    },
    Format {
        id: "path_mcap",
        title: "Path, ROS 2 bag",
        note: "An MCAP file for Foxglove and ros2 bag: the map, the path and the drive along it without errors.",
        needs_path: true,
    },
    Format {
        id: "program",
        title: "Path, robot program",
        note: "Human-readable: one forward or turn command per line.",
        needs_path: true,
    },
    Format {
        id: "roomba",
        title: "Path, Roomba commands (OI)",
        note: "Timed Open Interface commands for a Roomba 600. Open loop, so the robot drifts.",
        needs_path: true,
    },
];

/// The simulated run, which takes longer: see [`RunBag`].
pub const RUN: Format = Format {
    id: "run_mcap",
    title: "Run, ROS 2 bag",
    note: "An MCAP file for Foxglove and ros2 bag: the run so far with map, odometry, frames, sensors and commands.",
    needs_path: false,
};

/// Content of files: a room with its choices, and perhaps a path.
#[derive(Debug, Clone)]
pub struct Exported<'a> {
    /// The room and all choices.
    pub scenario: &'a Scenario,
    /// The room itself.
    pub plan: &'a FloorPlan,
    /// Corners of the path, m; empty if there is none.
    pub path: &'a [Point],
    /// How the path is driven smoothly; `None` with a stop at each corner.
    pub smooth: Option<&'a Trajectory>,
    /// Name of the files without ending.
    pub stem: &'a str,
    /// Mode of a ROS map's occupancy values.
    pub mode: OccupancyMode,
    /// Whether light cells of a ROS map are occupied.
    pub negate: bool,
}

/// Reasons why a file can't be exported.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// There is no such format.
    #[error("there is no format \"{0}\"; use one of {list}", list = ids())]
    Unknown(String),
    /// The format requires a path and there is none.
    #[error("{0} needs a path, and there is none yet; plan one first")]
    NoPath(&'static str),
    /// The file of the path can't be written.
    #[error(transparent)]
    Path(#[from] PathFileError),
    /// The scenario's robot isn't known.
    #[error("the robot in this room is unknown; choose another one")]
    NoRobot,
    /// The ROS map can't be written.
    #[error(transparent)]
    RosMap(#[from] RosMapError),
}

fn ids() -> String {
    FORMATS.iter().map(|format| format.id).collect::<Vec<_>>().join(", ")
}

impl Exported<'_> {
    /// The files of the format with that id.
    pub fn files(&self, format: &str) -> Result<Vec<ExportFile>, ExportError> {
        let Some(format) = FORMATS.iter().find(|known| known.id == format) else {
            return Err(ExportError::Unknown(format.to_owned()));
        };
        if format.needs_path && self.path.is_empty() {
            return Err(ExportError::NoPath(format.title));
        }
        match format.id {
            "scenario" => Ok(self.one("json", "application/json", self.scenario.to_json())),
            "text" => Ok(self.one("txt", "text/plain", to_ascii(self.plan))),
            "svg" => Ok(self.one("svg", "image/svg+xml", to_svg(self.plan, &self.saved().line()))),
            "dxf" => self.dxf(),
            "ros_pgm" => self.ros_map(MapImage::Pgm),
            "ros_png" => self.ros_map(MapImage::Png),
            "path_csv" => self.path_file("", PathFormat::Csv),
            "path_ros" => self.path_file("path.", PathFormat::Poses),
            "path_mcap" => self.path_file("path.", PathFormat::Bag),
            "program" => self.path_file("program.", PathFormat::Program),
            "roomba" => self.path_file("", PathFormat::Commands),
            other => Err(ExportError::Unknown(other.to_owned())),
        }
    }

    fn path_file(&self, name: &str, format: PathFormat) -> Result<Vec<ExportFile>, ExportError> {
        let robot = self.robot()?;
        let drawing = || path_dxf(self.plan, self.saved());
        let bytes = format.bytes(self.saved(), self.plan, &robot, &planned_for(&robot), drawing)?;
        let (ending, kind) = format.file_type();
        Ok(vec![ExportFile { name: format!("{}.{name}{ending}", self.stem), kind, bytes }])
    }

    fn saved(&self) -> SavedPath<'_> {
        let heading = self.plan.start.map_or(0.0, |start| start.heading);
        SavedPath { corners: self.path, heading, smooth: self.smooth }
    }

    /// The robot of the scenario, or the Roomba if it names none.
    fn robot(&self) -> Result<RobotModel, ExportError> {
        let id = self.scenario.robot.as_deref().unwrap_or(ROOMBA);
        let (robot, _) = choose_robot(id, self.plan, self.scenario.cell_size).ok_or(ExportError::NoRobot)?;
        let twin = self.scenario.twin.map(|twin| twin.of(&robot));
        let own = self.scenario.own_robot.as_ref().map(|own| own.of(&robot));
        Ok(own.or(twin).unwrap_or(robot))
    }

    fn one(&self, ending: &str, kind: &'static str, text: String) -> Vec<ExportFile> {
        vec![ExportFile { name: format!("{}.{ending}", self.stem), kind, bytes: text.into_bytes() }]
    }

    fn dxf(&self) -> Result<Vec<ExportFile>, ExportError> {
        let bytes = path_dxf(self.plan, self.saved()).map_err(PathFileError::from)?;
        let (ending, kind) = PathFormat::Dxf.file_type();
        Ok(vec![ExportFile { name: format!("{}.{ending}", self.stem), kind, bytes }])
    }

    fn ros_map(&self, image: MapImage) -> Result<Vec<ExportFile>, ExportError> {
        let map =
            to_ros_map(&robovac_core::coverage::with_objects(self.plan), self.stem, image, self.mode, self.negate)?;
        let kind = match image {
            MapImage::Pgm => "image/x-portable-graymap",
            MapImage::Png => "image/png",
        };
        Ok(vec![
            ExportFile { name: map.image_name, kind, bytes: map.image },
            ExportFile { name: format!("{}.yaml", self.stem), kind: "application/yaml", bytes: map.yaml.into_bytes() },
        ])
    }
}

/// Walls, furniture and a path in metres as a DXF drawing, in the frame of the map that the room came from; an empty path
/// leaves its layer out. Curves are polylines.
pub fn path_dxf(plan: &FloorPlan, path: SavedPath<'_>) -> Result<Vec<u8>, DrawingError> {
    let mut overlays = floor_drawing::outlines(plan);
    let line = path.line();
    if !line.is_empty() {
        let path = line.iter().map(|&at| plan.origin.to_world(at)).collect();
        overlays.push(floor_drawing::Overlay { layer: "PATH".to_owned(), colour: 5, lines: vec![path] });
    }
    floor_drawing::to_dxf(None, &overlays)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::room,
        geometry::Pose,
        robot::model,
        trajectory::{DriveLimits, Knot, RoundedLine, Rounding},
    };

    #[test]
    fn every_format_gives_files() {
        let plan = (room("flat").unwrap().build)();
        let path = [Point::new(1.0, 1.0), Point::new(2.0, 1.0), Point::new(2.0, 2.0)];
        let scenario = Scenario::of(&plan);
        for format in FORMATS {
            let mut exported = Exported {
                scenario: &scenario,
                plan: &plan,
                path: &path,
                smooth: None,
                stem: "flat",
                mode: OccupancyMode::Trinary,
                negate: false,
            };
            let files = exported.files(format.id).unwrap();
            assert!(files.iter().all(|file| !file.bytes.is_empty() && file.name.starts_with("flat.")), "{}", format.id);
            exported.path = &[];
            assert_eq!(exported.files(format.id).is_err(), format.needs_path, "{}", format.id);
        }
    }

    /// A path with a rounded corner in a room whose origin is elsewhere: all files that tell places tell those of the curve.
    #[test]
    fn files_of_a_smooth_path_hold_its_curves() {
        let mut plan = (room("bedroom").unwrap().build)();
        plan.origin = Pose::new(-5.0, 2.0, 0.5);
        let path = [Point::new(0.5, 0.5), Point::new(1.5, 0.5), Point::new(1.5, 1.5)];
        let limits = DriveLimits::of(model("roomba600").unwrap()).unwrap();
        let heading = plan.start.map_or(0.0, |start| start.heading);
        let rounded = RoundedLine::new(&path, heading, &[Rounding::Stop, Rounding::Alone(0.15), Rounding::Stop]);
        let trajectory = Trajectory::new(&rounded, &limits);
        let scenario = Scenario::of(&plan);
        let stopping = Exported {
            scenario: &scenario,
            plan: &plan,
            path: &path,
            smooth: None,
            stem: "b",
            mode: OccupancyMode::Trinary,
            negate: false,
        };
        let smooth = Exported { smooth: Some(&trajectory), ..stopping.clone() };
        for format in FORMATS {
            let [with_stops, with_curves] = [&stopping, &smooth].map(|exported| exported.files(format.id).unwrap());
            let has_places = format.needs_path || ["svg", "dxf"].contains(&format.id);
            assert_eq!(with_stops != with_curves, has_places, "{}", format.id);
        }
        let table = String::from_utf8(smooth.files("path_csv").unwrap().remove(0).bytes).unwrap();
        let rows =
            table.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>());
        let knots = trajectory.knots();
        let rows: Vec<Vec<f64>> = rows.collect();
        for row in &rows {
            let off = |knot: &Knot| (plan.origin.to_world(knot.pose.position()) - Point::new(row[0], row[1])).norm();
            let nearest = knots
                .windows(2)
                .map(|pair| off(&pair[0]).min(off(&pair[1])) - (pair[1].distance_m - pair[0].distance_m));
            assert!(nearest.fold(f64::MAX, f64::min) < 1e-3, "{row:?}");
        }
        let last = rows.last().unwrap();
        assert!((last[4] - trajectory.duration_s()).abs() < 1e-3, "{last:?}");
    }

    #[test]
    fn an_unknown_format_names_those_that_there_are() {
        let plan = (room("thesis8").unwrap().build)();
        let scenario = Scenario::of(&plan);
        let exported = Exported {
            scenario: &scenario,
            plan: &plan,
            path: &[],
            smooth: None,
            stem: "r",
            mode: OccupancyMode::Raw,
            negate: false,
        };
        let message = exported.files("dwg").unwrap_err().to_string();
        assert!(message.contains("\"dwg\"") && message.contains("ros_png"), "{message}");
    }
}
