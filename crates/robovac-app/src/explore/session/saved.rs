//! A session as a link and as a file, and back.

use super::{
    Session,
    moment::{MOMENT, Moment},
};
use crate::{Import, ImportError, ScenarioChoices, ScenarioError};
use robovac_core::{
    floor_plan::{self, FloorPlan, RoomInfo, Scenario, SourceFile},
    geometry::Pose,
    registry::Params,
    robot::CustomRobot,
};
use robovac_sim::experiment::{Algorithm, KEPT_PATH, Settings, SettingsError};
use serde::Serialize;
use std::collections::BTreeMap;

/// Name in links of a room that was drawn or loaded: it is kept.
const OWN_ROOM: &str = "own";
/// Key in links of whether the search is shown.
const SEARCH: &str = "search";

/// Reasons why files can't be loaded.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadError {
    /// They aren't a map.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// They are a scenario that can't be run.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
}

/// What a link asks for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct LinkOutline {
    /// It would change nothing but an own room. Keys of other tabs don't count.
    pub is_shown: bool,
    /// The room was drawn or loaded.
    pub has_own_room: bool,
    /// A program of the user drives or plans.
    pub has_program: bool,
}

/// The session after a link.
struct Linked {
    settings: Settings,
    /// Another room.
    room: Option<&'static RoomInfo>,
    shows_search: bool,
    /// Where in the run it leads; `None` for the start.
    moment: Option<Moment>,
}

impl Session {
    /// Loads a map or scenario from files that belong together. Changes nothing on an error.
    pub fn load(&mut self, files: &[SourceFile]) -> Result<(), LoadError> {
        Ok(self.take_import(Import::read(files)?)?)
    }

    /// Takes the result of reading files. Changes nothing on an error.
    pub fn take_import(&mut self, import: Import) -> Result<(), ScenarioError> {
        let brings_path = import.choices.as_ref().is_some_and(|choices| choices.path.is_some());
        let settings = import.choices.map(|choices| choices.settings(&self.settings)).transpose()?;
        self.message = None;
        let parted = !brings_path && self.part_with_path(&import.plan);
        if let Some(mut settings) = settings {
            settings.path = settings.path.filter(|_| !parted);
            self.settings = settings;
        }
        // A room that ships comes back as that room: with its name, all of it fits into a link.
        let plan = import.plan;
        let ships = floor_plan::ROOMS.iter().find(|room| room.title == plan.name && (room.build)() == plan);
        self.editor.replace(plan, ships.map(|room| room.id), None);
        self.prepare();
        self.tell_parted(parted);
        Ok(())
    }

    /// Takes the room only, as when a room that ships is chosen; with all the rest if a path was planned in it.
    pub fn take_room(&mut self, import: Import) -> Result<(), ScenarioError> {
        let choices = import.choices.filter(|choices| choices.path.is_some());
        self.take_import(Import { choices, ..import })
    }

