//! Objects packed into one list of numbers, for messages from a worker to the page; needs the least code in the page.

use robovac_core::{
    floor_plan::{Object, Who},
    geometry::{Point, Pose},
};

/// For each object its kind, the number of values that follow, and these.
pub fn pack(objects: &[Object]) -> Vec<f64> {
    let flat = |points: &[Point]| points.iter().flat_map(|p| [p.x, p.y]).collect::<Vec<_>>();
    let mut packed = Vec::new();
    for object in objects {
        let (kind, numbers) = match object {
            Object::Furniture { outline } => (0, flat(outline)),
            Object::DropOff { outline } => (1, flat(outline)),
            Object::Carpet { outline } => (2, flat(outline)),
            Object::Leg { at, radius } => (3, vec![at.x, at.y, *radius]),
            Object::Dirt { at, radius } => (4, vec![at.x, at.y, *radius]),
            Object::Dock { pose } => (5, vec![pose.x, pose.y, pose.heading]),
            Object::VirtualWall { pose, length } => (6, vec![pose.x, pose.y, pose.heading, *length]),
            Object::Mover { who: Who::Person, path } => (7, flat(path)),
            Object::Mover { who: Who::Pet, path } => (8, flat(path)),
            Object::LowObstacle { outline, height } => (9, [vec![*height], flat(outline)].concat()),
        };
        packed.extend([f64::from(kind), numbers.len() as f64]);
        packed.extend(numbers);
    }
    packed
}

/// The objects that [`pack`] packed, up to the first invalid one.
pub fn unpack(mut packed: &[f64]) -> Vec<Object> {
    let mut objects = Vec::new();
    while let [kind, count, rest @ ..] = packed {
        let Some((numbers, rest)) = rest.split_at_checked(*count as usize) else { break };
        packed = rest;
        let points = |numbers: &[f64]| numbers.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect();
        objects.push(match (*kind as u8, numbers) {
            (0, outline) => Object::Furniture { outline: points(outline) },
            (1, outline) => Object::DropOff { outline: points(outline) },
            (2, outline) => Object::Carpet { outline: points(outline) },
            (3, &[x, y, radius]) => Object::Leg { at: Point::new(x, y), radius },
            (4, &[x, y, radius]) => Object::Dirt { at: Point::new(x, y), radius },
            (5, &[x, y, heading]) => Object::Dock { pose: Pose { x, y, heading } },
            (6, &[x, y, heading, length]) => Object::VirtualWall { pose: Pose { x, y, heading }, length },
            (7, path) => Object::Mover { who: Who::Person, path: points(path) },
            (8, path) => Object::Mover { who: Who::Pet, path: points(path) },
            (9, &[height, ref outline @ ..]) => Object::LowObstacle { outline: points(outline), height },
            _ => break,
        });
    }
    objects
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_comes_out_as_it_went_in() {
        let path = vec![Point::new(1.0, 2.0), Point::new(3.5, 4.25), Point::new(0.0, 9.0)];
        let (at, pose) = (path[1], Pose::new(1.0, 2.0, -3.0));
        let objects = vec![
            Object::Furniture { outline: path.clone() },
            Object::Leg { at, radius: 0.02 },
            Object::DropOff { outline: path.clone() },
            Object::Carpet { outline: path.clone() },
            Object::Dirt { at, radius: 0.3 },
            Object::Dock { pose },
            Object::VirtualWall { pose, length: 2.0 },
            Object::Mover { who: Who::Person, path: path.clone() },
            Object::Mover { who: Who::Pet, path: path[..1].to_vec() },
            Object::LowObstacle { outline: path.clone(), height: 0.015 },
        ];
        let packed = pack(&objects);
        assert_eq!(unpack(&packed), objects);
        for end in 0..packed.len() {
            assert!(unpack(&packed[..end]).len() < objects.len());
        }
        assert_eq!(unpack(&[3.0, 2.0, 1.0, 1.0]), [], "a leg has three numbers");
        assert_eq!(unpack(&[0.0, f64::INFINITY]), []);
    }
}
