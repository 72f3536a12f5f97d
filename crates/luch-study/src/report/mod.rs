//! The report for people: Markdown, in their language.

mod tables;

use crate::findings::{Findings, Growth};
use crate::language::{Language, Numbers, SpeedUp, Text};
use crate::plan::Kind;
use std::fmt::Write as _;

/// From this load of other programs on, times are not to be trusted.
const BUSY: f64 = 0.5;

/// The content of `study.md`; `plots` are the stems of the plots that lie beside it, with their titles.
#[must_use]
pub fn markdown(findings: &Findings, plots: &[(String, String)], language: Language) -> String {
    let text = language.text();
    let page = Page { findings, text, numbers: &text.numbers };
    let mut lines = vec![format!("# {}", (text.title)(findings.study))];
    lines.extend(page.warnings().into_iter().map(|warning| format!("> {warning}")));
    lines.push(page.section(text.found, &bullets(&page.found())));
    for (stem, title) in plots {
        // Somebody's scene may be called anything; a title is no place for brackets.
        let title = title.replace(['[', ']'], " ");
        lines.push(format!("![{title}]({stem}.svg)"));
    }
    lines.push(page.section(text.results, &page.results()));
    if findings.study == Kind::Threads {
        lines.extend(page.growth().map(|table| page.section(text.growth, &table)));
        lines.extend(page.published().map(|content| page.section(text.published, &content)));
    }
    lines.push(page.section(text.method, &bullets(&page.method())));
    lines.push(page.section(text.machine, &page.machine()));
    lines.push(text.more.to_owned());
    lines.join("\n\n") + "\n"
}

/// What was found, a sentence each, without marks of Markdown: for terminals and panels.
#[must_use]
pub fn sentences(findings: &Findings, language: Language) -> Vec<String> {
    let text = language.text();
    let page = Page { findings, text, numbers: &text.numbers };
    let plain = |line: String| line.replace("**", "");
    page.warnings().into_iter().chain(page.found()).map(plain).collect()
}

/// A report in the making.
struct Page<'a> {
    findings: &'a Findings,
    text: &'static Text,
    numbers: &'static Numbers,
}

