//! A room as a ROS map: an image and the YAML file that describes it, for `map_server` and `nav2_map_server`.

use super::{FloorPlan, OccupancyMode, Shading};
use crate::grid::{Grid, Occupancy};
use image::{
    ExtendedColorType, ImageEncoder, ImageResult,
    codecs::{
        png::PngEncoder,
        pnm::{GraymapHeader, PnmEncoder, PnmHeader, SampleEncoding},
    },
};
use std::fmt::Write;

/// Kind of the image beside the YAML file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapImage {
    /// Grey, binary (P5).
    Pgm,
    /// Grey, with opacity where the mode needs it.
    Png,
}

/// The two files of a ROS map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RosMap {
    /// The description.
    pub yaml: String,
    /// Name of the image, as the description gives it.
    pub image_name: String,
    /// The image.
    pub image: Vec<u8>,
}

/// Reasons why a room can't be written as a ROS map.
#[derive(Debug, thiserror::Error)]
pub enum RosMapError {
    /// A PGM has no opacity, which the mode uses for unknown cells.
    #[error("in scale mode unknown cells are transparent, which PGM doesn't support; choose PNG or trinary mode")]
    NoOpacity,
    /// The image can't be written.
    #[error("the image can't be written: {0}")]
    Image(#[from] image::ImageError),
}

/// Shade of unknown cells in trinary mode, as written by `map_saver`: just between the thresholds.
const UNKNOWN: u8 = 205;
/// Shade of free cells in trinary mode, as written by `map_saver`.
const FREE: u8 = 254;
/// A value that isn't a percentage: unknown in raw mode.
const NO_VALUE: u8 = 255;

impl MapImage {
    /// The ending of its files.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Pgm => "pgm",
            Self::Png => "png",
        }
    }
}

/// Writes `plan` as files called `stem`, in the given mode; with `negate`, light and dark change places (raw values
/// stay, as the map server ignores `negate` there). The thresholds are those of [`Shading::default`]. Objects are left
/// out, as the map server has only cells.
pub fn to_ros_map(
    plan: &FloorPlan,
    stem: &str,
    image: MapImage,
    mode: OccupancyMode,
    negate: bool,
) -> Result<RosMap, RosMapError> {
    let has_unknown = plan.occupancy.values().contains(&Occupancy::Unknown);
    if mode == OccupancyMode::Scale && image == MapImage::Pgm && has_unknown {
        return Err(RosMapError::NoOpacity);
    }
    let image_name = format!("{stem}.{}", image.ending());
    let pixels = match image {
        MapImage::Pgm => pgm(&plan.occupancy, mode, negate)?,
        MapImage::Png => png(&plan.occupancy, mode, negate)?,
    };
    Ok(RosMap { yaml: yaml(plan, &image_name, mode, negate), image_name, image: pixels })
}

fn yaml(plan: &FloorPlan, image_name: &str, mode: OccupancyMode, negate: bool) -> String {
    let Shading { occupied_thresh, free_thresh, .. } = Shading::default();
    let mode = mode.name();
    let (origin, resolution) = (plan.origin, plan.resolution);
    let mut text = String::new();
    // Writing to a string can't fail.
    let _ = write!(
        text,
        "image: \"{image_name}\"\nmode: {mode}\nresolution: {resolution}\norigin: [{}, {}, {}]\nnegate: {}\n\
         occupied_thresh: {occupied_thresh}\nfree_thresh: {free_thresh}\n",
        origin.x,
        origin.y,
        origin.heading,
        u8::from(negate)
    );
    text
}

/// Shade and opacity of a cell.
fn pixel(cell: Occupancy, mode: OccupancyMode, negate: bool) -> [u8; 2] {
    let turned = |shade: u8| if negate { u8::MAX - shade } else { shade };
    match (mode, cell) {
        (OccupancyMode::Trinary, Occupancy::Free) => [turned(FREE), u8::MAX],
        (OccupancyMode::Trinary, Occupancy::Unknown) => [turned(UNKNOWN), u8::MAX],
        (OccupancyMode::Scale, Occupancy::Free) => [turned(u8::MAX), u8::MAX],
        (OccupancyMode::Scale, Occupancy::Unknown) => [turned(UNKNOWN), 0],
        (OccupancyMode::Trinary | OccupancyMode::Scale, Occupancy::Occupied) => [turned(0), u8::MAX],
        (OccupancyMode::Raw, Occupancy::Free) => [0, u8::MAX],
        (OccupancyMode::Raw, Occupancy::Occupied) => [100, u8::MAX],
        (OccupancyMode::Raw, Occupancy::Unknown) => [NO_VALUE, u8::MAX],
    }
}

