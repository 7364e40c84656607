//! The state machine `move_to_empty_space` (004, section 7.1), rule by rule in the printed order.
//!
//! # Where the print errs, and what is done here
//!
//! | print | here |
//! |---|---|
//! | Both bumpers are pressed and the obstacle is on the left: a `return` is missing, the rule falls through to `exit()`, which ends the program. | The rule ends where that of the right side does. |
//! | Both bumpers are pressed, no obstacle is known and neither front light sees one: `exit()`. | The obstacle is taken to be on the right, which is the side that the print asks about first. |
//! | Each rule of step three turns right, wherever the obstacle is. The text says "towards objects edge". | [`ThesisText::Mended`] turns towards the obstacle, [`ThesisText::Printed`] right. |
//! | `random.randint(100, 200)` may give 100, but the counter goes on to 101 in the same call: it is never met, and the robot rotates on. | [`ThesisText::Mended`] takes the number for reached from there on, [`ThesisText::Printed`] waits for ever, or for a light. |
//! | `random_number` starts at -1, which no counter reaches, and keeps its last value after a reset; the rule that asks for it comes first. So a second rule for it further down is never reached, and its `self.move_forward` without brackets would call nothing. | The second rule is left out. |
//! | "Moves forward 9 times" in comment and text, `< 10` in the code. | 10, as the code. |
//! | "Rotate 90 degrees": 15 and a few rotations of 0.5 rad/s for 0.1 s are less than 50. | As the code. |
//! | "For every three movements forward": every third count rotates, so that two movements lie between. | As the code. |
//! | "Lost left light rotate left" logs the opposite of what is set. | As the code: away from the obstacle that the front sensor sees. |
//!
//! A call without a command doesn't change the motion: the driver (create\_robot, chapter 6) holds the last command for
//! `latch_cmd_duration`, 0.2 s unless set otherwise, and then stops.

use super::position::{Position, Rotation};
use robovac_core::robot::SensorReadings;

/// Which text to follow where code and prose differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ThesisText {
    /// The code, literally, as far as it can run.
    Printed,
    /// The meaning of the prose.
    Mended,
}

/// The published Twist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Twist {
    /// `turn_left`: 0.5 rad/s.
    Left,
    /// `turn_right`: -0.5 rad/s.
    Right,
    /// `move_forward`: 0.1 m/s.
    Forward,
}

/// Result of a group of rules.
enum Ruled {
    /// None applies: the next group is tried.
    Not,
    /// One applies, with a command or none.
    Told(Option<Twist>),
}

impl Ruled {
    fn or_else(self, next: impl FnOnce() -> Self) -> Self {
        if let Self::Not = self { next() } else { self }
    }
}

/// Calls after which a rotation counts as stuck, and the most after which it ends: `random.randint(100, 200)`.
pub(super) const STUCK: (u32, u32) = (100, 200);
/// Rotations towards the end of an edge before step one begins: more than this.
const ROTATIONS_BEFORE: u32 = 1;
/// Movements forward in step one.
const FORWARD: u32 = 10;
/// Rotations of step two: more than this.
const ROTATIONS: u32 = 14;
/// In step three every third count is a rotation.
const ZIGZAG: u32 = 3;

/// Its variables, as `__init__` and `reset_status` have them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct EdgeMachine {
    pub text: ThesisText,
    /// Position of the obstacle that it follows.
    pub obstacle: Position,
    pub rotation: Rotation,
    /// 0, or the step on the way around the end of an edge.
    pub edge_detected: u8,
    pub forward_counter: u32,
    /// `None` is the printed -1.
    pub random_number: Option<u32>,
}

impl EdgeMachine {
    /// The state after `__init__`.
    pub fn new(text: ThesisText) -> Self {
        Self {
            text,
            obstacle: Position::None,
            rotation: Rotation::default(),
            edge_detected: 0,
            forward_counter: 0,
            random_number: None,
        }
    }

    /// `reset_status`.
    fn reset_status(&mut self) {
        self.rotation.set_position(Position::None);
        self.forward_counter = 0;
        self.edge_detected = 0;
    }

    /// `move_to_empty_space`: one call of the timer. `random` draws a number between the limits of [`STUCK`].
    pub fn call(&mut self, bumper: &SensorReadings, random: impl FnOnce() -> u32) -> Option<Twist> {
        if self.has_rotated_enough() {
            self.reset_status();
            self.obstacle = Position::None;
            return None;
        }
        if self.rotation.counter == STUCK.0 {
            self.random_number = Some(random());
            self.rotation.counter += 1;
            return None;
        }
        let seen = Seen::of(bumper, self.obstacle);
        let on_the_way_around = match self.edge_detected {
            1 if self.rotation.counter > ROTATIONS_BEFORE => Ruled::Told(self.forward_past_the_edge(&seen)),
            2 if self.rotation.counter > ROTATIONS => Ruled::Told(self.rotated_past_the_edge(&seen)),
            3 => Ruled::Told(self.zigzag(&seen)),
            _ => Ruled::Not,
        };
        let ruled = on_the_way_around
            .or_else(|| self.rotate(&seen))
            .or_else(|| self.meet(bumper, &seen))
            .or_else(|| self.keep_to_the_edge(bumper, &seen));
        match ruled {
            Ruled::Not => Some(Twist::Forward),
            Ruled::Told(command) => command,
        }
    }

    /// "Rotate for random amount and reset status".
    fn has_rotated_enough(&self) -> bool {
        let counter = self.rotation.counter;
        match self.text {
            ThesisText::Printed => self.random_number == Some(counter),
            // Below the limit, the number is from an earlier rotation.
            ThesisText::Mended => counter > STUCK.0 && self.random_number.is_some_and(|number| counter >= number),
        }
    }

