//! Watches whether the page that drives a robot still responds.

/// The page sends a sign of life every 40 ms. After a silence of this length, s, the robot begins to slow down.
const QUICK_S: f64 = 0.08;
/// Silence after which the robot stands still, s.
const STILL_S: f64 = 0.15;
/// Silence after which the page counts as hung and loses control, s: the least, and the most that a slow page gets.
const HUNG_S: (f64, f64) = (0.4, 1.0);
/// A slow page gets this many times its longest recent silence.
const PATIENCE: f64 = 2.0;
/// Time in which a silence is forgotten, s.
const MEMORY_S: f64 = 10.0;
/// Share of its speed that a robot keeps while its page is slow.
const SLOW_SHARE: f64 = 0.5;
/// A slow page is told about once it has been slow for this long, s: a single late sign of life, as at the start of a
/// program, is over before one has read that.
const TOLD_AFTER_S: f64 = 2.0;
/// Longest step of time that counts as the page's silence, s. Whoever watches can be held up, too, and then finds the signs
/// of life only later.
const LONGEST_STEP_S: f64 = 0.1;

/// What the page's signs of life allow. A page that is slow, as on a busy computer, slows the robot down; one that hangs
/// stops it.
#[derive(Debug, Clone, Default)]
pub(super) struct PageWatch {
    /// Time of the latest step, s.
    now: f64,
    /// Time of the latest sign of life, s.
    heard_at: f64,
    /// Silence since then, s.
    silent_s: f64,
    /// Longest recent silence, s.
    slowest_s: f64,
    /// Since when the page has been slow.
    slow_since: Option<f64>,
    /// The robot was stopped for another reason, and no sign of life has come since: whether the page hangs, too, isn't known.
    is_awaited: bool,
}

impl PageWatch {
    /// Begins to watch a page that responds.
    pub fn start(&mut self, now: f64) {
        *self = Self { now, heard_at: now, ..Self::default() };
    }

    /// The page has shown a sign of life at `at`, which may have taken a while to arrive.
    pub fn heard(&mut self, at: f64) {
        let gap = (at - self.heard_at).max(0.0);
        self.slowest_s -= self.slowest_s * (gap / MEMORY_S).min(1.0);
        // A page that was hidden or hung has lost control; that doesn't make it a slow one.
        if gap <= HUNG_S.1 {
            self.slowest_s = self.slowest_s.max(gap);
        }
        self.is_awaited = false;
        self.heard_at = self.heard_at.max(at);
        self.silent_s = (self.now - self.heard_at).clamp(0.0, self.silent_s);
    }

    /// The robot was stopped for another reason; the next sign of life says that the page is there.
    pub fn await_sign(&mut self) {
        self.is_awaited = true;
    }

    /// The page has lost control.
    pub fn forgo(&mut self) {
        self.is_awaited = false;
    }

    /// Whether a sign of life is due since the robot was stopped for another reason.
    pub fn is_awaited(&self) -> bool {
        self.is_awaited
    }

    /// Lets time pass until `now`.
    pub fn tick(&mut self, now: f64) {
        self.silent_s += (now - self.now).clamp(0.0, LONGEST_STEP_S);
        self.now = now;
        self.slow_since = if self.is_slow() { self.slow_since.or(Some(now)) } else { None };
    }

    /// Whether the page has been slow for so long that the user should know.
    pub fn stays_slow(&self) -> bool {
        self.slow_since.is_some_and(|since| self.now - since > TOLD_AFTER_S)
    }

    /// Whether the page was silent for so long recently that the robot stood still.
    pub fn is_slow(&self) -> bool {
        self.slowest_s > STILL_S
    }

    /// Share of its speed that the robot may have, 0 to 1.
    pub fn share(&self) -> f64 {
        let most = if self.is_slow() { SLOW_SHARE } else { 1.0 };
        ((STILL_S - self.silent_s) / (STILL_S - QUICK_S)).clamp(0.0, most)
    }

    /// Whether the page hangs.
    pub fn hangs(&self) -> bool {
        self.silent_s > (PATIENCE * self.slowest_s).clamp(HUNG_S.0, HUNG_S.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lets `seconds` pass in steps of 10 ms, with a sign of life every `every` seconds; returns the smallest share.
    fn pass(watch: &mut PageWatch, seconds: f64, every: f64) -> f64 {
        let end = watch.now + seconds;
        let mut least = f64::INFINITY;
        while watch.now < end {
            let now = watch.now + 0.01;
            watch.tick(now);
            if now - watch.heard_at >= every {
                watch.heard(now);
            }
            least = least.min(watch.share());
        }
        least
    }

    #[test]
    fn quick_page_never_slows_the_robot() {
        let mut watch = PageWatch::default();
        assert_eq!(pass(&mut watch, 20.0, 0.04), 1.0);
        assert!(!watch.is_slow());
    }

    #[test]
    fn hanging_page_slows_the_robot_then_stops_it_then_loses_control() {
        let mut watch = PageWatch::default();
        pass(&mut watch, 1.0, 0.04);
        let half = pass(&mut watch, 0.07, f64::INFINITY);
        assert!(half > 0.0 && half < 1.0, "{half}");
        assert_eq!(pass(&mut watch, 0.12, f64::INFINITY), 0.0);
        assert!(!watch.hangs());
        pass(&mut watch, 0.3, f64::INFINITY);
        assert!(watch.hangs());
    }

    #[test]
    fn slow_page_keeps_control_at_half_the_speed() {
        let mut watch = PageWatch::default();
        pass(&mut watch, 5.0, 0.3);
        assert!(watch.is_slow() && watch.stays_slow() && !watch.hangs());
        watch.heard(watch.now);
        assert_eq!(watch.share(), SLOW_SHARE);
        // Twice its usual silence isn't a hang, but a second is.
        pass(&mut watch, 0.5, f64::INFINITY);
        assert!(!watch.hangs());
        pass(&mut watch, 0.6, f64::INFINITY);
        assert!(watch.hangs());
    }

    #[test]
    fn a_single_late_sign_of_life_is_not_told() {
        let mut watch = PageWatch::default();
        pass(&mut watch, 1.0, 0.04);
        pass(&mut watch, 0.16, f64::INFINITY);
        watch.heard(watch.now);
        assert!(watch.is_slow());
        for _ in 0..20 {
            pass(&mut watch, 0.2, 0.04);
            assert!(!watch.stays_slow());
        }
    }

    #[test]
    fn slow_times_are_forgotten() {
        let mut watch = PageWatch::default();
        pass(&mut watch, 5.0, 0.3);
        pass(&mut watch, 20.0, 0.04);
        assert!(!watch.is_slow());
        assert_eq!(pass(&mut watch, 1.0, 0.04), 1.0);
    }

    #[test]
    fn silence_of_who_watches_is_not_the_page_s() {
        let mut watch = PageWatch::default();
        pass(&mut watch, 1.0, 0.04);
        watch.tick(watch.now + 2.0);
        assert!(!watch.hangs());
        // The signs of life that waited meanwhile.
        watch.heard(watch.now - 0.02);
        assert_eq!(watch.share(), 1.0);
    }
}
