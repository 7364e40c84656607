//! `$INSUNITS`: the drawing unit.

/// Metres per unit by its number in the DXF reference; `None` for 0, "unitless", and unknown ones.
pub(super) fn metres(number: i64) -> Option<f64> {
    /// A US survey foot: 1200/3937 m.
    const SURVEY_FOOT: f64 = 1200.0 / 3937.0;
    Some(match number {
        1 => 0.0254,
        2 => 0.3048,
        3 => 1609.344,
        4 => 1e-3,
        5 => 1e-2,
        6 => 1.0,
        7 => 1e3,
        8 => 0.0254e-6,
        9 => 0.0254e-3,
        10 => 0.9144,
        11 => 1e-10,
        12 => 1e-9,
        13 => 1e-6,
        14 => 0.1,
        15 => 10.0,
        16 => 100.0,
        17 => 1e9,
        18 => 149_597_870_700.0,
        19 => 9.460_730_472_580_8e15,
        20 => 3.085_677_581_491_367e16,
        21 => SURVEY_FOOT,
        22 => SURVEY_FOOT / 12.0,
        23 => SURVEY_FOOT * 3.0,
        24 => SURVEY_FOOT * 5280.0,
        _ => return None,
    })
}
