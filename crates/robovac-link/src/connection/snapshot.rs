//! Builds the view model of a connection.

use super::{
    Calibrating, Connection, ConnectionActions, ConnectionView, DiagnosisView, DriveSessionView, DropView, LightsView,
    SLEEP_S, Statistics,
};
use crate::{
    dashboard::RoombaView,
    driver::{ConnectionPhase, Step},
};
use roomba_oi::Mode;

impl Connection {
    /// The snapshot for the page.
    pub fn view(&mut self, now: f64) -> ConnectionView {
        let driver = &self.driver;
        let pose = self.odometry.pose();
        let (right, left) = driver.wheels().sent();
        let metres = |mm: i16| f64::from(mm) / 1000.0;
        let readings = driver.readings();
        let on_charger = readings.is_some_and(|r| r.chargers.byte() != 0);
        let since = |wanted: fn(Mode) -> bool| {
            self.mode
                .filter(|&(mode, _)| wanted(mode) && driver.phase() == ConnectionPhase::Connected)
                .map(|(_, at)| now - at)
        };
        let is_present = matches!(driver.phase(), ConnectionPhase::Connected | ConnectionPhase::Lost);
        let is_moving = self.is_moving();
        let view = ConnectionView {
            phase: match driver.phase() {
                ConnectionPhase::Closed => "closed",
                ConnectionPhase::Diagnosing => "diagnosing",
                ConnectionPhase::Waiting => "waiting",
                ConnectionPhase::Connected => "connected",
                ConnectionPhase::Lost => "lost",
            },
            diagnosis: self.diagnosis(),
            mode: match driver.mode().filter(|_| is_present) {
                None => "",
                Some(Mode::Off) => "Off",
                Some(Mode::Passive) => "Passive",
                Some(Mode::Safe) => "Safe",
                Some(Mode::Full) => "Full",
            },
            mode_offset: driver.mode_offset() > 0,
            ride: self.ride_view(),
            readings: readings.filter(|_| is_present).map(RoombaView::new),
            pose: [pose.x, pose.y, pose.heading],
            odometry: self.odometry_model.id(),
            distance_m: self.distance_m,
            motors: driver.actuators().motors.byte(),
            duty: driver.actuators().duty,
            lights: self.lights(),
            wheels: [metres(left), metres(right)],
            is_moving,
            is_slowed: self.rides() && self.page.stays_slow(),
            moves_alone: !is_moving && self.wheel_watch.moves_alone(now),
            transport: self.transport.clone(),
            statistics: self.statistics(now),
            sleeps_in_s: since(|m| m == Mode::Passive).filter(|_| !on_charger).map(|s| (SLEEP_S - s).max(0.0)),
            awake_s: since(|m| m > Mode::Passive).filter(|_| !self.transport.is_watching),
            drop: driver.dropped().map(|drop| DropView {
                from: if drop.from == Mode::Full { "Full" } else { "Safe" },
                text: drop.to_string(),
                remedy: drop.remedy().to_owned(),
                can_rearm: self.can().arm && !(drop.is_lasting() && on_charger),
            }),
            calibration: Calibrating::view(self.calibrating.as_ref(), &self.known),
            firmware: driver.firmware().map(ToOwned::to_owned),
            notice: self.notice.clone(),
            can: self.can(),
            ..ConnectionView::default()
        };
        view.captioned()
    }

    fn lights(&self) -> LightsView {
        let actuators = self.driver.actuators();
        LightsView {
            lamps: actuators.lamps.byte(),
            clean_light: actuators.clean_light,
            digits: actuators.digits.map(char::from).iter().collect(),
            weekdays: actuators.weekdays.byte(),
            schedule: actuators.schedule.byte(),
        }
    }

    fn diagnosis(&self) -> DiagnosisView {
        let diagnosis = self.driver.diagnosis();
        let step = match (diagnosis.step, self.driver.baud()) {
            (Step::Idle, _) => "",
            (Step::Listening, _) => "listening",
            (Step::Waking, _) => "waking",
            (Step::Subscribing | Step::Done, _) => "done",
            (Step::Waiting, _) => "waiting",
            (Step::Asking | Step::Changing, 19_200) => "slow",
            (Step::Asking | Step::Changing, 57_600) => "create1",
            (Step::Asking | Step::Changing, _) => "asking",
        };
        DiagnosisView {
            step,
            finding: diagnosis.finding.id(),
            text: diagnosis.finding.text().to_owned(),
            remedy: diagnosis.finding.remedy().to_owned(),
            log: diagnosis.log.clone(),
            ..DiagnosisView::default()
        }
    }

    fn ride_view(&self) -> Option<DriveSessionView> {
        let ride = self.ride.as_ref()?;
        let blocked = ride.controller.blocked().map_or([None; 4], |b| [b.forward, b.left, b.right, b.backward]);
        Some(DriveSessionView {
            title: ride.title.clone(),
            activity: ride.controller.activity(),
            time_s: ride.time_s,
            manual: ride.is_manual,
            blocked,
            corner: ride.controller.corner(),
            done: ride.is_done,
            ended: ride.ended.clone(),
        })
    }

    fn statistics(&self, now: f64) -> Statistics {
        let (driver, counts) = (&self.driver, self.driver.counts());
        let implausible = driver.implausible();
        Statistics {
            baud: driver.baud(),
            frames: counts.frames.saturating_sub(implausible),
            bad_checksums: counts.bad_checksums,
            false_headers: counts.false_headers,
            implausible,
            late: driver.late(),
            texts: counts.texts,
            noise: counts.noise,
            bytes: driver.bytes(),
            rate_hz: driver.link_stats().rate_hz(now),
            age_ms: driver.link_stats().last().map_or(0.0, |at| 1e3 * (now - at)),
            latency_ms: driver.link_stats().round_trip_s().map(|s| 1e3 * s),
            longest_gap_ms: 1e3 * driver.link_stats().longest_gap_s(),
            slot: driver.slot(),
        }
    }

    pub(super) fn can(&self) -> ConnectionActions {
        let phase = self.driver.phase();
        let is_connected = phase == ConnectionPhase::Connected;
        let reaches = is_connected && !self.transport.is_watching;
        let drive = self.driver.is_armed() && !self.driver.is_stalled();
        let is_asking = self.calibrating.as_ref().is_some_and(Calibrating::is_asking);
        ConnectionActions {
            connect: matches!(phase, ConnectionPhase::Waiting | ConnectionPhase::Diagnosing),
            disconnect: phase != ConnectionPhase::Closed,
            arm: reaches && !self.driver.is_armed(),
            disarm: is_connected && self.driver.target() > Mode::Passive,
            drive,
            steer: drive && self.ride.as_ref().is_none_or(|ride| ride.is_done || ride.is_manual),
            ride: drive && !self.is_moving() && !is_asking,
            press: reaches,
        }
    }
}
