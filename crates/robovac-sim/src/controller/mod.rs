//! Controllers, which drive a robot by its sensor readings alone.
//!
//! [`FollowPath`] drives a planned line, [`FollowSmoothly`] without stops at its corners. All others are behaviours, which know nothing of the room: one file each, all in
//! one registry. To add one, write its file with the constants `INFO` (a [`BehaviourInfo`]), `EXPLAINER` (an [`Explainer`]) and `BUILD` (a [`BuildBehaviour`]) and
//! list it below; menus, forms, command line and the contract test iterate [`BEHAVIOURS`].

mod bounce;
mod by_map;
mod cleaning_cycle;
mod command;
mod dock;
mod drive_on;
mod explore;
mod follow_path;
mod follow_smoothly;
mod follower;
mod info;
mod intent;
pub mod interlock;
pub mod learned;
mod manual;
mod online_snake;
mod parts;
mod random_walk;
mod recharge;
mod s_path;
mod spiral;
mod timing;
mod wall_follow;

pub use by_map::clean_by_map;
pub use command::Joystick;
pub use drive_on::drive_on;
pub use follow_path::FollowPath;
pub use follow_smoothly::FollowSmoothly;
pub use follower::Follower;
pub use info::{BehaviourClaims, BehaviourInfo, Setup};
pub use intent::Intent;
pub use parts::LIFTED;
pub(crate) use parts::safe_speed;
pub use recharge::Recharge;
pub use timing::Timing;

use crate::mapping::Mapper;
use robovac_core::{
    geometry::Pose,
    registry::Explainer,
    robot::{Drive, SensorReadings},
};

/// What drives a robot. Pure: the same readings give the same commands, on the simulated and on a real robot.
pub trait Controller {
    /// Takes a sensor reading, `dt_s` seconds after the last one, and returns the drive command until the next.
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive;

    /// Whether there is nothing left to do.
    fn is_done(&self) -> bool;

    /// Whether its next command isn't known yet. A run stands still meanwhile.
    fn waits(&self) -> bool {
        false
    }

    /// The controller's pose estimate, if it has one.
    fn estimate(&self) -> Option<Pose> {
        self.mapper().map(Mapper::pose)
    }

    /// Index of the corner that it drives to, if it follows a line; the number of corners at its end.
    fn corner(&self) -> Option<usize> {
        None
    }

    /// Its activity, in a few words that complete "The robot is ...": `backing up`; empty for none.
    fn activity(&self) -> &'static str {
        ""
    }

    /// A person's joystick command; ignored by autonomous controllers.
    fn command(&mut self, _: Joystick) {}

    /// The blocked part of a person's commands, with reasons; `None` for autonomous controllers.
    fn blocked(&self) -> Option<interlock::Blocked> {
        None
    }

    /// The map that it makes and its place on it, if it makes one.
    fn mapper(&self) -> Option<&Mapper> {
        None
    }

    /// Its goal on its map, if it makes one and drives by it.
    fn intent(&self) -> Option<Intent<'_>> {
        None
    }

    /// Sets its start in the frame that its map is to have; to be called before the first step, if known. By default a
    /// map begins at the origin, heading along x.
    fn start_at(&mut self, _: Pose) {}

    /// Approximate memory of its map, bytes.
    fn bytes(&self) -> usize {
        self.mapper().map_or(0, Mapper::bytes)
    }

    /// A copy in the same state, for key frames of recordings.
    fn boxed_clone(&self) -> Box<dyn Controller>;
}

/// Makes a behaviour.
pub type BuildBehaviour = fn(&Setup<'_>) -> Box<dyn Controller>;

/// A list of behaviours with their constructors. A program with only some of them is smaller, as others aren't linked.
#[derive(Debug, Clone, Copy)]
pub struct Behaviours(&'static [(&'static BehaviourInfo, BuildBehaviour)]);

impl Behaviours {
    /// No behaviour.
    pub const NONE: Self = Self(&[]);

    /// Their metadata, in the order of the menus.
    pub fn infos(self) -> impl Iterator<Item = &'static BehaviourInfo> + Clone {
        self.0.iter().map(|(info, _)| *info)
    }

    /// The behaviour with that id.
    pub fn find(self, id: &str) -> Option<&'static BehaviourInfo> {
        self.infos().find(|info| info.id == id)
    }

    /// Makes the behaviour with that id.
    pub fn build(self, id: &str, setup: &Setup<'_>) -> Option<Box<dyn Controller>> {
        self.0.iter().find(|(info, _)| info.id == id).map(|(_, build)| build(setup))
    }
}

/// Lists of the same behaviours: all, those that need no map, their metadata and their explanations.
macro_rules! registry {
    (mapless { $($($plain:ident)::+),* $(,)? } exploring { $($($explorer:ident)::+),* $(,)? }) => {
        /// Behaviours that keep no map: those of Explore, whose module is loaded first.
        pub const MAPLESS: Behaviours = Behaviours(&[$((&$($plain::)+INFO, $($plain::)+BUILD)),*]);
        /// All behaviours, in the order of the menus.
        pub const ALL: Behaviours = Behaviours(
            &[$((&$($plain::)+INFO, $($plain::)+BUILD),)* $((&$($explorer::)+INFO, $($explorer::)+BUILD)),*]
        );
        /// Ids of the behaviours that keep a map.
        pub const WITH_MAP: &[&str] = &[$($($explorer::)+INFO.id),*];
        /// Metadata of all behaviours.
        pub const BEHAVIOURS: &[&BehaviourInfo] = &[$(&$($plain::)+INFO,)* $(&$($explorer::)+INFO),*];
        const EXPLAINERS: &[(&str, &Explainer)] = &[
            $(($($plain::)+INFO.id, &$($plain::)+EXPLAINER),)* $(($($explorer::)+INFO.id, &$($explorer::)+EXPLAINER)),*
        ];
        $(const _: () = $($plain::)+EXPLAINER.check($($plain::)+INFO.summary);)*
        $(const _: () = $($explorer::)+EXPLAINER.check($($explorer::)+INFO.summary);)*
    };
}

// One line per behaviour.
registry! {
    mapless {
        random_walk,
        spiral,
        s_path,
        wall_follow,
        cleaning_cycle,
        bounce,
        dock,
        manual,
        explore::forward_rotate,
        explore::left_right,
        explore::look_ahead,
        explore::look_around,
        explore::until_obstacle,
        explore::edge,
    }
    exploring {
        explore::frontier,
        online_snake,
        learned,
    }
}

impl BehaviourInfo {
    /// Makes the behaviour; `None` for one that isn't in the registry.
    pub fn build(&self, setup: &Setup<'_>) -> Option<Box<dyn Controller>> {
        ALL.build(self.id, setup)
    }
}

/// The explanation of the behaviour with that id.
pub fn explainer(id: &str) -> Option<&'static Explainer> {
    EXPLAINERS.iter().find(|(of, _)| *of == id).map(|(_, explainer)| *explainer)
}

/// The behaviour with that id.
pub fn find(id: &str) -> Option<&'static BehaviourInfo> {
    ALL.find(id)
}
