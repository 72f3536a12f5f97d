//! The table for spreadsheets and scripts: one row for each case, the same in every language.

use crate::findings::{CaseFindings, Findings};
use crate::statistics::Summary;

/// The columns; docs/study.md explains each.
pub const COLUMNS: [&str; 25] = [
    "study",
    "partial",
    "scene",
    "threads",
    "threads_started",
    "triangles",
    "rays_per_pixel",
    "tile_size",
    "runs",
    "median_ms",
    "lower_quartile_ms",
    "upper_quartile_ms",
    "minimum_ms",
    "maximum_ms",
    "cpu_ms",
    "build_median_ms",
    "build_lower_quartile_ms",
    "build_upper_quartile_ms",
    "rays_per_s",
    "noise_rmse",
    "speed_up",
    "efficiency",
    "over_cores_percent",
    "growth_percent",
    "over_best_percent",
];

/// The content of `study.csv` (RFC 4180, lines end with a line feed): a cell is empty where the study has no such number.
#[must_use]
pub fn csv(findings: &Findings) -> String {
    let mut lines = vec![COLUMNS.join(",")];
    lines.extend(findings.cases.iter().map(|case| row(findings, case).map(|cell| quoted(&cell)).join(",")));
    lines.join("\n") + "\n"
}

fn row(findings: &Findings, case: &CaseFindings) -> [String; COLUMNS.len()] {
    let Summary { median, lower_quartile, upper_quartile, minimum, maximum } = case.render.summary_ms;
    let build = |of: fn(&Summary) -> f64| case.build.as_ref().map(|times| of(&times.summary_ms));
    let optional = |value: Option<f64>| value.map_or(String::new(), |v| v.to_string());
    [
        findings.study.word().to_owned(),
        findings.partial.to_string(),
        case.scene.clone(),
        case.threads.to_string(),
        case.threads_started.to_string(),
        case.triangles.to_string(),
        case.rays_per_pixel.to_string(),
        case.tile_size.to_string(),
        case.render.runs_ms.len().to_string(),
        median.to_string(),
        lower_quartile.to_string(),
        upper_quartile.to_string(),
        minimum.to_string(),
        maximum.to_string(),
        optional(case.cpu_ms),
        optional(build(|s| s.median)),
        optional(build(|s| s.lower_quartile)),
        optional(build(|s| s.upper_quartile)),
        case.rays_per_s.to_string(),
        optional(case.noise_rmse),
        optional(case.speed_up),
        optional(case.efficiency),
        optional(case.over_cores_percent),
        optional(case.growth_percent),
        optional(case.over_best_percent),
    ]
}

/// A cell, quoted if it holds what means something in a table.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn the_table_reads_back_as_what_was_found() {
        for record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            let findings = Findings::of(&record);
            let text = csv(&findings);
            let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
            let columns = lines.next().unwrap();
            assert_eq!(columns, COLUMNS);
            let rows: Vec<Vec<&str>> = lines.collect();
            assert_eq!(rows.len(), findings.cases.len());
            for (row, case) in rows.iter().zip(&findings.cases) {
                assert_eq!(row.len(), COLUMNS.len());
                let cell = |name: &str| row[COLUMNS.iter().position(|c| *c == name).unwrap()];
                let number = |name: &str| cell(name).parse::<f64>().ok();
                assert_eq!((cell("study"), cell("scene")), (findings.study.word(), case.scene.as_str()));
                assert_eq!(number("threads"), Some(f64::from(case.threads)));
                assert_eq!(number("threads_started"), Some(2.0));
                assert_eq!(number("triangles"), Some(case.triangles as f64));
                assert_eq!(number("runs"), Some(3.0));
                assert_eq!(number("median_ms"), Some(case.median_ms()));
                assert_eq!(number("upper_quartile_ms"), Some(case.render.summary_ms.upper_quartile));
                assert_eq!(number("build_median_ms"), case.build.as_ref().map(|b| b.summary_ms.median));
                assert_eq!(number("noise_rmse"), case.noise_rmse);
                assert_eq!(number("speed_up"), case.speed_up);
                assert_eq!(number("growth_percent"), case.growth_percent);
                assert_eq!(number("over_cores_percent"), case.over_cores_percent);
                assert_eq!(number("over_best_percent"), case.over_best_percent);
            }
        }
    }

    #[test]
    fn a_scene_with_a_comma_in_its_path_is_one_cell() {
        let mut record = samples::tiles();
        let crate::Plan::Tiles { mut subjects, tiles, threads, effort } = record.study.plan().clone() else { panic!() };
        subjects[0].id = "my, \"best\".toml".to_owned();
        record.study = crate::Study::new(crate::Plan::Tiles { subjects, tiles, threads, effort }).unwrap();
        assert!(csv(&Findings::of(&record)).contains("tiles,false,\"my, \"\"best\"\".toml\",2,2,"));
    }
}
