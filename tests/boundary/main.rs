//! The boundary to JavaScript, in a real browser.
#![cfg(target_arch = "wasm32")]

use js_sys::{Array, Float64Array, Function, Object, Reflect, Uint8Array};
use page::Playground;
use robovac_link::connection::TransportView;
use robovac_playground::wire::to_js;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::HtmlCanvasElement;
use workshop::{Connection, Replay, SessionMirror, VirtualRobot, plan, read_map};

mod live_map;
#[path = "../../src/page/mod.rs"]
mod page;
#[path = "../../src/workshop/mod.rs"]
mod workshop;

wasm_bindgen_test_configure!(run_in_browser);

fn playground() -> Playground {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().dyn_into().unwrap();
    let mut playground = Playground::new(canvas).unwrap();
    playground.resize(640.0, 480.0, 1.0);
    playground
}

fn get(object: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(object.clone(), |value, key| Reflect::get(&value, &key.into()).unwrap())
}

fn number(object: &JsValue, path: &str) -> f64 {
    get(object, path).as_f64().unwrap_or_else(|| panic!("{path} is no number"))
}

/// Serves the open planning request as the worker does.
fn serve(playground: &mut Playground) {
    let request = playground.take_plan_request().unwrap();
    assert!(!request.is_undefined(), "nothing to plan");
    let result = plan(&request, &Function::new_no_args("")).unwrap();
    playground
        .plan_finished(
            number(&request, "id") as u32,
            &get(&result, "cells"),
            number(&result, "seconds"),
            Some(Uint8Array::new(&get(&result, "trace")).to_vec()),
            None,
        )
        .unwrap();
}

#[wasm_bindgen_test]
fn catalogue_lists_what_there_is() {
    let catalogue = Playground::catalogue().unwrap();
    for (list, at_least) in [("rooms", 8), ("planners", 2), ("robots", 2), ("speeds", 3)] {
        assert!(Array::from(&get(&catalogue, list)).length() >= at_least, "{list}");
    }
    let planner = Array::from(&get(&catalogue, "planners")).get(0);
    assert!(get(&planner, "id").is_string() && Array::is_array(&get(&planner, "params")));
}

#[wasm_bindgen_test]
fn opens_playing_and_draws() {
    let mut playground = playground();
    assert!(playground.take_plan_request().unwrap().is_undefined(), "the opening scene is planned in advance");
    playground.frame(0.0).unwrap();
    playground.frame(16.0).unwrap();
    let view = playground.view().unwrap();
    assert_eq!(get(&view, "state").as_string().unwrap(), "playing");
    assert!(get(&view, "plan.planning_s").is_null());
    assert!(number(&view, "coverage") > 0.0 && number(&view, "plan.steps") > 100.0);
    let curve: Float64Array = playground.coverage_curve();
    assert!(curve.length() >= 4 && curve.length().is_multiple_of(2));
}

#[wasm_bindgen_test]
fn plan_crosses_to_the_worker_and_back() {
    let mut playground = playground();
    playground.select_room("lshape").unwrap();
    assert_eq!(get(&playground.view().unwrap(), "state").as_string().unwrap(), "planning");
    serve(&mut playground);
    let view = playground.view().unwrap();
    assert_eq!(get(&view, "state").as_string().unwrap(), "playing");
    assert_eq!(number(&view, "plan.visited_cells"), number(&view, "plan.reachable_cells"));
    assert!(playground.take_plan_request().unwrap().is_undefined());
}

#[wasm_bindgen_test]
fn bad_choices_throw_a_message_and_change_nothing() {
    let mut playground = playground();
    let link = playground.link();
    for error in [
        playground.select_room("attic").unwrap_err(),
        playground.select_algorithm("magic").unwrap_err(),
        playground.set_param("wings", "2").unwrap_err(),
        playground.set_cell_size(f64::NAN).unwrap_err(),
        playground.restore("seed=minus one").unwrap_err(),
    ] {
        let text = error.as_string().unwrap();
        assert!(["attic", "magic", "wings", "NaN", "minus one"].iter().any(|bad| text.contains(bad)), "{text}");
    }
    assert_eq!(playground.link(), link);
}

#[wasm_bindgen_test]
fn bad_planning_requests_throw_a_message() {
    for request in [JsValue::UNDEFINED, Object::new().into(), JsValue::from("x")] {
        assert!(plan(&request, &Function::new_no_args("")).unwrap_err().as_string().is_some());
    }
}

