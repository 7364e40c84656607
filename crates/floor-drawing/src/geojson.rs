//! GeoJSON floor plans (RFC 7946): polygons and lines, the usual form of building surveys and indoor maps.

use super::{Drawing, DrawingError, DrawingFlaw, error::bad, model::Builder};
use geojson::{Feature, GeoJson, Geometry, GeometryValue, JsonObject};
use robovac_core::{
    floor_plan::SourceFile,
    geometry::Point,
    math::{PI, cos, exp},
};

/// Properties that name a layer, in order of preference.
const LAYER_KEYS: [&str; 3] = ["layer", "class", "name"];
/// The earth's mean radius, m (IUGG).
const EARTH: f64 = 6_371_008.8;
/// The radius of the Mercator projection of web maps, m (WGS 84's at the equator).
const EQUATOR: f64 = 6_378_137.0;
/// Widest extent, in degrees, for coordinates to be taken as longitudes and latitudes of a building rather than metres
/// of a plan (ours): 10 km.
const WIDEST: f64 = 0.1;
/// Deepest nesting of collections.
const MAX_DEPTH: usize = 32;

/// Whether the bytes are JSON of a GeoJSON type.
pub(super) fn is_geojson(bytes: &[u8]) -> bool {
    if !bytes.trim_ascii_start().starts_with(b"{") {
        return false;
    }
    // The type can come last; scenarios and other JSON files contain none of these words.
    let has = |word: &[u8]| bytes.windows(word.len()).any(|window| window == word);
    let types: [&[u8]; 3] = [b"\"FeatureCollection\"", b"\"Feature\"", b"\"GeometryCollection\""];
    types.into_iter().any(has)
        || (has(b"\"coordinates\"")
            && [&b"\"Polygon\""[..], b"\"MultiPolygon\"", b"\"LineString\"", b"\"MultiLineString\""]
                .into_iter()
                .any(has))
}

/// Reads GeoJSON. If all coordinates can be longitudes and latitudes of one building they are projected to metres
/// around their middle (equirectangular: east, north), regardless of any `crs`. Otherwise they are used unchanged: in
/// metres if the `crs` is known to be metric, in units of the Mercator projection of web maps, or in units that the
/// user must enter.
pub(super) fn read(file: &SourceFile) -> Result<Drawing, DrawingError> {
    let bytes = file.bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&file.bytes);
    let refuse = |place: &str, flaw| bad(&file.name, place, flaw);
    let parsed: GeoJson = match serde_json::from_slice(bytes) {
        Ok(parsed) => parsed,
        Err(error) if error.is_eof() => {
            return Err(refuse("", DrawingFlaw::CutOff { place: "in the middle of the JSON" }));
        }
        Err(error) => {
            let place = format!("line {}, column {}", error.line(), error.column());
            return Err(refuse(&place, DrawingFlaw::Parser { cause: error.to_string() }));
        }
    };
    let code = epsg_code(&parsed);
    let mut reader = GeoJsonReader { builder: Builder::new(), shapes: Vec::new() };
    let read = match parsed {
        GeoJson::FeatureCollection(collection) => {
            collection.features.into_iter().enumerate().try_for_each(|(i, feature)| reader.feature(i + 1, feature))
        }
        GeoJson::Feature(feature) => reader.feature(1, feature),
        GeoJson::Geometry(geometry) => reader.top(1, "0", &geometry),
    };
    read.and_then(|()| reader.draw(code))
        .map_err(|(feature, flaw)| refuse(&format!("feature {feature}"), flaw))
        .and_then(|(builder, metre)| builder.finish(&file.name, metre))
}

/// Number of the coordinate reference system in the EPSG's register, if one is given.
fn epsg_code(parsed: &GeoJson) -> Option<u32> {
    let members = match parsed {
        GeoJson::FeatureCollection(collection) => &collection.foreign_members,
        GeoJson::Feature(feature) => &feature.foreign_members,
        GeoJson::Geometry(geometry) => &geometry.foreign_members,
    };
    let name = members.as_ref()?.get("crs")?.get("properties")?.get("name")?.as_str()?;
    let (authority, code) = name.rsplit_once(':')?;
    authority.to_uppercase().contains("EPSG").then(|| code.parse().ok())?
}

/// Whether it is the Mercator projection of web maps: 3857, or the unofficial 900913.
fn is_web_mercator(code: u32) -> bool {
    matches!(code, 3857 | 900_913)
}

/// Whether coordinates of that system are eastings and northings in metres, to about one part in a thousand: UTM on WGS
/// 84, ETRS89 and NAD83, the MGA of Australia, and the national grids of Europe and New Zealand (EPSG's register).
fn is_metric(code: u32) -> bool {
    matches!(code, 32601..=32660 | 32701..=32760 | 25828..=25838 | 26901..=26923 | 28346..=28359 | 7846..=7859)
        || matches!(code, 2056 | 21781 | 27700 | 28992 | 31370 | 2154 | 31466..=31469 | 31254..=31259 | 31287)
        || matches!(code, 3006 | 3067 | 2180 | 2193)
}

struct GeoShape {
    feature: u32,
    layer: u32,
    is_closed: bool,
    points: Vec<Point>,
}

struct GeoJsonReader {
    builder: Builder,
    shapes: Vec<GeoShape>,
}

type RefusedFeature = (u32, DrawingFlaw);

