//! SVG.
use super::Drawing;
use crate::floorplan::{MapError, SourceFile};
pub(super) fn is_svg(_bytes: &[u8]) -> bool {
    false
}
pub(super) fn read(file: &SourceFile) -> Result<Drawing, MapError> {
    Err(MapError::Empty { name: file.name.clone() })
}
