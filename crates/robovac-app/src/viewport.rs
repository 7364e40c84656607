//! Visible part of the world and its scale.

use robovac_core::geometry::{Point, Vector};

/// Space around the room when all of it is shown, CSS pixels: left, top, right, bottom. The page's tools float there.
const MARGINS: [f64; 4] = [24.0, 66.0, 24.0, 66.0];
/// Space around the room without floating tools, CSS pixels.
const BARE_MARGIN: f64 = 6.0;
/// Limits of pixels per metre.
const SCALES: std::ops::RangeInclusive<f64> = 0.5..=2000.0;
/// Width of the canvas below which the scale bar has no place between legend and zoom and stands above the zoom, CSS pixels.
const BESIDE_ZOOM: f64 = 626.0;
/// Width and height of the lower right corner in which it lies where nothing else does, CSS pixels.
const BARE_SCALE: (f64, f64) = (130.0, 32.0);
/// Size of the canvas below which there is none, CSS pixels.
const LEAST_WITH_SCALE: [f64; 2] = [240.0, 160.0];
/// No scale bar is longer, CSS pixels.
const LONGEST_SCALE: f64 = 130.0;
/// Width and height of the lower right corner with a scale bar above the zoom, CSS pixels.
const SCALE_CORNER: [f64; 2] = [120.0, 98.0];
/// Share of the canvas's height that messages, tools and zoom may take; the rest is left to the room.
const MOST_TOLD: f64 = 0.69;
/// Pixels of the room that stay in view when panning.
const KEPT: f64 = 60.0;

/// The window onto the world. The world's y points up, the screen's down; lengths on the screen are CSS pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewport {
    /// CSS pixels per metre.
    pub scale: f64,
    /// Screen position of the world's origin: CSS pixels from the left and from the top.
    pub origin: Vector,
    /// Width and height of the canvas, CSS pixels.
    pub size: Vector,
    /// Device pixels per CSS pixel.
    pub pixel_ratio: f64,
    /// Width and height of the room, m.
    room: Vector,
    /// Whether the whole room is kept in view when sizes change.
    fitted: bool,
    /// Whether no tools float over the canvas.
    is_bare: bool,
    /// Height of what floats at its bottom while the tools that float over it are hidden, CSS pixels.
    cleared: Option<f64>,
    /// Height of the page's message at the top that must not hide the room, CSS pixels.
    told: f64,
    /// Width and height of its lower right corner that must not hide the room either, CSS pixels.
    corner: Vector,
    /// The same of its lower left corner, where the legend is.
    legend: Vector,
}

impl Viewport {
    /// Shows all of a room.
    ///
    /// ```
    /// use robovac_app::Viewport;
    /// use robovac_core::geometry::Point;
    /// let view = Viewport::new(4.0, 3.0, 800.0, 600.0, 1.0);
    /// let middle = view.to_screen(Point::new(2.0, 1.5));
    /// assert_eq!(middle.x, 400.0);
    /// assert!((view.to_world(middle.x, middle.y) - Point::new(2.0, 1.5)).norm() < 1e-12);
    /// ```
    pub fn new(room_width: f64, room_height: f64, width: f64, height: f64, pixel_ratio: f64) -> Self {
        let mut view = Self {
            scale: 1.0,
            origin: Vector::zeros(),
            size: Vector::new(width, height),
            pixel_ratio,
            room: Vector::new(room_width, room_height),
            fitted: true,
            is_bare: false,
            cleared: None,
            told: 0.0,
            corner: Vector::zeros(),
            legend: Vector::zeros(),
        };
        view.fit();
        view
    }

    /// A window without floating tools, to be given its sizes.
    pub fn bare() -> Self {
        Self { is_bare: true, ..Self::new(1.0, 1.0, 1.0, 1.0, 1.0) }
    }

