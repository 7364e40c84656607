//! Recently driven ground, so that a robot without rear sensors reverses only over it.

use std::collections::VecDeque;

/// Distance between marks, m.
const SPACING: f64 = 0.008;
/// Most marks that are kept: the last two metres.
const MOST: usize = 250;
/// A mark counts as reached when it is this near, m.
const REACHED: f64 = 0.003;
/// Opposite wheel travel, m, without distance ahead, that counts as a turn on the spot, after which the ground behind
/// is another.
const TURN: f64 = 0.02;

/// Marks of the wheels' positions while the robot drove forward, as distances rolled.
#[derive(Debug, Clone, Default)]
pub(super) struct WheelTrail {
    /// Present position of the wheels, m: rolled distance less slip against walls.
    at: [f64; 2],
    marks: VecDeque<[f64; 2]>,
}

/// Distance of the middle between the wheels from one mark to another, m.
fn ahead(from: [f64; 2], to: [f64; 2]) -> f64 {
    0.5 * (to[0] - from[0] + to[1] - from[1])
}

impl WheelTrail {
    /// Forgets the trail.
    pub(super) fn clear(&mut self) {
        self.marks.clear();
    }

    /// Sets the known ground straight behind, m.
    pub(super) fn assume(&mut self, metres: f64) {
        self.marks.clear();
        let count = (metres / SPACING) as usize;
        self.marks.extend((0..=count.min(MOST - 1)).rev().map(|i| self.at.map(|wheel| wheel - SPACING * i as f64)));
    }

    /// The wheels rolled this far, m; `is_held` if an obstacle in front held the body meanwhile.
    pub(super) fn roll(&mut self, rolled: [f64; 2], is_held: bool, is_backing: bool) {
        let is_forward = rolled[0] + rolled[1] > 0.0;
        if is_held && is_forward {
            return;
        }
        self.at = [self.at[0] + rolled[0], self.at[1] + rolled[1]];
        let Some(&last) = self.marks.back() else {
            self.marks.push_back(self.at);
            return;
        };
        let way = ahead(last, self.at);
        let spin = 0.5 * (self.at[1] - last[1] - self.at[0] + last[0]).abs();
        if way >= SPACING {
            if self.marks.len() == MOST {
                self.marks.pop_front();
            }
            self.marks.push_back(self.at);
        } else if !is_backing && (way < -SPACING || spin > TURN + 3.0 * way.abs()) {
            self.marks.clear();
            self.marks.push_back(self.at);
        }
    }

    /// Length of the trail, m.
    pub(super) fn length(&self) -> f64 {
        self.marks.front().map_or(0.0, |&first| ahead(first, self.at).max(0.0))
    }

    /// Wheel speeds that lead back along the trail, as shares of the faster wheel's; `None` at its end.
    pub(super) fn back(&mut self) -> Option<[f64; 2]> {
        while self.marks.len() > 1 && self.marks.back().is_some_and(|&mark| ahead(mark, self.at) < REACHED) {
            self.marks.pop_back();
        }
        // A mark a few places farther on makes the direction less sensitive to the wheels' position.
        let target = *self.marks.get(self.marks.len().checked_sub(1)?.saturating_sub(2))?;
        if ahead(target, self.at) < REACHED {
            return None;
        }
        let way = [self.at[0] - target[0], self.at[1] - target[1]];
        let most = way[0].abs().max(way[1].abs());
        Some([-way[0] / most, -way[1] / most])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drive(trail: &mut WheelTrail, rolled: [f64; 2], steps: u32) {
        for _ in 0..steps {
            trail.roll(rolled, false, false);
        }
    }

    #[test]
    fn an_arc_is_gone_back_the_same_way_and_no_farther() {
        let mut trail = WheelTrail::default();
        drive(&mut trail, [0.002, 0.004], 50);
        assert!((trail.length() - 0.15).abs() < 0.004, "{}", trail.length());
        let mut rolled = [0.0; 2];
        while let Some(way) = trail.back() {
            let step = way.map(|share| share * 0.004);
            assert!((step[0] / step[1] - 0.5).abs() < 0.1, "{step:?}");
            rolled = [rolled[0] + step[0], rolled[1] + step[1]];
            trail.roll(step, false, true);
        }
        assert!((rolled[0] + 0.1).abs() < 0.01 && (rolled[1] + 0.2).abs() < 0.01, "{rolled:?}");
    }

    #[test]
    fn nothing_is_known_behind_after_a_turn_on_the_spot() {
        let mut trail = WheelTrail::default();
        drive(&mut trail, [0.004, 0.004], 50);
        drive(&mut trail, [-0.004, 0.004], 50);
        assert!(trail.length() < 0.01 && trail.back().is_none());
    }

    #[test]
    fn wheels_that_slip_against_a_wall_make_no_way_to_go_back() {
        let mut trail = WheelTrail::default();
        drive(&mut trail, [0.004, 0.004], 5);
        for _ in 0..20 {
            trail.roll([0.004, 0.004], true, false);
        }
        assert!((trail.length() - 0.016).abs() < 0.005, "{}", trail.length());
    }
}
