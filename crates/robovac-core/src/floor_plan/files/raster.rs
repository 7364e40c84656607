//! Images as maps: PNG and the Netpbm family (PGM above all), with the rules of the ROS map server; with the feature
//! `photos` JPEG and WebP, too.

use super::{MAX_SIDE, MapError};
use crate::grid::{Grid, Occupancy};
use image::{ColorType, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, metadata::Orientation};
use std::io::{Cursor, ErrorKind};

/// Metres per pixel of an image without a YAML file.
pub const DEFAULT_IMAGE_RESOLUTION: f64 = 0.05;

/// Most bytes for a decoder: the largest map with four channels of 16 bits, twice.
const MAX_DECODER_BYTES: u64 = (2 * 8 * MAX_SIDE * MAX_SIDE) as u64;

/// Most pixels of a picture whose shades are read: those for which a decoder with four channels of 8 bits has the bytes.
/// The page's own decoder (`www/shared/pictures.js`) has the same limit.
pub const MAX_PIXELS: usize = (MAX_DECODER_BYTES / 4) as usize;

/// Shades of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct PictureShades {
    /// 0 (black) to 255 (white); row 0 is at the bottom. No side is longer than [`MAX_SIDE`].
    pub shades: Grid<u8>,
    /// Pixels of the file on a side of each: a whole number, so that its shade is the mean of whole pixels.
    pub times: usize,
    /// Columns and rows of the file, upright.
    pub size: [usize; 2],
}

/// How shades are converted to cells. The default is that of the ROS 1 map server, which map files usually contain.
///
/// A pixel's shade is the mean of its colour channels, from 0 (black) to 1 (white). Its occupancy is `1 - shade`, or
/// `shade` if `negate` is set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shading {
    /// Treatment of occupancies between the two thresholds.
    pub mode: OccupancyMode,
    /// Whether light pixels are walls.
    pub negate: bool,
    /// Cells with a greater occupancy are walls, 0 to 1.
    pub occupied_thresh: f64,
    /// Cells with a smaller occupancy are floor, 0 to 1.
    pub free_thresh: f64,
}

/// The modes of the ROS map server (`nav2_map_server`, `map_io.cpp`).
///
/// The map server publishes a value from 0 to 100, or -1 for unknown. Planning distinguishes free and other cells: only
/// certainly free ones are driven on, and values in between count as unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OccupancyMode {
    /// Free, occupied, and unknown between the thresholds. Transparency is laid on white, as browsers show it. (The map
    /// server takes it for one more colour channel here, which its own source calls a relic.)
    #[default]
    Trinary,
    /// Values from 0 to 100 between the thresholds; pixels that aren't opaque are unknown.
    Scale,
    /// The shade from 0 to 255 is the value from 0 to 100 itself, anything above is unknown; `negate` has no effect.
    /// The thresholds are applied to the value as a percentage.
    Raw,
}

impl OccupancyMode {
    /// Every mode with its name in YAML files.
    pub const NAMES: [(&'static str, Self); 3] =
        [("trinary", Self::Trinary), ("scale", Self::Scale), ("raw", Self::Raw)];

    /// The mode with that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(known, _)| *known == name).map(|&(_, mode)| mode)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, mode)| *mode == self).map_or("", |&(name, _)| name)
    }
}

impl Default for Shading {
    fn default() -> Self {
        Self { mode: OccupancyMode::Trinary, negate: false, occupied_thresh: 0.65, free_thresh: 0.196 }
    }
}

impl Shading {
    /// The cell for a pixel of [`super::load_shades`].
    pub fn cell_of(&self, shade: u8) -> Occupancy {
        self.cell(f64::from(shade) / f64::from(u8::MAX), 1.0)
    }

    /// The cell for a pixel with this shade and opacity, both 0 to 1.
    fn cell(&self, shade: f64, alpha: f64) -> Occupancy {
        let occupied = |shade: f64| if self.negate { shade } else { 1.0 - shade };
        match self.mode {
            OccupancyMode::Trinary => self.threshold(occupied(shade * alpha + 1.0 - alpha)),
            OccupancyMode::Scale if alpha < 1.0 => Occupancy::Unknown,
            OccupancyMode::Scale => self.threshold(occupied(shade)),
            OccupancyMode::Raw => match (shade * 255.0).round() {
                value if value <= 100.0 => self.threshold(value / 100.0),
                _ => Occupancy::Unknown,
            },
        }
    }

