//! User requests to a robot, executed or refused.

use super::{
    Calibrated, Calibrating, Calibration, Connection, FloorMeasure, RecordedEvent, Request, RequestRefused, refuse,
};
use robovac_core::registry::Params;
use robovac_sim::controller::{self, Joystick as Stick, Setup};
use roomba_oi::{Command, CommandRefusal, Lamps, Mode, Motors, ScheduleLamps, Weekdays};

/// Most bytes of a raw command.
pub(super) const MOST_RAW: usize = 256;

fn invalid(refusal: CommandRefusal) -> RequestRefused {
    RequestRefused(format!("Invalid command: {refusal}."))
}

impl Connection {
    /// Executes a request, or returns why it is refused.
    pub fn request(&mut self, now: f64, request: Request) -> Result<(), RequestRefused> {
        self.now = now;
        if !matches!(request, Request::Drive { .. } | Request::DrivePwm { .. }) {
            let json = serde_json::to_string(&request).unwrap_or_default();
            self.recorder.note(now, RecordedEvent::Asked(json));
        }
        let done = self.serve(now, request);
        self.listen();
        done
    }

    fn serve(&mut self, now: f64, request: Request) -> Result<(), RequestRefused> {
        let can = self.can();
        let sorry = |allowed: bool, why: &str| if allowed { Ok(()) } else { refuse(why) };
        if self.transport.is_watching && request.is_for_robot() {
            return refuse(
                "Another client of the bridge drives this robot. You can watch and stop it, and drive when that client has left.",
            );
        }
        let in_control = || sorry(can.drive, "Take control of the robot first.");
        match request {
            Request::Connect => {
                sorry(can.connect, "There is no connection to a robot. Choose one first.")?;
                self.end_ride("The connection was reopened.");
                self.driver.open_again(now);
                self.place(self.odometry.pose());
            }
            Request::Disconnect => {
                self.end_ride("Disconnected.");
                // Whoever connects then begins anew.
                (self.ride, self.distance_m) = (None, 0.0);
                self.driver.leave(now);
                // The next one may be another robot.
                (self.known, self.calibrating) = (Calibrated::default(), None);
                (self.is_old, self.is_older) = (false, false);
                self.use_known();
            }
            Request::Arm { full } => {
                sorry(can.arm, "No robot that can be controlled is connected.")?;
                self.page.heard(now);
                self.driver.put_in(now, if full { Mode::Full } else { Mode::Safe });
            }
            Request::Disarm => {
                sorry(can.disarm, "The robot isn't under control.")?;
                self.end_ride("Control was released.");
                self.driver.put_in(now, Mode::Passive);
            }
            Request::Stop if self.transport.is_watching => {
                self.driver.stop_other();
                let text = "A stop was sent to the bridge. Whoever drives the robot has to take control again.";
                self.say("notice", text.to_owned());
            }
            Request::Stop => {
                self.end_ride("Stopped by the user.");
                self.driver.freeze(now);
            }
            Request::Drive { forward, left } => {
                in_control()?;
                self.nothing_asked()?;
                self.steer(now, Stick { forward, left })?;
            }
            Request::Press { button } => {
                sorry(can.press, "No robot is connected.")?;
                self.end_ride("A button was pressed.");
                self.driver.press(now, button.command());
            }
            Request::Raw { bytes } => {
                sorry(can.press, "No robot is connected.")?;
                if bytes.is_empty() || bytes.len() > MOST_RAW {
                    return refuse(format!(
                        "1 to {MOST_RAW} bytes can be sent at once, but there are {}.",
                        bytes.len()
                    ));
                }
                self.end_ride("Raw bytes were sent.");
                self.page.heard(now);
                self.driver.send_raw(now, &bytes).map_err(|e| RequestRefused(e.to_string()))?;
            }
            Request::Song { .. }
            | Request::Leds { .. }
            | Request::Digits { .. }
            | Request::ScheduleLeds { .. }
            | Request::Motors { .. }
            | Request::PwmMotors { .. } => {
                in_control()?;
                self.actuate(now, &request)?;
            }
            Request::DrivePwm { right, left } => {
                in_control()?;
                self.nothing_asked()?;
                self.end_ride("Another action started.");
                self.driver.drive_by_power(now, right, left).map_err(invalid)?;
            }
            Request::Clock { day, hour, minute } => {
                sorry(can.press, "No robot is connected.")?;
                self.send(now, Command::DayTime { day, time: [hour, minute] })?;
            }
            Request::Schedule { days, times } => {
                sorry(can.press, "No robot is connected.")?;
                self.send(now, Command::Schedule { days: Weekdays::from_byte(days), times })?;
            }
            Request::Calibrate { .. }
            | Request::Answer { .. }
            | Request::Skip
            | Request::UseCalibration { .. }
            | Request::Odometry { .. } => self.reckon(now, &request)?,
            Request::Identify => {
                sorry(can.press, "No robot is connected.")?;
                self.end_ride("The robot was restarted.");
                self.driver.restart(now);
                self.place(self.odometry.pose());
            }
        }
        Ok(())
    }

