//! `--map`, `--room` and `--flat`: where a floor plan comes from.

use super::failure::Failure;
use robovac_app::{Import, ScenarioChoices};
use robovac_core::floor_plan::{FloorPlan, ROOMS, SourceFile, generate::FlatId, image_of, room};
use std::{
    fs,
    io::ErrorKind,
    path::{Path, PathBuf},
};

/// One of them must be given.
#[derive(clap::Args)]
#[group(required = true, multiple = false)]
pub struct RoomSource {
    /// Map file: text of # and ., PNG, PGM, ROS map (YAML; its image is found automatically) or scenario
    #[arg(long, value_name = "FILE")]
    map: Option<PathBuf>,
    /// Built-in room, see "robovac rooms"
    #[arg(long, value_name = "ID")]
    room: Option<String>,
    /// Generated flat: a seed, or more as in 7~area:40..60~furniture:0.5~rugs:no, see "robovac generate"
    #[arg(long, value_name = "SEED")]
    flat: Option<FlatId>,
}

/// At most one of them.
#[derive(clap::Args)]
pub struct RoomArguments {
    /// Map file: text of # and ., PNG, PGM, ROS map (YAML; its image is found automatically) or scenario
    #[arg(long, value_name = "FILE", conflicts_with_all = ["room", "flat"])]
    map: Option<PathBuf>,
    /// Generated flat: a seed, or more as in 7~area:40..60~furniture:0.5~rugs:no, see "robovac generate"
    #[arg(long, value_name = "SEED", conflicts_with = "room")]
    flat: Option<FlatId>,
    /// Built-in room, see "robovac rooms"
    #[arg(long, value_name = "ID", default_value = ROOMS[0].id)]
    room: String,
}

impl RoomArguments {
    pub fn plan(&self) -> Result<FloorPlan, Failure> {
        RoomSource { map: self.map.clone(), room: Some(self.room.clone()), flat: self.flat }.plan()
    }
}

impl RoomSource {
    /// The file of `--map`, if that is given.
    pub fn file(&self) -> Result<Option<SourceFile>, Failure> {
        self.map.as_deref().map_or(Ok(None), read)
    }

    /// The floor plan of a scenario file with what else it says; `None` if it's none.
    pub fn scenario(&self) -> Result<Option<(FloorPlan, ScenarioChoices)>, Failure> {
        let Some(file) = self.file()? else { return Ok(None) };
        let Import { plan, choices } = Import::read(&[file])?;
        Ok(choices.map(|choices| (plan, choices)))
    }

    pub fn plan(&self) -> Result<FloorPlan, Failure> {
        if let Some(path) = &self.map {
            return load_with_image(path);
        }
        if let Some(flat) = self.flat {
            return Ok(flat.build());
        }
        let id = self.room.as_deref().unwrap_or_default();
        room(id).map(|info| (info.build)()).ok_or_else(|| Failure::unknown("room", id, "rooms"))
    }
}

/// Loads a map; a ROS map's image is looked up beside its YAML file.
pub fn load_with_image(path: &Path) -> Result<FloorPlan, Failure> {
    let mut files = vec![read(path)?.ok_or_else(|| Failure::io(path.display(), &ErrorKind::NotFound.into()))?];
    if let Some(image) = image_of(&files[0]) {
        let folder = path.parent().unwrap_or(Path::new(""));
        // If it doesn't exist, the loader's error names it.
        files.extend(read(&folder.join(image))?);
    }
    Ok(Import::read(&files)?.plan)
}

/// A file, or `None` if there is none.
fn read(path: &Path) -> Result<Option<SourceFile>, Failure> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(SourceFile { name: path.to_string_lossy().into_owned(), bytes })),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::io(path.display(), &error)),
    }
}