    fn threshold(&self, occupied: f64) -> Occupancy {
        if occupied > self.occupied_thresh {
            Occupancy::Occupied
        } else if occupied < self.free_thresh {
            Occupancy::Free
        } else {
            Occupancy::Unknown
        }
    }
}

/// The format announced by the first bytes, if it is supported.
pub(super) fn format_of(bytes: &[u8]) -> Option<ImageFormat> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some(ImageFormat::Png),
        [b'P', b'1'..=b'6'] => Some(ImageFormat::Pnm),
        [b'P', b'1'..=b'6', next, ..] if next.is_ascii_whitespace() || *next == b'#' => Some(ImageFormat::Pnm),
        #[cfg(feature = "photos")]
        [0xff, 0xd8, 0xff, ..] => Some(ImageFormat::Jpeg),
        #[cfg(feature = "photos")]
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Some(ImageFormat::WebP),
        _ => None,
    }
}

/// Cells of the image in the file `name`.
pub(super) fn read(
    name: &str,
    bytes: &[u8],
    format: ImageFormat,
    shading: &Shading,
) -> Result<Grid<Occupancy>, MapError> {
    decode(name, bytes, format, |shade, alpha| shading.cell(shade, alpha))
}

/// Shades of the image in the file `name`, reduced to no more than [`MAX_SIDE`] on a side; transparency is laid on white.
pub(super) fn shades(name: &str, bytes: &[u8], format: ImageFormat) -> Result<PictureShades, MapError> {
    let image = DecodedImage::read(name, bytes, format, |_, _| false)?;
    let times = image.width.max(image.height).div_ceil(MAX_SIDE);
    let shade = |shade: f64, alpha: f64| shade * alpha + 1.0 - alpha;
    let wide = image.width.div_ceil(times);
    let mut means: Vec<u8> = Vec::with_capacity(wide * image.height.div_ceil(times));
    for rows in image.bytes.chunks(times * image.row()) {
        let mut sums = vec![(0.0, 0.0); wide];
        for row in rows.chunks(image.row()) {
            for (x, value) in cells(row, image.colour, &shade).enumerate() {
                let (sum, count) = &mut sums[x / times];
                *sum += value;
                *count += 1.0;
            }
        }
        means.extend(sums.iter().map(|(sum, count)| (sum / count * f64::from(u8::MAX)).round() as u8));
    }
    let is_turned = matches!(
        image.held,
        Orientation::Rotate90 | Orientation::Rotate270 | Orientation::Rotate90FlipH | Orientation::Rotate270FlipH
    );
    let size = if is_turned { [image.height, image.width] } else { [image.width, image.height] };
    Ok(PictureShades { shades: grid(name, wide, means, image.held)?, times, size })
}

/// Cells of an image; `pixel` makes a cell of a shade and an opacity, both 0 to 1.
fn decode<T: Copy>(
    name: &str,
    bytes: &[u8],
    format: ImageFormat,
    pixel: impl Fn(f64, f64) -> T,
) -> Result<Grid<T>, MapError> {
    let image = DecodedImage::read(name, bytes, format, |width, height| width.max(height) > MAX_SIDE)?;
    let cells: Vec<T> = image.bytes.chunks(image.row()).flat_map(|row| cells(row, image.colour, &pixel)).collect();
    grid(name, image.width, cells, image.held)
}

/// Rows from the top, as the camera was held, as an upright grid.
fn grid<T: Copy>(name: &str, width: usize, cells: Vec<T>, held: Orientation) -> Result<Grid<T>, MapError> {
    let (width, cells) = upright(width, cells, held);
    let cells = cells.chunks(width).rev().flatten().copied().collect();
    Grid::from_rows(width, cells).ok_or_else(|| MapError::Truncated { name: name.to_owned(), part: "picture" })
}

/// An image as its decoder gives it: rows from the top.
struct DecodedImage {
    width: usize,
    height: usize,
    colour: ColorType,
    bytes: Vec<u8>,
    /// How the camera was held. Map servers don't look at it, and their formats don't have it.
    held: Orientation,
}

impl DecodedImage {
    /// Decodes an image that isn't too large by columns and rows, which are checked before any pixel is decoded.
    fn read(
        name: &str,
        bytes: &[u8],
        format: ImageFormat,
        is_too_large: impl Fn(usize, usize) -> bool,
    ) -> Result<Self, MapError> {
        let broken = |error: ImageError| explain(name, error);
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        let mut limits = Limits::no_limits();
        limits.max_alloc = Some(MAX_DECODER_BYTES);
        reader.limits(limits);
        let mut decoder = reader.into_decoder().map_err(broken)?;
        let (width, height) = (decoder.dimensions().0 as usize, decoder.dimensions().1 as usize);
        if width.min(height) == 0 {
            return Err(MapError::BadImage { name: name.to_owned(), cause: format!("its size is {width} x {height}") });
        }
        let name = || name.to_owned();
        if is_too_large(width, height) {
            return Err(MapError::TooLarge { name: name(), width, height });
        }
        if width.saturating_mul(height) > MAX_PIXELS || decoder.total_bytes() > MAX_DECODER_BYTES {
            return Err(MapError::TooManyPixels { name: name(), width, height });
        }
        let is_photo = !matches!(format, ImageFormat::Png | ImageFormat::Pnm);
        let held = is_photo.then(|| decoder.orientation().ok()).flatten().unwrap_or(Orientation::NoTransforms);
        let colour = decoder.color_type();
        let mut bytes = vec![0; decoder.total_bytes() as usize];
        decoder.read_image(&mut bytes).map_err(broken)?;
        Ok(Self { width, height, colour, bytes, held })
    }

