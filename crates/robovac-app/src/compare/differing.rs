//! What tells an algorithm from its copies, in a few words.

use robovac_core::registry::{ParamKind, ParamSpec, ParamValue, Params};

/// The values in which `params` differ from one of `others`, such as "95 %" or "vertical"; empty if they are alike.
pub(super) fn differing(specs: &[ParamSpec], params: &Params, others: &[&Params]) -> String {
    let differs = |spec: &&ParamSpec| others.iter().any(|other| other.get(spec.id) != params.get(spec.id));
    let differing: Vec<&ParamSpec> = specs.iter().filter(differs).collect();
    let is_alone = differing.len() == 1;
    let words = differing.into_iter().filter_map(|spec| Some(short(spec, params.get(spec.id)?, is_alone)));
    words.collect::<Vec<_>>().join(", ")
}

/// A value in a few words; without its name where its unit says enough.
fn short(spec: &ParamSpec, value: &ParamValue, is_alone: bool) -> String {
    let label = lower(spec.label);
    match (spec.kind, value) {
        (ParamKind::Number { unit: "%", .. }, value) if is_alone => format!("{value} %"),
        (ParamKind::Number { unit: "", .. }, value) => format!("{label} {value}"),
        (ParamKind::Number { unit, .. }, value) => format!("{label} {value} {unit}"),
        (ParamKind::Choice { options }, ParamValue::Choice(word)) => {
            let option = options.iter().find(|(id, _)| id == word);
            lower(option.map_or(word.as_str(), |(_, label)| label))
        }
        (_, ParamValue::Flag(false)) => format!("without {label}"),
        _ => label,
    }
}

/// In the middle of a sentence; abbreviations stay.
fn lower(text: &str) -> String {
    let mut chars = text.chars();
    match (chars.next(), chars.next()) {
        (Some(first), Some(second)) if !second.is_uppercase() => {
            first.to_lowercase().chain(Some(second)).chain(chars).collect()
        }
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coverage_planners::PLANNERS;

    #[test]
    fn copies_are_told_by_what_differs() {
        for (planner, set, expected) in [
            ("boustrophedon", vec![("lanes", "vertical")], "vertical"),
            ("lanes", vec![("coverage", "95")], "95 %"),
            ("snake", vec![("patience", "0")], "patience 0"),
            ("boustrophedon", vec![], ""),
        ] {
            let specs = PLANNERS.iter().find(|info| info.id == planner).unwrap().params;
            let original = Params::defaults(specs);
            let mut copy = original.clone();
            for (id, text) in set {
                copy.set_text(specs, id, text).unwrap();
            }
            assert_eq!(differing(specs, &copy, &[&original, &copy]), expected);
            assert_eq!(differing(specs, &original, &[&copy]).is_empty(), expected.is_empty());
        }
    }
}
