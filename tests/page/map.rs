//! The Map tab's session, without the page.

use robovac_app::{
    explore::Session,
    map::{CellVerdict, MapAction, MapPhase, MapSession, OpenError, STORE_VERSION, StoreError, Stored, explorers},
};
use robovac_core::{
    floor_plan::{MapImage, OccupancyMode, SourceFile, load, room, to_ros_map},
    geometry::{Pose, Vector},
    grid::{Cell, Occupancy},
    robot::OdometryModel,
};
use robovac_sim::{
    Run, STEP_S,
    mapping::{CellMark, OccupancyMap},
};

/// A session in the room of a link.
fn map_session(link: &str) -> MapSession {
    let mut explore = Session::new();
    explore.restore(link).expect("a link of ours");
    let mut session = MapSession::new();
    session.take(&explore);
    session
}

fn small() -> MapSession {
    let mut session = map_session("room=room12ft&robot=roomba600&seed=3");
    session.set("explorer", "wall_follow").expect("it exists");
    session
}

/// Runs frames until a condition holds.
fn arrive(session: &mut MapSession) {
    for _ in 0..100_000 {
        if !matches!(session.phase(), MapPhase::Resuming | MapPhase::Seeking) {
            return;
        }
        let mut looks = 0;
        session.frame(0.016, &mut || {
            looks += 1;
            looks < 50
        });
    }
    panic!("still {:?}", session.phase());
}

fn known(session: &MapSession) -> usize {
    let map = session.estimate().expect("there is a robot").map;
    map.iter().filter(|&(cell, _)| map.occupancy(cell) != Occupancy::Unknown).count()
}

#[test]
fn a_map_begins_empty_and_grows() {
    let mut session = small();
    session.set("explorer", "bounce").expect("it exists");
    assert_eq!((session.phase(), known(&session)), (MapPhase::Ready, 0));
    assert_eq!(session.figures().map(|[here, _]| here.boundary), Some(0.0));
    session.run_ahead(120.0);
    let [early, _] = session.figures().expect("there is a run");
    session.run_ahead(240.0);
    let [late, _] = session.figures().expect("there is a run");
    assert!(early.boundary > 0.0 && late.boundary >= early.boundary && late.known > early.known, "{early:?} {late:?}");
    assert!(late.known > 0.05 && late.right > 0.5 && late.known <= 1.0, "{late:?}");
    let times: Vec<f64> = session.samples().iter().map(|sample| sample.time_s).collect();
    assert!(times.len() > 20 && times.is_sorted() && times[0] == 0.0, "{times:?}");
}

#[test]
fn perfect_wheels_are_typical_here_unless_asked_for() {
    let mut session = small();
    assert_eq!((session.view().wheels, session.view().senses.as_str()), ("typical", "typical"));
    session.run_ahead(300.0);
    let [_, odometry] = session.figures().expect("there is a run");
    assert!(odometry.heading_deg > Some(0.5), "typical wheels drift: {odometry:?}");
    session.set("wheels", "none").expect("a level");
    session.set("senses", "off").expect("a level");
    session.run_ahead(300.0);
    let [_, odometry] = session.figures().expect("there is a run");
    // The remaining error was caused by pushing along walls.
    assert!(odometry.heading_deg < Some(0.5), "perfect wheels hardly do: {odometry:?}");
    // What Explore has chosen is kept.
    let mut explore = Session::new();
    explore.restore("room=room12ft&slip=harsh&noise.light=harsh").expect("a link of ours");
    let mut session = MapSession::new();
    session.take(&explore);
    assert_eq!((session.view().wheels, session.view().senses.as_str()), ("harsh", "light=harsh"));
}

#[test]
fn all_odometry_models_can_be_chosen_and_differ() {
    let mut poses = Vec::new();
    for (model, _) in OdometryModel::ALL.map(|(model, id)| (id, model)) {
        let mut session = small();
        session.set("counts", model).expect("a model");
        session.run_ahead(60.0);
        poses.push(session.run().and_then(|run| run.baseline()).expect("there is one").pose());
        // The robot that follows walls by what it feels drives the same, whatever anyone reckons.
        let view = session.view();
        assert_eq!(view.drifts.len(), OdometryModel::ALL.len());
        let [off, turned] = view.drifts[0];
        let [whole, degrees] = view.drifts[2];
        assert!(off < 0.5 && turned < 20.0, "counts are off by {off} m, {turned} degrees");
        assert!(
            whole > off || degrees > turned,
            "whole millimetres and degrees lose something: {whole} m, {degrees} degrees"
        );
    }
    for (i, pose) in poses.iter().enumerate() {
        assert!(poses[..i].iter().all(|other| other != pose), "{i} is like another");
    }
    assert!(small().set("counts", "spiral").unwrap_err().to_string().contains("arc"));
}

