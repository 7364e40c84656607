//! Distance and angle (packets 19 and 20), for odometry that uses them.
//!
//! A robot reports them in whole millimetres and degrees, truncated towards 0, and restarts at 0: the remainder is
//! lost. In every frame, 15 ms apart, no turn below 67 degrees a second would ever be seen. So the usual stream doesn't
//! contain them. Every 0.24 s (as in the simulator) the driver requests another subscription with them, and one frame
//! later the usual one again. Answers to queries would have no checksum.
//!
//! - If that request is lost, or the next one overtakes it before the robot sends a frame, the robot goes on summing up: nothing is
//!   lost. If the switch back is lost, every frame reports and truncates, until it is requested again.
//! - A lost or garbled frame loses its values, as the robot has restarted at 0. Encoder counts aren't lost.
//! - A held-back frame is added to the next one if that confirms it or if only a signal jumped; otherwise it is lost.
//! - The first one covers time before the request: it is ignored.
//! - A robot with the packets of a Create 1 has no counts: it always reports them, and its counts are
//!   [reckoned](super::reckoned_counts).
//! - Firmware up to 3.4.0 shows a third of every angle. A robot that turns three times as far by its counts (43, 44)
//!   has it: the missing part is reported at once, and whole angles from then on.

use super::{ConnectionPhase, Driver, FRAME_S};
use robovac_core::robot::{DistanceAngle, READINGS_PER_DISTANCE_ANGLE};
use roomba_oi::{
    Command, FRAMING, Packet, PacketId, Readings, StreamFrame,
    motion::{MM_PER_COUNT, WHEEL_BASE_MM, encoder_delta, true_angle},
    slot_bytes,
};

/// Least time between the two requests, s, for at least one frame in between.
const LEAST_S: f64 = 0.01;
/// Time after which a request without effect is repeated, s.
const ECHO_S: f64 = 0.06;
/// A failure of the stream longer than this after a request has another cause, s.
const BLAME_S: f64 = 0.5;
/// Turn by counts after which the angles are compared, and the least one considered, degrees; and the longest time, s,
/// beyond which something was lost.
const JUDGED_DEG: f64 = 45.0;
const SEEN_DEG: f64 = 6.0;
const WHOLE_S: f64 = 0.28;
/// Share of the angle shown by old firmware: 0.32, and less by truncation.
const OLD_SHARE: std::ops::Range<f64> = 0.15..0.5;

/// Subscriptions of the stream at a baud rate. No list contains a 7, neither as its length nor as a packet: a robot
/// that missed the opcode would take it as Reset.
pub(super) struct Subscriptions {
    /// Without odometry by distance and angle.
    pub usual: &'static [u8],
    /// With it, between and during the reports.
    pub without: &'static [u8],
    pub with: &'static [u8],
    /// Whether they contain the requested wheel speeds.
    pub tells_speeds: bool,
}

/// The packets of a Create 1: the last that drivers of it request are 26 and 35. Group 1 has those up to 16, group 3 those
/// from 21 on. A Roomba 980 sent these over its own USB port (`create_robot`, issue 106). Buttons can wait for the next frame.
pub(super) const CREATE_1: Subscriptions = {
    const OWN: &[u8] = &[1, 17, 18, 3, 35];
    Subscriptions { usual: OWN, without: OWN, with: &[1, 17, 3, 35, 19, 20], tells_speeds: false }
};

impl Subscriptions {
    /// Whether even the longest list fits into the slot.
    pub fn fits(&self, baud: u32) -> bool {
        frame_bytes(self.with) <= slot_bytes(baud)
    }
}

/// Bytes of a frame with these packets.
pub(super) fn frame_bytes(packets: &[u8]) -> usize {
    packets.iter().filter_map(|&id| PacketId::size_of(id)).map(|size| size + 1).sum::<usize>() + FRAMING
}

/// All packets, or those that fit into the slot.
fn subscriptions(baud: u32) -> Subscriptions {
    const ALL: &[u8] = &[100];
    // Group 1 holds bumps, wheel drops and cliffs.
    const FEW: &[u8] = &[1, 21, 34, 35, 43, 44];
    if slot_bytes(baud) >= FRAMING + 81 {
        Subscriptions { usual: ALL, without: &[1, 17, 18, 3, 4, 35, 41, 42, 101], with: ALL, tells_speeds: true }
    } else {
        // The charger can wait.
        Subscriptions { usual: FEW, without: FEW, with: &[1, 35, 43, 44, 19, 20], tells_speeds: false }
    }
}

