//! All values that a robot reports, typed.

use super::{
    bits::{BumpsAndDrops, Buttons, ChargingSources, LightBumper, Overcurrents, Stasis},
    packet::{Packet, PacketId, PacketSet},
};
use core::fmt;

/// Infrared characters that are received; 0 for none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct InfraredSeen {
    /// By the receiver on top that looks all around (packet 17).
    pub omni: u8,
    /// By the front receiver on the left (packet 52).
    pub left: u8,
    /// By the front receiver on the right (packet 53).
    pub right: u8,
}

/// State of the charger (packet 21).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ChargingState {
    /// Not charging.
    #[default]
    None,
    /// Reconditioning a battery that was run down.
    Reconditioning,
    /// Charging fully.
    Full,
    /// Keeping a full battery full.
    Trickle,
    /// Waiting.
    Waiting,
    /// Charging fault.
    Fault,
    /// An unknown state. The specification's table allows 6 without describing it.
    Other(u8),
}

impl ChargingState {
    /// From its byte.
    pub const fn from_byte(byte: u8) -> Self {
        match byte {
            0 => Self::None,
            1 => Self::Reconditioning,
            2 => Self::Full,
            3 => Self::Trickle,
            4 => Self::Waiting,
            5 => Self::Fault,
            other => Self::Other(other),
        }
    }

    /// Its byte.
    pub const fn byte(self) -> u8 {
        match self {
            Self::None => 0,
            Self::Reconditioning => 1,
            Self::Full => 2,
            Self::Trickle => 3,
            Self::Waiting => 4,
            Self::Fault => 5,
            Self::Other(byte) => byte,
        }
    }

    /// Whether current flows into the battery.
    pub const fn is_charging(self) -> bool {
        matches!(self, Self::Reconditioning | Self::Full | Self::Trickle)
    }
}

/// In words.
impl fmt::Display for ChargingState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "not charging",
            Self::Reconditioning => "reconditioning",
            Self::Full => "full charging",
            Self::Trickle => "trickle charging",
            Self::Waiting => "waiting",
            Self::Fault => "charging fault",
            Self::Other(byte) => return write!(f, "{byte}"),
        })
    }
}

/// The latest value of every packet. The unused ones, 16, 32 and 33, are always 0.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Readings {
    /// Bumper and wheel drops (7).
    pub bumps: BumpsAndDrops,
    /// Something is near on the right (8).
    pub wall: bool,
    /// No floor: left, front left, front right, right (9 to 12).
    pub cliff: [bool; 4],
    /// The beam of a virtual wall is seen (13).
    pub virtual_wall: bool,
    /// Motors that draw too much current (14).
    pub overcurrents: Overcurrents,
    /// Dirt that is being picked up, 0 to 255 (15).
    pub dirt: u8,
    /// Infrared characters; 0 for none (17, 52, 53).
    pub infrared: InfraredSeen,
    /// Buttons that are held down (18).
    pub buttons: Buttons,
    /// Distance since it was last read, mm (19).
    pub distance_mm: i16,
    /// Turn since it was last read, degrees, counter-clockwise positive (20).
    pub angle_deg: i16,
    /// State of the charger (21).
    pub charging: ChargingState,
    /// Voltage of the battery, mV (22).
    pub voltage_mv: u16,
    /// Current into the battery, mA (23).
    pub current_ma: i16,
    /// Temperature of the battery, degrees Celsius (24).
    pub temperature_c: i8,
    /// Charge of the battery, mAh (25). Negative values, of a flat battery, are as on the line: see
    /// [`Self::charge_left_mah`].
    pub charge_mah: u16,
    /// Capacity of the battery, mAh (26).
    pub capacity_mah: u16,
    /// Strength of the wall signal, 0 to 1023 (27).
    pub wall_signal: u16,
    /// Light from the floor, 0 to 4095: left, front left, front right, right (28 to 31).
    pub cliff_signal: [u16; 4],
    /// Chargers that are connected (34).
    pub chargers: ChargingSources,
    /// Mode as reported (35): see [`Mode::from_report`](super::Mode::from_report).
    pub mode: u8,
    /// Song that was chosen last (36).
    pub song_number: u8,
    /// Whether it plays (37).
    pub song_playing: bool,
    /// Packets in the stream (38).
    pub stream_packets: u8,
    /// Velocity of the latest Drive, mm/s (39).
    pub requested_velocity: i16,
    /// Its radius, mm (40).
    pub requested_radius: i16,
    /// Right wheel speed of the latest Drive Direct, mm/s (41).
    pub requested_right: i16,
    /// Its left wheel speed, mm/s (42).
    pub requested_left: i16,
    /// Left wheel encoder, counts modulo 65536 (43).
    pub left_counts: u16,
    /// Right wheel encoder, counts modulo 65536 (44).
    pub right_counts: u16,
    /// Light bumper (45).
    pub light_bumper: LightBumper,
    /// Strengths of its signals from left to right, 0 to 4095 (46 to 51).
    pub light_signal: [u16; 6],
    /// Current of the left wheel's motor, mA (54).
    pub left_motor_ma: i16,
    /// Current of the right wheel's motor, mA (55).
    pub right_motor_ma: i16,
    /// Current of the main brush's motor, mA (56).
    pub main_brush_ma: i16,
    /// Current of the side brush's motor, mA (57).
    pub side_brush_ma: i16,
    /// The castor's wheel (58).
    pub stasis: Stasis,
}

