//! Contact points on a body.

use robovac_core::geometry::Vector;

/// Most contacts that are distinguished: a body between walls and legs is held by three.
const MOST: usize = 4;

/// Directions from a body's origin to its contacts, as unit vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    directions: [Vector; MOST],
    count: usize,
}

impl Touch {
    /// No contact.
    pub const NONE: Self = Self { directions: [Vector::new(0.0, 0.0); MOST], count: 0 };

    /// Adds a direction; beyond the limit it is dropped.
    pub fn add(&mut self, direction: Vector) {
        if let Some(free) = self.directions.get_mut(self.count) {
            *free = direction;
            self.count += 1;
        }
    }

    /// Whether there is no contact.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.count == 0
    }

    /// The directions.
    pub fn iter(&self) -> impl Iterator<Item = Vector> {
        self.directions.into_iter().take(self.count)
    }
}