#[test]
fn the_thesis_grid_is_drawn_measured_and_exported_in_the_same_run() {
    let mut session = small();
    session.run_ahead(240.0);
    let ([own, odometry], time) = (session.figures().expect("there is a run"), session.view().time_s);
    assert!(session.thesis().is_none());
    session.set("grid", "thesis").expect("a grid");
    assert_eq!((session.view().time_s, session.view().grid), (time, "thesis"), "the run goes on");
    let [thesis, same] = session.figures().expect("there is a run");
    assert_eq!(same, odometry);
    // By odometry as printed: its pose is about that of the other column, and floor is known in squares of 20 cm.
    assert!(
        thesis.boundary > 0.02 && thesis.known > 0.1 && thesis.right > 0.5 && thesis != own,
        "{thesis:?}, ours {own:?}"
    );
    let plan = session.to_plan("thesis").expect("something is known");
    assert_eq!((plan.occupancy.width(), plan.occupancy.height(), plan.resolution), (100, 100, 0.1));
    let map = session.shown().expect("there is a robot");
    for (cell, &status) in plan.occupancy.iter() {
        let middle = plan.origin.to_world(cell.centre(0.1));
        // The robot starts in the middle of cells of the map: a little aside of where they meet.
        let at = map.cell_at(middle + Vector::new(0.012, 0.012));
        assert_eq!(map.occupancy(at), status, "{cell:?}");
    }
    let last = |session: &MapSession| session.curve().last().expect("there are samples");
    let shown = last(&session);
    session.set("grid", "own").expect("a grid");
    assert_eq!(session.figures(), Some([own, odometry]));
    assert_ne!(shown.boundary, last(&session).boundary);
    let error = session.set("grid", "hexagons").unwrap_err().to_string();
    assert!(error.contains("own, thesis"), "{error}");
}

#[test]
fn the_same_recipe_makes_the_same_map_and_time_can_be_gone_back() {
    let mut session = small();
    session.run_ahead(90.0);
    let digest = |session: &MapSession| session.run().expect("there is a run").digest();
    let (first, cells) = (digest(&session), known(&session));
    let end = session.run().expect("there is a run").time_s();
    session.run_ahead(30.0);
    session.seek(end);
    arrive(&mut session);
    assert_eq!((digest(&session), known(&session)), (first, cells));
    let mut other = small();
    other.run_ahead(90.0);
    assert_eq!(digest(&other), first);
    assert_eq!(other.recipe(), session.recipe());
}

#[test]
fn a_survey_that_was_left_goes_on_where_it_was() {
    let mut session = small();
    assert_eq!(session.store(), None, "nothing is worth it yet");
    session.run_ahead(60.0);
    session.lift();
    assert_eq!(session.phase(), MapPhase::Held);
    session.run_ahead(2.0);
    session.put_down(Pose::new(1.0, 1.0, 1.2));
    session.run_ahead(60.0);
    let text = session.store().expect("there is a map");
    let digest = session.run().expect("there is a run").digest();
    let (cells, pose) = (known(&session), session.estimate().expect("there is a robot").pose());

    let mut back = small();
    back.resume(&text).expect("it is one of ours");
    assert_eq!(back.phase(), MapPhase::Resuming);
    // The stored map is there before the robot.
    assert_eq!(known(&back), cells);
    assert_eq!(back.estimate().expect("there is a robot").pose(), pose);
    assert!(back.description().contains("restored from the last visit"));
    arrive(&mut back);
    assert_eq!(back.run().expect("there is a run").digest(), digest);
    assert!(!back.take_strayed());
    assert_eq!(back.estimate().expect("there is a robot").pose(), pose);
    // And it goes on alike.
    for session in [&mut session, &mut back] {
        session.run_ahead(20.0);
    }
    assert_eq!(back.run().map(Run::digest), session.run().map(Run::digest));
}

