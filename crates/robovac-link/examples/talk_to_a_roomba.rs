//! Connects to a Roomba, prints its sensors and disconnects:
//! `cargo run -p robovac-link --example talk_to_a_roomba -- [PORT] [--drive]`
//!
//! PORT is a serial port such as /dev/ttyUSB0 or COM3; without it, the program talks to a virtual Roomba. The robot does not
//! move unless `--drive` is given: then it drives 10 cm ahead in Safe mode. Clear the way, stay beside the robot, and let the
//! program end: a real robot drives on if its program is killed.

use robovac_core::floor_plan::room;
use robovac_core::robot::{Drive, model};
use robovac_link::driver::Driver;
use robovac_link::emulator::{Emulator, personality};
use robovac_sim::{Conditions, experiment::RoomSetup};
use roomba_oi::{Mode, Readings, motion::encoder_delta};
use std::fmt::Write as _;
use std::{env, error::Error, io, time::Duration, time::Instant};

/// Sends bytes, waits about 10 ms for others, and returns the time in s.
type Exchange<'a> = &'a mut dyn FnMut(&[u8], &mut Vec<u8>) -> io::Result<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let (flags, ports): (Vec<_>, Vec<_>) = env::args().skip(1).partition(|word| word == "--drive");
    let may_drive = !flags.is_empty();
    let Some(port) = ports.first() else {
        print!("{}", talk_to_virtual(may_drive)?);
        return Ok(());
    };
    let mut port = serialport::new(port, 115_200).timeout(Duration::from_millis(10)).open()?;
    // Opening the port can pull the wake-up wire low.
    let _ = port.write_request_to_send(false);
    let (began, mut buffer) = (Instant::now(), [0; 4096]);
    let said = talk(may_drive, &mut |sent, received| {
        port.write_all(sent)?;
        match port.read(&mut buffer) {
            Ok(count) => received.extend(&buffer[..count]),
            Err(error) if error.kind() == io::ErrorKind::TimedOut => {}
            Err(error) => return Err(error),
        }
        Ok(began.elapsed().as_secs_f64())
    });
    print!("{}", said?);
    Ok(())
}

/// The same over a line in memory, in simulated time.
pub fn talk_to_virtual(may_drive: bool) -> Result<String, Box<dyn Error>> {
    let plan = (room("empty").ok_or("no such room")?.build)();
    let robot = model("roomba600").ok_or("no such robot")?;
    let setup = RoomSetup::new(&plan, robot, robot.default_cell, None)?.setup(Conditions::default(), 1);
    let mut roomba = Emulator::new(&setup, personality("model").ok_or("no such personality")?);
    talk(may_drive, &mut |sent, received| {
        roomba.receive(sent, 115_200);
        roomba.advance(0.01);
        roomba.transmit(115_200, received);
        Ok(roomba.time_s())
    })
}

/// Connects, prints the sensors and drives if allowed. In every case the robot is stopped and released.
fn talk(may_drive: bool, exchange: Exchange<'_>) -> Result<String, Box<dyn Error>> {
    let mut link = Link { driver: Driver::new(), now: 0.0, exchange };
    link.driver.fix_rate(true);
    link.driver.open(link.now);
    let said = link.visit(may_drive);
    link.driver.leave(link.now);
    (link.exchange)(&link.driver.take_tx(), &mut Vec::new())?;
    said
}

struct Link<'a> {
    driver: Driver,
    now: f64,
    exchange: Exchange<'a>,
}

impl Link<'_> {
    fn visit(&mut self, may_drive: bool) -> Result<String, Box<dyn Error>> {
        let before = self.until(|driver, _| driver.readings().is_some())?;
        let (charge, volts) = (before.charge_left_mah(), f64::from(before.voltage_mv) / 1000.0);
        let mut said = format!("battery {charge} mAh, {volts:.1} V\n{:?}\ncliffs {:?}\n", before.bumps, before.cliff);
        if may_drive {
            self.driver.put_in(self.now, Mode::Safe);
            self.until(|driver, _| driver.is_armed())?;
            let end = self.now + 1.0;
            // The driver stops a robot whose speeds aren't renewed.
            self.until(|driver, now| {
                driver.drive(now, Drive::wheels(0.1, 0.1));
                now > end || driver.readings().is_some_and(|now| now.bumps.bump_left || now.bumps.bump_right)
            })?;
            self.driver.stop(self.now);
            let after = self.until(|_, now| now > end + 0.5)?;
            let counts = f64::from(encoder_delta(before.left_counts, after.left_counts));
            let metres = counts / model("roomba600").ok_or("no such robot")?.counts_per_metre;
            let _ = writeln!(said, "drove {:.0} mm", 1000.0 * metres);
        }
        Ok(said)
    }

    /// Exchanges bytes until `is_done` holds, for 10 s at most.
    fn until(&mut self, is_done: impl Fn(&mut Driver, f64) -> bool) -> Result<Readings, Box<dyn Error>> {
        let (began, mut received) = (self.now, Vec::new());
        while !is_done(&mut self.driver, self.now) {
            if self.now > began + 10.0 {
                let finding = self.driver.diagnosis().finding;
                let remedy = self.driver.dropped().map_or(finding.remedy(), |lost| lost.remedy());
                return Err(format!("{} {remedy}", finding.text()).into());
            }
            self.driver.tick(self.now);
            // The baud rate is fixed, and the BRC wire is left alone: press CLEAN to wake the robot.
            while self.driver.take_line().is_some() {}
            received.clear();
            self.now = (self.exchange)(&self.driver.take_tx(), &mut received)?;
            let mut rest = received.as_slice();
            while !rest.is_empty() {
                rest = &rest[self.driver.feed(self.now, rest)..];
            }
        }
        Ok(self.driver.readings().cloned().unwrap_or_default())
    }
}
