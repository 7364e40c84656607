//! Where the tool's disc is while a robot drives straight pieces and turns on the spot between them.

use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    math,
    robot::Tool,
};

/// Longest turn for which the way of the tool is taken as straight, rad: at 0.2 m from the middle it is 0.3 mm off.
const STEP: f64 = 0.1;
/// Turns this close to a reversal can go either way round, rad: what they sweep isn't counted.
const REVERSAL: f64 = 1e-6;

/// Place of the tool's disc on a robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ToolPlace {
    /// Ahead and to the left, m.
    at: Vector,
    /// Of a robot that keeps its heading: the same on the plan.
    kept: Option<Vector>,
}

impl ToolPlace {
    /// That of the robot of a floor; the middle, where its body is the tool.
    pub fn of(floor: &ReachableFloor) -> Self {
        let at = if let Tool::Disc([x, y]) = floor.tool { Vector::new(x, y) } else { Vector::zeros() };
        Self { at, kept: (!floor.turns).then(|| rotated(at, floor.start.direction())) }
    }

    /// From the robot to its tool on a straight way, m.
    #[inline]
    pub fn along(&self, way: Vector) -> Vector {
        if self.at == Vector::zeros() {
            return self.at;
        }
        self.kept.unwrap_or_else(|| way.try_normalize(1e-9).map_or(Vector::zeros(), |along| rotated(self.at, along)))
    }

    /// The way of the tool while the robot drives straight from `a` to `b`.
    #[inline]
    pub fn stroke(&self, a: Point, b: Point) -> (Point, Point) {
        let by = self.along(b - a);
        (a + by, b + by)
    }

    /// All straight ways of the tool along `path`, corners in metres, that begins with the heading `heading`. Chords stand for
    /// turns on the spot.
    pub fn strokes(&self, path: &[Point], heading: Vector) -> Vec<(Point, Point)> {
        let mut strokes = Vec::with_capacity(path.len());
        if let [only] = path {
            let at = only + self.kept.unwrap_or_else(|| rotated(self.at, heading));
            strokes.push((at, at));
        }
        let mut before = heading;
        for pair in path.windows(2) {
            if let Some(along) = (pair[1] - pair[0]).try_normalize(1e-9) {
                self.turn(pair[0], before, along, &mut strokes);
                before = along;
            }
            let by = self.kept.unwrap_or_else(|| rotated(self.at, before));
            strokes.push((pair[0] + by, pair[1] + by));
        }
        strokes
    }

    /// Adds the chords of a turn at a point from one direction to another.
    fn turn(&self, at: Point, from: Vector, to: Vector, strokes: &mut Vec<(Point, Point)>) {
        let angle = math::atan2(from.perp(&to), from.dot(&to));
        if self.at == Vector::zeros() || self.kept.is_some() || angle.abs() > math::PI - REVERSAL {
            return;
        }
        let steps = math::ceil(angle.abs() / STEP);
        let mut last = at + rotated(self.at, from);
        for step in 1..=steps {
            let (sin, cos) = math::sin_cos(angle * f64::from(step) / f64::from(steps));
            let next = at + rotated(self.at, rotated(from, Vector::new(cos, sin)));
            strokes.push((last, next));
            last = next;
        }
    }
}

/// A vector turned as `direction`, of length 1, is from straight ahead.
fn rotated(at: Vector, direction: Vector) -> Vector {
    Vector::new(direction.x * at.x - direction.y * at.y, direction.y * at.x + direction.x * at.y)
}

#[cfg(test)]
mod tests {
    use super::{super::swept_share, *};
    use rand::RngExt;
    use robovac_core::{
        floor_plan::Sketch,
        geometry::Pose,
        rng::seeded,
        robot::{RobotModel, WheelLayout, model},
    };

    fn floor(at: [f64; 2], wheels: WheelLayout) -> ReachableFloor {
        let plan = Sketch::open(4.0, 3.0, 0.05).start(1.0, 1.0, 0.6).finish("", "");
        let robot = RobotModel { tool: Tool::Disc(at), wheels, ..model("roomba600").unwrap().clone() };
        ReachableFloor::new(&plan, &robot, Some(Pose::new(1.0, 1.0, 0.6))).unwrap()
    }

    /// Swept share by samples 2 cm apart, of a disc that is moved in steps of 4 mm and 0.05 rad at most.
    fn stepped_share(floor: &ReachableFloor, at: [f64; 2], path: &[Point]) -> f64 {
        let mut places = Vec::new();
        let mut heading = floor.start.heading;
        let mut stand = |at_robot: Point, heading: f64| {
            let (sin, cos) = math::sin_cos(if floor.turns { heading } else { floor.start.heading });
            places.push(at_robot + Vector::new(cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]));
        };
        for pair in path.windows(2) {
            let way = pair[1] - pair[0];
            let towards = math::atan2(way.y, way.x);
            let turn = math::sin_cos(towards - heading);
            let turn = math::atan2(turn.0, turn.1);
            (0..=64).for_each(|i| stand(pair[0], heading + turn * f64::from(i) / 64.0));
            let steps = (way.norm() / 0.004) as u32;
            (0..=steps).for_each(|i| stand(pair[0] + way * (f64::from(i) / f64::from(steps)), towards));
            heading = towards;
        }
        let (mut all, mut swept) = (0, 0);
        for (i, j) in (0..200).flat_map(|i| (0..150).map(move |j| (i, j))) {
            let at = Point::new(0.02 * f64::from(i) + 0.0037, 0.02 * f64::from(j) + 0.0041);
            if floor.floor.is_set(floor.cell_at(at)) {
                all += 1;
                swept += u32::from(places.iter().any(|place| (place - at).norm() <= floor.tool_radius));
            }
        }
        f64::from(swept) / f64::from(all)
    }

    #[test]
    fn a_tool_beside_the_middle_sweeps_where_it_is() {
        let mut rng = seeded(7, 0);
        for (at, wheels) in [
            ([0.08, 0.0], WheelLayout::Differential),
            ([0.0, -0.07], WheelLayout::Differential),
            ([-0.05, 0.06], WheelLayout::Differential),
            ([0.08, 0.03], WheelLayout::Omnidirectional),
        ] {
            let floor = floor(at, wheels);
            let mut path = vec![floor.start.position()];
            path.extend((0..4).map(|_| Point::new(rng.random_range(0.4..3.6), rng.random_range(0.4..2.6))));
            let (exact, stepped) = (swept_share(&floor, &path), stepped_share(&floor, at, &path));
            assert!((exact - stepped).abs() < 0.004, "{at:?}: {exact}, {stepped} by steps");
        }
    }
}
