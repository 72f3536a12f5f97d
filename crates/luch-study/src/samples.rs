//! Records with round numbers, for tests.

use crate::machine::Machine;
use crate::plan::{Effect, Effort, Plan};
use crate::run::{Measurement, Record};
use crate::study::Study;
use crate::subject::Subject;
use luch_render::SimdLevel;
use luch_scene::ImageSize;

/// A record in which case i took `times[i]` milliseconds, and a millisecond more and less in two other rounds.
fn record(plan: Plan, times: &[f64], change: impl Fn(&mut Measurement)) -> Record {
    let mut record = Record::begin(&Study::new(plan).expect("a plan that makes sense"));
    record.machine = machine();
    record.began = "2026-08-02T17:05:09Z".to_owned();
    record.partial = false;
    for (round, more) in [(0, 0.0), (1, 1.0), (2, -1.0)] {
        for (case, &ms) in times.iter().enumerate() {
            let mut measurement = Measurement {
                case,
                round,
                render_ms: ms + more,
                cpu_ms: Some(ms * 2.0),
                build_ms: None,
                rays: 1_000_000,
                threads_started: 2,
                noise_rmse: None,
            };
            change(&mut measurement);
            record.measurements.push(measurement);
        }
    }
    record
}

pub(crate) fn machine() -> Machine {
    Machine {
        cpu: Some("A processor of two cores".to_owned()),
        cores: Some(2),
        hardware_threads: Some(4),
        usable_threads: 4,
        memory_bytes: Some(8 << 30),
        simd: "avx2".to_owned(),
        os: "Some Linux 12".to_owned(),
        arch: "x86_64".to_owned(),
        version: "0.1.0".to_owned(),
        profile: "release".to_owned(),
        load_before: Some(0.12),
    }
}

fn subjects(ids: &[&'static str]) -> Vec<Subject> {
    ids.iter().map(|id| Subject::built_in(id).expect("a built-in scene")).collect()
}

fn effort() -> Effort {
    let size = ImageSize::new(64, 48).expect("a size in range");
    Effort { runs: 3, warm_up: 1, size, simd: SimdLevel::Auto }
}

pub(crate) fn threads() -> Record {
    let subjects = subjects(&Subject::SPHERES);
    let plan = Plan::Threads { subjects, threads: vec![1, 2, 4], effort: effort() };
    record(plan, &[100.0, 50.0, 60.0, 110.0, 60.0, 90.0], |_| {})
}

pub(crate) fn triangles() -> Record {
    let plan = Plan::Triangles { triangles: vec![1_000, 10_000, 100_000], threads: 2, effort: effort() };
    record(plan, &[10.0, 15.0, 22.0], |m| m.build_ms = Some([1.0, 10.0, 100.0][m.case]))
}

pub(crate) fn rays() -> Record {
    let subjects = subjects(&["one-sphere"]);
    let (rays, effect) = (vec![1, 4, 16], Effect::Antialiasing);
    let plan = Plan::Rays { subjects, rays, reference: 256, effect, threads: 2, effort: effort() };
    record(plan, &[10.0, 40.0, 160.0], |m| {
        m.noise_rmse = (m.round == 0).then_some([0.04, 0.02, 0.01][m.case]);
    })
}

pub(crate) fn tiles() -> Record {
    let subjects = subjects(&["one-sphere"]);
    let plan = Plan::Tiles { subjects, tiles: vec![8, 32, 128], threads: 2, effort: effort() };
    record(plan, &[25.0, 20.0, 22.0], |_| {})
}
