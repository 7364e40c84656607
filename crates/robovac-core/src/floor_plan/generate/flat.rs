//! Furnished flats from a seed: as many different homes as a study or a learner needs.
//!
//! A flat is laid out first (rooms off a corridor, rooms around an open living room, or a single room with a bath), then
//! furnished piece by piece. A piece stays where it was put only if a robot vacuum can still drive from every door of the
//! room to nearly all floor that is wide enough for it. Sizes of rooms, doors and furniture are those of common homes, to
//! 5 cm; none are measured ones.

mod area;
mod fitting;
mod furnish;
mod id;
mod layout;
mod passable;
mod piece;
mod pieces;

pub use id::{FlatId, FlatIdError};

use crate::{
    floor_plan::{FloorPlan, Sketch},
    rng::seeded,
};
use area::Area;
use furnish::Furnished;
use layout::FlatLayout;
use serde::{Deserialize, Serialize};

/// Side of a cell of the plan, m.
const CELL: f64 = 0.05;
/// Stream of the random numbers.
const STREAM: u64 = 0x666c_6174;
/// Smallest and largest area that can be asked for, m².
const AREAS: [f64; 2] = [25.0, 120.0];

/// What is common to all flats of a set; the seed tells them apart.
///
/// ```
/// use robovac_core::floor_plan::generate::{FlatSpec, generate_flat};
/// let spec = FlatSpec { area_m2: [60.0, 80.0], ..FlatSpec::default() };
/// assert_eq!(spec.check(), Ok(()));
/// let flat = generate_flat(7, &spec);
/// assert_eq!(flat, generate_flat(7, &spec));
/// assert!(flat.start.is_some());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct FlatSpec {
    /// Least and greatest area between the outer walls, m²: 25 to 120.
    pub area_m2: [f64; 2],
    /// How much of the furniture that a room can have is in it, 0 (empty) to 1 (crammed).
    pub furniture: f64,
    /// Whether there are rugs, on which wheels slip more.
    pub rugs: bool,
}

impl Default for FlatSpec {
    fn default() -> Self {
        Self { area_m2: AREAS, furniture: 0.7, rugs: true }
    }
}

/// Reasons why there are no flats of a kind.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FlatSpecError {
    /// The area is out of range or its ends are the wrong way round.
    #[error("area_m2 [{low}, {high}] isn't possible; give the least and the greatest area, from 25 to 120 m²")]
    Area {
        /// Least area asked for, m².
        low: f64,
        /// Greatest area asked for, m².
        high: f64,
    },
    /// The amount of furniture is out of range.
    #[error("furniture {0} isn't possible; give a number from 0 (empty) to 1 (crammed)")]
    Furniture(f64),
}

impl FlatSpec {
    /// Whether there are such flats.
    pub fn check(&self) -> Result<(), FlatSpecError> {
        let [low, high] = self.area_m2;
        // In this form it refuses NaN, too.
        if !(AREAS[0] <= low && low <= high && high <= AREAS[1]) {
            return Err(FlatSpecError::Area { low, high });
        }
        if !(0.0..=1.0).contains(&self.furniture) {
            return Err(FlatSpecError::Furniture(self.furniture));
        }
        Ok(())
    }

    /// The nearest values that are possible.
    fn possible(&self) -> Self {
        let within = |value: f64, [low, high]: [f64; 2], otherwise: f64| {
            if value.is_nan() { otherwise } else { value.clamp(low, high) }
        };
        let low = within(self.area_m2[0], AREAS, AREAS[0]);
        let high = within(self.area_m2[1], AREAS, AREAS[1]).max(low);
        Self { area_m2: [low, high], furniture: within(self.furniture, [0.0, 1.0], 0.7), ..*self }
    }
}

/// The flat with that seed. Takes about a millisecond; the same seed gives the same flat on every machine.
///
/// Cells of 5 cm hold walls and what stands flush on the floor; legs, thin things, rugs and the dock are objects. Doors
/// are 0.7 to 0.9 m wide. From the start, in front of the dock, a robot 0.35 m wide reaches every room. Values of `spec`
/// that [`FlatSpec::check`] refuses are taken as the nearest possible ones.
pub fn generate_flat(seed: u64, spec: &FlatSpec) -> FloorPlan {
    let spec = spec.possible();
    let mut rng = seeded(seed, STREAM);
    let layout = FlatLayout::new(&spec, &mut rng);
    let furnished = furnish::furnish(&layout, &spec, &mut rng);
    draw(FlatId { seed, spec }, &layout, furnished)
}

fn draw(id: FlatId, layout: &FlatLayout, furnished: Furnished) -> FloorPlan {
    let rects = |areas: &[Area]| areas.iter().map(Area::metres).collect::<Vec<_>>();
    let free: Vec<Area> = layout.rooms.iter().map(|room| room.area).chain(layout.doors.iter().map(|d| d.gap)).collect();
    let (width, height) = (f64::from(layout.width) * CELL, f64::from(layout.height) * CELL);
    let sketch = Sketch::solid(width, height, CELL).carve(&rects(&free)).fill(&rects(&furnished.solids));
    let area = layout.area_m2();
    let note = id.note(&format!("{area:.0} m² in {} rooms.", layout.rooms.len()));
    let mut plan = sketch.finish(&format!("Flat {}", id.seed), &note);
    plan.objects = furnished.objects;
    plan.start = Some(furnished.start);
    plan
}

