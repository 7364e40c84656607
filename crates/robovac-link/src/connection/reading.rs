//! Handling of a new sensor reading.

use super::{Calibrating, Connection, LEFT_ALONE_S, MOST_TRACE, ODD_COUNTS, STICK_S, SWEEPS};
use crate::recording::{LineEvent, RecordedReading};
use robovac_core::robot::{Drive, RobotPort, SensorReadings};
use robovac_sim::controller::{Joystick as Stick, drive_on};
use roomba_oi::motion::encoder_delta;

impl Connection {
    /// Processes a new reading.
    pub(super) fn reading(&mut self, now: f64, dt_s: f64) {
        let sensed = self.driver.port(now).sensors().clone();
        let before = self.odometry.pose();
        self.odometry.update(&sensed);
        let pose = self.odometry.pose();
        self.distance_m += (pose.position() - before.position()).norm();
        if let Some(watched) = &mut self.watched {
            let reading = RecordedReading {
                readings: self.driver.readings().cloned().unwrap_or_default(),
                contained: self.driver.contained(),
                mode: self.driver.mode(),
                loss: self.driver.dropped().cloned(),
                pose,
                distance_m: self.distance_m,
                dt_s,
            };
            watched.push((now, LineEvent::Reading(Box::new(reading))));
        }
        if self.trace.len() < MOST_TRACE {
            let sweeps = if self.sweeps() { SWEEPS } else { 0 };
            self.trace.extend([pose.x, pose.y, pose.heading, f64::from(felt(&sensed) | sweeps)]);
        }
        let mode = self.driver.mode().unwrap_or_default();
        if self.mode.is_none_or(|(known, _)| known != mode) {
            self.mode = Some((mode, now));
        }
        self.mind_encoders(&sensed);
        self.wheel_watch.take(now, self.counts, self.is_moving());
        if self.driver.has_old_angle() && !std::mem::replace(&mut self.is_old, true) {
            self.say(
                "notice",
                "Packet 20 reports a third of every angle, as in firmware up to 3.4.0. This is corrected, but coarse; \
                 encoder counts are more accurate."
                    .to_owned(),
            );
        }
        if self.driver.is_older() && !std::mem::replace(&mut self.is_older, true) {
            self.say(
                "notice",
                "This robot reports what a Create 1 does: no encoder counts and no light bumper. Its position is less exact, \
                 and it notices walls only by touching them."
                    .to_owned(),
            );
        }
        let is_held = now - self.stick_at <= STICK_S;
        let Some(ride) = self.ride.as_mut().filter(|ride| !ride.is_done) else { return };
        if !self.driver.is_armed() {
            return;
        }
        if ride.is_manual && !is_held {
            ride.controller.command(Stick::default());
        }
        let is_left_alone = ride.is_manual && now - self.stick_at > LEFT_ALONE_S;
        ride.time_s += dt_s;
        let was_done = ride.controller.is_done();
        let mut port = SlowedPort { port: self.driver.port(now), share: self.page.share() };
        ride.is_done = !drive_on(&mut port, &mut *ride.controller, dt_s, |controller, drive| {
            // Otherwise it could back off from an edge long after it was left alone.
            was_done || controller.is_done() || (is_left_alone && drive.is_stop())
        });
        if ride.is_done {
            let cleans = ride.cleans;
            self.driver.stop(now);
            if cleans {
                self.driver.stop_brushes(now);
            }
            self.ride_ended();
        }
    }

    /// Checks that the encoders count in the direction of the wheels: a robot with swapped packets loses its pose at
    /// once.
    fn mind_encoders(&mut self, sensed: &SensorReadings) {
        let (right, left) = self.driver.wheels().sent();
        let counts = [sensed.left_counts, sensed.right_counts];
        let last = std::mem::replace(&mut self.counts, counts);
        if right.signum() * left.signum() >= 0
            || self.is_odd
            || self.calibrating.as_ref().is_some_and(Calibrating::is_moving)
        {
            self.turned = [0; 2];
            return;
        }
        for (sum, (before, now)) in self.turned.iter_mut().zip(last.into_iter().zip(counts)) {
            *sum += i32::from(encoder_delta(before, now)) * i32::from(right.signum());
        }
        // Turning to the left, the left wheel counts down and the right one up.
        if self.turned[0] > ODD_COUNTS && self.turned[1] < -ODD_COUNTS {
            self.is_odd = true;
            self.say(
                "notice",
                "The encoders count opposite to the commanded turn: they may be swapped, so the position on the map is \
                wrong. Calibrate with Nudge."
                    .to_owned(),
            );
        }
    }
}

/// A robot that gets only a share of the speeds that its controller commands.
struct SlowedPort<P> {
    port: P,
    share: f64,
}

impl<P: RobotPort> RobotPort for SlowedPort<P> {
    fn sensors(&self) -> &SensorReadings {
        self.port.sensors()
    }

    fn drive(&mut self, wanted: Drive) {
        let [left, right, lateral] = [wanted.left, wanted.right, wanted.lateral].map(|speed| self.share * speed);
        self.port.drive(Drive { left, right, lateral });
    }
}

/// The robot's contacts as bits.
fn felt(sensed: &SensorReadings) -> u16 {
    let [left, front_left, front_right, right] = sensed.cliff;
    let all = [
        sensed.bump_left,
        sensed.bump_right,
        left,
        front_left,
        front_right,
        right,
        sensed.wheel_dropped(),
        sensed.virtual_wall,
    ];
    all.iter().enumerate().map(|(bit, &is_set)| u16::from(is_set) << bit).sum()
}
