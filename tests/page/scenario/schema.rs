//! The part of JSON Schema that ours uses, to compare the schema with the reader.

use serde_json::Value;

/// Keywords that only people read.
const SILENT: [&str; 6] = ["$schema", "$defs", "title", "description", "default", "additionalProperties"];

/// Why `value` isn't what `schema` (part of `root`) describes; `None` if it is.
pub fn complaint(root: &Value, schema: &Value, value: &Value) -> Option<String> {
    let keywords = schema.as_object().expect("a schema is an object");
    keywords.iter().find_map(|(keyword, rule)| {
        let within = |part: &Value, value: &Value| complaint(root, part, value);
        let number = || value.as_f64().zip(rule.as_f64());
        let length = || value.as_array().map_or(0, Vec::len) as u64;
        let keys = || value.as_object().into_iter().flatten();
        let holds = match keyword.as_str() {
            "$ref" => {
                let name = rule.as_str().unwrap().strip_prefix("#/$defs/").expect("all references are local");
                return within(&root["$defs"][name], value);
            }
            "type" => match rule {
                Value::Array(types) => types.iter().any(|name| has_type(value, name)),
                name => has_type(value, name),
            },
            "const" => value == rule,
            "enum" => rule.as_array().unwrap().contains(value),
            "required" => rule.as_array().unwrap().iter().all(|key| value.get(key.as_str().unwrap()).is_some()),
            "not" => within(rule, value).is_some(),
            "minimum" => number().is_none_or(|(number, least)| number >= least),
            "maximum" => number().is_none_or(|(number, most)| number <= most),
            "minItems" => !value.is_array() || length() >= rule.as_u64().unwrap(),
            "maxItems" => length() <= rule.as_u64().unwrap(),
            "minLength" => value.as_str().is_none_or(|text| text.chars().count() as u64 >= rule.as_u64().unwrap()),
            "maxLength" => value.as_str().is_none_or(|text| text.chars().count() as u64 <= rule.as_u64().unwrap()),
            "minProperties" => keys().count() as u64 >= rule.as_u64().unwrap(),
            "maxProperties" => keys().count() as u64 <= rule.as_u64().unwrap(),
            "pattern" => {
                assert_eq!(rule, "^[#.?]+$", "the only pattern that is known here");
                value.as_str().is_none_or(|text| !text.is_empty() && text.chars().all(|c| "#.?".contains(c)))
            }
            "items" => return value.as_array().into_iter().flatten().find_map(|item| within(rule, item)),
            "properties" => {
                return keys().find_map(|(key, value)| match (rule.get(key), schema.get("additionalProperties")) {
                    (Some(part), _) => within(part, value),
                    (None, Some(Value::Bool(false))) => Some(format!("unknown key {key}")),
                    (None, _) => None,
                });
            }
            keyword => {
                assert!(SILENT.contains(&keyword), "this test doesn't know the keyword {keyword}");
                true
            }
        };
        (!holds).then(|| format!("{value} against {keyword}: {rule}"))
    })
}

fn has_type(value: &Value, name: &Value) -> bool {
    match name.as_str().unwrap() {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        name => panic!("unknown type {name}"),
    }
}
