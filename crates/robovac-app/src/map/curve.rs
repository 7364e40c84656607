//! Map quality over time.

/// Most samples kept; beyond that every second one is dropped.
const MOST: usize = 600;
/// Initial simulated time between samples, steps: three seconds.
const FIRST_STRIDE: u64 = 200;

/// The figures at one moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveSample {
    /// Simulated time, s.
    pub time_s: f64,
    /// Share of the boundary that is on the map.
    pub boundary: f64,
    /// Distance between the estimated and the true position, m; `None` while there is no estimate.
    pub position_m: Option<f64>,
    /// The same by odometry alone, m.
    pub odometry_m: Option<f64>,
    /// The same share and distance of the thesis' grid, if it is made.
    pub thesis: Option<(f64, Option<f64>)>,
}

/// Samples of a run up to where it was simulated.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    samples: Vec<CurveSample>,
    stride: u64,
    next: u64,
}

impl Curve {
    pub fn new() -> Self {
        Self { samples: Vec::new(), stride: FIRST_STRIDE, next: 0 }
    }

    /// Steps after which the next sample is due.
    pub fn due(&self) -> u64 {
        self.next
    }

    pub fn add(&mut self, steps: u64, sample: CurveSample) {
        self.samples.push(sample);
        self.next = steps + self.stride;
        if self.samples.len() > MOST {
            let mut index = 0;
            self.samples.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.stride *= 2;
        }
    }

    /// Drops the samples after `time_s`, when `steps` had been taken, as the run will continue differently.
    pub fn cut(&mut self, steps: u64, time_s: f64) {
        self.samples.retain(|sample| sample.time_s <= time_s);
        self.next = self.next.min(steps + self.stride);
    }

    pub fn samples(&self) -> &[CurveSample] {
        &self.samples
    }
}
