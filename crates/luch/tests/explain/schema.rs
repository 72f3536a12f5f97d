//! A validator of JSON Schema for the words that `docs/explain.schema.json` uses. A word that it does not know is an
//! error, so that the schema cannot say what nobody checks.

use serde_json::Value;

/// Checks a value; answers with the first thing that is wrong and where.
pub(crate) fn validate(value: &Value, schema: &Value) -> Result<(), String> {
    check(value, schema, schema, "$")
}

fn check(value: &Value, schema: &Value, root: &Value, at: &str) -> Result<(), String> {
    let wrong = |what: String| Err(format!("{at}: {what}, in {}", shortened(value)));
    let words = schema.as_object().ok_or_else(|| format!("{at}: the schema is no object"))?;
    for (word, rule) in words {
        match word.as_str() {
            "$schema" | "$id" | "$defs" | "title" | "description" => {}
            "$ref" => {
                let place = rule.as_str().and_then(|r| r.strip_prefix('#')).unwrap_or_default();
                let target = root.pointer(place).ok_or_else(|| format!("{at}: the schema has no {rule}"))?;
                check(value, target, root, at)?;
            }
            "type" => {
                let fits = |name: &Value| is_of_type(value, name.as_str().unwrap_or_default());
                let fits = rule.as_array().map_or_else(|| fits(rule), |names| names.iter().any(fits));
                if !fits {
                    return wrong(format!("not of type {rule}"));
                }
            }
            "const" if value != rule => return wrong(format!("not {rule}")),
            "enum" if !rule.as_array().is_some_and(|all| all.contains(value)) => {
                return wrong(format!("not of {rule}"));
            }
            "const" | "enum" => {}
            "anyOf" => {
                let all = rule.as_array().ok_or_else(|| format!("{at}: anyOf is no list"))?;
                let outcomes: Vec<_> = all.iter().map(|one| check(value, one, root, at)).collect();
                if let Some(first) = outcomes.iter().all(Result::is_err).then(|| outcomes.into_iter().next()).flatten()
                {
                    return first;
                }
            }
            "minimum" | "maximum" | "exclusiveMinimum" => {
                let (Some(number), Some(limit)) = (value.as_f64(), rule.as_f64()) else { continue };
                let fits = match word.as_str() {
                    "minimum" => number >= limit,
                    "maximum" => number <= limit,
                    _ => number > limit,
                };
                if !fits {
                    return wrong(format!("against {word} {limit}"));
                }
            }
            "minItems" | "maxItems" => {
                let (Some(list), Some(limit)) = (value.as_array(), rule.as_u64()) else { continue };
                if (word == "minItems") != (list.len() as u64 >= limit) && list.len() as u64 != limit {
                    return wrong(format!("against {word} {limit}"));
                }
            }
            "items" => {
                for (index, item) in value.as_array().into_iter().flatten().enumerate() {
                    check(item, rule, root, &format!("{at}[{index}]"))?;
                }
            }
            "required" => {
                let Some(object) = value.as_object() else { continue };
                let mut names = rule.as_array().into_iter().flatten().filter_map(Value::as_str);
                if let Some(name) = names.find(|name| !object.contains_key(*name)) {
                    return wrong(format!("without {name}"));
                }
            }
            "properties" => {
                for (name, inner) in value.as_object().into_iter().flatten() {
                    match rule.get(name) {
                        Some(rule) => check(inner, rule, root, &format!("{at}.{name}"))?,
                        None if schema["additionalProperties"] == false => return wrong(format!("with {name}")),
                        None => {}
                    }
                }
            }
            "additionalProperties" if *rule == false => {}
            "pattern" if rule == "^#[0-9a-f]{6}$" => {
                let text = value.as_str().unwrap_or_default();
                let digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
                if !text.strip_prefix('#').is_some_and(|hex| hex.len() == 6 && digits(hex)) {
                    return wrong("no colour".to_owned());
                }
            }
            other => return Err(format!("{at}: the validator does not know {other}")),
        }
    }
    Ok(())
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        _ => false,
    }
}

fn shortened(value: &Value) -> String {
    let text = value.to_string();
    text.chars().take(120).collect()
}
