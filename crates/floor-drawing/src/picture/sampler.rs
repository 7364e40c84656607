//! What lies on squares of a turned picture.

use super::Picture;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid, chessboard},
    math::{ceil, cos, floor, sin},
};

/// A picture to be looked up often.
pub(crate) struct PictureSampler<'a> {
    pub picture: &'a Picture,
    /// King's moves from each pixel to the next that isn't floor, or out of the picture.
    moves: Grid<u8>,
    sin: f64,
    cos: f64,
}

impl<'a> PictureSampler<'a> {
    pub fn new(picture: &'a Picture) -> Self {
        let moves = chessboard(&picture.blocked);
        Self { picture, moves, sin: sin(-picture.turn), cos: cos(-picture.turn) }
    }

    /// Whether something lies on the square with `side` at `low`; `outside` is what lies beyond the picture.
    pub fn blocks(&self, low: Point, side: f64, outside: bool) -> bool {
        // All of the square is within half its diagonal, and rounding by a pixel either way.
        let reach = ceil(side * std::f64::consts::FRAC_1_SQRT_2) + 2;
        let middle = self.pixel(low + Vector::new(0.5, 0.5) * side);
        if self.moves.get(middle).is_some_and(|&moves| i32::from(moves) >= reach) {
            return false;
        }
        let is_beyond = |at: i32, pixels: usize| at <= -reach || at >= pixels as i32 + reach;
        if is_beyond(middle.x, self.moves.width()) || is_beyond(middle.y, self.moves.height()) {
            return outside;
        }
        // A sample a pixel, at least.
        let count = floor(side + 1e-9).max(1);
        let step = side / f64::from(count);
        (0..count * count).any(|index| {
            let by = Vector::new(f64::from(index % count) + 0.5, f64::from(index / count) + 0.5) * step;
            self.picture.blocked.get(self.pixel(low + by)).copied().unwrap_or(outside)
        })
    }

    /// The pixel at a place in the turned picture.
    fn pixel(&self, at: Point) -> Cell {
        Cell::new(floor(at.x * self.cos - at.y * self.sin), floor(at.x * self.sin + at.y * self.cos))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::RngExt;
    use robovac_core::{grid::from_picture, math::FRAC_PI_2, rng::seeded};

    #[test]
    fn a_turned_picture_is_looked_up_where_it_lies() {
        let blocked = from_picture("#...\n....\n", |c| c == '#').unwrap();
        let mut picture = Picture { name: String::new(), blocked, turn: 0.0 };
        let sampler = PictureSampler::new(&picture);
        assert!(sampler.blocks(Point::new(0.0, 1.0), 1.0, false) && !sampler.blocks(Point::new(1.0, 1.0), 1.0, false));
        assert!(sampler.blocks(Point::new(0.0, 0.0), 2.0, false), "a square with a wall in it");
        // A quarter to the left: the upper left corner comes to the lower left.
        picture.turn = FRAC_PI_2;
        let sampler = PictureSampler::new(&picture);
        let [low, _] = Picture::bounds(4, 2, picture.turn);
        assert!(sampler.blocks(low, 1.0, false) && !sampler.blocks(low + Vector::new(1.0, 0.0), 1.0, false));
        assert!(sampler.blocks(Point::new(5.0, 5.0), 1.0, true));
    }

    #[test]
    fn squares_far_from_everything_are_found_as_by_samples() {
        let mut rng = seeded(1, 7);
        for _ in 0..20 {
            let mut blocked = Grid::filled(80, 60, false);
            for _ in 0..4 {
                blocked[Cell::new(rng.random_range(0..80), rng.random_range(0..60))] = true;
            }
            let picture = Picture { name: String::new(), blocked, turn: rng.random_range(-3.0..3.0) };
            let sampler = PictureSampler::new(&picture);
            let by_samples = |low: Point, side: f64, outside: bool| {
                let count = floor(side + 1e-9).max(1);
                let centre = |index: i32| (f64::from(index) + 0.5) * side / f64::from(count);
                let mut all = (0..count).flat_map(|row| (0..count).map(move |column| (column, row)));
                all.any(|(column, row)| {
                    let pixel = sampler.pixel(low + Vector::new(centre(column), centre(row)));
                    picture.blocked.get(pixel).copied().unwrap_or(outside)
                })
            };
            for _ in 0..500 {
                let low = Point::new(rng.random_range(-80.0..80.0), rng.random_range(-80.0..80.0));
                let (side, outside) = (rng.random_range(0.3..12.0), rng.random_bool(0.5));
                assert_eq!(sampler.blocks(low, side, outside), by_samples(low, side, outside), "{low} {side}");
            }
        }
    }
}