    /// Shows all of the room again.
    pub fn fit(&mut self) {
        let [left, top, right, mut bottom] = self.margins();
        let mut view = self.between([left, top, right, bottom]);
        let (size, mut corner, is_framed) = (self.size, self.corner, self.is_framed());
        let start = view.to_screen(Point::origin());
        if start.x < self.legend.x && start.y > size.y - self.legend.y {
            bottom = bottom.max(self.legend.y.min(MOST_TOLD * size.y - top));
            view = self.between([left, top, right, bottom]);
        }
        let is_above_zoom = is_framed || (self.cleared.is_none() && size.x < BESIDE_ZOOM);
        let has_scale = !self.is_bare && is_above_zoom && self.scale_bar().is_some();
        // Below the room that lies beside the corner is the scale bar.
        let below = if has_scale && corner.x > 0.0 && !is_framed { bottom.max(SCALE_CORNER[1]) } else { bottom };
        if has_scale {
            corner = corner.sup(&Vector::from(SCALE_CORNER));
        }
        let end = view.to_screen(Point::new(self.room.x, 0.0));
        if end.x > size.x - corner.x && end.y > size.y - corner.y {
            // Left of the corner or above it, whichever shows the room larger, but two fifths of the canvas are left to the room.
            let most = Vector::new(0.6 * size.x - left, 0.6 * size.y - top);
            let beside = self.between([left, top, right.max(corner.x.min(most.x)), below]);
            let above = self.between([left, top, right, bottom.max(corner.y.min(most.y))]);
            let (fits_beside, fits_above) = (corner.x <= most.x, corner.y <= most.y);
            let is_above = if fits_beside == fits_above { above.scale > beside.scale } else { fits_above };
            view = if is_above { above } else { beside };
        }
        *self = view;
        self.fitted = true;
    }

    /// Keeps the uppermost `told` CSS pixels free when the whole room is shown, the lower right `corner`, and the lower left one
    /// with the `legend`. While the tools that float over it are hidden, it is `cleared` but for so many at the bottom.
    pub fn keep_clear(&mut self, told: f64, cleared: Option<f64>, corner: Vector, legend: Vector) {
        let is_near = |a: Vector, b: Vector| (a - b).amax() < 0.5;
        let is_same = (told - self.told).abs() < 0.5 && is_near(corner, self.corner) && is_near(legend, self.legend);
        if is_same && cleared == self.cleared {
            return;
        }
        (self.told, self.cleared, self.corner, self.legend) = (told, cleared, corner, legend);
        if self.fitted {
            self.fit();
        }
    }

    /// Whether the whole room is shown.
    pub fn is_fitted(&self) -> bool {
        self.fitted
    }

    /// Takes the size of another room, in metres, and shows all of it.
    pub fn set_room(&mut self, width: f64, height: f64) {
        self.room = Vector::new(width, height);
        self.fit();
    }

    /// Takes the size of the canvas, CSS pixels, and its device pixels per CSS pixel; keeps the middle in place.
    pub fn resize(&mut self, width: f64, height: f64, pixel_ratio: f64) {
        let size = Vector::new(width.max(1.0), height.max(1.0));
        self.origin += 0.5 * (size - self.size);
        self.size = size;
        self.pixel_ratio = pixel_ratio.clamp(0.5, 4.0);
        if self.fitted {
            self.fit();
        } else {
            self.keep_in_view();
        }
    }

