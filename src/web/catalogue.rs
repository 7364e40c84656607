//! What there is to choose from, for menus and forms.

use crate::{
    app::{CELL_SIZES, SPEEDS},
    floorplan::ROOMS,
    planner::{self, PLANNERS, ParamKind, ParamSpec, ParamValue},
    robot::MODELS,
};
use serde::Serialize;

/// Rooms, planners, robots, cell sizes and speeds.
#[derive(Serialize)]
pub(super) struct Catalogue {
    rooms: Vec<Room>,
    planners: Vec<Planner>,
    robots: Vec<Robot>,
    cell_sizes_m: [f64; CELL_SIZES.len()],
    speeds: [f64; SPEEDS.len()],
}

#[derive(Serialize)]
struct Room {
    id: &'static str,
    title: &'static str,
    note: &'static str,
}

#[derive(Serialize)]
struct Planner {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    source: &'static str,
    link: &'static str,
    complete: bool,
    deterministic: bool,
    fast: bool,
    idea: &'static str,
    complexity: &'static str,
    use_when: &'static str,
    shines: Example,
    fails: Example,
    params: Vec<Param>,
}

#[derive(Serialize)]
struct Example {
    room: &'static str,
    why: &'static str,
}

#[derive(Serialize)]
struct Robot {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    default_cell_m: f64,
}

#[derive(Serialize)]
pub(super) struct Param {
    id: &'static str,
    label: &'static str,
    help: &'static str,
    default: ParamValue,
    #[serde(flatten)]
    kind: Kind,
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Kind {
    Number { min: f64, max: f64, step: f64, unit: &'static str },
    Choice { options: &'static [(&'static str, &'static str)] },
    Flag,
}

impl Catalogue {
    pub fn new() -> Self {
        Self {
            rooms: ROOMS.iter().map(|r| Room { id: r.id, title: r.title, note: r.note }).collect(),
            planners: PLANNERS
                .iter()
                .map(|p| Planner {
                    id: p.id,
                    title: p.title,
                    summary: p.summary,
                    source: p.source,
                    link: p.link,
                    complete: p.claims.complete,
                    deterministic: p.claims.deterministic,
                    fast: p.claims.fast,
                    idea: p.explainer.idea,
                    complexity: p.explainer.complexity,
                    use_when: p.explainer.use_when,
                    shines: Example::new(&p.explainer.shines),
                    fails: Example::new(&p.explainer.fails),
                    params: params(p.params),
                })
                .collect(),
            robots: MODELS
                .iter()
                .map(|m| Robot { id: m.id, title: m.title, summary: m.summary, default_cell_m: m.default_cell })
                .collect(),
            cell_sizes_m: CELL_SIZES,
            speeds: SPEEDS,
        }
    }
}

impl Example {
    fn new(example: &planner::Example) -> Self {
        Self { room: example.room, why: example.why }
    }
}

/// The parameters as forms take them.
pub(super) fn params(specs: &[ParamSpec]) -> Vec<Param> {
    specs.iter().map(Param::new).collect()
}

impl Param {
    fn new(spec: &ParamSpec) -> Self {
        let kind = match spec.kind {
            ParamKind::Number { min, max, step, unit, .. } => Kind::Number { min, max, step, unit },
            ParamKind::Choice { options } => Kind::Choice { options },
            ParamKind::Flag { .. } => Kind::Flag,
        };
        Self { id: spec.id, label: spec.label, help: spec.help, default: spec.kind.default(), kind }
    }
}
