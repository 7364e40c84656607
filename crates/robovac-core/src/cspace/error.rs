//! Why there is no configuration space.

/// Why there is no configuration space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CspaceError {
    /// The outline is no simple polygon around the origin, too large or too small.
    #[error("{0}")]
    Outline(String),
    /// The side of a cell is no length.
    #[error("cells can't be {0} m wide; choose a width above 0")]
    Cell(f64),
    /// More cells than fit into memory.
    #[error("{width} x {height} cells with {headings} headings are more than fit; take larger cells or fewer headings")]
    TooLarge {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Headings.
        headings: usize,
    },
}
