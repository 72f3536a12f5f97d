//! The tables of a report.

use super::{Page, bullets, cell};
use crate::findings::{CaseFindings, Times};
use crate::plan::Kind;
use crate::statistics::Summary;

/// The heading of a column, and what stands in it for a case.
type Column<'a> = (&'static str, Box<dyn Fn(&CaseFindings) -> String + 'a>);

impl Page<'_> {
    /// A table for each scene.
    pub(super) fn results(&self) -> String {
        let scenes = &self.findings.setting.scenes;
        let mut content = Vec::new();
        for scene in scenes {
            let cases: Vec<&CaseFindings> = self.findings.cases_of(&scene.id).collect();
            if cases.is_empty() {
                continue;
            }
            if self.findings.study != Kind::Triangles {
                content.push(format!("### {}", self.scene(&scene.id)));
            }
            content.push(self.table(&cases));
        }
        content.join("\n\n")
    }

    fn table(&self, cases: &[&CaseFindings]) -> String {
        let (text, numbers) = (self.text, self.numbers);
        let times = |times: &Times| {
            let Summary { median, lower_quartile, upper_quartile, minimum, .. } = times.summary_ms;
            let quartiles = format!("{}\u{2013}{}", numbers.time(lower_quartile), numbers.time(upper_quartile));
            [numbers.time(median), quartiles, numbers.time(minimum)]
        };
        let optional = |value: Option<f64>, write: &dyn Fn(f64) -> String| value.map_or(String::new(), write);
        let mut columns: Vec<Column<'_>> = vec![match self.findings.study {
            Kind::Threads => (text.threads, Box::new(|case| case.threads.to_string())),
            Kind::Triangles => (text.triangles, Box::new(|case| numbers.whole(case.triangles))),
            Kind::Rays => (text.rays_per_pixel, Box::new(|case| numbers.whole(u64::from(case.rays_per_pixel)))),
            Kind::Tiles => (text.tile_side, Box::new(|case| case.tile_size.to_string())),
        }];
        if self.findings.study == Kind::Threads {
            columns.push((text.threads_started, Box::new(|case| case.threads_started.to_string())));
        }
        if self.findings.study == Kind::Triangles {
            let build = move |case: &CaseFindings| {
                let written = case.build.as_ref().map(&times);
                written.map_or(String::new(), |[median, quartiles, _]| format!("{median} ({quartiles})"))
            };
            columns.push((text.build_ms, Box::new(build)));
        }
        for (place, heading) in [text.median_ms, text.quartiles_ms, text.minimum_ms].into_iter().enumerate() {
            columns.push((heading, Box::new(move |case| times(&case.render)[place].clone())));
        }
        match self.findings.study {
            Kind::Threads => {
                columns.push((text.speed_up, Box::new(move |c| optional(c.speed_up, &|v| numbers.fixed(v, 2)))));
                columns.push((text.efficiency, Box::new(move |c| optional(c.efficiency, &|v| numbers.fixed(v, 2)))));
                let over = move |c: &CaseFindings| optional(c.over_cores_percent, &|v| numbers.change(v));
                columns.push((text.over_cores, Box::new(over)));
                columns.push((text.cpu_ms, Box::new(move |c| optional(c.cpu_ms, &|v| numbers.time(v)))));
            }
            Kind::Rays => {
                columns.push((text.noise, Box::new(move |c| optional(c.noise_rmse, &|v| numbers.fixed(v, 6)))));
            }
            Kind::Tiles => {
                let over = move |c: &CaseFindings| optional(c.over_best_percent, &|v| numbers.change(v));
                columns.push((text.over_best, Box::new(over)));
            }
            Kind::Triangles => {}
        }
        columns.push((text.mray_per_s, Box::new(move |case| numbers.fixed(case.rays_per_s / 1e6, 1))));
        let headings: Vec<String> = columns.iter().map(|(heading, _)| (*heading).to_owned()).collect();
        let rows = cases.iter().map(|case| columns.iter().map(|(_, write)| write(case)).collect());
        table(&headings, rows)
    }

    /// How much longer each other scene takes than the first, for each number of threads.
    pub(super) fn growth(&self) -> Option<String> {
        let findings = self.findings;
        let (first, others) = findings.setting.scenes.split_first()?;
        let percent = |scene: &str, threads| {
            let case = findings.cases_of(scene).find(|case| case.threads == threads)?;
            case.growth_percent.map(|percent| self.numbers.change(percent))
        };
        let mut headings = vec![self.text.threads.to_owned()];
        headings.extend(others.iter().map(|s| format!("{}: {}", self.scene(&s.id), self.text.growth_percent)));
        let counts: Vec<u32> = findings.cases_of(&first.id).map(|case| case.threads).collect();
        let mut rows: Vec<Vec<String>> = Vec::new();
        for threads in counts {
            let cells = others.iter().map(|s| percent(&s.id, threads).unwrap_or_default());
            rows.push(std::iter::once(threads.to_string()).chain(cells).collect());
        }
        let mean = |scene: &str| findings.growth.iter().find(|g| g.to == scene).map(|g| g.mean_percent);
        let means = others.iter().map(|s| mean(&s.id).map_or(String::new(), |p| self.numbers.change(p)));
        rows.push(std::iter::once(self.text.mean.to_owned()).chain(means).collect());
        (!findings.growth.is_empty()).then(|| table(&headings, rows.into_iter()))
    }

    /// The published times; `None` if no scene of theirs is among ours.
    pub(super) fn published(&self) -> Option<String> {
        let (text, numbers, published) = (self.text, self.numbers, self.findings.published.as_ref()?);
        let scenes = || self.findings.setting.scenes.iter().map(|s| s.id.as_str());
        let best = |id: &str| {
            let speed_up = published.best_speed_up(id)?;
            Some((text.published_best)(&self.scene(id), &numbers.fixed(speed_up, 2)))
        };
        let best: Vec<String> = scenes().filter_map(best).collect();
        if best.is_empty() {
            return None;
        }
        let names = crate::Subject::SPHERES.map(|id| format!("{}, {}", self.scene(id), text.ms));
        let headings = [text.threads.to_owned(), names[0].clone(), names[1].clone(), text.growth_percent.to_owned()];
        let rows = published.times.iter().map(|time| {
            let growth = (time.two_spheres_ms / time.one_sphere_ms - 1.0) * 100.0;
            let times = [time.one_sphere_ms, time.two_spheres_ms].map(|ms| numbers.fixed(ms, 2));
            let [one, two] = times;
            vec![time.threads.to_string(), one, two, numbers.change(growth)]
        });
        let caveat = (text.published_caveat)(&published.cpu, published.cores, published.hardware_threads);
        Some(format!("{caveat}\n\n{}\n\n{}", table(&headings, rows), bullets(&best)))
    }
}

/// A table of numbers: every column to the right.
fn table(headings: &[String], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
    let mut lines = vec![line(headings.iter().map(|heading| cell(heading)).collect())];
    lines.push(format!("|{}", "---:|".repeat(headings.len())));
    lines.extend(rows.map(line));
    lines.join("\n")
}
