//! Write.
use super::Overlay;
use crate::floorplan::MapError;
/// x
pub fn to_dxf(_original: Option<&[u8]>, _overlays: &[Overlay]) -> Result<Vec<u8>, MapError> {
    Ok(Vec::new())
}