    /// Step one of the way around the end of an edge: past it.
    fn forward_past_the_edge(&mut self, seen: &Seen) -> Option<Twist> {
        if seen.opposite_bumper {
            return self.change_sides();
        }
        if seen.any_light {
            self.reset_status();
            return None;
        }
        if seen.bumper {
            return Some(self.away());
        }
        if self.forward_counter < FORWARD {
            self.forward_counter += 1;
            return Some(Twist::Forward);
        }
        self.rotation.counter = 0;
        self.forward_counter = 0;
        self.edge_detected = 2;
        None
    }

    /// The end of step two, in which it has rotated towards the obstacle.
    fn rotated_past_the_edge(&mut self, seen: &Seen) -> Option<Twist> {
        if seen.opposite_bumper {
            return self.change_sides();
        }
        if seen.any_light || seen.bumper {
            self.reset_status();
            return None;
        }
        self.edge_detected = 3;
        self.rotation.counter = 0;
        self.forward_counter = 0;
        None
    }

    /// Step three: zig-zag towards the obstacle.
    fn zigzag(&mut self, seen: &Seen) -> Option<Twist> {
        if seen.opposite_bumper {
            return self.change_sides();
        }
        if seen.outer_or_middle_light || seen.bumper {
            self.reset_status();
            return None;
        }
        self.rotation.counter += 1;
        if !self.rotation.counter.is_multiple_of(ZIGZAG) {
            return Some(Twist::Forward);
        }
        let is_mended = self.text == ThesisText::Mended;
        Some(if is_mended && self.obstacle.is_left() { Twist::Left } else { Twist::Right })
    }

    /// "Narrow corner, go back": changes to the obstacle on the other side.
    fn change_sides(&mut self) -> Option<Twist> {
        self.obstacle = self.obstacle.switched();
        self.reset_status();
        None
    }

    /// Rotates until only the outer light sensor on the obstacle's side sees it.
    fn rotate(&mut self, seen: &Seen) -> Ruled {
        let twist = match self.rotation.position {
            Position::None => return Ruled::Not,
            Position::Right => Twist::Right,
            Position::Left => Twist::Left,
        };
        if seen.only_outer_light {
            self.reset_status();
            return Ruled::Told(Some(Twist::Forward));
        }
        self.rotation.counter += 1;
        Ruled::Told(Some(twist))
    }

    /// Reacts to the bumper.
    fn meet(&mut self, bumper: &SensorReadings, seen: &Seen) -> Ruled {
        let [_, front_left, .., front_right, _] = bumper.light_bumper;
        if bumper.bump_left && bumper.bump_right {
            if self.obstacle.is_none() {
                // Without a light on either side the print ends the program.
                self.obstacle = if front_left && !front_right { Position::Left } else { Position::Right };
            }
            self.rotation.set_position(self.obstacle.switched());
            return Ruled::Told(None);
        }
        if self.obstacle.is_none() && (bumper.bump_left || bumper.bump_right) {
            self.obstacle = if bumper.bump_right { Position::Right } else { Position::Left };
            self.rotation.set_position(self.obstacle.switched());
            return Ruled::Told(None);
        }
        if seen.bumper { Ruled::Told(Some(self.away())) } else { Ruled::Not }
    }

    /// Reacts to lights that went off.
    fn keep_to_the_edge(&mut self, bumper: &SensorReadings, seen: &Seen) -> Ruled {
        if self.obstacle.is_none() {
            return Ruled::Not;
        }
        if !seen.any_light {
            self.rotation.set_position(self.obstacle);
            self.edge_detected = 1;
            return Ruled::Told(None);
        }
        let [left, front_left, .., front_right, right] = bumper.light_bumper;
        let (outer, front) = if self.obstacle.is_left() { (left, front_left) } else { (right, front_right) };
        if outer {
            return Ruled::Not;
        }
        self.rotation.set_position(if front { self.obstacle.switched() } else { self.obstacle });
        Ruled::Told(None)
    }

    /// A rotation away from the obstacle.
    fn away(&self) -> Twist {
        if self.obstacle.is_left() { Twist::Right } else { Twist::Left }
    }
}

/// The sensors on the obstacle's side; all false without an obstacle.
#[expect(clippy::struct_excessive_bools)]
struct Seen {
    /// The bumper on that side.
    bumper: bool,
    /// The bumper on the other side.
    opposite_bumper: bool,
    /// `any_left_lights_pressed`, `any_right_lights_pressed`.
    any_light: bool,
    /// `only_left_light_pressed`, `only_right_light_pressed`.
    only_outer_light: bool,
    /// The outer or the middle one, which is all that step three asks.
    outer_or_middle_light: bool,
}

impl Seen {
    fn of(bumper: &SensorReadings, obstacle: Position) -> Self {
        let [left, front_left, middle_left, middle_right, front_right, right] = bumper.light_bumper;
        let (is_known, is_left) = (!obstacle.is_none(), obstacle.is_left());
        let [outer, front, middle] =
            if is_left { [left, front_left, middle_left] } else { [right, front_right, middle_right] };
        let (pressed, opposite) =
            if is_left { (bumper.bump_left, bumper.bump_right) } else { (bumper.bump_right, bumper.bump_left) };
        Self {
            bumper: is_known && pressed,
            opposite_bumper: is_known && opposite,
            any_light: is_known && (outer || front || middle),
            only_outer_light: is_known && outer && !front && !middle,
            outer_or_middle_light: is_known && (outer || middle),
        }
    }
}