/// Where a hand puts a robot is no round number, and time may stand still when the page is left.
#[test]
fn a_robot_that_was_carried_comes_back_to_where_it_was_put() {
    for (x, lasts) in [(0.1 + 0.2 + 0.777_777_777_777_7, 0.0), (1.123_456_789_012_345_6, 12.3), (2.0 / 3.0, 0.0)] {
        let mut session = small();
        session.run_ahead(20.0);
        session.lift();
        session.put_down(Pose::new(x, x.sqrt(), x * 1.7));
        session.run_ahead(lasts);
        let text = session.store().expect("there is a map");
        let run = session.run().expect("there is a run");
        let (digest, pose) = (run.digest(), run.pose());
        let mut back = small();
        back.resume(&text).expect("it is one of ours");
        arrive(&mut back);
        let run = back.run().expect("there is a run");
        assert_eq!((run.digest(), run.pose(), run.is_lifted()), (digest, pose, false), "{x} {lasts}");
        assert!(!back.take_strayed(), "{x} {lasts}");
    }
}

#[test]
fn a_program_that_drives_otherwise_is_noticed() {
    let mut session = small();
    session.run_ahead(30.0);
    let mut stored = Stored::from_text(&session.store().expect("there is a map")).expect("it is one of ours");
    stored.digest ^= 1;
    let mut back = small();
    back.resume(&stored.to_text()).expect("it can be tried");
    assert!(!back.take_strayed(), "nobody knows yet");
    arrive(&mut back);
    assert!(back.take_strayed() && !back.take_strayed(), "it is said once");
}

#[test]
fn what_was_stored_at_an_earlier_moment_comes_back_to_that() {
    let mut session = small();
    session.run_ahead(60.0);
    session.seek(20.0);
    arrive(&mut session);
    let text = session.store().expect("there is a map");
    let mut back = small();
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    let time = back.run().expect("there is a run").time_s();
    assert!((time - 20.0).abs() < STEP_S && (back.view().end_s - 60.0).abs() < 2.0 * STEP_S, "{time}");
}

#[test]
fn stored_text_keeps_map_marks_and_pose() {
    let mut session = small();
    session.run_ahead(200.0);
    let estimate = session.estimate().expect("there is a robot");
    let stored = Stored::from_text(&session.store().expect("there is a map")).expect("it is one of ours");
    let cells =
        |map: &OccupancyMap| map.iter().map(|(cell, odds)| (cell, (100.0 * odds).round() as i32)).collect::<Vec<_>>();
    let sorted = |mut list: Vec<(Cell, i32)>| {
        list.sort_by_key(|(cell, _)| (cell.y, cell.x));
        list
    };
    assert_eq!(sorted(cells(&stored.map)), sorted(cells(estimate.map)));
    for mark in [CellMark::Cleaned, CellMark::Dirty] {
        assert!(estimate.marks.cells(mark).all(|cell| stored.marks.has(cell, mark)));
        assert_eq!(stored.marks.cells(mark).count(), estimate.marks.cells(mark).count());
    }
    assert_eq!((Some(stored.pose), stored.title.as_str()), (estimate.pose(), session.view().title.as_str()));
    assert!(session.store().is_some_and(|text| text.len() < 60_000), "it is compact");
}

#[test]
fn what_can_not_be_brought_back_is_explained_and_changes_nothing() {
    let mut session = small();
    session.run_ahead(40.0);
    let text = session.store().expect("there is a map");
    let digest = session.run().expect("there is a run").digest();
    let newer = text.replacen(&format!("\"version\":{STORE_VERSION}"), "\"version\":77", 1);
    let mut refused = |text: &str| session.resume(text).expect_err("it can't be brought back");
    assert_eq!(refused(&newer), StoreError::Version { found: 77 });
    assert!(refused(&newer).to_string().contains("another version"));
    // Of another version, whatever else may be in it.
    assert_eq!(refused("{\"format\":\"robovac-survey\",\"version\":9,\"more\":[]}"), StoreError::Version { found: 9 });
    for other in ["", "{}", "[1,2]", "null", "{\"format\":\"x\",\"version\":1}", "\u{0}"] {
        assert!(matches!(refused(other), StoreError::NotASurvey(_)), "{other:?}");
    }
    for end in [text.len() / 3, text.len() / 2, text.len() - 2] {
        let cut = &text[..end];
        assert!(matches!(refused(cut), StoreError::NotASurvey(_)), "cut at {end}");
    }
    // One sign that is another.
    let at = text.len() / 2;
    let sign = if text.as_bytes()[at] == b'A' { "B" } else { "A" };
    let damaged = format!("{}{sign}{}", &text[..at], &text[at + 1..]);
    assert!(matches!(refused(&damaged), StoreError::Damaged { .. }));

    let mut other = map_session("room=empty&robot=roomba600&seed=3");
    assert_eq!(other.resume(&text), Err(StoreError::Another { title: session.view().title }));
    assert_eq!(session.run().expect("there is a run").digest(), digest, "nothing has changed");
}

