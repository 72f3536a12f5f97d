//! Findings as JSON, and back.

use crate::findings::Findings;

/// The content of `study.json`: every number that was measured or worked out, indented for people.
///
/// # Errors
/// None that is known of: findings are plain data.
pub fn to_json(findings: &Findings) -> serde_json::Result<String> {
    serde_json::to_string_pretty(findings).map(|text| text + "\n")
}

/// Reads the content of a `study.json`.
///
/// # Errors
/// What is not JSON, or not of this form: an unknown key is an error, too.
pub fn from_json(text: &str) -> serde_json::Result<Findings> {
    serde_json::from_str(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn what_is_written_is_read_back() {
        for mut record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            for left in [usize::MAX, 1, 0] {
                record.measurements.truncate(left);
                record.partial = left < 2;
                let findings = Findings::of(&record);
                assert_eq!(from_json(&to_json(&findings).unwrap()).unwrap(), findings);
            }
        }
    }

    #[test]
    fn keys_that_scripts_rely_on() {
        let findings = Findings::of(&samples::threads());
        let value: serde_json::Value = serde_json::from_str(&to_json(&findings).unwrap()).unwrap();
        assert_eq!(value["luch_study"], 1);
        assert_eq!((&value["study"], &value["partial"]), (&"threads".into(), &false.into()));
        assert_eq!(value["cases"][4]["render"]["summary_ms"]["median"], 60.0);
        assert_eq!(value["cases"][4]["render"]["runs_ms"].as_array().unwrap().len(), 3);
        assert_eq!(value["published"]["times"][0]["one_sphere_ms"], 626.01);
    }

    #[test]
    fn other_forms_are_refused() {
        let text = to_json(&Findings::of(&samples::tiles())).unwrap();
        assert!(from_json(&text.replacen("\"partial\"", "\"portial\"", 1)).is_err());
        assert!(from_json("{}").is_err());
    }
}
