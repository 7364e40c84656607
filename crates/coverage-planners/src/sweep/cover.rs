//! Coverage of a sweep.

use robovac_core::{
    cspace::{FreeSteps, Outline, Swath},
    geometry::Point,
    grid::{Direction, Grid},
    math,
};

/// Reachable floor, and its swept part: see [`super::Sweep::coverage`].
pub(super) struct Cover {
    floor: Swath,
    swept: Swath,
    /// The body, if it faces where it drives.
    turning: Option<Outline>,
    /// Least gain for which a stroke is driven, cells.
    pub least_gain: f64,
}

impl Cover {
    /// The floor swept along `path` by `body`, on the cells of the obstacle map. `planned` is the outline that the map
    /// was made for: the body at heading 0, or the circle in which it turns.
    pub fn new(
        (body, planned): (&Outline, &Outline),
        reached: &Grid<bool>,
        steps: &FreeSteps,
        cell: f64,
        path: &[Point],
    ) -> Self {
        let nothing = |outline| Swath::new(outline, reached.width(), reached.height(), cell);
        let (mut floor, swept) = (nothing(planned), nothing(body));
        floor.sweep_cells(reached, |at| steps.is_open(at, Direction::Right));
        let (low, high) = body.bounds();
        let least_gain = 0.01 * (high.x - low.x) * (high.y - low.y) / (cell * cell);
        let turning = (body != planned).then(|| body.clone());
        let mut cover = Self { floor, swept, turning, least_gain };
        if let &[only] = path {
            cover.swept.sweep(only, only);
        }
        cover.sweep(path);
        cover
    }

    /// Number of cells that a stroke would add.
    pub fn gain(&mut self, from: Point, to: Point) -> f64 {
        self.face(from, to);
        self.swept.gain(&self.floor, from, to) as f64
    }

    /// Sweeps along a way.
    pub fn sweep(&mut self, way: &[Point]) {
        for piece in way.windows(2) {
            self.face(piece[0], piece[1]);
            self.swept.sweep(piece[0], piece[1]);
            // Contacts lie up to a cell beyond the centres of FREE cells.
            self.floor.sweep(piece[0], piece[1]);
        }
    }

    fn face(&mut self, from: Point, to: Point) {
        if let Some(body) = &self.turning {
            self.swept.face(body, math::atan2(to.y - from.y, to.x - from.x));
        }
    }

    /// Swept share, 0 to 1.
    pub fn share(&self) -> f64 {
        if self.floor.count() == 0 { 0.0 } else { self.swept.count() as f64 / self.floor.count() as f64 }
    }
}