#[cfg(test)]
mod tests {
    use super::{layout::RoomUse, *};
    use crate::{coverage::ReachableFloor, floor_plan::Object, geometry::Point, grid::Cell, robot::model};
    use std::collections::HashSet;

    /// Everything that is promised of a flat.
    fn check(seed: u64, spec: &FlatSpec) {
        let plan = generate_flat(seed, spec);
        assert_eq!(plan, generate_flat(seed, spec), "{seed}");
        assert_eq!(plan.check_objects(plan.start), Ok(()), "{seed}");
        let layout = FlatLayout::new(&spec.possible(), &mut seeded(seed, STREAM));
        let area = layout.area_m2();
        assert!((0.98 * spec.area_m2[0]..=1.02 * spec.area_m2[1]).contains(&area), "{seed}: {area}");
        let docks = plan.objects.iter().filter(|object| matches!(object, Object::Dock { .. })).count();
        assert_eq!(docks, 1, "{seed}");
        for door in layout.doors.iter().filter(|door| !door.is_wide) {
            let width = f64::from(door.gap.width().max(door.gap.height())) * CELL;
            assert!((0.699..0.901).contains(&width), "{seed}: {width}");
        }
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        for room in &layout.rooms {
            let [left, bottom, right, top] = room.area.metres();
            let inside = |cell: Cell| {
                let Point { coords, .. } = floor.centre(cell);
                (left..right).contains(&coords.x) && (bottom..top).contains(&coords.y)
            };
            let stood = floor.standing.iter().filter(|&(cell, &stands)| stands && inside(cell)).count();
            let stood = stood as f64 * floor.resolution * floor.resolution;
            assert!(stood > 0.1, "seed {seed}: {:?} {:?}: {stood:.2} m²", room.purpose, room.area);
        }
        // Furniture takes floor, but never most of it.
        let [low, high] = [0.35, 0.95];
        assert!((low * area..high * area).contains(&floor.area()), "{seed}: {} of {area} m²", floor.area());
    }

    // slow: places to stand in every room of hundreds of flats
    #[test]
    fn flats_have_what_is_promised() {
        (0..200).for_each(|seed| check(seed, &FlatSpec::default()));
        for (seed, furniture) in [(1, 0.0), (2, 1.0), (3, 1.0), (4, 1.0)] {
            check(seed, &FlatSpec { furniture, ..FlatSpec::default() });
        }
        for (seed, area) in [(5, 25.0), (6, 40.0), (7, 63.0), (8, 120.0)] {
            check(seed, &FlatSpec { area_m2: [area, area], ..FlatSpec::default() });
        }
    }

    #[test]
    #[ignore = "soak: 2,000 more flats"]
    fn many_flats_have_what_is_promised() {
        (100..2100)
            .for_each(|seed| check(seed, &FlatSpec { furniture: (seed % 11) as f64 / 10.0, ..FlatSpec::default() }));
    }

    #[test]
    fn layouts_of_hundreds_of_seeds_are_different_homes() {
        let (mut plans, mut purposes, mut areas) = (HashSet::new(), HashSet::new(), Vec::new());
        for seed in 0..400 {
            let layout = FlatLayout::new(&FlatSpec::default(), &mut seeded(seed, STREAM));
            plans.insert(format!("{:?}", layout.rooms));
            purposes.extend(layout.rooms.iter().map(|room| room.purpose));
            areas.push(layout.area_m2());
            let has = |purpose| layout.rooms.iter().any(|room| room.purpose == purpose);
            assert!(has(RoomUse::Bath) && (has(RoomUse::Living) || has(RoomUse::OpenPlan) || has(RoomUse::Studio)));
            for (i, one) in layout.rooms.iter().enumerate() {
                assert!(one.area.width().min(one.area.height()) <= passable::MOST_BITS, "{seed} {one:?}");
                assert!(layout.rooms[..i].iter().all(|other| !other.area.overlaps(&one.area)), "{seed}");
            }
        }
        assert_eq!(plans.len(), 400);
        assert_eq!(purposes.len(), RoomUse::COUNT);
        let spread = |share: f64| areas.iter().filter(|&&area| area < share).count();
        assert!(spread(50.0) > 60 && spread(90.0) < 340, "{} {}", spread(50.0), spread(90.0));
    }

    #[test]
    fn impossible_specs_are_refused_and_still_give_a_flat() {
        let odd = [
            FlatSpec { area_m2: [80.0, 60.0], ..FlatSpec::default() },
            FlatSpec { area_m2: [f64::NAN, f64::INFINITY], ..FlatSpec::default() },
            FlatSpec { area_m2: [1.0, 1.0], ..FlatSpec::default() },
            FlatSpec { furniture: f64::NAN, ..FlatSpec::default() },
            FlatSpec { furniture: -1.0, ..FlatSpec::default() },
        ];
        for spec in odd {
            assert!(spec.check().is_err());
            check(3, &spec.possible());
        }
    }
}
