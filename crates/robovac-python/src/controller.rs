//! Behaviours written in Python.

use crate::failure::Failure;
use pyo3::prelude::*;
use robovac_core::robot::{Drive, SensorReadings};
use robovac_sim::controller::Controller;
use std::sync::{Arc, Mutex, PoisonError};

/// One reading of all sensors, as the Open Interface reports it.
#[pyclass(frozen, get_all, module = "robovac._native")]
pub struct Sensed {
    bump_left: bool,
    bump_right: bool,
    wheel_drop_left: bool,
    wheel_drop_right: bool,
    cliff: [bool; 4],
    cliff_signal: [u16; 4],
    wall: bool,
    wall_signal: u16,
    virtual_wall: bool,
    light_bumper: [bool; 6],
    light_signal: [u16; 6],
    dirt: u8,
    infrared: [u8; 3],
    left_counts: u16,
    right_counts: u16,
    distance_mm: Option<i16>,
    angle_deg: Option<i16>,
    stasis: bool,
    overcurrent: [bool; 2],
    charge_mah: u16,
    capacity_mah: u16,
    voltage_mv: u16,
    current_ma: i16,
    on_dock: bool,
}

#[pymethods]
impl Sensed {
    #[getter]
    fn bumped(&self) -> bool {
        self.bump_left || self.bump_right
    }

    #[getter]
    fn sees_cliff(&self) -> bool {
        self.cliff.contains(&true)
    }

    /// Readings with given values, for trying a behaviour; the others are those of a robot on free floor.
    #[new]
    #[pyo3(signature = (*, bump_left=false, bump_right=false, wheel_drop=false, cliff=[false; 4], light_signal=[0; 6], left_counts=0, right_counts=0, charge_mah=2696))]
    fn new(
        bump_left: bool,
        bump_right: bool,
        wheel_drop: bool,
        cliff: [bool; 4],
        light_signal: [u16; 6],
        left_counts: u16,
        right_counts: u16,
        charge_mah: u16,
    ) -> Self {
        let mut sensed = SensorReadings {
            bump_left,
            bump_right,
            cliff,
            light_signal,
            left_counts,
            right_counts,
            ..SensorReadings::default()
        };
        (sensed.wheel_drop_left, sensed.wheel_drop_right) = (wheel_drop, wheel_drop);
        sensed.battery.charge_mah = charge_mah;
        sensed.battery.capacity_mah = 2696;
        Self::of(&sensed)
    }
}

impl Sensed {
    fn of(sensed: &SensorReadings) -> Self {
        let SensorReadings { infrared, overcurrent, battery, .. } = sensed;
        Self {
            bump_left: sensed.bump_left,
            bump_right: sensed.bump_right,
            wheel_drop_left: sensed.wheel_drop_left,
            wheel_drop_right: sensed.wheel_drop_right,
            cliff: sensed.cliff,
            cliff_signal: sensed.cliff_signal,
            wall: sensed.wall,
            wall_signal: sensed.wall_signal,
            virtual_wall: sensed.virtual_wall,
            light_bumper: sensed.light_bumper,
            light_signal: sensed.light_signal,
            dirt: sensed.dirt,
            infrared: [infrared.omni, infrared.left, infrared.right],
            left_counts: sensed.left_counts,
            right_counts: sensed.right_counts,
            distance_mm: sensed.moved.map(|moved| moved.distance_mm),
            angle_deg: sensed.moved.map(|moved| moved.angle_deg),
            stasis: sensed.stasis,
            overcurrent: [overcurrent.left_wheel, overcurrent.right_wheel],
            charge_mah: battery.charge_mah,
            capacity_mah: battery.capacity_mah,
            voltage_mv: battery.voltage_mv,
            current_ma: battery.current_ma,
            on_dock: battery.on_dock,
        }
    }
}

/// What went wrong in a behaviour, if anything did.
pub type BehaviourFault = Arc<Mutex<Option<PyErr>>>;

/// A behaviour: an object with `step(sensed, dt_s)`, which returns speeds of the left and right wheel in m/s, or `None` once
/// it is done.
pub struct PythonController {
    behaviour: Py<PyAny>,
    name: String,
    is_done: bool,
    fault: BehaviourFault,
}

impl PythonController {
    /// Drives by `behaviour`, called `name` in messages.
    pub fn new(behaviour: Py<PyAny>, name: String) -> Self {
        Self { behaviour, name, is_done: false, fault: BehaviourFault::default() }
    }

    /// The place for its fault.
    pub fn fault(&self) -> BehaviourFault {
        Arc::clone(&self.fault)
    }

    fn ask(&self, sensed: &SensorReadings, dt_s: f64) -> PyResult<Option<Drive>> {
        Python::attach(|py| {
            let answer = self.behaviour.bind(py).call_method1("step", (Sensed::of(sensed), dt_s))?;
            if answer.is_none() {
                return Ok(None);
            }
            let broken = |what: String| {
                let rule =
                    "step(sensed, dt_s) must return the speeds of the left and right wheel in m/s, or None to end";
                PyErr::from(Failure::contract(format!("behaviour \"{}\": {rule}; it returned {what}", self.name)))
            };
            let repr = || answer.repr().map_or_else(|_| "something else".to_owned(), |text| text.to_string());
            let [left, right] = answer.extract::<[f64; 2]>().map_err(|_| broken(repr()))?;
            if !(left.is_finite() && right.is_finite()) {
                return Err(broken(repr()));
            }
            Ok(Some(Drive::wheels(left, right)))
        })
    }
}

impl Controller for PythonController {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if self.is_done {
            return Drive::STOP;
        }
        match self.ask(sensed, dt_s) {
            Ok(Some(drive)) => return drive,
            Ok(None) => {}
            Err(error) => *self.fault.lock().unwrap_or_else(PoisonError::into_inner) = Some(error),
        }
        self.is_done = true;
        Drive::STOP
    }

    fn is_done(&self) -> bool {
        self.is_done
    }

    fn activity(&self) -> &'static str {
        "driving by Python"
    }

    // Runs from Python have no key frames; a copy would share the state of the object.
    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(Self {
            behaviour: Python::attach(|py| self.behaviour.clone_ref(py)),
            name: self.name.clone(),
            is_done: self.is_done,
            fault: self.fault(),
        })
    }
}
