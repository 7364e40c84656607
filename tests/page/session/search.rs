//! Films of improvements, and the decisions of planners.

use super::{finish, opened};
use coverage_planners::{CoveragePath, ProgressReport};
use robovac_app::explore::{Session, SessionState, pictures};
use std::ops::ControlFlow;

/// Lets a film run to its end, and collects what is said meanwhile.
fn watched(session: &mut Session) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    let mut frames = 0;
    for _ in 0..20 * 200 {
        let text = session.view().search.text;
        assert_eq!(session.picture().is_none(), text.contains("finished"), "{text}");
        if told.last() != Some(&text) {
            // Nobody reads more than 18 characters a second, and looks at the picture, too.
            let (seconds, length) = (f64::from(frames) / 20.0, told.last().map_or(0, String::len));
            assert!(seconds >= length as f64 / 18.0, "{seconds} s for {:?}", told.last());
            told.push(text);
            frames = 0;
        }
        frames += 1;
        session.frame(0.05, &mut || true);
    }
    assert!(told.len() > 1 && told[told.len() - 1].contains("finished"), "{told:?}");
    told
}

// slow: a search that runs to its proof
#[test]
fn search_of_a_small_room_is_a_film() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.plan_now(|| 0.0);
    assert_eq!((session.picture(), session.state()), (None, SessionState::Playing), "it isn't shown unasked");
    session.show_search(true);
    assert_eq!(session.state(), SessionState::Ready, "the robot waits");
    let told = watched(&mut session);
    assert!(told[0].starts_with("Construction, 1 of 3: Boustrophedon (parallel lanes) needs "), "{told:?}");
    assert_eq!(told.iter().filter(|text| text.contains("The search starts from it")).count(), 1, "{told:?}");
    // Every improvement in three pictures, the way from what it was to what it is.
    let improvements = &told[3..told.len() - 1];
    assert!(!improvements.is_empty(), "{told:?}");
    for three in improvements.chunks(3) {
        assert!(three[0].starts_with("Improvement") && three[0].ends_with("will change."), "{three:?}");
        assert!(three[1].contains("is cut where it changes; "), "{three:?}");
        assert!(three[2].contains("rejoined, ") && three[2].contains(" % of the bound); now "), "{three:?}");
    }
    assert!(told[told.len() - 1].starts_with("Search finished: a plan "), "{told:?}");
    session.show_search(false);
    assert_eq!(session.view().search.text, "");
    session.show_search(true);
    assert_eq!(session.view().search.text, told[0]);
}

#[test]
fn search_in_metres_is_a_film() {
    let mut session = Session::new();
    session.restore("room=lshape&planner=lanes&p.effort=0.1").unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Ready, "the robot waits");
    let told = watched(&mut session);
    assert!(told[0].starts_with("First path: Lanes in metres needs "), "{told:?}");
    let last = &told[told.len() - 2];
    assert!(
        last.starts_with("Improvement")
            && (last.contains(": rejoined, ") || last.contains(": every piece moved, "))
            && last.contains("; now "),
        "{told:?}"
    );
    assert_eq!(told[told.len() - 1], "Search finished.");
}

#[test]
fn film_waits_while_the_robot_drives() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.configure(|s| s.set_param("effort", "0")).unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Ready, "a film that was asked for has the floor first");
    let first = session.view().search.text;
    assert!(session.scene().robot.is_none(), "no robot is parked on what the film shows");
    session.play();
    for _ in 0..600 {
        session.frame(1.0 / 60.0, &mut || true);
    }
    assert!(session.picture().is_none() && session.scene().robot.is_some());
    assert!(session.view().search.text.contains("is hidden while the robot drives"), "{}", session.view().search.text);
    session.pause();
    assert_eq!(session.view().search.text, first, "it hasn't gone on meanwhile");
}