#[test]
fn a_kidnapped_robot_does_not_know() {
    let mut session = small();
    session.run_ahead(30.0);
    let before = session.estimate().and_then(|estimate| estimate.pose()).expect("it believes something");
    session.lift();
    session.put_down(Pose::new(2.5, 2.5, 0.0));
    session.run_ahead(0.1);
    assert_eq!(session.view().is_sure, Some(false), "it has felt that it was carried");
    let estimate = session.estimate().and_then(|estimate| estimate.pose()).expect("it believes something");
    let truth = session.run().expect("there is a run").pose();
    assert!((estimate.position() - before.position()).norm() < 0.05, "{estimate} was {before}");
    assert!((truth.position() - before.position()).norm() > 0.2 || (truth.heading - before.heading).abs() > 0.5);
    assert!(session.can(MapAction::Lift) || session.phase() == MapPhase::Held);
    session.forget();
    assert_eq!((session.phase(), known(&session)), (MapPhase::Ready, 0));
}

// slow: relocalising takes minutes of driving
#[test]
fn a_kidnapped_explorer_relocalises_and_goes_on_exploring() {
    let mut session = map_session("room=bedroom&robot=roomba600&seed=3");
    session.run_ahead(240.0);
    let before = known(&session);
    session.lift();
    session.put_down(Pose::new(1.0, 1.6, 2.0));
    session.run_ahead(2.0);
    assert_eq!((session.view().is_sure, session.view().activity), (Some(false), "relocalising on its map"));
    let words = session.description();
    assert!(words.contains("was kidnapped and is relocalising on its map, and"), "{words}");
    let mut waited = 0;
    while session.view().is_sure.is_some() && waited < 40 {
        assert_eq!(session.view().is_sure, Some(false), "it doesn't go by what it guesses yet");
        assert_eq!(known(&session), before, "who is lost doesn't know what he maps");
        session.run_ahead(15.0);
        waited += 1;
    }
    assert_eq!(session.view().is_sure, None, "it is found");
    let off = session.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(off < 0.15, "{off} m off");
    session.run_ahead(120.0);
    assert!(known(&session) > before, "it goes on");
}

#[test]
fn every_explorer_can_be_chosen_and_links_bring_choices_back() {
    for info in explorers() {
        let mut session = small();
        session.set("explorer", info.id).expect("it is offered");
        for (key, value) in [
            ("track", "odometry"),
            ("wheels", "harsh"),
            ("senses", "off"),
            ("grid", "thesis"),
            ("layers", "belief,dirt"),
            ("pace", "4"),
        ] {
            session.set(key, value).expect(key);
        }
        let link = session.setup().to_link();
        let mut other = small();
        other.restore(&format!("room=flat&place=map&{link}&more=1")).expect("a link of ours");
        assert_eq!(other.setup().to_link(), link);
        assert_eq!(other.recipe(), session.recipe());
        other.run_ahead(5.0);
        // A Roomba has no laser, and is said to lack it.
        let drives = other.run().is_some_and(|run| run.steps() > 0);
        let needs_laser = other.expectation().is_some_and(|text| text.contains("laser scanner"));
        assert_eq!((drives, needs_laser), (!info.claims.needs_laser, info.claims.needs_laser), "{}", info.id);
    }
    let mut session = small();
    let before = session.setup().to_link();
    assert!(session.restore("explorer=wall_folow").unwrap_err().to_string().contains("wall_follow"));
    assert!(session.restore("explorer=bounce&layers=everything").is_err());
    assert_eq!(session.setup().to_link(), before, "nothing has changed");
}

#[test]
fn a_room_that_the_robot_does_not_fit_into_says_so() {
    let mut narrow = Session::new();
    narrow.restore("robot=roomba600").expect("a link of ours");
    let corridor = SourceFile { name: "corridor.txt".into(), bytes: b"; resolution 0.1\n......\n......\n".to_vec() };
    narrow.load(&[corridor]).expect("it is a map");
    let mut outside = Session::new();
    outside.restore("room=room12ft&robot=roomba600&start=-3,-3,0").expect("a link of ours");
    for explore in [&narrow, &outside] {
        assert!(explore.prepared().is_none());
        let mut session = MapSession::new();
        session.take(explore);
        assert_eq!(session.phase(), MapPhase::Failed);
        assert!(!session.complaint().is_empty());
        // Nothing of it may panic.
        session.play();
        session.step();
        session.lift();
        session.seek(3.0);
        session.frame(0.1, &mut || true);
        assert!(!session.description().is_empty());
    }
}