impl Readings {
    /// The bits of one packet as they go on the line; one byte's stand in the low half.
    pub fn raw(&self, packet: Packet) -> u16 {
        match packet {
            Packet::BumpsAndDrops => self.bumps.byte().into(),
            Packet::Wall => self.wall.into(),
            Packet::CliffLeft => self.cliff[0].into(),
            Packet::CliffFrontLeft => self.cliff[1].into(),
            Packet::CliffFrontRight => self.cliff[2].into(),
            Packet::CliffRight => self.cliff[3].into(),
            Packet::VirtualWall => self.virtual_wall.into(),
            Packet::Overcurrents => self.overcurrents.byte().into(),
            Packet::DirtDetect => self.dirt.into(),
            Packet::Unused1 | Packet::Unused2 | Packet::Unused3 => 0,
            Packet::InfraredOmni => self.infrared.omni.into(),
            Packet::Buttons => self.buttons.byte().into(),
            Packet::Distance => self.distance_mm.cast_unsigned(),
            Packet::Angle => self.angle_deg.cast_unsigned(),
            Packet::ChargingState => self.charging.byte().into(),
            Packet::Voltage => self.voltage_mv,
            Packet::Current => self.current_ma.cast_unsigned(),
            Packet::Temperature => self.temperature_c.cast_unsigned().into(),
            Packet::BatteryCharge => self.charge_mah,
            Packet::BatteryCapacity => self.capacity_mah,
            Packet::WallSignal => self.wall_signal,
            Packet::CliffLeftSignal => self.cliff_signal[0],
            Packet::CliffFrontLeftSignal => self.cliff_signal[1],
            Packet::CliffFrontRightSignal => self.cliff_signal[2],
            Packet::CliffRightSignal => self.cliff_signal[3],
            Packet::ChargingSources => self.chargers.byte().into(),
            Packet::OiMode => self.mode.into(),
            Packet::SongNumber => self.song_number.into(),
            Packet::SongPlaying => self.song_playing.into(),
            Packet::StreamPackets => self.stream_packets.into(),
            Packet::RequestedVelocity => self.requested_velocity.cast_unsigned(),
            Packet::RequestedRadius => self.requested_radius.cast_unsigned(),
            Packet::RequestedRightVelocity => self.requested_right.cast_unsigned(),
            Packet::RequestedLeftVelocity => self.requested_left.cast_unsigned(),
            Packet::LeftEncoder => self.left_counts,
            Packet::RightEncoder => self.right_counts,
            Packet::LightBumper => self.light_bumper.byte().into(),
            Packet::LightLeft => self.light_signal[0],
            Packet::LightFrontLeft => self.light_signal[1],
            Packet::LightCentreLeft => self.light_signal[2],
            Packet::LightCentreRight => self.light_signal[3],
            Packet::LightFrontRight => self.light_signal[4],
            Packet::LightRight => self.light_signal[5],
            Packet::InfraredLeft => self.infrared.left.into(),
            Packet::InfraredRight => self.infrared.right.into(),
            Packet::LeftMotorCurrent => self.left_motor_ma.cast_unsigned(),
            Packet::RightMotorCurrent => self.right_motor_ma.cast_unsigned(),
            Packet::MainBrushCurrent => self.main_brush_ma.cast_unsigned(),
            Packet::SideBrushCurrent => self.side_brush_ma.cast_unsigned(),
            Packet::Stasis => self.stasis.byte().into(),
        }
    }

