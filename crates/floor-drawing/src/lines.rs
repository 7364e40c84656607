//! Tells layers of lines from walls in a drawing whose walls are drawn as wide as they are: dimension lines and doors.

use crate::{Drawing, Role, Stroke, roles::says_wall};
use robovac_core::{
    geometry::{Point, Vector, contains, convex_hull},
    math::{FRAC_PI_2, atan2},
};

/// Least side of a building, as a share of the drawing's longer side (ours).
const BUILDING: f64 = 0.15;
/// Fewest wide strokes.
const WALLS: usize = 4;
/// Largest turn from chord to chord of an arc, rad.
const CHORD: f64 = 0.15;
/// How far the arc of a door can be off a right angle, rad.
const OPEN: f64 = 0.6;

/// The drawing in which layers that are named by a colour, and have lines alone, are ignored if all lie outside of the walls, or
/// most are doors: a leaf with its arc. Furniture stays.
pub(crate) fn without_lines(mut drawing: Drawing) -> Drawing {
    let role = |stroke: &Stroke| drawing.layers[stroke.layer as usize].role;
    let wide = || drawing.strokes.iter().filter(|stroke| stroke.width > 0.0 && role(stroke) == Role::Wall);
    let hull = convex_hull(wide().flat_map(|stroke| drawing.corners(stroke)).copied().collect());
    let (Some(size), Some(all)) = (size(&hull), size(&drawing.points)) else { return drawing };
    if wide().count() < WALLS || size.min() < BUILDING * all.max() {
        return drawing;
    }
    let ignored: Vec<usize> = (0..drawing.layers.len())
        .filter(|&index| {
            let layer = &drawing.layers[index];
            let strokes = || drawing.strokes.iter().filter(|stroke| stroke.layer as usize == index);
            let is_outside = |stroke: &Stroke| !drawing.corners(stroke).iter().any(|&corner| contains(&hull, corner));
            let doors = strokes().filter(|stroke| !stroke.is_closed && is_door(drawing.corners(stroke))).count();
            layer.role == Role::Wall
                && layer.name.starts_with('#')
                && !says_wall(&layer.name)
                && strokes().all(|stroke| stroke.width == 0.0)
                && (strokes().all(is_outside) || 2 * doors > strokes().count())
        })
        .collect();
    for index in ignored {
        drawing.layers[index].role = Role::Ignored;
    }
    drawing
}

/// Width and height of the box around points.
fn size(points: &[Point]) -> Option<Vector> {
    let first = *points.first()?;
    let (low, high) = points.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
    Some(high - low)
}

/// Whether a line has one arc, of about a right angle.
fn is_door(corners: &[Point]) -> bool {
    let mut arcs = Vec::new();
    let mut turned = 0.0_f64;
    for three in corners.windows(3) {
        let (before, after) = (three[1] - three[0], three[2] - three[1]);
        let turn = atan2(before.perp(&after), before.dot(&after));
        if turn != 0.0 && turn.abs() <= CHORD && turn * turned >= 0.0 {
            turned += turn;
        } else if turned != 0.0 {
            arcs.push(turned);
            turned = 0.0;
        }
    }
    arcs.extend((turned != 0.0).then_some(turned));
    matches!(arcs[..], [arc] if (arc.abs() - FRAC_PI_2).abs() <= OPEN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read;
    use robovac_core::floor_plan::SourceFile;

    /// Roles of the layers of a flat with walls `wide` units thick, by name.
    fn roles(wide: f64) -> Vec<(String, Role)> {
        let wall = |way: &str| format!("<path d='M{way}' stroke='#111' stroke-width='{wide}'/>");
        let walls = ["200 200H1000V400", "1000 500V800H200V200", "600 200V450", "600 550V800"].map(wall).join("\n");
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1200 1000' fill='none'>{walls}\
             <path d='M1000 400H900A100 100 0 0 0 1000 500' stroke='#333'/><path d='M600 450H700A100 100 0 0 1 600 550' stroke='#333'/>\
             <path d='M200 150H1000M190 160L210 140M990 160L1010 140' stroke='#444'/>\
             <path d='M300 300H400V380H300Z' stroke='#555'/><circle cx='800' cy='300' r='40' stroke='#666'/>\
             <g id='fence'><path d='M100 100H1100' stroke='#777'/></g></svg>"
        );
        let drawing = read(&SourceFile { name: "flat.svg".into(), bytes: svg.into() }).unwrap();
        drawing.layers.into_iter().map(|layer| (layer.name, layer.role)).collect()
    }

    #[test]
    fn doors_and_dimension_lines_beside_wide_walls_are_ignored_and_furniture_stays() {
        let ignored = |roles: Vec<(String, Role)>| -> Vec<String> {
            roles.into_iter().filter(|(_, role)| *role == Role::Ignored).map(|(name, _)| name).collect()
        };
        assert_eq!(ignored(roles(24.0)), ["#333333", "#444444"]);
        // Walls that are lines, too, can't be told from others.
        assert_eq!(ignored(roles(1.0)), [""; 0]);
    }
}