#[test]
fn film_does_not_come_back_over_the_end_of_the_run() {
    for planner in ["near_optimal&p.effort=0", "boustrophedon", "genetic"] {
        let mut session = Session::new();
        session.restore(&format!("room=lshape&planner={planner}")).unwrap();
        session.show_search(true);
        session.plan_now(|| 0.0);
        assert!(session.picture().is_some(), "{planner}: a film has the floor first");
        finish(&mut session);
        session.frame(1.0 / 60.0, &mut || true);
        assert_eq!(session.state(), SessionState::Finished);
        assert!(session.picture().is_none() && session.scene().robot.is_some(), "{planner}: what was swept is seen");
        let film = session.view().search.film.unwrap();
        assert_eq!(film.at, film.pictures, "{planner}: so the page says what was reached");
        session.hold_film(false);
        assert!(session.picture().is_some(), "{planner}: it can be watched again");
    }
}

#[test]
fn film_that_is_held_goes_on_by_hand() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.configure(|s| s.set_param("effort", "0")).unwrap();
    session.hold_motion();
    session.plan_now(|| 0.0);
    session.show_search(true);
    let at = |session: &Session| session.view().search.film.unwrap().at;
    for _ in 0..600 {
        session.frame(1.0 / 60.0, &mut || true);
    }
    assert_eq!(at(&session), 0);
    session.turn_film(true);
    session.turn_film(true);
    session.turn_film(false);
    assert_eq!(at(&session), 1);
    session.hold_film(false);
    for _ in 0..60 * 12 {
        session.frame(1.0 / 60.0, &mut || true);
        if at(&session) != 1 {
            break;
        }
    }
    assert_eq!(at(&session), 2);
    for _ in 0..100 {
        session.turn_film(true);
    }
    let film = session.view().search.film.unwrap();
    assert_eq!((film.at, session.picture()), (film.pictures, None));
    session.hold_film(false);
    assert_eq!(at(&session), 0, "once it's over, it begins again");
}

// slow: a search has to be under way before it is kept
#[test]
fn plan_that_is_kept_early_has_a_film_and_says_so() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    let request = session.take_plan_request().unwrap();
    let (mut film, mut last) = (request.film().unwrap(), None);
    let mut watch = |report: ProgressReport<'_>| {
        film.take(&report);
        last = report.proof.map(|proof| (report.done, report.walk.to_vec(), proof));
        if report.done > 0.3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    assert!(request.serve(|| 0.0, Some(&mut watch)).is_err());
    let (done, walk, proof) = last.unwrap();
    let (id, frames) = (request.id, film.take_frames());
    session.plan_progress(id, ProgressReport { done, walk: &walk, line: &[], proof: Some(proof) });
    session.keep_plan(1.5);
    let film = request.film_with(frames).unwrap();
    let frames = film.ended(&CoveragePath::walk(walk), Some(proof));
    session.plan_filmed(id, pictures(&frames, &session.planning_room().unwrap().planning_grid));
    let plan = session.view().plan.unwrap();
    assert_eq!((plan.kept_at, plan.planning_s), (Some(done), Some(1.5)));
    session.show_search(true);
    let told = watched(&mut session);
    assert!(told.len() > 4 && told.iter().any(|text| text.starts_with("Improvement")), "{told:?}");
    session.configure(|s| s.select_algorithm("snake")).unwrap();
    session.plan_now(|| 0.0);
    assert_eq!(session.view().plan.unwrap().kept_at, None);
}

