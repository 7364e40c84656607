//! The figures that 002 (Hasan, Al-Nahid & Reza 2014) prints.

use robovac_sim::controller::Timing;

/// The robot of section IV.A: r = 4 cm, R = 12 cm, N = 1.2 a second, L = 14.5 cm.
const DVR_1: Timing = Timing { wheel_radius: 0.04, half_base: 0.12, turns_per_s: 1.2, lane: 0.145 };

/// Whether `value` is printed as `printed` when cut or rounded to its number of decimals.
fn is_printed(value: f64, printed: &str) -> bool {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    let scale = 10_f64.powi(decimals as i32);
    let printed: f64 = printed.parse().unwrap();
    (value - printed).abs() < 1e-9 + 0.5 / scale || (value * scale).floor() / scale == printed
}

#[test]
fn section_iv_a_i_corner_escape() {
    let least = DVR_1.corner_escape_s(120.0);
    assert!((least - 12.0 * 120.0 / (720.0 * 4.0 * 1.2)).abs() < 1e-12, "R theta / (720 r N)");
    assert!(is_printed(least, "0.41") && (0.41..0.42).contains(&least), "{least}");
    // "Time for 360 degrees = R / (r N)", and the least time turns by half of the bumper's angle.
    assert!((DVR_1.full_turn_s() - 2.5).abs() < 1e-12);
    assert!((360.0 * least / DVR_1.full_turn_s() - 60.0).abs() < 1e-12);
}

#[test]
fn section_iv_a_iii_back_turn_go() {
    assert!(is_printed(DVR_1.back_s(), "0.16"), "{}", DVR_1.back_s());
    assert!(is_printed(DVR_1.turn_s(), "0.625"), "{}", DVR_1.turn_s());
    assert!(is_printed(DVR_1.go_s(), "0.48"), "{}", DVR_1.go_s());
    // Back is L / 3 and go is L at the speed of the wheels.
    let speed = 2.0 * std::f64::consts::PI * DVR_1.wheel_radius * DVR_1.turns_per_s;
    assert!((DVR_1.back_s() * speed - 0.145 / 3.0).abs() < 1e-12 && (DVR_1.go_s() * speed - 0.145).abs() < 1e-12);
}