/// State of the poll.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Default)]
pub(super) struct DistanceAnglePoll {
    /// Wanted by the user, and wanted at all: by the user, or because nothing else tells the way.
    is_chosen: bool,
    pub is_wanted: bool,
    /// It was in use on this line, so frames of either subscription can arrive.
    was_wanted: bool,
    has_begun: bool,
    /// Times of the last report, of the next request, of a request not yet reverted, and of the last reversion, s.
    told_at: Option<f64>,
    due_at: f64,
    asked_at: Option<f64>,
    back_at: Option<f64>,
    /// Values of a frame that waits for the next, and whether they count regardless of it.
    held: Option<(DistanceAngle, bool)>,
    /// Whether it has just arrived.
    is_news: bool,
    /// Counts at the last report; degrees by counts and by packet 20, in either direction.
    counts: Option<[u16; 2]>,
    turned: [f64; 2],
    /// The angle so far as shown by packet 20, degrees.
    shown: f64,
    is_old: bool,
}

impl DistanceAnglePoll {
    /// The initial state on a reopened line.
    pub fn anew(&self) -> Self {
        Self { is_chosen: self.is_chosen, is_wanted: self.is_chosen, ..Self::default() }
    }

    /// A frame waits for confirmation.
    pub fn hold(&mut self, frame: StreamFrame<'_>, is_sure: bool) {
        self.held = told(frame).filter(|_| self.is_wanted).map(|moved| (moved, is_sure));
        self.is_news = self.held.is_some();
    }

    /// Whether a frame has just reported values and waits.
    pub fn take_news(&mut self) -> bool {
        std::mem::take(&mut self.is_news)
    }

    /// Takes an accepted frame, and the waiting one if it is `late`; returns the sum of both reports.
    pub fn take(
        &mut self,
        frame: StreamFrame<'_>,
        readings: &Readings,
        now: f64,
        is_late: bool,
    ) -> Option<DistanceAngle> {
        let held = self.held.take().filter(|&(_, is_sure)| is_late || is_sure).map(|(moved, _)| moved);
        if !self.is_wanted {
            return None;
        }
        let here = told(frame);
        let is_whole = self.told_at.is_some_and(|at| now - at <= WHOLE_S);
        if here.is_some() || held.is_some() {
            self.told_at = Some(now);
            self.due_at = now + (f64::from(READINGS_PER_DISTANCE_ANGLE) - 1.5) * FRAME_S;
        }
        let moved = match (held, here) {
            (Some(held), Some(here)) => held.and(here),
            (held, here) => held.or(here)?,
        };
        let was_old = self.is_old;
        self.judge(moved, readings, is_whole);
        if !std::mem::replace(&mut self.has_begun, true) {
            return None;
        }
        let (shown, so_far) = (f64::from(moved.angle_deg), self.shown);
        self.shown += shown;
        let angle = match (was_old, self.is_old) {
            (_, false) => shown,
            (false, true) => true_angle(self.shown) - so_far,
            (true, true) => true_angle(shown),
        };
        Some(DistanceAngle { angle_deg: angle.round() as i16, ..moved })
    }

    /// Compares the reported angles with the counts of the wheels.
    fn judge(&mut self, moved: DistanceAngle, readings: &Readings, is_whole: bool) {
        let counts = [readings.left_counts, readings.right_counts];
        let Some(last) = self.counts.replace(counts) else { return };
        let [left, right] = [0, 1].map(|wheel| f64::from(encoder_delta(last[wheel], counts[wheel])));
        let by_counts = ((right - left) * MM_PER_COUNT / WHEEL_BASE_MM).to_degrees().abs();
        if by_counts < SEEN_DEG || !is_whole {
            return;
        }
        let [whole, shown] = &mut self.turned;
        (*whole, *shown) = (*whole + by_counts, *shown + f64::from(moved.angle_deg).abs());
        if *whole >= JUDGED_DEG {
            self.is_old |= OLD_SHARE.contains(&(*shown / *whole));
            self.turned = [0.0; 2];
        }
    }
}

