//! The live map of a robot on its way, and plans for it, in a real browser.

use super::workshop::{LiveMap, SessionMirror, plan};
use js_sys::{Function, Reflect, Uint32Array};
use robovac_app::explore::Session;
use robovac_link::connection::SWEEPS;
use robovac_playground::wire::to_js;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::HtmlCanvasElement;

/// Width of the strip that a Roomba 600 cleans, m.
const TOOL_WIDTH: f64 = 0.17;

fn guest(link: &str) -> SessionMirror {
    let mut guest = SessionMirror::new();
    let mut session = Session::new();
    session.restore(link).unwrap();
    guest.follow(to_js(&session.snapshot()).unwrap(), None).unwrap();
    guest
}

fn map(guest: &SessionMirror, known: bool) -> LiveMap {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().dyn_into().unwrap();
    let mut map = LiveMap::new(canvas, guest, known).unwrap();
    map.resize(640.0, 480.0, 1.0);
    map
}

/// A straight way from a place to the right, a reading every 2 cm, with the main brush running or not.
fn way(x: f64, y: f64, length: f64, sweeps: bool) -> Vec<f64> {
    let flags = if sweeps { f64::from(SWEEPS) } else { 0.0 };
    (0..=(length / 0.02) as u32).flat_map(|i| [x + 0.02 * f64::from(i), y, 0.0, flags]).collect()
}

fn straight(x: f64, y: f64, length: f64) -> Vec<f64> {
    way(x, y, length, true)
}

fn number(object: &JsValue, name: &str) -> f64 {
    Reflect::get(object, &name.into()).unwrap().as_f64().unwrap()
}

#[wasm_bindgen_test]
fn blank_paper_grows_and_keeps_what_was_swept() {
    let mut map = map(&guest("room=empty&robot=roomba600"), false);
    map.follow(&straight(0.0, 0.0, 12.0));
    map.show_robot(12.0, 0.0, 0.0, false, false, false);
    map.draw().unwrap();
    let expected = 12.0 * TOOL_WIDTH;
    // Cells of 2.5 cm know the strip's width to two centimetres.
    assert!((map.swept_m2() - expected).abs() < 0.12 * expected, "{} m²", map.swept_m2());
    assert_eq!(map.coverage(), None, "nobody knows how large the room is");
}

#[wasm_bindgen_test]
fn a_known_room_has_a_share() {
    let mut map = map(&guest("room=empty&robot=roomba600"), true);
    map.follow(&straight(1.0, 2.0, 3.0));
    let share = map.coverage().unwrap();
    assert!(share > 0.02 && share < 0.05, "{share}");
    map.wipe();
    assert_eq!(map.coverage(), Some(0.0));
}

#[wasm_bindgen_test]
fn a_robot_that_is_elsewhere_all_at_once_has_not_driven_there() {
    let mut map = map(&guest("room=empty&robot=roomba600"), true);
    let sweeps = f64::from(SWEEPS);
    map.follow(&[1.0, 1.0, 0.0, sweeps, 4.0, 3.0, 0.0, sweeps]);
    assert!(map.swept_m2() > 0.03 && map.swept_m2() < 0.06, "{} m²", map.swept_m2());
}

#[wasm_bindgen_test]
fn floor_is_swept_only_while_the_brush_runs_also_on_larger_paper() {
    let mut map = map(&guest("room=empty&robot=roomba600"), false);
    map.follow(&way(0.0, 0.0, 3.0, false));
    assert_eq!(map.swept_m2(), 0.0);
    // The brush starts where the robot stands.
    map.follow(&[3.0, 0.0, 0.0, f64::from(SWEEPS)]);
    assert!(map.swept_m2() > 0.015);
    map.follow(&way(3.0, 0.0, 1.0, true));
    map.follow(&way(4.0, 0.0, 12.0, false));
    assert!((map.swept_m2() - 1.1 * TOOL_WIDTH).abs() < 0.2 * TOOL_WIDTH, "{} m²", map.swept_m2());
}

#[wasm_bindgen_test]
fn beliefs_are_placed_where_the_robot_stands() {
    let mut map = map(&guest("room=empty&robot=roomba600"), true);
    // It believes to be at the origin, and stands in the middle, looking up.
    map.place(0.0, 0.0, 0.0, &[2.5, 2.0, std::f64::consts::FRAC_PI_2]);
    map.follow(&straight(0.0, 0.0, 1.0));
    assert!(map.swept_m2() > 0.9 * TOOL_WIDTH);
    // Off the floor, a metre further down, there is nothing to sweep.
    map.follow(&straight(-10.0, 0.0, 1.0));
    assert!(map.swept_m2() < 1.4 * TOOL_WIDTH);
}

#[wasm_bindgen_test]
fn a_bump_leaves_one_mark_however_long_it_is_felt() {
    let mut map = map(&guest("room=empty&robot=roomba600"), true);
    // With and without the brush.
    map.follow(&[1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0, 513.0, 1.0, 1.0, 0.0, 512.0, 1.0, 1.0, 0.0, 520.0]);
    map.show_robot(1.0, 1.0, 0.0, false, false, false);
    let words = map.words("Empty room", "Safe", "");
    assert!(words.contains("; 1 bump, 1 cliff."), "{words}");
    map.draw().unwrap();
}

#[wasm_bindgen_test]
fn what_is_no_number_is_not_drawn() {
    let mut map = map(&guest("room=empty&robot=roomba600"), false);
    map.follow(&[f64::NAN, 0.0, 0.0, 0.0, f64::INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0]);
    map.draw().unwrap();
    assert_eq!(map.swept_m2(), 0.0);
}

#[wasm_bindgen_test]
fn a_plan_becomes_a_line_to_drive() {
    let mut guest = guest("room=empty&planner=boustrophedon&robot=roomba600");
    assert!(guest.corners().is_empty());
    let request = guest.take_plan_request().unwrap();
    let result = plan(&request, &Function::new_no_args("")).unwrap();
    let cells = Reflect::get(&result, &"cells".into()).unwrap();
    guest.plan_finished(number(&request, "id") as u32, &cells, number(&result, "seconds")).unwrap();
    let corners = guest.corners();
    assert!(corners.len() >= 8 && corners.len().is_multiple_of(2), "{} numbers", corners.len());
    assert_eq!(guest.start().len(), 3);
    assert!(guest.take_plan_request().unwrap().is_undefined(), "it is planned already");
}

#[wasm_bindgen_test]
fn a_plan_through_walls_is_refused() {
    let mut guest = guest("room=empty&planner=boustrophedon&robot=roomba600");
    let request = guest.take_plan_request().unwrap();
    let refusal =
        guest.plan_finished(number(&request, "id") as u32, &Uint32Array::from(&[0, 0, 500, 500][..]), 0.0).unwrap_err();
    assert!(refusal.as_string().unwrap().contains("planner failed"), "{refusal:?}");
    assert!(guest.corners().is_empty());
}