    /// Takes the bits of one packet. Flags are true for anything but 0; bits beyond the type are dropped, everything
    /// else is kept, even implausible values: see [`Packet::is_plausible`].
    pub fn set_raw(&mut self, packet: Packet, raw: u16) {
        let (byte, flag, word) = (raw as u8, raw != 0, raw.cast_signed());
        match packet {
            Packet::BumpsAndDrops => self.bumps = BumpsAndDrops::from_byte(byte),
            Packet::Wall => self.wall = flag,
            Packet::CliffLeft => self.cliff[0] = flag,
            Packet::CliffFrontLeft => self.cliff[1] = flag,
            Packet::CliffFrontRight => self.cliff[2] = flag,
            Packet::CliffRight => self.cliff[3] = flag,
            Packet::VirtualWall => self.virtual_wall = flag,
            Packet::Overcurrents => self.overcurrents = Overcurrents::from_byte(byte),
            Packet::DirtDetect => self.dirt = byte,
            Packet::Unused1 | Packet::Unused2 | Packet::Unused3 => {}
            Packet::InfraredOmni => self.infrared.omni = byte,
            Packet::Buttons => self.buttons = Buttons::from_byte(byte),
            Packet::Distance => self.distance_mm = word,
            Packet::Angle => self.angle_deg = word,
            Packet::ChargingState => self.charging = ChargingState::from_byte(byte),
            Packet::Voltage => self.voltage_mv = raw,
            Packet::Current => self.current_ma = word,
            Packet::Temperature => self.temperature_c = byte.cast_signed(),
            Packet::BatteryCharge => self.charge_mah = raw,
            Packet::BatteryCapacity => self.capacity_mah = raw,
            Packet::WallSignal => self.wall_signal = raw,
            Packet::CliffLeftSignal => self.cliff_signal[0] = raw,
            Packet::CliffFrontLeftSignal => self.cliff_signal[1] = raw,
            Packet::CliffFrontRightSignal => self.cliff_signal[2] = raw,
            Packet::CliffRightSignal => self.cliff_signal[3] = raw,
            Packet::ChargingSources => self.chargers = ChargingSources::from_byte(byte),
            Packet::OiMode => self.mode = byte,
            Packet::SongNumber => self.song_number = byte,
            Packet::SongPlaying => self.song_playing = flag,
            Packet::StreamPackets => self.stream_packets = byte,
            Packet::RequestedVelocity => self.requested_velocity = word,
            Packet::RequestedRadius => self.requested_radius = word,
            Packet::RequestedRightVelocity => self.requested_right = word,
            Packet::RequestedLeftVelocity => self.requested_left = word,
            Packet::LeftEncoder => self.left_counts = raw,
            Packet::RightEncoder => self.right_counts = raw,
            Packet::LightBumper => self.light_bumper = LightBumper::from_byte(byte),
            Packet::LightLeft => self.light_signal[0] = raw,
            Packet::LightFrontLeft => self.light_signal[1] = raw,
            Packet::LightCentreLeft => self.light_signal[2] = raw,
            Packet::LightCentreRight => self.light_signal[3] = raw,
            Packet::LightFrontRight => self.light_signal[4] = raw,
            Packet::LightRight => self.light_signal[5] = raw,
            Packet::InfraredLeft => self.infrared.left = byte,
            Packet::InfraredRight => self.infrared.right = byte,
            Packet::LeftMotorCurrent => self.left_motor_ma = word,
            Packet::RightMotorCurrent => self.right_motor_ma = word,
            Packet::MainBrushCurrent => self.main_brush_ma = word,
            Packet::SideBrushCurrent => self.side_brush_ma = word,
            Packet::Stasis => self.stasis = Stasis::from_byte(byte),
        }
    }

    /// Writes a packet or group at the start of `out`, as the answer to Sensors (142); how many bytes, or `None` if `out` is
    /// too short.
    pub fn write(&self, id: PacketId, out: &mut [u8]) -> Option<usize> {
        let out = out.get_mut(..id.size())?;
        let mut at = 0;
        for packet in id.packets() {
            at += packet.write(self.raw(packet), out.get_mut(at..)?)?;
        }
        Some(at)
    }

    /// Takes a packet or group from the start of `bytes`; those that were in it, or `None` if there are too few bytes: then
    /// nothing is taken.
    pub fn read(&mut self, id: PacketId, bytes: &[u8]) -> Option<PacketSet> {
        let mut rest = bytes.get(..id.size())?;
        let mut read = PacketSet::default();
        for packet in id.packets() {
            self.set_raw(packet, packet.read(rest)?);
            rest = rest.get(packet.format().size()..)?;
            read.insert(packet);
        }
        Some(read)
    }

    /// Charge of the battery, mAh. Flat batteries have been seen to report 65521 and 65529, which are -15 and -7 in two's
    /// complement; no Roomba holds half as much as that, so the upper half counts as empty.
    pub fn charge_left_mah(&self) -> u16 {
        if self.charge_mah.cast_signed() < 0 { 0 } else { self.charge_mah }
    }
}
