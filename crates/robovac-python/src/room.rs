//! Rooms: shipped, from text, arrays and files, generated.

use crate::failure::Failure;
use floor_drawing::{DrawingRegion, Tracing, drawing_kind, is_drawing, read, trace};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use robovac_app::{Import, export};
use robovac_core::{
    floor_plan::{
        self, FloorPlan, MAX_SIDE, Scenario, SourceFile,
        generate::{FlatSpec, generate_flat},
        image_of, to_ascii,
    },
    geometry::{Point, Pose},
    grid::Occupancy,
};
use std::{io::ErrorKind, path::Path, sync::Arc};

/// A room: walls, objects and the robot's start.
#[pyclass(frozen, module = "robovac._native")]
#[derive(Debug)]
pub struct Room {
    /// The room.
    pub plan: Arc<FloorPlan>,
}

/// Gaps between wall ends that are closed in a drawing, m, as on the command line.
const GAP: f64 = 0.1;

#[pymethods]
impl Room {
    #[staticmethod]
    fn shipped(id: &str) -> PyResult<Self> {
        let info = floor_plan::room(id).ok_or_else(|| Failure::unknown("room", id, "rooms"))?;
        Ok(Self::of((info.build)()))
    }

    #[staticmethod]
    fn from_text(text: &str, name: &str) -> PyResult<Self> {
        let file = SourceFile { name: format!("{name}.txt"), bytes: text.as_bytes().to_vec() };
        Ok(Self::of(Import::read(&[file]).map_err(Failure::from)?.plan))
    }

    /// A map, or the room in a drawing, whose unit is `metre` metres unless it states its own.
    #[staticmethod]
    fn open(path: &str, metre: Option<f64>, resolution_m: f64) -> PyResult<Self> {
        let file = read_file(path)?.ok_or_else(|| Failure::io(path, &ErrorKind::NotFound.into()))?;
        if is_drawing(&file) {
            return Ok(Self::of(drawn(&file, metre, resolution_m)?));
        }
        let mut files = vec![file];
        if let Some(image) = files.first().and_then(image_of) {
            let folder = Path::new(path).parent().unwrap_or(Path::new(""));
            // If it doesn't exist, the loader's error names it.
            files.extend(read_file(&folder.join(image).to_string_lossy())?);
        }
        Ok(Self::of(Import::read(&files).map_err(Failure::from)?.plan))
    }

    /// Cells as in a ROS occupancy grid: -1 unknown, 0 free, others occupied; row 0 at the bottom.
    #[staticmethod]
    fn from_cells(
        cells: PyReadonlyArray2<'_, i8>,
        resolution_m: f64,
        start: Option<(f64, f64, f64)>,
        name: &str,
    ) -> PyResult<Self> {
        let cells = cells.as_array();
        let (height, width) = cells.dim();
        if width.max(height) > MAX_SIDE || width.min(height) == 0 {
            let message = format!("a room has 1 to {MAX_SIDE} rows and columns, not {height} x {width}");
            return Err(Failure::map(message).into());
        }
        if !cells.iter().any(|&cell| cell == 0) {
            let message = "the array has no free cell; 0 is free, -1 unknown, all else occupied".to_owned();
            return Err(Failure::map(message).into());
        }
        // As text, so that it is checked as a file is.
        let mut text = format!("; resolution {resolution_m}\n");
        for row in (0..height).rev() {
            text.extend(cells.row(row).iter().map(|&cell| match cell {
                -1 => '?',
                0 => '.',
                _ => '#',
            }));
            text.push('\n');
        }
        let file = SourceFile { name: format!("{name}.txt"), bytes: text.into_bytes() };
        let mut plan = Import::read(&[file]).map_err(Failure::from)?.plan;
        if let Some((x, y, heading_deg)) = start {
            if ![x, y, heading_deg].iter().all(|number| number.is_finite()) {
                let message = "start: use x and y in metres and a heading in degrees, all finite".to_owned();
                return Err(Failure::usage(message).into());
            }
            plan.start = Some(Pose::new(x, y, heading_deg.to_radians()));
        }
        Ok(Self::of(plan))
    }

    /// A furnished flat by its seed.
    #[staticmethod]
    fn flat(seed: u64, area_m2: (f64, f64), furniture: f64, rugs: bool) -> PyResult<Self> {
        let spec = FlatSpec { area_m2: area_m2.into(), furniture, rugs };
        spec.check().map_err(|error| Failure::usage(error.to_string()))?;
        Ok(Self::of(generate_flat(seed, &spec)))
    }

    #[getter]
    fn name(&self) -> &str {
        &self.plan.name
    }

    #[getter]
    fn note(&self) -> &str {
        &self.plan.note
    }

    #[getter]
    fn resolution_m(&self) -> f64 {
        self.plan.resolution
    }

    #[getter]
    fn width_m(&self) -> f64 {
        self.plan.width_m()
    }

    #[getter]
    fn height_m(&self) -> f64 {
        self.plan.height_m()
    }

    #[getter]
    fn start(&self) -> Option<(f64, f64, f64)> {
        self.plan.start.map(|start| (start.x, start.y, start.heading.to_degrees()))
    }

    #[getter]
    fn cells<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i8>>> {
        let grid = &self.plan.occupancy;
        let values = grid.values().iter().map(|&cell| match cell {
            Occupancy::Unknown => -1,
            Occupancy::Free => 0,
            Occupancy::Occupied => 100,
        });
        PyArray1::from_iter(py, values).reshape([grid.height(), grid.width()])
    }

    fn to_text(&self) -> String {
        to_ascii(&self.plan)
    }

    fn to_scenario(&self) -> String {
        Scenario::of(&self.plan).to_json()
    }

    fn to_svg(&self, line: Vec<(f64, f64)>) -> String {
        let line: Vec<Point> = line.into_iter().map(|(x, y)| Point::new(x, y)).collect();
        export::to_svg(&self.plan, &line)
    }

    /// For pickling and copying.
    fn __reduce__(slf: &Bound<'_, Self>) -> PyResult<(Py<PyAny>, (String, String))> {
        let room = slf.get();
        Ok((slf.get_type().getattr("from_text")?.unbind(), (room.to_scenario(), room.plan.name.clone())))
    }

    fn __repr__(&self) -> String {
        let FloorPlan { name, .. } = &*self.plan;
        format!("<robovac.Room \"{name}\", {:.2} m x {:.2} m>", self.plan.width_m(), self.plan.height_m())
    }
}

impl Room {
    /// A room of its own.
    pub fn of(plan: FloorPlan) -> Self {
        Self { plan: Arc::new(plan) }
    }
}

/// The room in a drawing.
fn drawn(file: &SourceFile, metre: Option<f64>, resolution: f64) -> Result<FloorPlan, Failure> {
    let drawing = read(file)?;
    let metre = metre.or(drawing.metre).ok_or_else(|| {
        let kind = drawing_kind(file).unwrap_or("a drawing");
        Failure::usage(format!("{} is {kind} that doesn't state its unit; add units, e.g. units=\"mm\"", file.name))
    })?;
    let roles = drawing.layers.iter().map(|layer| layer.role).collect();
    let how = Tracing { roles, metre, gap: GAP, resolution, region: DrawingRegion::WHOLE };
    Ok(trace(&drawing, &how)?.plan)
}

/// A file, or `None` if there is none.
fn read_file(path: &str) -> Result<Option<SourceFile>, Failure> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(Some(SourceFile { name: path.to_owned(), bytes })),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::io(path, &error)),
    }
}