    /// Bytes of a row.
    fn row(&self) -> usize {
        self.width * usize::from(self.colour.bytes_per_pixel())
    }
}

/// Rows of pixels, from the top, turned as the camera was held; with their new width.
fn upright<T: Copy>(width: usize, pixels: Vec<T>, held: Orientation) -> (usize, Vec<T>) {
    let height = pixels.len() / width.max(1);
    let (is_turned, flips_x, flips_y) = match held {
        Orientation::NoTransforms => return (width, pixels),
        Orientation::FlipHorizontal => (false, true, false),
        Orientation::Rotate180 => (false, true, true),
        Orientation::FlipVertical => (false, false, true),
        Orientation::Rotate90FlipH => (true, false, false),
        Orientation::Rotate90 => (true, false, true),
        Orientation::Rotate270FlipH => (true, true, true),
        Orientation::Rotate270 => (true, true, false),
    };
    let (new_width, new_height) = if is_turned { (height, width) } else { (width, height) };
    let at = |x: usize, y: usize| {
        let (x, y) = if is_turned { (y, x) } else { (x, y) };
        let x = if flips_x { width - 1 - x } else { x };
        let y = if flips_y { height - 1 - y } else { y };
        pixels[y * width + x]
    };
    let turned = (0..new_height).flat_map(|y| (0..new_width).map(move |x| (x, y))).map(|(x, y)| at(x, y)).collect();
    (new_width, turned)
}

/// Cells of one row of pixels, each made of 8 or 16 bits a channel.
fn cells<'a, T>(row: &'a [u8], colour: ColorType, pixel: &'a impl Fn(f64, f64) -> T) -> impl Iterator<Item = T> + 'a {
    let channels = usize::from(colour.channel_count());
    let size = usize::from(colour.bytes_per_pixel()) / channels;
    let colours = channels - usize::from(colour.has_alpha());
    row.chunks_exact(channels * size).map(move |bytes| {
        let value = |channel: &[u8]| match *channel {
            [byte] => f64::from(byte) / f64::from(u8::MAX),
            [low, high] => f64::from(u16::from_ne_bytes([low, high])) / f64::from(u16::MAX),
            // The decoders in use have no other depth.
            _ => 1.0,
        };
        let sum: f64 = bytes[..colours * size].chunks_exact(size).map(value).sum();
        let alpha = if colour.has_alpha() { value(&bytes[colours * size..]) } else { 1.0 };
        pixel(sum / colours as f64, alpha)
    })
}

/// A decoder's error as a message for the user.
fn explain(name: &str, error: ImageError) -> MapError {
    let name = name.to_owned();
    match error {
        ImageError::IoError(io) if io.kind() == ErrorKind::UnexpectedEof => {
            MapError::Truncated { name, part: "picture" }
        }
        ImageError::Limits(_) => MapError::BadImage { name, cause: "decoding it takes too much memory".to_owned() },
        // The decoder of plain PGM has no error kind of its own for this.
        other if other.to_string().contains("Not enough data") => MapError::Truncated { name, part: "picture" },
        other => MapError::BadImage { name, cause: in_short(&other.to_string()) },
    }
}