    /// Pans by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.origin += Vector::new(dx, dy);
        self.fitted = false;
        self.keep_in_view();
    }

    /// Zooms by `factor`, keeping the point under (`x`, `y`) in place.
    pub fn zoom_at(&mut self, x: f64, y: f64, factor: f64) {
        let scale = (self.scale * factor).clamp(*SCALES.start(), *SCALES.end());
        let fixed = Vector::new(x, y);
        self.origin = fixed + (self.origin - fixed) * (scale / self.scale);
        self.scale = scale;
        self.fitted = false;
        self.keep_in_view();
    }

    /// Where the scale bar ends, CSS pixels from the right and from the bottom; `None` if there is no place for it.
    pub fn scale_bar(&self) -> Option<[f64; 2]> {
        let [width, height] = LEAST_WITH_SCALE;
        let end = self.to_screen(Point::new(self.room.x, 0.0));
        // Of several small panes, each can do without.
        if self.is_bare && end.x > self.size.x - BARE_SCALE.0 && end.y > self.size.y - BARE_SCALE.1 {
            return None;
        }
        // It would lie under a joystick, or what is as wide as the canvas.
        if self.is_framed() && (self.corner.y > SCALE_CORNER[1] || self.corner.x > 0.9 * self.size.x) {
            return None;
        }
        let place = match self.size.x {
            _ if self.is_bare => [10.0, 10.0],
            // Left of what lies in the corner, or of the whole room on a low screen.
            x if x < BESIDE_ZOOM && self.corner.x > 0.0 && !self.is_framed() => {
                let start = self.to_screen(Point::origin()).x;
                let lies_on_room = end.x > x - self.corner.x - LONGEST_SCALE && end.y > self.size.y - SCALE_CORNER[1];
                let to_right =
                    if self.fitted && lies_on_room && start > LONGEST_SCALE { x - start + 10.0 } else { self.corner.x };
                [to_right, 72.0]
            }
            x if x < BESIDE_ZOOM || self.is_framed() => [20.0, 72.0],
            _ => [204.0, 24.0],
        };
        (self.size.x >= width && self.size.y >= height).then_some(place)
    }

    /// Whether only the zoom floats over it, in a small frame: the scale bar shares its corner.
    fn is_framed(&self) -> bool {
        self.cleared.is_some() && self.corner.x > 0.0
    }

    /// Screen position of a point of the world, CSS pixels from the upper left.
    #[inline]
    pub fn to_screen(&self, point: Point) -> Point {
        Point::new(self.origin.x + self.scale * point.x, self.origin.y - self.scale * point.y)
    }

    /// The point of the world at (`x`, `y`) CSS pixels from the upper left.
    pub fn to_world(&self, x: f64, y: f64) -> Point {
        Point::new((x - self.origin.x) / self.scale, (self.origin.y - y) / self.scale)
    }

    /// The same window for a frame whose origin lies at `origin` in this world, and whose unit has length `unit` here.
    pub fn onto(&self, origin: Point, unit: f64) -> Self {
        Self { origin: self.to_screen(origin).coords, scale: self.scale * unit, ..*self }
    }

    /// The visible part of the world: lower-left and upper-right corner.
    pub fn bounds(&self) -> (Point, Point) {
        (self.to_world(0.0, self.size.y), self.to_world(self.size.x, 0.0))
    }

    /// All of the room between `margins`.
    fn between(self, [left, top, right, bottom]: [f64; 4]) -> Self {
        let free = Vector::new(self.size.x - left - right, self.size.y - top - bottom);
        let scale = (free.x / self.room.x).min(free.y / self.room.y).clamp(*SCALES.start(), *SCALES.end());
        let middle = Vector::new(left + 0.5 * free.x, top + 0.5 * free.y);
        let origin = middle + 0.5 * scale * Vector::new(-self.room.x, self.room.y);
        Self { scale, origin, ..self }
    }

    /// The margins, reduced where the canvas is small.
    fn margins(&self) -> [f64; 4] {
        if self.is_bare {
            return [BARE_MARGIN; 4];
        }
        let shrink = |size: f64, enough: f64| (size / enough).clamp(0.1, 1.0);
        let (sideways, down) = (shrink(self.size.x, 480.0), shrink(self.size.y, 260.0));
        let [left, top, right, bottom] = MARGINS;
        let scaled = [left * sideways, top * down, right * sideways, bottom * down];
        let [left, top, right, bottom] = self.cleared.map_or(scaled, |foot| {
            // What is too low for a room and its foot shows the room.
            let foot = if foot < 0.2 * self.size.y { foot } else { 0.0 };
            [BARE_MARGIN, BARE_MARGIN, BARE_MARGIN, foot.max(BARE_MARGIN)]
        });
        [left, top.max(self.told.min(MOST_TOLD * self.size.y - bottom)), right, bottom]
    }

    /// Keeps some of the room in view.
    fn keep_in_view(&mut self) {
        let room = self.room * self.scale;
        // At most half of the canvas, so that the limits stay apart.
        let kept = self.size.map(|size| KEPT.min(0.5 * size));
        self.origin.x = self.origin.x.clamp(kept.x - room.x, self.size.x - kept.x);
        self.origin.y = self.origin.y.clamp(kept.y, self.size.y - kept.y + room.y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view() -> Viewport {
        Viewport::new(8.0, 6.0, 900.0, 700.0, 2.0)
    }

    #[test]
    fn y_points_up_in_the_world_and_down_on_the_screen() {
        let view = view();
        let (low, high) = (view.to_screen(Point::new(0.0, 0.0)), view.to_screen(Point::new(0.0, 6.0)));
        assert!(high.y < low.y);
        assert!(high.y >= 0.0 && low.y <= 700.0);
    }

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let mut view = view();
        let before = view.to_world(300.0, 200.0);
        view.zoom_at(300.0, 200.0, 1.7);
        assert!((view.to_world(300.0, 200.0) - before).norm() < 1e-9);
    }

    #[test]
    fn what_is_told_hides_nothing_of_a_room_that_is_shown_whole() {
        let mut view = view();
        let before = view;
        view.keep_clear(130.0, None, Vector::zeros(), Vector::zeros());
        assert!(view.to_screen(Point::new(0.0, 6.0)).y >= 130.0 - 1e-9);
        view.keep_clear(0.0, None, Vector::zeros(), Vector::zeros());
        assert_eq!(view.scale, before.scale);
        // The tallest card on a phone leaves the room three tenths of the canvas.
        let mut phone = Viewport::new(10.6, 8.4, 390.0, 452.0, 1.0);
        phone.keep_clear(245.7, None, Vector::zeros(), Vector::zeros());
        assert!(phone.to_screen(Point::new(0.0, 8.4)).y >= 245.7 - 1e-9 && phone.scale > 10.0);
        // Never more of it, and not when zoomed in.
        view.keep_clear(5000.0, None, Vector::zeros(), Vector::zeros());
        assert!(view.scale > 0.0 && view.to_screen(Point::new(0.0, 6.0)).y < 420.0);
        view.zoom_at(300.0, 200.0, 2.0);
        let zoomed = view;
        view.keep_clear(100.0, None, Vector::zeros(), Vector::zeros());
        assert_eq!((view.scale, view.origin), (zoomed.scale, zoomed.origin));
    }

    #[test]
    fn the_room_is_left_of_what_lies_in_the_corner_or_above_it() {
        for (width, height, corner) in [(900.0, 700.0, [220.0, 300.0]), (390.0, 480.0, [160.0, 260.0])] {
            let mut view = Viewport::new(8.0, 6.0, width, height, 1.0);
            let before = view;
            let corner = Vector::from(corner);
            view.keep_clear(0.0, None, corner, Vector::zeros());
            let end = view.to_screen(Point::new(8.0, 0.0));
            assert!(end.x <= width - corner.x + 1e-9 || end.y <= height - corner.y + 1e-9, "{end}");
            assert!(view.to_screen(Point::origin()).x >= 19.0 && view.scale > 0.5 * before.scale);
            view.keep_clear(0.0, None, Vector::zeros(), Vector::zeros());
            assert_eq!(view, before);
        }
        // A narrow room in a large window stays where it is.
        let mut view = Viewport::new(4.0, 8.0, 900.0, 700.0, 1.0);
        let before = view.origin;
        view.keep_clear(0.0, None, Vector::new(220.0, 300.0), Vector::zeros());
        assert_eq!(view.origin, before);
        // Never all of it.
        view.keep_clear(0.0, None, Vector::new(5000.0, 5000.0), Vector::zeros());
        assert!(view.scale > 0.0 && view.to_screen(Point::new(6.0, 0.0)).x > 0.0);
    }

    #[test]
    fn on_a_phone_the_legend_lay_on_the_corner_of_a_room_below_the_card_of_the_end() {
        let mut view = Viewport::new(5.2, 4.2, 390.0, 458.0, 1.0);
        let legend = Vector::new(196.0, 98.0);
        let before = view;
        view.keep_clear(0.0, None, Vector::zeros(), legend);
        assert_eq!((view.scale, view.origin), (before.scale, before.origin), "it has room enough");
        view.keep_clear(206.0, None, Vector::zeros(), legend);
        let [start, end] = [0.0, 4.2].map(|y| view.to_screen(Point::new(0.0, y)).y);
        assert!(start <= 458.0 - 98.0 + 1e-9 && end >= 206.0 - 1e-9, "{start} {end}");
    }

    #[test]
    fn in_a_frame_the_zoom_lay_on_the_corner_of_the_room() {
        for (width, height) in [(640.0, 314.0), (560.0, 330.0), (420.0, 520.0)] {
            let mut view = Viewport::new(5.2, 4.2, width, height, 1.0);
            let zoom = Vector::new(206.0, 72.0);
            view.keep_clear(52.0, Some(0.0), zoom, Vector::zeros());
            let end = view.to_screen(Point::new(5.2, 0.0));
            let [to_right, to_bottom] = view.scale_bar().unwrap();
            let corner = zoom.sup(&Vector::new(to_right + 130.0, to_bottom));
            assert!(end.x <= width - corner.x || end.y <= height - zoom.y + 1e-9, "{width}: {end}");
            assert!(view.scale * 4.2 > 0.5 * height, "{width}: {}", view.scale);
            view.keep_clear(52.0, Some(0.0), Vector::new(162.0, 120.0), Vector::zeros());
            assert_eq!(view.scale_bar(), None, "it lay under the joystick");
        }
    }

    #[test]
    fn the_scale_bar_above_the_zoom_lies_beside_the_room() {
        let view = Viewport::new(4.0, 3.0, 390.0, 440.0, 1.0);
        let end = view.to_screen(Point::new(4.0, 0.0));
        assert!(end.x > 350.0 && end.y <= 440.0 - SCALE_CORNER[1], "{end}");
        assert_eq!(view.scale_bar(), Some([20.0, 72.0]));
        // Beside a joystick it has its place, too.
        let mut driven = Viewport::new(10.0, 8.0, 390.0, 458.0, 1.0);
        driven.keep_clear(0.0, None, Vector::new(162.0, 166.0), Vector::zeros());
        let end = driven.to_screen(Point::new(10.0, 0.0));
        assert!(driven.scale_bar() == Some([162.0, 72.0]) && end.y <= 458.0 - 166.0 + 1e-9, "{end}");
        assert!(10.0 * driven.scale > 270.0, "above the joystick the floor is larger than beside it");
        // On a phone's side the room is beside the joystick, and the bar on its other side.
        let mut low = Viewport::new(10.0, 8.0, 540.0, 340.0, 1.0);
        low.keep_clear(175.0, None, Vector::new(162.0, 166.0), Vector::zeros());
        let [to_right, to_bottom] = low.scale_bar().unwrap();
        let start = low.to_screen(Point::origin());
        assert!(start.y > 340.0 - to_bottom && 540.0 - to_right < start.x - 5.0, "{start} {to_right}");
        // Without zoom buttons it needs no place of its own, but lies on no floor.
        let bare = |width: f64, height: f64| {
            let mut view = Viewport::bare();
            view.resize(390.0, 440.0, 1.0);
            view.set_room(width, height);
            view.scale_bar()
        };
        assert_eq!([bare(4.0, 3.0), bare(3.0, 4.0)], [Some([10.0, 10.0]), None]);
        assert_eq!(Viewport::new(4.0, 3.0, 200.0, 150.0, 1.0).scale_bar(), None);
    }

    #[test]
    fn a_narrow_window_leaves_as_much_room_for_tools_as_a_wide_one() {
        let narrow = Viewport::new(4.0, 8.0, 360.0, 270.0, 1.0);
        assert!(narrow.to_screen(Point::new(0.0, 8.0)).y >= 65.9 && narrow.to_screen(Point::new(0.0, 0.0)).y <= 204.1);
    }

    #[test]
    fn resizing_refits_only_what_was_fitted() {
        let mut fitted = view();
        fitted.resize(450.0, 350.0, 1.0);
        assert_eq!(fitted, Viewport::new(8.0, 6.0, 450.0, 350.0, 1.0));
        let mut moved = view();
        moved.pan(10.0, 0.0);
        let middle = moved.to_world(450.0, 350.0);
        moved.resize(600.0, 500.0, 1.0);
        assert!((moved.to_world(300.0, 250.0) - middle).norm() < 1e-9);
    }

    #[test]
    fn the_room_can_not_be_lost() {
        let mut view = view();
        view.pan(1e6, -1e6);
        let (low, high) = view.bounds();
        assert!(low.x < 8.0 && high.x > 0.0 && low.y < 6.0 && high.y > 0.0);
    }

    #[test]
    fn tiny_canvases_are_survived() {
        let mut view = view();
        view.resize(0.0, 0.0, 1.0);
        view.zoom_at(0.0, 0.0, 0.0);
        assert!(view.scale > 0.0 && view.origin.x.is_finite());
    }

    #[test]
    fn a_small_room_on_a_low_canvas_is_survived() {
        let mut view = view();
        view.zoom_at(0.0, 0.0, 0.0);
        view.resize(80.0, 40.0, 1.0);
        let (low, high) = view.bounds();
        assert!(low.x < 8.0 && high.x > 0.0 && low.y < 6.0 && high.y > 0.0);
    }

    #[test]
    fn without_tools_over_it_a_room_is_as_large_as_a_low_canvas() {
        let mut view = view();
        view.resize(390.0, 190.0, 1.0);
        view.fit();
        let before = view.scale;
        view.keep_clear(0.0, Some(0.0), Vector::zeros(), Vector::zeros());
        assert!(view.scale > 1.4 * before && view.scale * 6.0 <= 190.0, "{before} {}", view.scale);
        view.keep_clear(40.0, Some(0.0), Vector::zeros(), Vector::zeros());
        assert!(view.scale * 6.0 <= 150.0, "{}", view.scale);
        // The legend hid the lowest lane on the full screen.
        view.resize(900.0, 700.0, 1.0);
        view.keep_clear(0.0, Some(44.0), Vector::zeros(), Vector::zeros());
        assert!(view.to_screen(Point::new(0.0, 0.0)).y <= 656.1);
    }
}
