//! Contact points on a body.

use robovac_core::geometry::Vector;

/// Most places that are told apart: a body between walls and legs is held by three.
const MOST: usize = 4;

/// Directions from a body's origin to what it touches, as unit vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    directions: [Vector; MOST],
    count: usize,
}

impl Touch {
    /// Nothing is touched.
    pub const NONE: Self = Self { directions: [Vector::new(0.0, 0.0); MOST], count: 0 };

    /// Adds a direction; more than can be told apart are left out.
    pub fn add(&mut self, direction: Vector) {
        if let Some(free) = self.directions.get_mut(self.count) {
            *free = direction;
            self.count += 1;
        }
    }

    /// Whether nothing is touched.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.count == 0
    }

    /// The directions.
    pub fn iter(&self) -> impl Iterator<Item = Vector> {
        self.directions.into_iter().take(self.count)
    }
}