/// A decoder's reason without its name and its numbers: "CRC error" of "Format error decoding Png: CRC error: expected 0x505".
fn in_short(message: &str) -> String {
    let (_, reason) =
        message.split_once("decoding ").and_then(|(_, rest)| rest.split_once(": ")).unwrap_or(("", message));
    let reason = reason.split(": ").next().unwrap_or(reason);
    // Some name types of their program.
    if reason.contains(['{', '(']) { "it can't be decoded".to_owned() } else { reason.trim_end_matches('.').to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(mode: OccupancyMode, shade: u8, alpha: f64) -> Occupancy {
        Shading { mode, ..Shading::default() }.cell(f64::from(shade) / 255.0, alpha)
    }

    #[test]
    fn the_usual_grey_is_unknown() {
        // (255 - 205) / 255 is just above 0.196: gmapping and the map saver write this value for unexplored floor.
        assert_eq!(cell(OccupancyMode::Trinary, 205, 1.0), Occupancy::Unknown);
        assert_eq!(cell(OccupancyMode::Trinary, 206, 1.0), Occupancy::Free);
        assert_eq!(cell(OccupancyMode::Trinary, 90, 1.0), Occupancy::Unknown);
        assert_eq!(cell(OccupancyMode::Trinary, 89, 1.0), Occupancy::Occupied);
    }

    #[test]
    fn transparency_is_paper_or_unknown_by_mode() {
        assert_eq!(cell(OccupancyMode::Trinary, 0, 0.0), Occupancy::Free);
        assert_eq!(cell(OccupancyMode::Trinary, 0, 0.9), Occupancy::Occupied);
        assert_eq!(cell(OccupancyMode::Scale, 255, 0.9), Occupancy::Unknown);
        assert_eq!(cell(OccupancyMode::Scale, 255, 1.0), Occupancy::Free);
    }

    #[test]
    fn raw_values_are_percentages() {
        let expected =
            [(0, Occupancy::Free), (19, Occupancy::Free), (20, Occupancy::Unknown), (66, Occupancy::Occupied)];
        for (value, occupancy) in expected {
            assert_eq!(cell(OccupancyMode::Raw, value, 1.0), occupancy, "{value}");
        }
        assert_eq!(cell(OccupancyMode::Raw, 100, 1.0), Occupancy::Occupied);
        assert_eq!(cell(OccupancyMode::Raw, 101, 1.0), Occupancy::Unknown);
        assert_eq!(cell(OccupancyMode::Raw, 255, 1.0), Occupancy::Unknown);
    }

    /// A grey image of `width` columns, as PGM.
    fn pgm(width: usize, pixels: &[u8]) -> Vec<u8> {
        [format!("P5\n{width} {}\n255\n", pixels.len() / width).as_bytes(), pixels].concat()
    }

    #[test]
    fn a_picture_larger_than_a_map_is_reduced_by_a_whole_factor_to_the_means_of_its_pixels() {
        // An A3 sheet at 300 dpi, with a line of two pixels on the left and stripes of one on the right.
        let (width, height) = (4961, 3508);
        let shade = |x: usize| match x {
            100 | 101 => 0,
            4000.. if x.is_multiple_of(2) => 60,
            _ => 220,
        };
        let pixels: Vec<u8> = (0..width * height).map(|index| shade(index % width)).collect();
        let read = shades("a3.pgm", &pgm(width, &pixels), ImageFormat::Pnm).unwrap();
        assert_eq!((read.times, read.size), (2, [4961, 3508]));
        assert_eq!((read.shades.width(), read.shades.height()), (2481, 1754));
        let row = &read.shades.values()[..2481];
        assert_eq!((row[49], row[50], row[51], row[2100]), (220, 0, 220, 140));
        // The last column has one pixel of the file beside none.
        assert_eq!(row[2480], 60);
        let as_map = read_map(&pgm(width, &pixels));
        assert!(as_map.unwrap_err().to_string().contains("4961 x 3508 cells, but the limit is 4096 x 4096"));
        // What a map can hold stays as it is.
        let small = shades("small.pgm", &pgm(3, &[1, 2, 3, 4, 5, 6]), ImageFormat::Pnm).unwrap();
        assert_eq!((small.times, small.shades.values()), (1, [4, 5, 6, 1, 2, 3].as_slice()));
    }

    fn read_map(bytes: &[u8]) -> Result<Grid<Occupancy>, MapError> {
        read("a3.pgm", bytes, ImageFormat::Pnm, &Shading::default())
    }

    #[test]
    fn too_many_pixels_are_refused_before_they_are_decoded_with_a_size_that_will_do() {
        // No pixel follows.
        for (width, height, size) in [(12_000, 9000, "6000 x 4500"), (60_000, 60_000, "7500 x 7500")] {
            let head = format!("P5\n{width} {height}\n255\n");
            let message = shades("huge.pgm", head.as_bytes(), ImageFormat::Pnm).unwrap_err().to_string();
            assert!(message.contains(&format!("{width} x {height} pixels")) && message.contains(size), "{message}");
        }
    }

    #[test]
    fn a_camera_held_any_way_gives_the_same_picture() {
        // image's own definition: rotating what was stored by the angle, clockwise, makes it upright.
        let stored = image::GrayImage::from_fn(3, 2, |x, y| image::Luma([(10 * y + x) as u8]));
        for exif in 1..=8 {
            let held = Orientation::from_exif(exif).unwrap();
            let mut expected = image::DynamicImage::ImageLuma8(stored.clone());
            expected.apply_orientation(held);
            let (width, pixels) = upright(3, stored.as_raw().clone(), held);
            assert_eq!((width, pixels), (expected.width() as usize, expected.into_bytes()), "{held:?}");
        }
    }

    #[test]
    fn negate_swaps_black_and_white() {
        let shading = Shading { negate: true, ..Shading::default() };
        assert_eq!((shading.cell(0.0, 1.0), shading.cell(1.0, 1.0)), (Occupancy::Free, Occupancy::Occupied));
    }
}