impl Page<'_> {
    fn section(&self, heading: &str, content: &str) -> String {
        format!("## {heading}\n\n{content}")
    }

    /// The scene's name in the language of the report.
    fn scene(&self, id: &str) -> String {
        scene_name(self.findings, id, self.text)
    }

    fn warnings(&self) -> Vec<String> {
        let Findings { machine, partial, .. } = self.findings;
        let busy = machine.load_before.filter(|load| *load >= BUSY);
        [
            partial.then(|| self.text.partial.to_owned()),
            (machine.profile != "release").then(|| self.text.debug_build.to_owned()),
            busy.map(|load| (self.text.busy)(&self.numbers.fixed(load, 1))),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn found(&self) -> Vec<String> {
        let (findings, text, numbers) = (self.findings, self.text, self.numbers);
        let mut found = Vec::new();
        match findings.study {
            Kind::Threads => {
                found.extend(findings.setting.scenes.iter().filter_map(|scene| self.best_speed_up(&scene.id)));
                for law in &findings.amdahl {
                    let limit = law.limit().map(|limit| numbers.fixed(limit, 1));
                    let share = numbers.fixed(law.serial_share * 100.0, 1);
                    found.push((text.found_law)(&self.scene(&law.scene), &share, limit.as_deref()));
                }
                for Growth { from, to, mean_percent } in &findings.growth {
                    found.push((text.found_growth)(&self.scene(from), &self.scene(to), &numbers.change(*mean_percent)));
                }
                let cores = findings.machine.cores_for_threads();
                let worst = findings.worst_over_cores_percent();
                found.extend(worst.map(|percent| (text.found_over_cores)(cores, &numbers.change(percent))));
            }
            Kind::Triangles | Kind::Rays => found.extend(findings.exponents.iter().map(|exponent| {
                let scene = exponent.scene.as_ref().map(|id| self.scene(id));
                (text.found_exponent)(exponent.of, scene.as_deref(), &numbers.fixed(exponent.exponent, 2))
            })),
            Kind::Tiles => found.extend(findings.setting.scenes.iter().filter_map(|scene| {
                let best = findings.cases_of(&scene.id).min_by(|a, b| a.median_ms().total_cmp(&b.median_ms()))?;
                Some((text.found_best_tile)(&self.scene(&scene.id), best.tile_size, &numbers.time(best.median_ms())))
            })),
        }
        found
    }

    /// What the most threads that have a core each brought; with fewer threads than that, the most that were measured.
    fn best_speed_up(&self, scene: &str) -> Option<String> {
        let cores = self.findings.machine.cores_for_threads();
        let one = self.findings.cases_of(scene).find(|case| case.threads == 1)?;
        let most = self.findings.cases_of(scene).filter(|case| (2..=cores).contains(&case.threads));
        let most = most.max_by_key(|case| case.threads)?;
        Some((self.text.found_speed_up)(&SpeedUp {
            scene: &self.scene(scene),
            one_ms: &self.numbers.time(one.median_ms()),
            threads: most.threads,
            ms: &self.numbers.time(most.median_ms()),
            speed_up: &self.numbers.fixed(most.speed_up?, 2),
        }))
    }

    fn method(&self) -> Vec<String> {
        let (findings, text) = (self.findings, self.text);
        let setting = &findings.setting;
        let mut method = vec![text.method_time.to_owned()];
        if findings.study == Kind::Triangles {
            method.extend([text.method_build, text.method_meshes].map(str::to_owned));
        }
        method.push((text.method_picture)(setting.size, &findings.machine.simd));
        if findings.study != Kind::Threads {
            method.extend(findings.cases.first().map(|case| (text.method_threads)(case.threads)));
        }
        method.push((text.method_runs)(setting.warm_up, setting.runs));
        method.push(text.method_quartiles.to_owned());
        match findings.study {
            Kind::Threads => {
                method.push(text.method_started.to_owned());
                method.push(text.method_efficiency.to_owned());
                let cores = findings.machine.cores_for_threads();
                let base = findings.most_threads_with_cores();
                method.extend(base.map(|threads| (text.method_over_cores)(threads, cores)));
                if let Some(law) = findings.amdahl.first() {
                    let counts: Vec<String> = law.fitted_threads.iter().map(u32::to_string).collect();
                    method.push((text.method_law)(&counts.join(", ")));
                    if counts.len() == 2 {
                        method.push(text.method_law_exact.to_owned());
                    }
                }
            }
            Kind::Triangles => method.push(text.method_exponent.to_owned()),
            Kind::Rays => {
                if let (Some(effect), Some(reference)) = (setting.effect, setting.reference_rays) {
                    method.push((text.method_noise)((text.effect)(effect), reference));
                }
                method.push(text.method_exponent.to_owned());
            }
            Kind::Tiles => {}
        }
        method
    }

    fn machine(&self) -> String {
        let (machine, text, numbers) = (&self.findings.machine, self.text, self.numbers);
        let known = |value: Option<String>| value.unwrap_or_else(|| text.unknown.to_owned());
        let count = |value: Option<u32>| known(value.map(|n| n.to_string()));
        let memory = machine.memory_bytes.map(|b| (text.gibibytes)(&numbers.fixed(b as f64 / (1_u64 << 30) as f64, 1)));
        let profile = if machine.profile == "release" { text.release } else { text.debug };
        let rows = [
            (text.processor, known(machine.cpu.clone())),
            (text.cores, count(machine.cores)),
            (text.hardware_threads, count(machine.hardware_threads)),
            (text.usable_threads, machine.usable_threads.to_string()),
            (text.memory, known(memory)),
            (text.simd, machine.simd.clone()),
            (text.system, format!("{}, {}", machine.os, machine.arch)),
            (text.program, format!("luch {}, {profile}", machine.version)),
            (text.load, known(machine.load_before.map(|load| numbers.fixed(load, 2)))),
            (text.began, self.findings.began.clone()),
        ];
        let mut content = "| | |\n|---|---|".to_owned();
        for (name, value) in rows {
            // Writing to a string cannot fail.
            let _ = write!(content, "\n| {name} | {} |", cell(&value));
        }
        content
    }
}

/// The name of a scene of the findings in a language.
pub(crate) fn scene_name(findings: &Findings, id: &str, text: &Text) -> String {
    let known = findings.setting.scenes.iter().find(|scene| scene.id == id);
    (text.scene)(id).map_or_else(|| known.map_or(id, |scene| scene.name.as_str()).to_owned(), str::to_owned)
}

fn bullets(lines: &[String]) -> String {
    lines.iter().map(|line| format!("- {line}")).collect::<Vec<_>>().join("\n")
}

/// A text that may stand in a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace(['\n', '\r'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn report(findings: &Findings, language: Language) -> String {
        markdown(findings, &[("threads-all".to_owned(), "A [title]".to_owned())], language)
    }

    #[test]
    fn an_english_report_has_the_numbers_worked_out_by_hand() {
        let text = report(&Findings::of(&samples::threads()), Language::English);
        for part in [
            "# Render time against the number of threads\n",
            "- **One sphere**: 100.0 ms with one thread, 50.00 ms with 2: 2.00 times as fast.\n",
            "- **Two spheres**, by Amdahl\u{2019}s law: 9.1 % of the work is serial, so that no number of threads would make \
             it more than 11.0 times as fast.\n",
            "- **Two spheres** against **One sphere**: +26.7 % of time",
            "- More threads than the 2 cores change the median time by +50.0 % at worst.",
            "![A  title ](threads-all.svg)",
            "| 2 | 2 | 60.00 | 59.50\u{2013}60.50 | 59.00 | 1.83 | 0.92 |  | 120.0 | 16.7 |",
            "| 4 | 2 | 60.00 | 59.50\u{2013}60.50 | 59.00 | 1.67 | 0.42 | +20.0 | 120.0 | 16.7 |",
            "| Mean | +26.7 |",
            "| 1 | 626.01 | 694.57 | +11.0 |",
            "The size of its pictures is not stated",
            "- Two numbers of threads determine the law",
            "| Processor | A processor of two cores |",
            "| Program | luch 0.1.0, release build |",
        ] {
            assert!(text.contains(part), "{part}\nis not in\n{text}");
        }
        assert!(!text.contains("Partial") && !text.contains("Busy"), "{text}");
    }

    #[test]
    fn a_russian_report_has_no_word_of_english_prose() {
        let text = report(&Findings::of(&samples::threads()), Language::Russian);
        for part in [
            "# Зависимость времени визуализации от числа потоков\n",
            "- **Одна сфера**: 100,0 мс на одном потоке, 50,00 мс на 2 потоках: быстрее в 2,00 раза.\n",
            "| Число потоков | Запущено | Медиана, мс | Квартили, мс | Минимум, мс | Ускорение | Эффективность |",
            "| 4 | 2 | 60,00 | 59,50\u{2013}60,50 | 59,00 | 1,67 | 0,42 | +20,0 | 120,0 | 16,7 |",
            "Размер изображения не указан",
        ] {
            assert!(text.contains(part), "{part}\nis not in\n{text}");
        }
        for study in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            let text = markdown(&Findings::of(&study), &[], Language::Russian);
            for word in ["the", "thread", "threads", "time", "median", "sphere", "noise", "tile"] {
                let words = || text.split(|c: char| !c.is_alphanumeric());
                assert!(!words().any(|w| w.eq_ignore_ascii_case(word)), "{word} is in\n{text}");
            }
        }
    }

    #[test]
    fn what_makes_times_worthless_is_said_first() {
        let mut record = samples::threads();
        record.partial = true;
        record.machine.profile = "debug".to_owned();
        record.machine.load_before = Some(3.0);
        for (language, words) in
            [(Language::English, "**Busy machine.**"), (Language::Russian, "**Компьютер был занят.**")]
        {
            let text = report(&Findings::of(&record), language);
            let head: Vec<&str> = text.lines().take_while(|line| !line.starts_with("##")).collect();
            assert_eq!(head.iter().filter(|line| line.starts_with("> **")).count(), 3, "{head:?}");
            assert!(text.contains(words));
            let sentences = sentences(&Findings::of(&record), language);
            assert!(sentences.len() > 3 && sentences.iter().all(|s| !s.contains("**")), "{sentences:?}");
        }
    }

    #[test]
    fn every_study_of_every_extent_has_a_report() {
        for mut record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            for left in [usize::MAX, 1, 0] {
                record.measurements.truncate(left);
                for language in Language::ALL {
                    let text = report(&Findings::of(&record), language);
                    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
                }
            }
        }
    }

    #[test]
    fn a_name_with_bars_does_not_break_the_table() {
        let mut record = samples::threads();
        record.machine.cpu = Some("A|B\nC".to_owned());
        assert!(report(&Findings::of(&record), Language::English).contains("| Processor | A\\|B C |"));
    }
}