#[test]
fn search_of_the_snake_follows_the_robot() {
    use robovac_core::grid::Direction;
    let mut session = opened();
    session.restore("room=thesis8&robot=cell&planner=snake").unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    session.pause();
    // A decision at every step of the walk, each where the one before has led to.
    let steps = session.search().unwrap().steps().to_vec();
    assert_eq!(steps.len(), session.planned().unwrap().walk.unwrap().steps);
    for (i, pair) in steps.windows(2).enumerate() {
        assert_eq!((pair[0].step, pair[0].at.step(pair[0].towards)), (i, pair[1].at));
    }
    let block = steps.iter().find(|step| step.sides.is_some()).expect("a smaller block decides");
    let [(first, a), (second, b)] = block.sides.unwrap();
    assert_eq!(second, first.opposite());
    assert!(
        block.note.contains(&format!("cells to clean: {a} ")) && block.note.contains(&b.to_string()),
        "{}",
        block.note
    );
    assert!(steps.iter().any(|step| step.rule == "Shortest path" || step.rule == "Back"));

    // The decision shown is the one that the robot carries out, all along the run.
    let cell = session.settings().cell_size;
    let mut shown = Vec::new();
    while session.state() != SessionState::Finished {
        session.step();
        let Some(decision) = session.decision() else { break };
        shown.push(decision.step);
        let at = session.recording().unwrap().run().pose().position();
        assert!((decision.at.centre(cell) - at).norm() < 1.2 * cell, "{decision:?} while the robot is at {at}");
        assert!(session.description().contains(&decision.note));
    }
    assert!(shown.is_sorted() && shown.len() > steps.len() / 2, "{shown:?}");

    // Back in time it's the same as on the way there.
    let (time, decision) = (session.view().time_s / 2.0, |session: &Session| session.decision().cloned());
    session.seek(time);
    session.frame(0.0, &mut || true);
    let middle = decision(&session).expect("a decision in the middle");
    assert!((1..steps.len() - 1).contains(&middle.step) && middle.towards != Direction::opposite(middle.towards));
    session.seek(0.0);
    session.frame(0.0, &mut || true);
    assert_eq!(decision(&session).as_ref(), steps.first());
    assert_eq!(session.view().search.text, format!("{}.", steps[0].note));
}

#[test]
fn search_says_why_a_walk_ends_early() {
    let mut session = opened();
    session.restore("room=room12ft&robot=cell&planner=snake&p.rules=program").unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    session.seek(session.planned().unwrap().drive.duration_s * 2.0);
    while session.state() != SessionState::Finished {
        session.frame(1.0, &mut || true);
    }
    let planned = session.planned().unwrap();
    let walk = planned.walk.unwrap();
    assert!(!walk.is_complete());
    let ending = session.search().unwrap().ending().expect("it ends early");
    assert_eq!((ending.step, &session.view().search.text), (walk.steps, &format!("{}.", ending.note)));
}

#[test]
fn search_is_only_shown_where_there_is_one() {
    let mut session = opened();
    session.show_search(true);
    session.restore("room=living&behaviour=random_walk").unwrap();
    let search = session.view().search;
    assert!(search.on && !search.offered && search.text.is_empty(), "a behaviour has no search");
    for (planner, refusal) in [
        ("snake", "shown only in rooms of up to 20,000 planning cells"),
        ("near_optimal", "filmed only in rooms of up to 2,000 planning cells"),
        ("lanes", "filmed only in rooms of up to 20,000 planning cells"),
    ] {
        session.restore(&format!("room=hall20&planner={planner}")).unwrap();
        let search = session.view().search;
        assert!(search.offered && !search.on && search.fits_small && search.text.is_empty(), "{search:?}");
        assert!(search.refusal.contains(refusal), "{}", search.refusal);
    }
    session.show_search(false);
    assert!(session.view().search.text.is_empty() && session.decision().is_none());
}

#[test]
fn link_says_whether_the_search_is_shown() {
    let mut session = opened();
    assert!(!session.link().contains("search="));
    session.show_search(true);
    let link = session.link();
    let mut other = opened();
    other.restore(&link).expect("it was just written");
    assert!(other.link() == link && link.ends_with("&search=1"), "{link}");
    // A link that changes only the robot leaves it as it is.
    other.restore("robot=cell").expect("the robot exists");
    assert!(other.link().contains("search=1"));
}
