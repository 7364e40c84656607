//! Metadata and construction of a behaviour.

use robovac_core::{
    registry::{ParamSpec, Params},
    robot::RobotModel,
};

/// Metadata of a behaviour for menus, forms and tests.
#[derive(Debug)]
pub struct BehaviourInfo {
    /// Name in links, files and on the command line: lower case, `_` between words; no planner has the same.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence on how it works.
    pub summary: &'static str,
    /// The properties that the contract tests check.
    pub claims: BehaviourClaims,
    /// Its parameters, the important ones first.
    pub params: &'static [ParamSpec],
}

/// Properties of a behaviour that the contract test checks.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BehaviourClaims {
    /// Ends by itself; others continue until the battery is empty.
    pub ends: bool,
    /// Cleans: covers more and more floor. Others serve another purpose, such as docking.
    pub cleans: bool,
    /// Cleans along walls and furniture only.
    pub walls_only: bool,
    /// Is driven by a person.
    pub manual: bool,
    /// Explores: its purpose is to detect walls and furniture for a map. Cleaned floor doesn't count.
    pub explores: bool,
    /// Does nothing without a laser scanner.
    pub needs_laser: bool,
}

impl BehaviourClaims {
    /// Claims nothing: what an entry of the registry begins with.
    pub const NONE: Self =
        Self { ends: false, cleans: false, walls_only: false, manual: false, explores: false, needs_laser: false };
}

/// Parameters for making a behaviour.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    /// The robot that it drives.
    pub robot: &'a RobotModel,
    /// Checked values of its parameters.
    pub params: &'a Params,
    /// Seed of its random numbers.
    pub seed: u64,
}
