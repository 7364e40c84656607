//! What holds for any bytes.

use super::support::{BAUD, Lab, plan, setup};
use proptest::prelude::*;
use robovac_link::emulator::{Emulator, PERSONALITIES};
use robovac_sim::Conditions;
use roomba_oi::{BAUD_RATES, Buttons, Command, CommandDecoder, Mode};

/// Bytes in which opcodes are common.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let opcode = prop_oneof![Just(7_u8), 128..=174_u8];
    proptest::collection::vec(prop_oneof![opcode, any::<u8>()], 0..120)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn nothing_panics_and_nothing_moves_it_but_safe_full_and_builtin_programs(
        who in 0..PERSONALITIES.len(),
        parts in proptest::collection::vec((bytes(), 0..12_usize, 0.0..2.0_f64, any::<u8>()), 1..12),
    ) {
        let mut robot = Emulator::new(&setup(plan(), Conditions::default(), 3), &PERSONALITIES[who]);
        let mut heard = Vec::new();
        let mut quiet_steps = 0;
        for (bytes, rate, time, what) in parts {
            let rate = if what & 1 == 0 { BAUD } else { BAUD_RATES[rate] };
            robot.receive(&bytes, rate);
            match what >> 1 & 15 {
                1 => robot.set_brc(true),
                2 => robot.set_brc(false),
                3 => robot.press(Buttons::from_byte(what)),
                4 => robot.plug_charger(true),
                5 => robot.plug_charger(false),
                _ => {}
            }
            for _ in 0..(time / 0.015) as u32 {
                robot.advance(0.015);
                let may_move = robot.mode() >= Mode::Safe || robot.runs_builtin_program();
                quiet_steps = if may_move { 0 } else { quiet_steps + 1 };
                // It takes 14 steps to brake from 0.5 m/s, and 42 gently, as when a built-in program is paused.
                let speed = robot.robot().speed();
                prop_assert!(quiet_steps < 60 || speed.is_stop(), "{speed:?} in {}", robot.mode());
            }
            robot.transmit(rate, &mut heard);
        }
    }

    /// Whole commands without motion and built-in programs never move it.
    #[test]
    fn only_motion_commands_move_it(bytes in bytes()) {
        let mut decoder = CommandDecoder::default();
        let moves = |command: &Command<'_>| {
            use Command as C;
            matches!(
                command,
                C::Drive { .. } | C::DriveDirect { .. } | C::DrivePwm { .. } | C::Clean | C::Spot | C::Max | C::SeekDock
                    | C::Buttons(_)
            )
        };
        let mut lab = Lab::in_mode(Mode::Full);
        for byte in bytes {
            let Some(received) = decoder.push(byte) else { continue };
            if received.command.is_ok_and(|command| !moves(&command)) {
                let bytes = received.bytes.to_vec();
                lab.send(&bytes);
            }
        }
        let from = lab.robot.pose();
        lab.wait(2.0);
        prop_assert_eq!(lab.robot.pose(), from);
    }
}