#[test]
fn truth_tells_right_from_wrong() {
    let session = small();
    let truth = session.truth().expect("there is a room");
    let boundary: Vec<Cell> = truth.boundary().collect();
    assert!(boundary.len() > 100 && boundary.iter().all(|&cell| truth.is_solid(cell)));
    let mut map = OccupancyMap::new(truth.resolution());
    let wall = boundary[boundary.len() / 2];
    assert_eq!(truth.verdict(&map, wall), Some(CellVerdict::Unseen));
    map.add(wall, 3.0);
    assert_eq!(truth.verdict(&map, wall), Some(CellVerdict::Right));
    let is_open =
        |cell: &Cell| (-2..=2).all(|dy| (-2..=2).all(|dx| !truth.is_solid(Cell::new(cell.x + dx, cell.y + dy))));
    let floor = truth.covered().find(is_open).expect("there is floor");
    assert_eq!(truth.verdict(&map, floor), None);
    map.add(floor, 3.0);
    assert_eq!(truth.verdict(&map, floor), Some(CellVerdict::Phantom));
    let inside = Cell::new(-4, -4);
    map.add(inside, -3.0);
    assert_eq!(truth.verdict(&map, inside), Some(CellVerdict::Missed));
}

#[test]
fn a_map_comes_back_from_a_file_where_it_was() {
    let mut session = small();
    session.run_ahead(120.0);
    let map = session.estimate().expect("there is a robot").map.clone();
    let plan = map.to_plan("mapped").expect("something is known");
    let files = to_ros_map(&plan, "mapped", MapImage::Pgm, OccupancyMode::Trinary, false).expect("it can be written");
    let file = |name: &str, bytes: Vec<u8>| SourceFile { name: name.into(), bytes };
    let read =
        load(&[file("mapped.yaml", files.yaml.into_bytes()), file(&files.image_name, files.image)]).expect("ours");
    assert_eq!(read.origin.position(), plan.origin.position());
    session.open(&read).expect("it has walls");
    let known = session.estimate().expect("there is a robot").map;
    for (cell, _) in map.iter() {
        assert_eq!(known.occupancy(cell), map.occupancy(cell), "{cell:?}");
    }
}

// slow: relocalising takes minutes of driving
#[test]
fn a_robot_that_is_given_a_map_starts_lost_and_relocalises() {
    let mut session = map_session("room=kitchen&robot=roomba600&seed=1");
    session.set("explorer", "wall_follow").expect("it exists");
    let plan = (room("kitchen").expect("it ships").build)();
    session.open(&plan).expect("it has walls");
    let here = |session: &MapSession| session.figures().expect("there is a run")[0];
    assert_eq!((here(&session).position_m, session.view().is_sure), (None, Some(false)), "it has no idea");
    assert!(here(&session).boundary > 0.95 && here(&session).right > 0.95, "the map is the room: {:?}", here(&session));
    let start = session.prepared().expect("it fits").floor.start;
    assert_ne!(session.run().expect("there is a run").pose(), start, "it isn't where it believes to start");
    assert_eq!(session.store(), None, "what is known already need not be kept");
    session.run_ahead(120.0);
    let off = here(&session).position_m.expect("it has an idea");
    assert!(off < 0.1 && session.view().is_sure == Some(true), "{off} m off after two minutes");
    // The way back to a map of its own.
    session.close_map();
    assert_eq!((session.phase(), known(&session), session.view().known), (MapPhase::Ready, 0, None));
}

#[test]
fn a_map_that_nobody_can_find_himself_on_is_refused_and_the_current_one_stays() {
    let mut session = small();
    session.run_ahead(60.0);
    let (digest, cells) = (session.run().expect("there is a run").digest(), known(&session));
    let mut plan = (room("room12ft").expect("it ships").build)();
    plan.objects.clear();
    for cell in plan.occupancy.values_mut() {
        *cell = Occupancy::Occupied;
    }
    assert_eq!(session.open(&plan), Err(OpenError::NothingOnIt));
    plan.resolution = 50.0;
    assert!(matches!(session.open(&plan), Err(OpenError::TooLarge { .. })));
    assert_eq!((session.run().expect("there is a run").digest(), known(&session)), (digest, cells));
}