/// Distance and angle of a frame.
fn told(frame: StreamFrame<'_>) -> Option<DistanceAngle> {
    let value = |wanted| frame.values().find(|&(packet, _)| packet == wanted).map(|(_, raw)| raw.cast_signed());
    Some(DistanceAngle { distance_mm: value(Packet::Distance)?, angle_deg: value(Packet::Angle)? })
}

impl Driver {
    /// Enables or disables reports of distance and angle, which some
    /// [readings](robovac_core::robot::SensorReadings::moved) then contain.
    pub fn tell_moved(&mut self, now: f64, is_chosen: bool) {
        self.poll.is_chosen = is_chosen;
        let is_wanted = is_chosen || self.is_older;
        if is_wanted == self.poll.is_wanted {
            return;
        }
        let was_wanted = self.poll.was_wanted || is_wanted;
        self.poll = DistanceAnglePoll { is_chosen, is_wanted, was_wanted, ..DistanceAnglePoll::default() };
        self.sensors.moved = None;
        if matches!(self.phase, ConnectionPhase::Connected | ConnectionPhase::Lost) {
            self.subscribe(now);
        }
    }

    /// Whether its packet 20 shows a third of every angle and is corrected.
    pub fn has_old_angle(&self) -> bool {
        self.poll.is_old
    }

    /// Sets whether the robot has the packets of a Create 1 only.
    pub(super) fn has_packets_of_create_1(&mut self, is_older: bool) {
        self.is_older = is_older;
        self.poll.is_wanted = is_older || self.poll.is_chosen;
    }

    /// Whether the robot reports neither encoder counts nor a light bumper: it has the packets of a Create 1 only.
    pub fn is_older(&self) -> bool {
        self.is_older
    }

    /// The subscriptions for this robot.
    pub(super) fn subscriptions(&self) -> Subscriptions {
        if self.is_older { CREATE_1 } else { subscriptions(self.baud) }
    }

    /// The subscription between reports.
    pub(super) fn subscription(&self) -> &'static [u8] {
        let Subscriptions { usual, without, .. } = self.subscriptions();
        if self.poll.is_wanted { without } else { usual }
    }

    pub(super) fn subscribe(&mut self, now: f64) {
        let Subscriptions { usual, without, with, .. } = self.subscriptions();
        self.poll.was_wanted |= self.poll.is_wanted;
        // All of them exist.
        let _ =
            if self.poll.was_wanted { self.parser.expect_either([without, with]) } else { self.parser.expect(usual) };
        (self.poll.asked_at, self.poll.back_at) = (None, Some(now));
        self.poll.due_at = self.poll.due_at.max(now + ECHO_S);
        let _ = self.send(now, Command::Stream { packets: self.subscription() });
    }

    /// Requests distance and angle when they are due, and reverts to the usual subscription; called after a frame and
    /// regularly.
    pub(super) fn mind_telling(&mut self, now: f64, has_frame: bool) {
        let DistanceAnglePoll { is_wanted, told_at, asked_at, back_at, due_at, .. } = self.poll;
        if !is_wanted || self.phase != ConnectionPhase::Connected || self.question.is_some() {
            return;
        }
        let since_back = back_at.map_or(f64::INFINITY, |at| now - at);
        if let Some(at) = asked_at {
            if now - at >= if has_frame { LEAST_S } else { FRAME_S } {
                self.subscribe(now);
            }
        } else if !has_frame {
            // A list that lost a byte yields unexpected frames.
            let is_silent = self.link_stats.last().is_some_and(|last| now - last > ECHO_S);
            if is_silent && (ECHO_S..BLAME_S).contains(&since_back) {
                self.subscribe(now);
            }
        } else if since_back > ECHO_S {
            if told_at == Some(now) {
                self.subscribe(now);
            } else if now >= due_at {
                self.poll.asked_at = Some(now);
                let packets = self.subscriptions().with;
                let _ = self.send(now, Command::Stream { packets });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_list_resets_a_robot_that_missed_its_beginning() {
        for known in [subscriptions(19_200), subscriptions(115_200), CREATE_1] {
            let Subscriptions { usual, without, with, .. } = known;
            for list in [usual, without, with] {
                assert!(list.len() != 7 && !list.contains(&7), "{list:?}");
            }
        }
    }
}
