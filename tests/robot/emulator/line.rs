//! Rates, pulses on BRC, and what a wrong rate makes of bytes.

use super::support::{BAUD, Lab};
use roomba_oi::{BAUD_RATES, Mode, StreamFrame};

#[test]
fn every_rate_can_be_set_and_talks() {
    for (code, &rate) in BAUD_RATES.iter().enumerate() {
        let mut lab = Lab::in_mode(Mode::Safe);
        lab.send(&[129, code as u8]);
        lab.baud = rate;
        // Too early: it isn't heard.
        lab.send(&[132]);
        if rate >= 2400 {
            assert_eq!(lab.robot.mode(), Mode::Safe, "{rate}");
        }
        lab.wait(0.1);
        assert_eq!(lab.robot.baud(), rate);
        lab.take();
        lab.send(&[142, 35]);
        lab.wait(0.1);
        assert_eq!(lab.take(), [lab.robot.mode() as u8], "{rate}");
    }
}

fn pulse(lab: &mut Lab, low_s: f64, high_s: f64) {
    lab.robot.set_brc(true);
    lab.wait(low_s);
    lab.robot.set_brc(false);
    lab.wait(high_s);
}

#[test]
fn three_short_pulses_set_19200_and_long_ones_dont() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.wait(2.0);
    for _ in 0..3 {
        pulse(&mut lab, 1.0, 0.2);
    }
    assert_eq!(lab.robot.baud(), BAUD);
    for _ in 0..3 {
        pulse(&mut lab, 0.1, 0.1);
    }
    assert_eq!((lab.robot.baud(), lab.robot.take_display().tunes.len()), (19_200, 1));
    lab.baud = 19_200;
    lab.wait(0.1);
    assert_eq!(lab.ask(35), [1]);
    // Until it loses power, or is reset.
    lab.send(&[7]);
    lab.wait(6.0);
    assert_eq!(lab.robot.baud(), BAUD);
}

#[test]
fn pulses_right_after_power_on_dont_count() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[7]);
    for _ in 0..3 {
        pulse(&mut lab, 0.1, 0.1);
    }
    assert_eq!(lab.robot.baud(), BAUD);
}

#[test]
fn a_wrong_rate_garbles_both_ways_and_always_the_same() {
    let garbled = || {
        let mut lab = Lab::in_mode(Mode::Passive);
        lab.send(&[148, 2, 35, 22]);
        lab.wait(0.1);
        lab.take();
        lab.baud = 19_200;
        lab.wait(1.0);
        let slow = lab.take();
        // The other way round: nothing that it hears makes sense.
        lab.robot.take_heard();
        for _ in 0..20 {
            lab.send(&[128, 142, 35]);
        }
        lab.wait(0.1);
        (slow, lab.robot.take_heard())
    };
    let (heard_by_host, heard_by_robot) = garbled();
    assert!(heard_by_host.len() > 20 && heard_by_host.len() < 600, "{}", heard_by_host.len());
    assert!((0..heard_by_host.len()).all(|at| StreamFrame::parse(&heard_by_host[at..]).is_err()));
    assert!(!heard_by_robot.iter().any(|heard| heard.bytes == [142, 35]));
    assert_eq!(garbled(), (heard_by_host, heard_by_robot));
}

#[test]
fn rates_that_are_nearly_the_same_understand_each_other() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.baud = 117_000;
    assert_eq!(lab.ask(35), [1]);
}

#[test]
fn bytes_take_their_time_to_the_robot() {
    let mut lab = Lab::new("slow");
    lab.robot.receive(&[128, 131], 19_200);
    lab.robot.advance(0.0005);
    assert_eq!(lab.robot.mode(), Mode::Off);
    lab.robot.advance(0.0003);
    assert_eq!((lab.robot.mode(), lab.robot.is_answering()), (Mode::Passive, true));
    lab.robot.advance(0.0003);
    assert_eq!((lab.robot.mode(), lab.robot.is_answering()), (Mode::Safe, false));
}

#[test]
fn nobody_has_to_listen() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.robot.receive(&[148, 1, 100], BAUD);
    lab.robot.advance(600.0);
    lab.wait(0.1);
    let heard = lab.take();
    assert!(heard.len() <= 1 << 16, "{}", heard.len());
}
