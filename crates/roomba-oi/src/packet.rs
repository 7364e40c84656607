//! Sensor packets: number, name, size, unit and range of each, and packet groups.

use core::{fmt, ops::RangeInclusive};

/// How a value stands on the line; high byte first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueFormat {
    /// One byte, unsigned.
    U8,
    /// One byte, signed.
    I8,
    /// Two bytes, unsigned.
    U16,
    /// Two bytes, signed.
    I16,
}

impl ValueFormat {
    /// Bytes on the line.
    pub const fn size(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
        }
    }

    /// Whether it can be negative.
    pub const fn is_signed(self) -> bool {
        matches!(self, Self::I8 | Self::I16)
    }

    const fn full_range(self) -> (i32, i32) {
        match self {
            Self::U8 => (0, 255),
            Self::I8 => (-128, 127),
            Self::U16 => (0, 65_535),
            Self::I16 => (-32_768, 32_767),
        }
    }
}

/// Writes the enum and its table from one list, so that they can't disagree. A range is given only where robots don't use
/// all of what the format can hold.
macro_rules! packets {
    ($($(#[$doc:meta])+ $variant:ident = $id:literal, $name:literal, $format:ident $([$least:literal, $most:literal])?, $unit:literal;)+) => {
        /// A single sensor packet, 7 to 58 (Create 2 specification of 2016).
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum Packet { $($(#[$doc])+ $variant = $id,)+ }

        impl Packet {
            /// All of them, in the order of their numbers.
            pub const ALL: [Self; 52] = [$(Self::$variant,)+];

            /// Name in logs and recordings.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }

            /// How it stands on the line.
            pub const fn format(self) -> ValueFormat {
                match self { $(Self::$variant => ValueFormat::$format,)+ }
            }

            /// Its unit; empty for flags, numbers of things and raw signals.
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$variant => $unit,)+ }
            }

            /// Values that a robot can report; others were garbled on the way.
            pub const fn range(self) -> RangeInclusive<i32> {
                let (least, most) = match self { $(Self::$variant => {
                    #[allow(unused_variables)]
                    let range = ValueFormat::$format.full_range();
                    $(let range: (i32, i32) = ($least, $most);)?
                    range
                })+ };
                least..=most
            }
        }
    };
}

packets! {
    /// Bumper and wheel drops, as bits.
    BumpsAndDrops = 7, "bumps_wheel_drops", U8 [0, 15], "";
    /// Rightmost light bumper, as a flag; deprecated.
    Wall = 8, "wall", U8 [0, 1], "";
    /// No floor at the left.
    CliffLeft = 9, "cliff_left", U8 [0, 1], "";
    /// No floor at the front left.
    CliffFrontLeft = 10, "cliff_front_left", U8 [0, 1], "";
    /// No floor at the front right.
    CliffFrontRight = 11, "cliff_front_right", U8 [0, 1], "";
    /// No floor at the right.
    CliffRight = 12, "cliff_right", U8 [0, 1], "";
    /// The beam of a virtual wall is seen.
    VirtualWall = 13, "virtual_wall", U8 [0, 1], "";
    /// Motors that draw too much current, as bits.
    Overcurrents = 14, "overcurrents", U8 [0, 31], "";
    /// Dirt that is being picked up.
    DirtDetect = 15, "dirt_detect", U8, "";
    /// Unused, 0.
    Unused1 = 16, "unused_1", U8, "";
    /// Infrared character seen all around; 0 for none.
    InfraredOmni = 17, "ir_omni", U8, "";
    /// Buttons that are held down, as bits.
    Buttons = 18, "buttons", U8, "";
    /// Distance since it was last read, mean of the wheels; wrong before firmware 3.3.0.
    Distance = 19, "distance", I16, "mm";
    /// Turn since it was last read, counter-clockwise positive; too small up to firmware 3.4.0, see
    /// [`ANGLE_ERROR`](super::motion::ANGLE_ERROR).
    Angle = 20, "angle", I16, "deg";
    /// What the charger does: see [`ChargingState`](super::readings::ChargingState).
    ChargingState = 21, "charging_state", U8 [0, 6], "";
    /// Of the battery.
    Voltage = 22, "voltage", U16, "mV";
    /// Into the battery; negative while it discharges.
    Current = 23, "current", I16, "mA";
    /// Of the battery.
    Temperature = 24, "temperature", I8, "deg C";
    /// Left in the battery. A flat one is reported as a little less than 65536.
    BatteryCharge = 25, "battery_charge", U16, "mAh";
    /// Of the battery when full, by its own estimate.
    BatteryCapacity = 26, "battery_capacity", U16, "mAh";
    /// Strength of the wall signal; deprecated.
    WallSignal = 27, "wall_signal", U16 [0, 1023], "";
    /// Light that the floor sends back at the left.
    CliffLeftSignal = 28, "cliff_left_signal", U16 [0, 4095], "";
    /// Light that the floor sends back at the front left.
    CliffFrontLeftSignal = 29, "cliff_front_left_signal", U16 [0, 4095], "";
    /// Light that the floor sends back at the front right.
    CliffFrontRightSignal = 30, "cliff_front_right_signal", U16 [0, 4095], "";
    /// Light that the floor sends back at the right.
    CliffRightSignal = 31, "cliff_right_signal", U16 [0, 4095], "";
    /// Unused, 0.
    Unused2 = 32, "unused_2", U8, "";
    /// Unused, 0.
    Unused3 = 33, "unused_3", U16, "";
    /// Chargers that are connected, as bits.
    ChargingSources = 34, "charging_sources", U8 [0, 3], "";
    /// Mode, 0 to 3; up to 4 on robots that report one too much: see [`Mode::from_report`](super::Mode::from_report).
    OiMode = 35, "oi_mode", U8 [0, 4], "";
    /// Song that was chosen last. The specification's text says 0 to 15, its table 0 to 4.
    SongNumber = 36, "song_number", U8 [0, 15], "";
    /// Whether a song plays.
    SongPlaying = 37, "song_playing", U8 [0, 1], "";
    /// Packets in the stream.
    StreamPackets = 38, "stream_packets", U8 [0, 108], "";
    /// Velocity of the latest Drive.
    RequestedVelocity = 39, "requested_velocity", I16 [-500, 500], "mm/s";
    /// Radius of the latest Drive, special values included; wrong before firmware 3.3.0.
    RequestedRadius = 40, "requested_radius", I16, "mm";
    /// Right wheel speed of the latest Drive Direct.
    RequestedRightVelocity = 41, "requested_right_velocity", I16 [-500, 500], "mm/s";
    /// Left wheel speed of the latest Drive Direct.
    RequestedLeftVelocity = 42, "requested_left_velocity", I16 [-500, 500], "mm/s";
    /// Left wheel encoder, modulo 65536: see [`encoder_delta`](super::motion::encoder_delta).
    LeftEncoder = 43, "left_encoder", I16, "counts";
    /// Right wheel encoder, modulo 65536.
    RightEncoder = 44, "right_encoder", I16, "counts";
    /// Light bumper, as bits.
    LightBumper = 45, "light_bumper", U8 [0, 63], "";
    /// Strength of the light bumper's signal at the left.
    LightLeft = 46, "light_bump_left", U16 [0, 4095], "";
    /// Strength of the light bumper's signal at the front left.
    LightFrontLeft = 47, "light_bump_front_left", U16 [0, 4095], "";
    /// Strength of the light bumper's signal left of the centre.
    LightCentreLeft = 48, "light_bump_center_left", U16 [0, 4095], "";
    /// Strength of the light bumper's signal right of the centre.
    LightCentreRight = 49, "light_bump_center_right", U16 [0, 4095], "";
    /// Strength of the light bumper's signal at the front right.
    LightFrontRight = 50, "light_bump_front_right", U16 [0, 4095], "";
    /// Strength of the light bumper's signal at the right.
    LightRight = 51, "light_bump_right", U16 [0, 4095], "";
    /// Infrared character seen on the left; 0 for none.
    InfraredLeft = 52, "ir_left", U8, "";
    /// Infrared character seen on the right; 0 for none.
    InfraredRight = 53, "ir_right", U8, "";
    /// Of the left wheel's motor.
    LeftMotorCurrent = 54, "left_motor_current", I16, "mA";
    /// Of the right wheel's motor.
    RightMotorCurrent = 55, "right_motor_current", I16, "mA";
    /// Of the main brush's motor.
    MainBrushCurrent = 56, "main_brush_current", I16, "mA";
    /// Of the side brush's motor.
    SideBrushCurrent = 57, "side_brush_current", I16, "mA";
    /// The castor's wheel, as bits.
    Stasis = 58, "stasis", U8 [0, 3], "";
}

impl Packet {
    /// The packet with that number; groups are none.
    pub fn from_byte(id: u8) -> Option<Self> {
        Self::ALL.get(usize::from(id.checked_sub(7)?)).copied()
    }

    /// The value of its bits: one byte's stand in the low half.
    pub const fn value(self, raw: u16) -> i32 {
        match self.format() {
            ValueFormat::U8 | ValueFormat::U16 => raw as i32,
            ValueFormat::I8 => raw as i8 as i32,
            ValueFormat::I16 => raw.cast_signed() as i32,
        }
    }

    /// Whether a robot can report these bits.
    pub fn is_plausible(self, raw: u16) -> bool {
        self.range().contains(&self.value(raw))
    }

    /// Writes it at the start of `out`; how many bytes, or `None` if `out` is too short.
    pub fn write(self, raw: u16, out: &mut [u8]) -> Option<usize> {
        let [high, low] = raw.to_be_bytes();
        match self.format().size() {
            1 => *out.first_mut()? = low,
            _ => *out.first_chunk_mut()? = [high, low],
        }
        Some(self.format().size())
    }

    /// Its bits, from the start of `bytes`; `None` if there are too few.
    pub fn read(self, bytes: &[u8]) -> Option<u16> {
        match self.format().size() {
            1 => bytes.first().map(|&byte| byte.into()),
            _ => bytes.first_chunk().map(|&pair| u16::from_be_bytes(pair)),
        }
    }
}

/// Name in logs and recordings.
impl fmt::Display for Packet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A single packet, or a group that stands for a run of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PacketId {
    id: u8,
    first: u8,
    last: u8,
}

/// Number, first and last packet of each group.
pub const GROUPS: [(u8, Packet, Packet); 11] = [
    (0, Packet::BumpsAndDrops, Packet::BatteryCapacity),
    (1, Packet::BumpsAndDrops, Packet::Unused1),
    (2, Packet::InfraredOmni, Packet::Angle),
    (3, Packet::ChargingState, Packet::BatteryCapacity),
    (4, Packet::WallSignal, Packet::ChargingSources),
    (5, Packet::OiMode, Packet::RequestedLeftVelocity),
    (6, Packet::BumpsAndDrops, Packet::RequestedLeftVelocity),
    (100, Packet::BumpsAndDrops, Packet::Stasis),
    (101, Packet::LeftEncoder, Packet::Stasis),
    (106, Packet::LightLeft, Packet::LightRight),
    (107, Packet::LeftMotorCurrent, Packet::Stasis),
];

impl PacketId {
    /// The packet or group with that number.
    ///
    /// ```
    /// use roomba_oi::PacketId;
    /// assert_eq!(PacketId::from_byte(100).map(PacketId::size), Some(80));
    /// assert_eq!(PacketId::from_byte(59), None);
    /// ```
    pub fn from_byte(id: u8) -> Option<Self> {
        if let Some(packet) = Packet::from_byte(id) {
            return Some(packet.into());
        }
        let &(_, first, last) = GROUPS.iter().find(|group| group.0 == id)?;
        Some(Self { id, first: first as u8, last: last as u8 })
    }

    /// Its number on the line.
    pub const fn byte(self) -> u8 {
        self.id
    }

    /// The packets that it stands for, in the order of the line: their numbers ascend.
    pub fn packets(self) -> impl Iterator<Item = Packet> {
        (self.first..=self.last).filter_map(Packet::from_byte)
    }

    /// Bytes on the line, without the number itself.
    pub fn size(self) -> usize {
        usize::from(SIZES[usize::from(self.id)])
    }

    /// Bytes of the packet or group with that number; `None` if there is none.
    pub fn size_of(id: u8) -> Option<usize> {
        let size = SIZES[usize::from(id)];
        (size > 0).then_some(size.into())
    }
}

impl From<Packet> for PacketId {
    fn from(packet: Packet) -> Self {
        let id = packet as u8;
        Self { id, first: id, last: id }
    }
}

/// Bytes of every packet and group by its number, 0 where there is none: the receiver asks for each field of each frame.
const SIZES: [u8; 256] = {
    let mut sizes = [0; 256];
    let mut at = 0;
    while at < Packet::ALL.len() {
        sizes[Packet::ALL[at] as usize] = Packet::ALL[at].format().size() as u8;
        at += 1;
    }
    at = 0;
    while at < GROUPS.len() {
        let (id, first, last) = GROUPS[at];
        let mut packet = first as usize;
        while packet <= last as usize {
            sizes[id as usize] += sizes[packet];
            packet += 1;
        }
        at += 1;
    }
    sizes
};

/// A set of packets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct PacketSet(u64);

impl PacketSet {
    /// Adds one.
    pub fn insert(&mut self, packet: Packet) {
        self.0 |= 1 << packet as u8;
    }

    /// Whether it is in there.
    pub fn contains(self, packet: Packet) -> bool {
        self.0 & (1 << packet as u8) != 0
    }

    /// Those that are in either.
    pub fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Those that are in there, in the order of their numbers.
    pub fn iter(self) -> impl Iterator<Item = Packet> {
        Packet::ALL.into_iter().filter(move |&packet| self.contains(packet))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_have_the_sizes_of_the_specification() {
        let sizes = GROUPS.map(|(id, ..)| PacketId::size_of(id).unwrap());
        assert_eq!(sizes, [26, 10, 6, 10, 14, 12, 52, 80, 28, 12, 9]);
    }

    #[test]
    fn numbers_and_sizes_agree_for_every_byte() {
        for id in 0..=255 {
            let sum = PacketId::from_byte(id).map(|p| p.packets().map(|p| p.format().size()).sum::<usize>());
            assert_eq!(PacketId::size_of(id), sum, "{id}");
            assert_eq!(PacketId::from_byte(id).map_or(id, PacketId::byte), id);
        }
    }

    #[test]
    fn signs_are_extended_from_the_right_bit() {
        assert_eq!((Packet::Temperature.value(0xFB), Packet::DirtDetect.value(0xFB)), (-5, 251));
        assert_eq!((Packet::Current.value(0xFF24), Packet::Voltage.value(0xFF24)), (-220, 65_316));
        assert!(!Packet::LightLeft.is_plausible(22_802) && Packet::LightLeft.is_plausible(4095));
    }

    #[test]
    fn nothing_is_written_past_the_end() {
        let mut one = [0];
        assert_eq!((Packet::Voltage.write(1, &mut one), Packet::Voltage.read(&one)), (None, None));
        assert_eq!((Packet::Wall.write(1, &mut one), one), (Some(1), [1]));
    }
}
