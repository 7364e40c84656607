//! Controllers, which drive a robot by its sensor readings alone.
//!
//! [`FollowPath`] drives a planned line. All others are behaviours, which know nothing of the room: one file each, all in
//! one registry. To add one, write its file with the constants `INFO` (a [`BehaviourInfo`]) and `BUILD` (a [`BuildBehaviour`]) and
//! list it below; menus, forms, command line and the contract test iterate [`BEHAVIOURS`].

mod bounce;
mod by_map;
mod cleaning_cycle;
mod command;
mod dock;
mod explore;
mod follow_path;
mod info;
mod intent;
pub mod interlock;
mod manual;
mod parts;
mod random_walk;
mod s_path;
mod spiral;
mod timing;
mod wall_follow;

pub use by_map::clean_by_map;
pub use command::Joystick;
pub use follow_path::FollowPath;
pub use info::{BehaviourClaims, BehaviourInfo, Setup};
pub use intent::Intent;
pub use timing::Timing;

use robovac_core::{
    geometry::Pose,
    robot::{Drive, SensorReadings},
};

/// What drives a robot. Pure: the same readings give the same commands, on the simulated and on a real robot.
pub trait Controller {
    /// Takes a sensor reading, `dt_s` seconds after the last one, and says how to drive until the next.
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive;

    /// Whether there is nothing left to do.
    fn is_done(&self) -> bool;

    /// The controller's pose estimate, if it has one.
    fn estimate(&self) -> Option<Pose> {
        None
    }

    /// Index of the corner that it drives to, if it follows a line; the number of corners once it has come to the end.
    fn corner(&self) -> Option<usize> {
        None
    }

    /// What it is doing, in a few words that go on "The robot is ...": `backing up`; empty if there is nothing to tell.
    fn activity(&self) -> &'static str {
        ""
    }

    /// What a person at the controls wants; ignored by those that drive by themselves.
    fn command(&mut self, _: Joystick) {}

    /// What of a person's commands it doesn't obey at present, and why; `None` if nobody is at the controls.
    fn blocked(&self) -> Option<interlock::Blocked> {
        None
    }

    /// The map that it makes and its place on it, if it makes one.
    fn mapper(&self) -> Option<&crate::mapping::Mapper> {
        None
    }

    /// What it is going for on its map, if it makes one and drives by it.
    fn intent(&self) -> Option<Intent<'_>> {
        None
    }

    /// Learns where it starts, in the frame that its map is to have; to be called before the first step, by those who know.
    /// A map that nobody tells of begins at the origin, heading along x.
    fn start_at(&mut self, _: Pose) {}

    /// A copy in the same state, so that a run can be recorded and gone back to.
    fn boxed_clone(&self) -> Box<dyn Controller>;
}

/// Makes a behaviour.
pub type BuildBehaviour = fn(&Setup<'_>) -> Box<dyn Controller>;

/// Two lists of the same behaviours: what they say of themselves, and how they are made.
macro_rules! registry {
    ($($($behaviour:ident)::+),* $(,)?) => {
        /// All behaviours, in the order of the menus.
        pub const BEHAVIOURS: &[&BehaviourInfo] = &[$(&$($behaviour::)+INFO),*];
        const BUILDERS: &[(&str, BuildBehaviour)] = &[$(($($behaviour::)+INFO.id, $($behaviour::)+BUILD)),*];
        $(const _: () = $($behaviour::)+INFO.check();)*
    };
}

// One line a behaviour.
registry! {
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
    explore::frontier,
}

impl BehaviourInfo {
    /// Makes the behaviour; `None` for one that isn't in the registry.
    pub fn build(&self, setup: &Setup<'_>) -> Option<Box<dyn Controller>> {
        BUILDERS.iter().find(|(id, _)| *id == self.id).map(|(_, build)| build(setup))
    }
}

/// The behaviour with that id.
pub fn find(id: &str) -> Option<&'static BehaviourInfo> {
    BEHAVIOURS.iter().copied().find(|b| b.id == id)
}