    /// Requests that set the pose and its odometry.
    fn reckon(&mut self, now: f64, request: &Request) -> Result<(), RequestRefused> {
        match *request {
            Request::Calibrate { what } => {
                if !self.can().drive {
                    return refuse("Take control of the robot first.");
                }
                self.nothing_asked()?;
                if what == Calibration::Nudge && self.driver.is_older() {
                    return refuse("This robot has no encoders that could be swapped. Use Spin and Metre.");
                }
                let began =
                    self.encoders().ok_or_else(|| RequestRefused("No encoder readings yet. Wait a moment.".into()))?;
                let controller = what.controller(&self.known.apply(&self.model));
                self.set_off(now, what.title(), Box::new(controller), self.odometry.pose(), false);
                let measure = self.truth.map(|truth| FloorMeasure::new(truth, self.odometry.pose()));
                self.calibrating = Some(Calibrating::new(what, began, measure));
            }
            Request::Answer { .. } | Request::UseCalibration { .. } if self.is_acting() => {
                return refuse("Stop the robot first: the running program uses its calibration.");
            }
            Request::Odometry { .. } if self.is_acting() => {
                return refuse("Stop the robot first: the running program uses its odometry.");
            }
            Request::Odometry { model } => {
                self.odometry_model = model;
                self.driver.tell_moved(now, model.is_by_packets());
                self.place(self.odometry.pose());
            }
            Request::Answer { value } => {
                let Some(calibrating) = self.calibrating.as_mut().filter(|c| c.is_asking()) else {
                    return refuse("There is no question to answer.");
                };
                calibrating.answer(value, &mut self.known).map_err(RequestRefused)?;
                self.use_known();
            }
            Request::Skip => {
                let Some(calibrating) = self.calibrating.as_mut().filter(|c| c.is_asking()) else {
                    return refuse("There is no question to answer.");
                };
                calibrating.fail("Skipped; nothing has changed.");
            }
            Request::UseCalibration { swapped, distance_factor, base_factor } => {
                let known = Calibrated { swapped, distance_factor, base_factor };
                if !known.is_sound() {
                    return refuse("The stored calibration is out of range. Calibrate again.");
                }
                self.known = known;
                self.use_known();
            }
            _ => {}
        }
        Ok(())
    }

    /// Sounds, lights and brushes.
    fn actuate(&mut self, now: f64, request: &Request) -> Result<(), RequestRefused> {
        match *request {
            Request::Song { number, ref notes } => {
                self.send(now, Command::Song { number, notes })?;
                self.send(now, Command::Play { number })?;
            }
            Request::Leds { lamps, colour, intensity } => {
                self.send(now, Command::Leds { lamps: Lamps::from_byte(lamps), colour, intensity })?;
            }
            Request::Digits { ref text } => {
                let command = Command::digits(text).map_err(|e| RequestRefused(format!("{e}.")))?;
                self.send(now, command)?;
            }
            Request::ScheduleLeds { weekdays, lamps } => {
                let (weekdays, lamps) = (Weekdays::from_byte(weekdays), ScheduleLamps::from_byte(lamps));
                self.send(now, Command::SchedulingLeds { weekdays, lamps })?;
            }
            Request::Motors { bits } => {
                self.send(now, Command::Motors(Motors::from_byte(bits)))?;
                self.page.heard(now);
            }
            Request::PwmMotors { main_brush, side_brush, vacuum } => {
                self.send(now, Command::PwmMotors { main_brush, side_brush, vacuum })?;
                self.page.heard(now);
            }
            _ => {}
        }
        Ok(())
    }

    pub(super) fn send(&mut self, now: f64, command: Command<'_>) -> Result<(), RequestRefused> {
        self.driver.send(now, command).map_err(invalid)
    }

    /// Drives by hand.
    fn steer(&mut self, now: f64, stick: Stick) -> Result<(), RequestRefused> {
        // It is no sign of life: it can have waited for long. Those say when they were sent.
        self.stick_at = now;
        if self.ride.as_ref().is_none_or(|ride| !ride.is_manual || ride.is_done) {
            let manual = controller::find("manual")
                .ok_or_else(|| RequestRefused("The manual mode is missing from this build.".into()))?;
            let params = Params::defaults(manual.params);
            let robot = self.known.apply(&self.model);
            let controller = manual.build(&Setup { robot: &robot, params: &params, seed: 0 });
            let controller =
                controller.ok_or_else(|| RequestRefused("The manual mode is missing from this build.".into()))?;
            let pose = self.odometry.pose();
            self.set_off(now, manual.title, controller, pose, true);
        }
        if let Some(ride) = &mut self.ride {
            ride.controller.command(stick);
        }
        Ok(())
    }
}