#[wasm_bindgen_test]
fn files_come_in_and_bad_ones_leave_the_room() {
    let mut playground = playground();
    let load = |playground: &mut Playground, name: &str, bytes: &[u8]| {
        let file = Object::new();
        Reflect::set(&file, &"name".into(), &name.into()).unwrap();
        Reflect::set(&file, &"bytes".into(), &Uint8Array::from(bytes)).unwrap();
        playground.take_map(&read_map(&Array::of1(&file))?)
    };
    let before = playground.link();
    for (name, bytes) in [("empty.png", &b""[..]), ("cut.png", b"\x89PNG\r\n\x1a\n\0\0"), ("notes.txt", b"hello")] {
        let error = load(&mut playground, name, bytes).unwrap_err().as_string().unwrap();
        assert!(error.len() > 10, "{name}: {error}");
        assert_eq!(playground.link(), before);
    }
    for read in [&b""[..], b"x", &[255; 64]] {
        assert!(playground.take_map(read).unwrap_err().as_string().is_some());
        assert_eq!(playground.link(), before);
    }
    load(&mut playground, "room.txt", b"; resolution 0.25\n........\n........\n........\n........\n").unwrap();
    let view = playground.view().unwrap();
    assert_eq!((number(&view, "room.width_m"), number(&view, "room.height_m")), (2.0, 1.0));
    serve(&mut playground);
    playground.set_cell_size(0.35).unwrap();
    let saved = playground.scenario_json().unwrap();
    let wrong = saved.replace("boustrophedon", "magic");
    let error = load(&mut playground, "wrong.json", wrong.as_bytes()).unwrap_err().as_string().unwrap();
    assert!(error.starts_with("the scenario can't be run: planner: there is no planner \"magic\""), "{error}");
    playground.select_room("empty").unwrap();
    playground.set_cell_size(0.2).unwrap();
    load(&mut playground, "saved.json", saved.as_bytes()).unwrap();
    assert_eq!(number(&playground.view().unwrap(), "room.width_m"), 2.0);
    assert_eq!(number(&playground.view().unwrap(), "cell_size_m"), 0.35);
}

#[wasm_bindgen_test]
fn pointer_draws_a_wall_and_undo_takes_it_back() {
    let mut playground = playground();
    playground.select_room("empty").unwrap();
    serve(&mut playground);
    let before = number(&playground.view().unwrap(), "plan.reachable_cells");
    playground.frame(0.0).unwrap();
    playground.set_tool("wall");
    playground.pointer("down", 300.0, 200.0);
    playground.pointer("move", 340.0, 280.0);
    playground.pointer("up", 340.0, 280.0);
    serve(&mut playground);
    assert!(number(&playground.view().unwrap(), "plan.reachable_cells") < before);
    playground.undo();
    serve(&mut playground);
    assert_eq!(number(&playground.view().unwrap(), "plan.reachable_cells"), before);
}

/// A line as its owner describes it.
fn line() -> JsValue {
    to_js(&TransportView::default()).unwrap()
}

/// A request as JavaScript makes it.
fn request(json: &str) -> JsValue {
    js_sys::JSON::parse(json).unwrap()
}

#[wasm_bindgen_test]
fn virtual_robot_is_connected_controlled_and_recorded() {
    let guest = SessionMirror::new();
    assert!(VirtualRobot::new(&guest, "nobody").err().unwrap().as_string().unwrap().contains("\"nobody\""));
    let (mut link, mut robot) = (Connection::new(), VirtualRobot::new(&guest, "model").unwrap());
    let mut now = 0.0;
    let mut pass = |link: &mut Connection, seconds: f64| {
        let end = now + seconds;
        while now < end {
            now += 0.01;
            robot.advance(0.01);
            let bytes = robot.transmit(115_200);
            link.feed(now, &bytes);
            link.beat(now);
            link.tick(now);
            robot.receive(&link.take_tx(), 115_200);
        }
        now
    };
    link.opened(0.0, line()).unwrap();
    let now = pass(&mut link, 2.0);
    let view = link.view(now, line()).unwrap();
    assert_eq!(Reflect::get(&view, &"phase".into()).unwrap(), "connected");
    let refused = link.request(now, request(r#"{ "do": "drive", "forward": 1, "left": 0 }"#)).unwrap_err();
    assert_eq!(refused, "Take control of the robot first.");
    assert!(link.request(now, request(r#"{ "do": "fly" }"#)).unwrap_err().as_string().is_some());
    link.request(now, request(r#"{ "do": "arm", "full": false }"#)).unwrap();
    let now = pass(&mut link, 1.0);
    link.request(now, request(r#"{ "do": "drive", "forward": 1, "left": 0 }"#)).unwrap();
    let now = pass(&mut link, 0.1);
    assert!(link.take_trace().len().is_multiple_of(4));
    assert!(number(&link.view(now, line()).unwrap(), "wheels.0") > 0.0);
    let mut replay = Replay::new("log.txt".into(), &link.recording()).unwrap();
    replay.advance(replay.duration_s());
    assert_eq!(Reflect::get(&replay.view().unwrap(), &"mode".into()).unwrap(), "Safe");
    assert!(Replay::new("map.txt".into(), "a map").err().unwrap().as_string().unwrap().contains("not a recording"));
}
