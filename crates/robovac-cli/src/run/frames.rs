//! Readings and commands as frames of numbers: for programs that take them instead of lines, also for many runs at once. See
//! docs/program-protocol.md.

use super::{
    child::ProgramProcess,
    protocol::Words,
    talk::{Prints, add_prints},
};
use robovac_sim::{montecarlo::ProgramRun, program::LogEnd};
use serde::Deserialize;

/// Bytes of a command in an answer: left, right, hold, done.
const COMMAND: usize = 16;

/// A run, and what was last said of it.
struct Seat<'a> {
    run: &'a mut ProgramRun,
    /// Number of the laser's scan that the program has.
    scan: u32,
    /// Why it has ended.
    end: Option<&'static str>,
}

/// What a program says besides its commands.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Saying {
    /// Number of the run.
    run: usize,
    print: Vec<String>,
    error: Option<String>,
    line: Option<u64>,
}

/// Lets a program drive all of these runs, in turn. Returns why each ended, as [`drive`](super::drive) does; or what went wrong
/// in one of them, and in which.
pub fn drive_framed(
    process: &mut ProgramProcess,
    runs: &mut [ProgramRun],
    prints: &mut [Prints],
) -> Result<Vec<&'static str>, (usize, String)> {
    let mut seats: Vec<Seat<'_>> = runs.iter_mut().map(|run| Seat { run, scan: 0, end: None }).collect();
    let (mut frame, mut asked) = (Vec::new(), Vec::new());
    loop {
        asked.clear();
        frame.clear();
        frame.extend([0; 8]);
        for (number, seat) in seats.iter_mut().enumerate() {
            if seat.end.is_none() && seat.run.is_over() {
                seat.end = Some("time");
            }
            if seat.end.is_none() {
                asked.push(number);
                seat.ask(number as u32, &mut frame);
            }
        }
        let Some(&first) = asked.first() else {
            return Ok(seats.iter().map(|seat| seat.end.unwrap_or("time")).collect());
        };
        let (length, count) = ((frame.len() - 4) as u32, asked.len() as u32);
        frame[..4].copy_from_slice(&length.to_le_bytes());
        frame[4..8].copy_from_slice(&count.to_le_bytes());
        let answer = process.exchange(&frame).map_err(|fault| (first, seats[first].told(&fault)))?;
        let (commands, rest) = answer.split_at_checked(COMMAND * asked.len()).ok_or_else(|| {
            (first, format!("the program answered {} bytes to {count} readings; see the protocol", answer.len()))
        })?;
        if !rest.is_empty() {
            let said: Vec<Saying> = serde_json::from_slice(rest)
                .map_err(|error| (first, format!("the program's frame can't be read: {error}")))?;
            for saying in said {
                let seat =
                    seats.get(saying.run).ok_or_else(|| (first, "the program named an unknown run".to_owned()))?;
                take(seat, &saying, &mut prints[saying.run]).map_err(|fault| (saying.run, seat.told(&fault)))?;
            }
        }
        for (&number, command) in asked.iter().zip(commands.chunks_exact(COMMAND)) {
            seats[number].command(command);
        }
    }
}

fn take(seat: &Seat<'_>, saying: &Saying, prints: &mut Prints) -> Result<(), String> {
    let time_s = seat.run.lockstep().run().time_s();
    add_prints(prints, time_s, &saying.print)?;
    let error = saying.error.as_ref().map(|error| Words::of(error.as_bytes()));
    match (error, saying.line) {
        (Some(error), Some(line)) => Err(format!("line {line}: {error}")),
        (Some(error), None) => Err(error),
        (None, _) => Ok(()),
    }
}

impl Seat<'_> {
    /// Adds its readings: its number, the number of the laser's ranges that follow, readings, ranges of a new scan.
    fn ask(&mut self, number: u32, frame: &mut Vec<u8>) {
        let lockstep = self.run.lockstep();
        let (readings, ranges) = lockstep.readings().split_at(robovac_sim::program::LASER);
        let ranges = if lockstep.scan() == self.scan { &[] } else { ranges };
        self.scan = lockstep.scan();
        frame.extend(number.to_le_bytes());
        frame.extend((ranges.len() as u32).to_le_bytes());
        let begin = frame.len();
        frame.resize(begin + size_of::<f64>() * (readings.len() + ranges.len()), 0);
        for (place, reading) in frame[begin..].chunks_exact_mut(size_of::<f64>()).zip(readings.iter().chain(ranges)) {
            place.copy_from_slice(&reading.to_le_bytes());
        }
    }

    /// Drives as it is commanded.
    fn command(&mut self, command: &[u8]) {
        let words = [0, 4, 8, 12].map(|at| command.get(at..at + 4).and_then(|word| word.try_into().ok()));
        let [left, right, hold, done] = words.map(|word| i32::from_le_bytes(word.unwrap_or_default()));
        if done != 0 {
            self.run.finish(LogEnd::Done);
            self.end = Some("done");
        } else if self.run.hold([left, right].map(f64::from), (hold as u32).saturating_add(1)) == 0 {
            self.end = Some("battery");
        }
    }

    fn told(&self, fault: &str) -> String {
        format!("at {:.2} s: {fault}", self.run.lockstep().run().time_s())
    }
}
