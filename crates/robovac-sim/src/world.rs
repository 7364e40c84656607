//! The robot's surroundings apart from the walls.

use robovac_core::{
    floor_plan::{FloorPlan, Object, Who},
    geometry::{Point, Pose, contains},
};

/// Objects of a room that aren't obstacles, prepared for simulation. Obstacles are part of the walls; the moving and
/// consumable state is in [`Life`](super::Life).
#[derive(Debug, Clone, Default)]
pub struct World {
    /// Docks: the middle of the back, and the heading.
    pub docks: Vec<Pose>,
    /// Virtual walls: the lighthouse's position with the beam's direction, and the beam's length, m.
    pub virtual_walls: Vec<(Pose, f64)>,
    /// Outlines of drop-offs.
    pub drop_offs: Vec<Vec<Point>>,
    /// Outlines of carpets.
    pub carpets: Vec<Vec<Point>>,
    /// Spots of dirt: centre and radius, m.
    pub dirt: Vec<(Point, f64)>,
    /// Movers and their lines.
    pub movers: Vec<(Who, Vec<Point>)>,
}

impl World {
    /// The objects in `plan`.
    pub fn new(plan: &FloorPlan) -> Self {
        let mut world = Self::default();
        for object in &plan.objects {
            match object.clone() {
                Object::Furniture { .. } | Object::LowObstacle { .. } | Object::Leg { .. } => {}
                Object::DropOff { outline } => world.drop_offs.push(outline),
                Object::Carpet { outline } => world.carpets.push(outline),
                Object::Dirt { at, radius } => world.dirt.push((at, radius)),
                Object::Dock { pose } => world.docks.push(pose),
                Object::VirtualWall { pose, length } => world.virtual_walls.push((pose, length)),
                Object::Mover { who, path } => world.movers.push((who, path)),
            }
        }
        world
    }

    /// Whether there is no floor at a point.
    #[inline]
    pub fn is_drop_off(&self, point: Point) -> bool {
        self.drop_offs.iter().any(|outline| contains(outline, point))
    }

    /// Whether there is carpet at a point.
    #[inline]
    pub fn is_on_carpet(&self, point: Point) -> bool {
        self.carpets.iter().any(|outline| contains(outline, point))
    }
}