impl GeoJsonReader {
    fn feature(&mut self, number: usize, feature: Feature) -> Result<(), RefusedFeature> {
        let number = u32::try_from(number).unwrap_or(u32::MAX);
        let layer = feature.properties.as_ref().and_then(layer_of).unwrap_or_else(|| "0".to_owned());
        match feature.geometry {
            Some(geometry) => self.top(number, &layer, &geometry),
            None => Ok(()),
        }
    }

    fn top(&mut self, feature: u32, layer: &str, geometry: &Geometry) -> Result<(), RefusedFeature> {
        let layer = self.builder.layer(layer).map_err(|flaw| (feature, flaw))?;
        self.geometry(feature, layer, &geometry.value, 0)
    }

    fn geometry(
        &mut self,
        feature: u32,
        layer: u32,
        value: &GeometryValue,
        depth: usize,
    ) -> Result<(), RefusedFeature> {
        match value {
            GeometryValue::Polygon { coordinates } => self.lines(feature, layer, true, coordinates)?,
            GeometryValue::MultiPolygon { coordinates } => {
                coordinates.iter().try_for_each(|rings| self.lines(feature, layer, true, rings))?;
            }
            GeometryValue::LineString { coordinates } => self.line(feature, layer, false, coordinates)?,
            GeometryValue::MultiLineString { coordinates } => self.lines(feature, layer, false, coordinates)?,
            GeometryValue::GeometryCollection { geometries } if depth < MAX_DEPTH => {
                for geometry in geometries {
                    self.geometry(feature, layer, &geometry.value, depth + 1)?;
                }
            }
            GeometryValue::GeometryCollection { .. } => {
                return Err((feature, DrawingFlaw::TooMany { what: "nested collections", most: MAX_DEPTH }));
            }
            GeometryValue::Point { .. } | GeometryValue::MultiPoint { .. } => self.builder.leave_out("points", 1),
        }
        Ok(())
    }

    fn lines(
        &mut self,
        feature: u32,
        layer: u32,
        is_closed: bool,
        lines: &[Vec<geojson::Position>],
    ) -> Result<(), RefusedFeature> {
        lines.iter().try_for_each(|line| self.line(feature, layer, is_closed, line))
    }

    fn line(
        &mut self,
        feature: u32,
        layer: u32,
        is_closed: bool,
        line: &[geojson::Position],
    ) -> Result<(), RefusedFeature> {
        let mut points = Vec::with_capacity(line.len());
        for position in line {
            let [x, y, ..] = position.as_slice() else {
                let found = DrawingFlaw::Parser { cause: "a position has fewer than two numbers".to_owned() };
                return Err((feature, found));
            };
            super::model::check_coordinate(*x)
                .and(super::model::check_coordinate(*y))
                .map_err(|flaw| (feature, flaw))?;
            points.push(Point::new(*x, *y));
        }
        // A line that ends where it began is an outline.
        let is_closed = is_closed || (points.len() > 3 && points.first() == points.last());
        self.shapes.push(GeoShape { feature, layer, is_closed, points });
        Ok(())
    }

    fn draw(mut self, code: Option<u32>) -> Result<(Builder, Option<f64>), RefusedFeature> {
        let bounds = self.bounds();
        let middle = bounds.and_then(place_on_earth);
        let metre = match (code, bounds) {
            _ if middle.is_some() => Some(1.0),
            (Some(code), Some([low, high])) if is_web_mercator(code) => Some(mercator_metre(0.5 * (low.y + high.y))),
            (Some(code), _) if is_metric(code) => Some(1.0),
            _ => None,
        };
        for shape in self.shapes {
            let points = shape.points.into_iter().map(|p| match middle {
                Some(middle) => {
                    let degree = EARTH * PI / 180.0;
                    Point::new((p.x - middle.x) * degree * cos(middle.y.to_radians()), (p.y - middle.y) * degree)
                }
                None => p,
            });
            self.builder
                .stroke(shape.layer, shape.feature, shape.is_closed, points)
                .map_err(|flaw| (shape.feature, flaw))?;
        }
        Ok((self.builder, metre))
    }

    /// The box around all points.
    fn bounds(&self) -> Option<[Point; 2]> {
        let mut points = self.shapes.iter().flat_map(|shape| &shape.points);
        let &first = points.next()?;
        Some(points.fold([first; 2], |[low, high], p| [low.inf(p), high.sup(p)]))
    }
}

/// The middle of the box, in degrees, if it can be that of a building.
fn place_on_earth([low, high]: [Point; 2]) -> Option<Point> {
    let fits = low.x >= -180.0 && high.x <= 180.0 && low.y >= -90.0 && high.y <= 90.0;
    let is_small = (high - low).max() <= WIDEST;
    (fits && is_small).then(|| nalgebra::center(&low, &high))
}

/// Length of a unit of the web maps' Mercator projection at a northing, m: the cosine of the latitude (Snyder, Map
/// projections, 1987, p. 41: y = R artanh(sin latitude)), within 0.7 % as the earth is no sphere.
fn mercator_metre(northing: f64) -> f64 {
    // The projection ends at 20 037 508 m.
    let y = (northing / EQUATOR).clamp(-PI, PI);
    2.0 / (exp(y) + exp(-y))
}

fn layer_of(properties: &JsonObject) -> Option<String> {
    LAYER_KEYS.iter().find_map(|&key| properties.get(key)?.as_str().filter(|name| !name.is_empty()).map(str::to_owned))
}
