//! Plausibility filter for frames.
//!
//! An 8-bit sum lets one garbled frame in 256 through; flipped bits at the same place of two bytes cancel each other
//! even more often. So the values of a frame must also be consistent with the last one. A frame that isn't is kept: if
//! the next one is consistent with it, it was right and is accepted late.

use robovac_core::math::PI;
use roomba_oi::{
    Packet, StreamFrame,
    motion::{MAX_SPEED_MM_S, MM_PER_COUNT, WHEEL_BASE_MM},
};

/// Index of the distance in [`Packet::ALL`]; the angle is always reported with it.
const DISTANCE: usize = Packet::Distance as usize - Packet::ALL[0] as usize;

/// Pairs of requested wheel speeds that are remembered: all that can be in transit, as the robot reports a command two
/// or three frames later.
const REMEMBERED: usize = 16;

/// Uncertainty of a reading's time, s: browsers deliver bytes in batches.
const LUMP_S: f64 = 0.1;

/// Allowed change of a value from frame to frame.
#[derive(Debug, Clone, Copy)]
enum ChangeRule {
    /// Any change: flags.
    Free,
    /// By this amount and a share of the value (one in the second number; none for 0). A jump is accepted with the next
    /// frame.
    Signal(i32, i32),
    /// Changes so rarely that a change waits for the next frame.
    Rare,
    /// By at most this amount.
    Within(i32),
    /// Motion since the last report: within 1 of the last frame's, or as much as the wheels can roll in the time,
    /// scaled per mm.
    Way(f64),
    /// As many counts as a wheel can make in the time, modulo 65536.
    Counts,
    /// The value of a recent Drive Direct.
    RightSpeed,
    /// See [`ChangeRule::RightSpeed`].
    LeftSpeed,
}

const fn rule(packet: Packet) -> ChangeRule {
    match packet {
        Packet::Unused1
        | Packet::Unused2
        | Packet::Unused3
        | Packet::BatteryCapacity
        | Packet::StreamPackets
        | Packet::SongNumber
        | Packet::RequestedVelocity
        | Packet::RequestedRadius
        | Packet::OiMode
        | Packet::Temperature
        | Packet::ChargingState
        | Packet::ChargingSources => ChangeRule::Rare,
        Packet::InfraredOmni
        | Packet::InfraredLeft
        | Packet::InfraredRight
        | Packet::Overcurrents
        | Packet::SongPlaying
        | Packet::Wall
        | Packet::VirtualWall
        | Packet::Buttons => ChangeRule::Signal(0, 0),
        Packet::Distance => ChangeRule::Way(1.0),
        Packet::Angle => ChangeRule::Way(2.0 / WHEEL_BASE_MM * 180.0 / PI),
        Packet::DirtDetect
        | Packet::WallSignal
        | Packet::LightLeft
        | Packet::LightFrontLeft
        | Packet::LightCentreLeft
        | Packet::LightCentreRight
        | Packet::LightFrontRight
        | Packet::LightRight => ChangeRule::Signal(24, 2),
        Packet::CliffLeftSignal
        | Packet::CliffFrontLeftSignal
        | Packet::CliffFrontRightSignal
        | Packet::CliffRightSignal => ChangeRule::Signal(24, 4),
        Packet::LeftMotorCurrent | Packet::RightMotorCurrent | Packet::MainBrushCurrent | Packet::SideBrushCurrent => {
            ChangeRule::Signal(60, 2)
        }
        Packet::Voltage => ChangeRule::Signal(400, 0),
        Packet::Current => ChangeRule::Signal(400, 2),
        Packet::BatteryCharge => ChangeRule::Within(4),
        Packet::LeftEncoder | Packet::RightEncoder => ChangeRule::Counts,
        Packet::RequestedRightVelocity => ChangeRule::RightSpeed,
        Packet::RequestedLeftVelocity => ChangeRule::LeftSpeed,
        _ => ChangeRule::Free,
    }
}

/// Values of every packet, by its index in [`Packet::ALL`]; `None` for those not in the frame.
type FlagBits = [Option<u16>; Packet::ALL.len()];

/// A frame, with the values of other packets from earlier ones.
#[derive(Debug, Clone, Copy)]
struct HeardFrame {
    /// Times of its arrival and of the last frame with distance and angle, s.
    at: f64,
    told_at: Option<f64>,
    bits: FlagBits,
}

/// Verdict on a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameVerdict {
    /// Consistent with the one before.
    Believed,
    /// Consistent with the waiting one, which was right then.
    Late,
    /// Can be right, if the next one is consistent with it.
    Waits,
    /// The same, but only signals jumped, which can happen.
    Jumps,
    /// Contains values that no robot can report.
    Impossible,
}

