//! Bytes with named bits, in commands and packets.

/// A struct of named bits with its byte. Bits without a name are reserved: they are written as 0 and ignored when read.
macro_rules! bits {
    ($($(#[$doc:meta])+ $name:ident { $($(#[$bit_doc:meta])+ $bit:ident = $at:literal,)+ })+) => {$(
        $(#[$doc])+
        #[allow(clippy::struct_excessive_bools)]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
        pub struct $name { $($(#[$bit_doc])+ pub $bit: bool,)+ }

        impl $name {
            /// The bits that have a name.
            pub const MASK: u8 = $(1 << $at)|+;

            /// From its byte.
            pub const fn from_byte(byte: u8) -> Self {
                Self { $($bit: byte & (1 << $at) != 0,)+ }
            }

            /// Its byte.
            pub const fn byte(self) -> u8 {
                $((self.$bit as u8) << $at)|+
            }
        }
    )+};
}

bits! {
    /// Bumper and wheel drops (packet 7). Bit 4, the castor's drop, exists on the Create 1 only.
    BumpsAndDrops {
        /// Right half of the bumper.
        bump_right = 0,
        /// Left half of the bumper.
        bump_left = 1,
        /// Right wheel.
        drop_right = 2,
        /// Left wheel.
        drop_left = 3,
    }

    /// Motors that draw too much current (packet 14). Bit 1 is reserved: the main brush is bit 2.
    Overcurrents {
        /// Side brush.
        side_brush = 0,
        /// Main brush.
        main_brush = 2,
        /// Right wheel.
        right_wheel = 3,
        /// Left wheel.
        left_wheel = 4,
    }

    /// Buttons that are held down (packet 18), or are to be pressed (opcode 165). Robots of the 600 series have no
    /// Schedule and no Clock.
    Buttons {
        /// Clean.
        clean = 0,
        /// Spot.
        spot = 1,
        /// Dock.
        dock = 2,
        /// Minute.
        minute = 3,
        /// Hour.
        hour = 4,
        /// Day.
        day = 5,
        /// Schedule.
        schedule = 6,
        /// Clock.
        clock = 7,
    }

    /// Chargers that are connected (packet 34).
    ChargingSources {
        /// The plug at the robot's side.
        internal_charger = 0,
        /// The dock.
        home_base = 1,
    }

    /// Light bumper: something is near (packet 45).
    LightBumper {
        /// Left.
        left = 0,
        /// Front left.
        front_left = 1,
        /// Centre left.
        centre_left = 2,
        /// Centre right.
        centre_right = 3,
        /// Front right.
        front_right = 4,
        /// Right.
        right = 5,
    }

    /// The castor's wheel (packet 58).
    Stasis {
        /// It turns: the robot makes forward progress. Also clear when it turns on the spot, backs up or stands.
        toggling = 0,
        /// The sensor is dirty and switched off.
        disabled = 1,
    }

    /// Brushes and vacuum (opcode 138).
    Motors {
        /// Side brush runs.
        side_brush = 0,
        /// Vacuum runs.
        vacuum = 1,
        /// Main brush runs.
        main_brush = 2,
        /// The side brush turns clockwise instead of counter-clockwise.
        side_brush_clockwise = 3,
        /// The main brush turns outward instead of inward.
        main_brush_outward = 4,
    }

    /// Lights around the Clean button (opcode 139).
    Lamps {
        /// Debris, blue.
        debris = 0,
        /// Spot, green.
        spot = 1,
        /// Dock, green.
        dock = 2,
        /// Check robot, orange.
        check_robot = 3,
    }

    /// Days of a week: those to clean on (opcode 167), or their lights (opcode 162).
    Weekdays {
        /// Sunday.
        sunday = 0,
        /// Monday.
        monday = 1,
        /// Tuesday.
        tuesday = 2,
        /// Wednesday.
        wednesday = 3,
        /// Thursday.
        thursday = 4,
        /// Friday.
        friday = 5,
        /// Saturday.
        saturday = 6,
    }

    /// Lights of the schedule display beside the weekdays (opcode 162).
    ScheduleLamps {
        /// Colon between hours and minutes.
        colon = 0,
        /// PM.
        pm = 1,
        /// AM.
        am = 2,
        /// Clock.
        clock = 3,
        /// Schedule.
        schedule = 4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_keeps_the_bits_that_have_a_name() {
        assert_eq!((BumpsAndDrops::MASK, Overcurrents::MASK, LightBumper::MASK), (0x0F, 0x1D, 0x3F));
        for byte in 0..=255 {
            assert_eq!(Overcurrents::from_byte(byte).byte(), byte & Overcurrents::MASK);
            assert_eq!(Buttons::from_byte(byte).byte(), byte);
            assert_eq!(Weekdays::from_byte(byte).byte(), byte & 0x7F);
        }
    }
}
