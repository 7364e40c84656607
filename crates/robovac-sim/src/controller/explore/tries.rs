//! Failed attempts at goals, so that none is repeated for ever.

use crate::mapping::Layer;
use robovac_core::{geometry::Point, grid::Cell};

/// How much is spent on a place before it is given up, and the side of places, m.
const MOST: u8 = 8;
const SIDE: f64 = 0.1;
/// What it costs to set out for it, and to get there in vain; how near that is, m.
const SET_OUT: u8 = 1;
const IN_VAIN: u8 = 3;
pub(super) const THERE: f64 = 0.4;

/// What was spent on places.
#[derive(Debug, Clone, Default)]
pub(super) struct Tries(Layer<u8>);

impl Tries {
    /// The robot sets out for a place.
    pub fn set_out(&mut self, place: Point) {
        self.spend(place, SET_OUT);
    }

    /// It stopped `at` a place on its way: if that is near, what it went for isn't to be had.
    pub fn stopped(&mut self, at: Point, place: Point) {
        if (at - place).norm() < THERE {
            self.spend(place, IN_VAIN);
        }
    }

    fn spend(&mut self, place: Point, much: u8) {
        self.0.update(Cell::at(place, SIDE), |spent| spent.saturating_add(much));
    }

    /// Whether a place is still worth going for.
    pub fn allow(&self, place: Point) -> bool {
        self.0.get(Cell::at(place, SIDE)) < MOST
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_given_up_sooner_by_those_who_were_there() {
        let (place, far) = (Point::new(1.0, 1.0), Point::new(3.0, 1.0));
        let tries_until = |at: Point| {
            let mut tries = Tries::default();
            (1..20).find(|_| {
                tries.set_out(place);
                tries.stopped(at, place);
                !tries.allow(place)
            })
        };
        assert_eq!((tries_until(place), tries_until(far)), (Some(2), Some(8)));
        assert!(Tries::default().allow(place));
    }
}
