//! Errors of the configuration space.

/// Errors of the configuration space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CspaceError {
    /// The outline is no simple polygon around the origin, too large or too small.
    #[error("{0}")]
    Outline(String),
    /// The side of a cell isn't a valid length.
    #[error("the cell size can't be {0} m; choose one above 0")]
    Cell(f64),
    /// More cells than fit into memory.
    #[error("{width} x {height} cells with {headings} headings are too many; use larger cells or fewer headings")]
    TooLarge {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Headings.
        headings: usize,
    },
}
