//! Questions about numbers: medians, odometry, log odds, bytes.

use super::{Question, Right};
use crate::fixed;
use rand::RngExt;
use robovac_core::rng::Rng;

/// Encoder counts of a turn of the wheel, diameter of the wheels and distance between them, m: Create 2 Open Interface
/// Specification, packets 43 and 44, and its figures of the robot.
const COUNTS: f64 = 508.8;
const WHEEL_M: f64 = 0.072;
const BASE_M: f64 = 0.235;

/// A number in a sentence, where a minus isn't a hyphen.
fn fixed(value: f64, places: u32) -> String {
    fixed::fixed(value, places).replace('-', "−")
}

fn question(text: String, example: &str, right: Right, because: String) -> Question {
    Question { text, room: Vec::new(), options: Vec::new(), example: example.to_owned(), right, because }
}

/// The median of five coverages.
pub fn median(rng: &mut Rng) -> Question {
    let mut values: [u32; 5] = std::array::from_fn(|_| rng.random_range(40..100));
    let given = values.map(|value| format!("{value} %")).join(", ");
    values.sort_unstable();
    let sorted = values.map(|value| value.to_string()).join(", ");
    let because = format!("Sorted: {sorted}. The one in the middle is {}.", values[2]);
    question(
        format!("Five runs cover {given}. What is the median, in percent?"),
        "e.g. 72",
        Right::Number(f64::from(values[2]), 0.01),
        because,
    )
}

/// The turn that encoder counts stand for.
pub fn odometry(rng: &mut Rng) -> Question {
    let left = rng.random_range(2..20) * 25;
    let right = loop {
        let right = rng.random_range(2..20) * 25;
        if right != left {
            break right;
        }
    };
    let metres = |counts: i32| f64::from(counts) / COUNTS * std::f64::consts::PI * WHEEL_M;
    let angle = ((metres(right) - metres(left)) / BASE_M).to_degrees();
    let text = format!(
        "A Roomba's left encoder counts {left}, its right one {right}. A turn of a wheel is 508.8 counts, wheels have a \
         diameter of 72 mm and are 235 mm apart. By how many degrees has the robot turned, counter-clockwise?"
    );
    let because = format!(
        "({right} − {left}) / 508.8 × π × 72 mm = {} mm; divided by 235 mm that is {} rad = {}°.",
        fixed(1000.0 * (metres(right) - metres(left)), 1),
        fixed(angle.to_radians(), 3),
        fixed(angle, 1)
    );
    question(text, "e.g. −42.5", Right::Number(angle, 0.02 * angle.abs() + 0.5), because)
}

/// The probability after some hits and misses.
pub fn log_odds(rng: &mut Rng) -> Question {
    let (hits, misses) = (rng.random_range(1..5), rng.random_range(0..4));
    let (hit, miss) = ((0.7_f64 / 0.3).ln(), (0.4_f64 / 0.6).ln());
    let sum = f64::from(hits) * hit + f64::from(misses) * miss;
    let percent = 100.0 / (1.0 + (-sum).exp());
    let text = format!(
        "A cell begins at 50 %. It is seen occupied {hits} ×, each time with p = 0.7, and free {misses} ×, each time with \
         p = 0.4. With what probability is it occupied, in percent?"
    );
    let [hit, miss, sum] = [hit, miss, sum].map(|odds| fixed(odds, 3));
    let because = format!(
        "The log odds are {hits} × {hit} + {misses} × ({miss}) = {sum}; 1 / (1 + e^−({sum})) is {} %.",
        fixed(percent, 1)
    );
    question(text, "e.g. 84", Right::Number(percent, 1.0), because)
}

/// The bytes of Drive Direct.
pub fn bytes(rng: &mut Rng) -> Question {
    let mut speed = || rng.random_range(-10..=10) * 50_i16;
    let (right, left) = (speed(), speed());
    let [a, b] = right.to_be_bytes();
    let [c, d] = left.to_be_bytes();
    let text = format!(
        "Drive Direct is opcode 145, then the speeds of the right and the left wheel in mm/s. Each is two bytes in \
         two's complement, the high byte first. Which five bytes drive the right wheel at {right} mm/s and the left at \
         {left}?"
    );
    let wrapped =
        |speed: i16| if speed < 0 { format!("{speed} + 65,536 = {}", speed as u16) } else { speed.to_string() };
    let because =
        format!("{} is {a} × 256 + {b}; {} is {c} × 256 + {d}: 145 {a} {b} {c} {d}.", wrapped(right), wrapped(left));
    question(text, "e.g. 145 1 44 255 56", Right::Bytes(vec![145, a, b, c, d]), because)
}
