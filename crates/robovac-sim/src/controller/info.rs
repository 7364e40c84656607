//! Metadata and construction of a behaviour.

use robovac_core::{
    registry::{Explainer, ParamSpec, Params},
    robot::RobotModel,
};

/// What menus, forms and tests know of a behaviour.
#[derive(Debug)]
pub struct BehaviourInfo {
    /// Name in links, files and on the command line: lower case, `_` between words; no planner has the same.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence: how it goes about it.
    pub summary: &'static str,
    /// Where it comes from: authors, year, title, section.
    pub source: &'static str,
    /// Address of the source or of a good description; empty if there is none.
    pub link: &'static str,
    /// What its panel explains.
    pub explainer: Explainer,
    /// What the contract test holds it to.
    pub claims: BehaviourClaims,
    /// Its parameters, the important ones first.
    pub params: &'static [ParamSpec],
}

impl BehaviourInfo {
    /// Checks the texts.
    ///
    /// # Panics
    ///
    /// If they aren't as they must be. The registry has `const _: () = INFO.check();`, so that it is an error of the compiler.
    pub const fn check(&self) {
        self.explainer.check(self.summary);
        assert!(!self.source.is_empty(), "`source` is empty");
    }
}

/// Properties of a behaviour that the contract test checks.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BehaviourClaims {
    /// Comes to an end by itself; others go on until the battery is empty.
    pub ends: bool,
    /// Cleans: covers more and more floor. Others serve another purpose, such as going home.
    pub cleans: bool,
    /// Cleans along walls and furniture only.
    pub walls_only: bool,
    /// Is driven by a person.
    pub manual: bool,
    /// Explores: is there to see walls and furniture, for a map. What it cleans on the way doesn't count.
    pub explores: bool,
}

/// What a behaviour is made from.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    /// The robot that it drives.
    pub robot: &'a RobotModel,
    /// Checked values of its parameters.
    pub params: &'a Params,
    /// Seed of its random numbers.
    pub seed: u64,
}
