//! Errors when placing a robot in a room.

/// Errors when placing a robot in a room.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FloorError {
    /// No cell of the map is free.
    #[error("the map has no free floor to clean; add some (in images, light pixels are free)")]
    NoFreeCell,
    /// The robot doesn't fit anywhere.
    #[error(
        "the robot, {diameter:.2} m wide, fits nowhere in this room; choose a smaller robot or check the map's resolution"
    )]
    TooNarrow {
        /// Diameter of the robot's body, m.
        diameter: f64,
    },
    /// Planning cells are finer than the fine grid.
    #[error("planning cells of {cell_size} m are too small for this map; choose at least {least} m")]
    CellTooSmall {
        /// The given side, m.
        cell_size: f64,
        /// The smallest allowed side, m.
        least: f64,
    },
    /// The start lies outside the map.
    #[error(
        "the start ({x:.2} m, {y:.2} m) lies outside the map, which is {width:.2} m x {height:.2} m; move it inside"
    )]
    StartOutside {
        /// x of the start, m.
        x: f64,
        /// y of the start, m.
        y: f64,
        /// Width of the map, m.
        width: f64,
        /// Height of the map, m.
        height: f64,
    },
    /// The start lies in a wall, in furniture or on a drop-off.
    #[error(
        "the start ({x:.2} m, {y:.2} m) is inside a wall or an obstacle; move it to free floor, e.g. ({free_x:.2} m, {free_y:.2} m)"
    )]
    StartInWall {
        /// x of the start, m.
        x: f64,
        /// y of the start, m.
        y: f64,
        /// x of the nearest place where the robot fits, m.
        free_x: f64,
        /// y of the nearest place where the robot fits, m.
        free_y: f64,
    },
}
