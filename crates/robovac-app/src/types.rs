//! TypeScript declarations of all plain objects exchanged between JavaScript and Rust.

use crate::{
    CatalogueEntry, ExplainerEntry,
    bench::BenchResult,
    compare::{ComparisonView, ManyRunsOffer, ManyRunsPlace, ManyRunsView, TableView},
    explore::{Catalogue, LinkOutline, PageView, SessionSnapshot},
    floor_plan::FloorPlanView,
    map::MapView,
};
use robovac_core::{program::Program, robot::OwnRobotForm};
use robovac_lessons::{Answer, Lesson, Question, Verdict};
use robovac_link::{
    connection::{ConnectionView, LineRequest, Request, Traffic, TypedBytes},
    emulator::{PersonalityView, VirtualView},
    recording::Timeline,
    twin::{Prediction, TwinFigure},
};
use robovac_sim::montecarlo::Summary;
use std::collections::BTreeMap;
use ts_rs::{Config, TS, TypeVisitor};

/// The file's header.
const HEAD: &str = "// Generated from the Rust types by `cargo test --test page types`: change them there.\n";

/// Declarations by the names of their types.
struct Declarations {
    config: Config,
    texts: BTreeMap<String, String>,
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        // Numbers, strings and lists need no declaration.
        let Some(_) = T::output_path() else { return };
        let name = T::ident(&self.config);
        if self.texts.contains_key(&name) {
            return;
        }
        let text = format!("{}export {}\n", T::docs().unwrap_or_default(), T::decl(&self.config));
        self.texts.insert(name, text);
        T::visit_dependencies(self);
    }
}

/// The content of `www/types.d.ts`.
pub fn declarations() -> String {
    // All whole numbers in these objects fit JavaScript's number type.
    let mut all = Declarations { config: Config::new().with_large_int("number"), texts: BTreeMap::new() };
    all.visit::<Answer>();
    all.visit::<BenchResult>();
    all.visit::<Catalogue>();
    all.visit::<CatalogueEntry>();
    all.visit::<ComparisonView<'static>>();
    all.visit::<ConnectionView>();
    all.visit::<ExplainerEntry>();
    all.visit::<FloorPlanView>();
    all.visit::<Lesson>();
    all.visit::<LineRequest>();
    all.visit::<LinkOutline>();
    all.visit::<MapView>();
    all.visit::<OwnRobotForm>();
    all.visit::<PageView>();
    all.visit::<PersonalityView>();
    all.visit::<Prediction>();
    all.visit::<Program>();
    all.visit::<Question>();
    all.visit::<Request>();
    all.visit::<SessionSnapshot>();
    all.visit::<ManyRunsOffer>();
    all.visit::<ManyRunsPlace<'static>>();
    all.visit::<ManyRunsView<'static>>();
    all.visit::<Summary>();
    all.visit::<TableView>();
    all.visit::<Timeline>();
    all.visit::<Traffic>();
    all.visit::<TwinFigure>();
    all.visit::<TypedBytes>();
    all.visit::<Verdict>();
    all.visit::<VirtualView>();
    let texts: Vec<String> = all.texts.into_values().collect();
    // Single-line comments on one line.
    let text = texts.join("\n").replace("/**\n * ", "/** ").replace("\n */\n", " */\n").replace(" \n", "\n");
    format!("{HEAD}\n{text}")
}
