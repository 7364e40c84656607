//! The openings of a picture whose scale was assumed.

use super::{DrawingSession, settings::MOST_OUTER};
use floor_drawing::{OUTER_DOOR, Traced};

impl DrawingSession {
    /// The width up to which openings to the outside are closed instead of the usual one, m, as long as a picture has the scale
    /// that was assumed. If that is too large, so is the front door, and the house would be outside: its opening is
    /// the one by which most floor is lost, up to the widest that can be closed, a fifth of a picture of 20 m. Whoever confirms
    /// the size means the room as it is shown.
    pub(super) fn assumed_outer(&self, traced: &Traced) -> Option<f64> {
        // Whoever chooses another width means it.
        let is_asked = self.has_assumed_scale() && self.settings().outer == OUTER_DOOR;
        let leak = traced.leak.filter(|leak| is_asked && leak.closes && leak.width <= MOST_OUTER)?;
        Some(leak.width)
    }
}

#[cfg(test)]
mod tests {
    use crate::floor_plan::{DrawingSession, FloorPlanSettings};
    use robovac_core::{
        floor_plan::{SourceFile, generate::random_flat},
        grid::{Cell, Occupancy},
    };

    /// Pixels on a side of a flat's cell, and round the flat.
    const PIXELS: i32 = 2;
    const MARGIN: i32 = 40;

    /// A picture of a flat whose front door is open, and the width of its pixels, m.
    fn picture(seed: u64) -> (SourceFile, f64) {
        let plan = random_flat(2, 2, seed);
        let [width, height] =
            [plan.occupancy.width(), plan.occupancy.height()].map(|cells| cells as i32 * PIXELS + 2 * MARGIN);
        let mut bytes = format!("P5\n{width} {height}\n255\n").into_bytes();
        for (y, x) in (0..height).rev().flat_map(|y| (0..width).map(move |x| (y, x))) {
            let cell = Cell::new((x - MARGIN).div_euclid(PIXELS), (y - MARGIN).div_euclid(PIXELS));
            // 0.9 m of the left wall.
            let is_door = cell.x < 4 && (10..28).contains(&cell.y);
            let is_wall = plan.occupancy.get(cell) == Some(&Occupancy::Occupied) && !is_door;
            bytes.push(if is_wall { 0 } else { 255 });
        }
        (SourceFile { name: "flat.pgm".to_owned(), bytes }, plan.resolution / f64::from(PIXELS))
    }

    #[test]
    fn a_front_door_is_closed_though_the_size_that_is_assumed_makes_it_wide() {
        for seed in 0..2 {
            let (file, pixel) = picture(seed);
            let mut session = DrawingSession::open(&[file]).unwrap();
            let assumed = session.settings().metre.unwrap();
            assert!(session.assumes_size());
            let floor = |session: &DrawingSession, metre: f64| session.floor_m2() / (metre * metre);
            let set = |session: &mut DrawingSession, change: &dyn Fn(&mut FloorPlanSettings)| {
                let mut settings = session.settings().clone();
                change(&mut settings);
                session.set(settings).unwrap();
            };
            let found = floor(&session, assumed);
            // It was opened then, and the robot mowed round the house.
            set(&mut session, &|settings| settings.confirmed = settings.metre);
            assert!(!session.assumes_size());
            assert_eq!(floor(&session, assumed), found, "seed {seed}: another room is confirmed than was shown");
            set(&mut session, &|settings| settings.metre = Some(pixel));
            let share = found / floor(&session, pixel);
            assert!((0.95..1.05).contains(&share), "seed {seed}: {share} of the floor");
        }
    }
}