    /// Takes a link's `key=value` pairs, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let Linked { mut settings, room, shows_search, moment } = self.linked(link)?;
        let start = settings.start.take();
        self.shows_search = shows_search;
        self.replace(settings, room.map(|room| ((room.build)(), Some(room.id))), start);
        if let Some(moment) = moment {
            self.go_to(moment);
        }
        Ok(())
    }

    /// What a link asks for, before it is followed.
    pub fn link_outline(&self, link: &str) -> LinkOutline {
        let has = |key: &str, value: &str| pairs(link).any(|pair| pair == (key, value));
        let is_complete = self.link_pairs().all(|(key, value)| has(&key, &value));
        let would_be = |linked: Linked| {
            let same = linked.settings.to_link() == self.linked_settings().to_link();
            same && linked.shows_search == self.shows_search && linked.moment.is_none()
        };
        LinkOutline {
            is_shown: is_complete && self.linked(link).is_ok_and(would_be),
            has_own_room: has("room", OWN_ROOM),
            has_program: pairs(link)
                .any(|(key, id)| matches!(key, "behaviour" | "planner") && Algorithm::is_program_id(id)),
        }
    }

    /// The session as it would be after a link.
    fn linked(&self, link: &str) -> Result<Linked, SettingsError> {
        let mut settings = self.settings.clone();
        let mut room = None;
        let (mut shows_search, mut moment) = (None, None);
        // Robot and planner bring defaults of their own, which must not override the link's other values.
        let (first, others): (Vec<_>, Vec<_>) =
            pairs(link).partition(|(key, _)| matches!(*key, "robot" | "planner" | "behaviour"));
        for (key, value) in first {
            settings.take_link(key, value)?;
        }
        // Back and forward lead to how it was, and links of others to what they see.
        let is_whole = Settings::is_whole(pairs(link));
        if is_whole {
            settings.reset_unlinked();
        }
        for (key, value) in others {
            if key == "room" {
                room = Some(value);
            } else if key == "path" && value == KEPT_PATH {
                // It came with the room.
                settings.path = Some(self.settings.path.clone().ok_or(SettingsError::FarPath)?);
            } else if key == SEARCH {
                shows_search = Some(value == "1");
            } else if key == MOMENT {
                moment = Some(Moment::parse(value)?);
            } else {
                settings.take_link(key, value)?;
            }
        }
        let room = room.filter(|&id| id != OWN_ROOM).map(known_room).transpose()?;
        if let Some(room) = room
            && pairs(link).all(|(key, _)| key != "path")
            && !self.is_same_floor(&(room.build)())
        {
            settings.path = None;
        }
        let shows_search = shows_search.unwrap_or(!is_whole && self.shows_search);
        Ok(Linked { settings, room, shows_search, moment })
    }

    /// Settings with the start, as links have them.
    fn linked_settings(&self) -> Settings {
        let mut settings = self.settings.clone();
        settings.start = self.editor.start();
        settings
    }

    /// Applies settings, another room if there is one, and a start in it, as one undoable change.
    pub(in crate::explore) fn replace(
        &mut self,
        settings: Settings,
        room: Option<(FloorPlan, Option<&'static str>)>,
        start: Option<Pose>,
    ) {
        self.settings = settings;
        self.message = None;
        match room {
            Some((plan, id)) => self.editor.replace(plan, id, start),
            None if start.is_some() => self.editor.set_start(start),
            None => {}
        }
        self.prepare();
    }

    /// Room and settings as a scenario file that [`Session::load`] reads.
    pub fn scenario_json(&self) -> String {
        self.scenario().to_json()
    }

    /// Room and settings as a scenario.
    pub fn scenario(&self) -> Scenario {
        let settings = &self.settings;
        let defaults = Params::defaults(settings.algorithm.params());
        let changed = settings.params.iter().filter(|&(id, value)| defaults.get(id) != Some(value));
        let params = changed.filter_map(|(id, value)| Some((id.to_owned(), serde_json::to_value(value).ok()?)));
        let choices = ScenarioChoices::of_settings(settings);
        let mut scenario = self.own_room();
        scenario.robot = choices.robot;
        scenario.twin = settings.custom.as_ref().and_then(CustomRobot::twin);
        scenario.own_robot = settings.custom.as_ref().and_then(CustomRobot::own).cloned();
        scenario.path.clone_from(&settings.path);
        scenario.planner = choices.planner;
        scenario.behaviour = choices.behaviour;
        scenario.program = choices.program;
        scenario.params.extend(params);
        scenario.cell_size = choices.cell_size;
        scenario.cell_offset = choices.cell_offset;
        scenario.seed = Some(settings.seed);
        scenario.slip = choices.slip;
        scenario.noise = choices.noise.map(|levels| {
            let mut by_kind = BTreeMap::new();
            by_kind.extend(levels);
            by_kind
        });
        scenario.quantised = choices.quantised;
        scenario.start_charge_percent = choices.start_charge_percent;
        scenario.odometry = choices.odometry;
        scenario.smooth = choices.smooth;
        scenario
    }

    /// The room and the robot's start in it.
    pub fn own_room(&self) -> Scenario {
        let mut scenario = Scenario::of(self.plan());
        // A start inside a wall would be refused, and is of no use.
        let start = self.editor.start().or(self.plan().start);
        scenario.start = start.filter(|_| self.prepared.is_some()).map(Into::into);
        scenario
    }

    /// The session as a link's `key=value` pairs. A room that was drawn or loaded isn't in it: see [`Session::scenario_json`].
    pub fn link(&self) -> String {
        self.link_pairs().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>().join("&")
    }

    /// Keys and values of [`Session::link`].
    pub fn link_pairs(&self) -> impl Iterator<Item = (String, String)> + use<> {
        let settings = self.linked_settings();
        // A path that is too long for a link is kept with the room.
        let is_linked = settings.path_link().is_none_or(|path| path != KEPT_PATH);
        let room = self.editor.room().filter(|_| is_linked).unwrap_or(OWN_ROOM);
        let room = ("room".to_owned(), room.to_owned());
        let search = self.shows_search.then(|| (SEARCH.to_owned(), "1".to_owned()));
        std::iter::once(room).chain(settings.to_link()).chain(search)
    }
}

/// Keys and values of a link.
fn pairs(link: &str) -> impl Iterator<Item = (&str, &str)> {
    let pairs = link.trim_start_matches('#').split('&').filter(|pair| !pair.is_empty());
    pairs.map(|pair| pair.split_once('=').unwrap_or((pair, "")))
}

/// The built-in room with that id.
pub(in crate::explore) fn known_room(id: &str) -> Result<&'static RoomInfo, SettingsError> {
    floor_plan::room(id).ok_or_else(|| {
        let known = floor_plan::ROOMS.iter().map(|r| r.id).collect::<Vec<_>>().join(", ");
        SettingsError::Unknown { kind: "room", id: id.to_owned(), known }
    })
}