/// Pixels from the top row down, as images are stored.
fn pixels(cells: &Grid<Occupancy>, mode: OccupancyMode, negate: bool) -> impl Iterator<Item = [u8; 2]> {
    let rows = cells.values().chunks(cells.width().max(1)).rev();
    rows.flatten().map(move |&cell| pixel(cell, mode, negate))
}

fn pgm(cells: &Grid<Occupancy>, mode: OccupancyMode, negate: bool) -> ImageResult<Vec<u8>> {
    let shades: Vec<u8> = pixels(cells, mode, negate).map(|[shade, _]| shade).collect();
    let (width, height) = (cells.width() as u32, cells.height() as u32);
    let header = GraymapHeader { encoding: SampleEncoding::Binary, height, width, maxwhite: u32::from(u8::MAX) };
    let mut file = Vec::new();
    PnmEncoder::new(&mut file).with_header(PnmHeader::from(header)).write_image(
        &shades,
        width,
        height,
        ExtendedColorType::L8,
    )?;
    Ok(file)
}

fn png(cells: &Grid<Occupancy>, mode: OccupancyMode, negate: bool) -> ImageResult<Vec<u8>> {
    // Opacity only where needed: some readers count it as a colour.
    let (values, colour): (Vec<u8>, _) = if mode == OccupancyMode::Scale {
        (pixels(cells, mode, negate).flatten().collect(), ExtendedColorType::La8)
    } else {
        (pixels(cells, mode, negate).map(|[shade, _]| shade).collect(), ExtendedColorType::L8)
    };
    let mut file = Vec::new();
    PngEncoder::new(&mut file).write_image(&values, cells.width() as u32, cells.height() as u32, colour)?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        floor_plan::{SourceFile, load},
        geometry::Pose,
        grid::from_picture,
    };

    fn plan(text: &str) -> FloorPlan {
        FloorPlan {
            name: "den".into(),
            note: String::new(),
            resolution: 0.05,
            occupancy: from_picture(text, |c| match c {
                '#' => Occupancy::Occupied,
                '?' => Occupancy::Unknown,
                _ => Occupancy::Free,
            })
            .unwrap(),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(-1.5, 2.25, 0.3),
        }
    }

    fn read_back(map: &RosMap) -> FloorPlan {
        let file = |name: &str, bytes: Vec<u8>| SourceFile { name: name.into(), bytes };
        load(&[file("den.yaml", map.yaml.clone().into_bytes()), file(&map.image_name, map.image.clone())]).unwrap()
    }

    #[test]
    fn every_mode_comes_back_as_it_was() {
        let plan = plan("#####\n#..?#\n#.?.#\n##...\n");
        for image in [MapImage::Pgm, MapImage::Png] {
            for mode in [OccupancyMode::Trinary, OccupancyMode::Scale, OccupancyMode::Raw] {
                for negate in [false, true] {
                    let map = match to_ros_map(&plan, "den", image, mode, negate) {
                        Err(RosMapError::NoOpacity) => {
                            assert_eq!((image, mode), (MapImage::Pgm, OccupancyMode::Scale));
                            continue;
                        }
                        map => map.unwrap(),
                    };
                    assert_eq!(read_back(&map), plan, "{image:?} {mode:?} {negate}");
                }
            }
        }
    }

    #[test]
    fn a_pgm_of_known_cells_can_be_scaled() {
        let plan = plan("###\n#..\n");
        assert_eq!(read_back(&to_ros_map(&plan, "den", MapImage::Pgm, OccupancyMode::Scale, false).unwrap()), plan);
    }

    #[test]
    fn the_files_are_those_that_map_saver_writes() {
        let map = to_ros_map(&plan("#.?\n"), "den", MapImage::Pgm, OccupancyMode::Trinary, false).unwrap();
        assert_eq!(
            map.yaml,
            "image: \"den.pgm\"\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2.25, 0.3]\nnegate: 0\n\
             occupied_thresh: 0.65\nfree_thresh: 0.196\n"
        );
        assert_eq!(map.image, b"P5\n3 1 255\n\x00\xfe\xcd");
    }
}