/// Distinguishes plausible frames from others.
#[derive(Debug, Clone)]
pub struct Filter {
    /// The last accepted or waiting frame.
    believed: Option<HeardFrame>,
    waiting: Option<HeardFrame>,
    /// Recently commanded wheel speeds: right, left.
    asked: [(i16, i16); REMEMBERED],
    next: usize,
    refused: u64,
    late: u64,
}

impl Default for Filter {
    fn default() -> Self {
        Self { believed: None, waiting: None, asked: [(0, 0); REMEMBERED], next: 0, refused: 0, late: 0 }
    }
}

impl Filter {
    /// Records a Drive Direct with these speeds, mm/s.
    pub fn asked(&mut self, right: i16, left: i16) {
        if let Some(slot) = self.asked.get_mut(self.next) {
            *slot = (right, left);
        }
        self.next = (self.next + 1) % REMEMBERED;
    }

    /// Number of refused frames with a right checksum.
    pub fn refused(&self) -> u64 {
        self.refused
    }

    /// Number of frames accepted late.
    pub fn late(&self) -> u64 {
        self.late
    }

    /// Forgets the frames, as after a break: the second next one is accepted.
    pub fn forget(&mut self) {
        (self.believed, self.waiting) = (None, None);
    }

    /// The verdict on `frame`, which arrived at `now`.
    pub fn judge(&mut self, now: f64, frame: StreamFrame<'_>) -> FrameVerdict {
        let mut bits: FlagBits = [None; Packet::ALL.len()];
        let mut is_possible = true;
        for (packet, raw) in frame.values() {
            is_possible &= packet.is_plausible(raw);
            if let Some(slot) = bits.get_mut(usize::from(packet as u8 - Packet::ALL[0] as u8)) {
                *slot = Some(raw);
            }
        }
        let follows = |from: &Option<HeardFrame>, is_strict: bool| {
            from.as_ref().is_some_and(|before| self.follows(before, &bits, now, is_strict))
        };
        // Signals can keep jumping; then at least every other frame is accepted.
        let is_next = is_possible && follows(&self.believed, true);
        let is_late = !is_next && is_possible && follows(&self.waiting, false);
        let is_told = bits.get(DISTANCE).is_some_and(Option::is_some);
        // Other frames of the subscription can have other packets.
        let heard = |before: Option<HeardFrame>| HeardFrame {
            at: now,
            told_at: if is_told { Some(now) } else { before.and_then(|before| before.told_at) },
            bits: before.map_or(bits, |before| {
                std::array::from_fn(|i| bits.get(i).copied().flatten().or(before.bits.get(i).copied().flatten()))
            }),
        };
        if is_next || is_late {
            let before = if is_next { self.believed } else { self.waiting };
            self.refused -= u64::from(is_late);
            self.late += u64::from(is_late);
            (self.believed, self.waiting) = (Some(heard(before)), None);
            return if is_late { FrameVerdict::Late } else { FrameVerdict::Believed };
        }
        let is_near = is_possible && follows(&self.believed, false);
        self.refused += 1;
        if !is_possible {
            return FrameVerdict::Impossible;
        }
        self.waiting = Some(heard(self.believed));
        if is_near { FrameVerdict::Jumps } else { FrameVerdict::Waits }
    }

    fn follows(&self, from: &HeardFrame, bits: &FlagBits, now_s: f64, is_strict: bool) -> bool {
        let most_since = |then: f64| ((now_s - then).max(0.0) + LUMP_S) * f64::from(MAX_SPEED_MM_S);
        let most_mm = most_since(from.at);
        let asked =
            |pick: fn(&(i16, i16)) -> i16, value: i32| self.asked.iter().any(|pair| i32::from(pick(pair)) == value);
        Packet::ALL.into_iter().zip(from.bits.iter().zip(bits)).all(|(packet, pair)| {
            let (&Some(before), &Some(now)) = pair else { return true };
            let (old, new) = (packet.value(before), packet.value(now));
            match rule(packet) {
                ChangeRule::Free => true,
                ChangeRule::Signal(..) if !is_strict => true,
                ChangeRule::Signal(most, part) => {
                    (new - old).abs() <= most + old.abs().max(new.abs()).checked_div(part).unwrap_or(0)
                }
                ChangeRule::Way(_) if from.told_at == Some(from.at) => !is_strict || (new - old).abs() <= 1,
                ChangeRule::Way(per_mm) => {
                    from.told_at.is_none_or(|then| f64::from(new).abs() <= per_mm * most_since(then) + 1.0)
                }
                ChangeRule::Rare => old == new,
                ChangeRule::Within(most) => (new - old).abs() <= most,
                ChangeRule::Counts => f64::from(now.wrapping_sub(before).cast_signed()).abs() <= most_mm / MM_PER_COUNT,
                ChangeRule::RightSpeed => old == new || asked(|pair| pair.0, new),
                ChangeRule::LeftSpeed => old == new || asked(|pair| pair.1, new),
            }
        })
    }
}
