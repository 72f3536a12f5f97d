//! English.

use super::{Numbers, SpeedUp, Text};
use crate::findings::Grows;
use crate::plan::{Effect, Kind, MAX_PIXELS, MAX_VALUES};
use crate::plan_error::{PlanError, Quantity};

pub(super) static TEXT: Text = Text {
    numbers: Numbers { decimal: ".", group: ",", grouped_from: 4 },

    scene: |id| {
        Some(match id {
            "one-sphere" => "One sphere",
            "two-spheres" => "Two spheres",
            "knight" => "Knight, cube and sphere",
            "chess" => "Chess",
            "bumpy-sphere" => "Bumpy sphere",
            _ => return None,
        })
    },
    title: |kind| match kind {
        Kind::Threads => "Render time against the number of threads",
        Kind::Triangles => "Time against the number of triangles",
        Kind::Rays => "Time and noise against rays per pixel",
        Kind::Tiles => "Render time against the size of the tiles",
    },
    effect: |effect| match effect {
        Effect::Antialiasing => "the pixel (antialiasing)",
        Effect::DepthOfField => "the lens (depth of field)",
        Effect::Both => "the pixel and the lens (antialiasing and depth of field)",
    },

    plan_error,

    found: "What was found",
    results: "Results",
    growth: "What the other scene costs more",
    published: "The published study",
    method: "How it was measured",
    machine: "The machine",

    threads: "Threads",
    threads_started: "Started",
    triangles: "Triangles",
    rays_per_pixel: "Rays per pixel",
    tile_side: "Side of a tile",
    tile_side_axis: "Side of a tile, pixels",
    median_ms: "Median, ms",
    quartiles_ms: "Quartiles, ms",
    minimum_ms: "Minimum, ms",
    cpu_ms: "CPU time, ms",
    build_ms: "Build (quartiles), ms",
    speed_up: "Speed-up",
    efficiency: "Efficiency",
    over_cores: "Over cores, %",
    over_best: "Over the best, %",
    mray_per_s: "Mray/s",
    noise: "Noise (RMSE)",
    growth_percent: "growth, %",
    time_axis: "Time, ms",
    render_time_axis: "Render time, ms",
    noise_axis: "Noise (RMSE of linear light)",
    speed_up_axis: "Speed-up",
    mean: "Mean",
    ms: "ms",

    plot_threads_all: "Render time against the number of threads",
    plot_threads_from_2: "Render time from two threads on",
    plot_speed_up: "Speed-up against one thread",
    plot_triangles: "Time against the number of triangles",
    plot_rays_time: "Render time against rays per pixel",
    plot_rays_noise: "Noise against rays per pixel",
    plot_tiles: "Render time against the size of the tiles",
    ours: "Luch, this machine",
    build: "Build",
    render: "Render",
    perfect: "Perfect, up to the cores",
    published_series: |scene| format!("{scene}, published"),
    published_panel: |cpu| format!("Published: {cpu}, image size not stated"),
    law_series: |scene| format!("{scene}, Amdahl\u{2019}s law"),
    power_series: |what, exponent| format!("{what}, exponent {exponent}"),
    more_than_cores: |cores| format!("More threads than this machine has cores ({cores})"),
    bars: "Medians; bars span the quartiles.",
    partial_short: "Partial: stopped before its end.",

    processor: "Processor",
    cores: "Cores",
    hardware_threads: "Hardware threads",
    usable_threads: "Usable threads",
    memory: "Memory",
    gibibytes: |amount| format!("{amount} GiB"),
    simd: "Instruction set",
    system: "System",
    program: "Program",
    release: "release build",
    debug: "debug build",
    load: "Load before",
    began: "Began",
    unknown: "not known",
    cores_short: |count| if count == 1 { "1 core".to_owned() } else { format!("{count} cores") },

    partial: "**Partial.** The study was stopped before its end; what follows rests on the runs made until then.",
    debug_build: "**Debug build.** The program was not built for speed: these times say little of a release build.",
    busy: |load| {
        format!("**Busy machine.** Before the study other programs kept {load} threads busy: the times are too long.")
    },
    found_speed_up: |SpeedUp { scene, one_ms, threads, ms, speed_up }| {
        format!("**{scene}**: {one_ms} ms with one thread, {ms} ms with {threads}: {speed_up} times as fast.")
    },
    found_law: |scene, percent, limit| match limit {
        Some(limit) => format!(
            "**{scene}**, by Amdahl\u{2019}s law: {percent} % of the work is serial, so that no number of threads would \
             make it more than {limit} times as fast."
        ),
        None => format!("**{scene}**, by Amdahl\u{2019}s law: no part of the work is serial that could be measured."),
    },
    found_growth: |from, to, percent| {
        format!("**{to}** against **{from}**: {percent} % of time, in the mean over the numbers of threads.")
    },
    found_over_cores: |cores, percent| {
        format!("More threads than the {cores} cores change the median time by {percent} % at worst.")
    },
    found_exponent: |grows, scene, exponent| {
        let of = scene.map(|scene| format!("**{scene}**: ")).unwrap_or_default();
        match grows {
            Grows::Render => format!("{of}The time to render grows by the power {exponent}."),
            Grows::Build => format!("{of}The time to build grows by the power {exponent}."),
            Grows::Noise => {
                format!("{of}The noise falls by the power {exponent}; that of unrelated random rays is \u{2212}0.5.")
            }
        }
    },
    found_best_tile: |scene, side, ms| format!("**{scene}**: tiles of {side}x{side} pixels are the fastest, {ms} ms."),
    published_best: |scene, speed_up| format!("**{scene}**: at best {speed_up} times as fast as with one thread."),
    published_caveat: |cpu, cores, threads| {
        format!(
            "Times of another program, as published, on an {cpu} ({cores} cores, {threads} threads). The size of its \
             pictures is not stated and the machine is another one: the shapes of the curves can be compared, the \
             milliseconds cannot."
        )
    },
    method_time: "A time is that of the render alone, from the start of the first thread to the end of the last: reading \
                  the scene, building trees and writing files are not in it.",
    method_build: "The time to build is that of everything that makes a mesh ready for rays: tree and shading layout.",
    method_picture: |[width, height], simd| {
        format!("Pictures of {width}x{height} pixels from the scene\u{2019}s first camera, instruction set {simd}.")
    },
    method_threads: |threads| match threads {
        1 => "One thread.".to_owned(),
        _ => format!("{threads} threads."),
    },
    method_runs: |warm_up, runs| {
        format!(
            "Each case was run {warm_up} times to warm up and then {runs} times. A round runs every case once; the rounds \
             are ordered so that every case stands at every place, and comes right after every other, equally often \
             (Williams, 1949): no drift of the machine favours one."
        )
    },
    method_quartiles: "Quartiles are those of Hyndman and Fan\u{2019}s definition 7 (1996), as in NumPy, R and spreadsheets.",
    method_started: "Threads beyond those that the machine runs at once begin one by one, each when the picture has taken so \
                     long that starting it costs a hundredth of that; \u{201c}started\u{201d} are the most that took part in a \
                     run.",
    method_law: |threads| {
        format!(
            "Amdahl\u{2019}s law, T(n) = T(1) (s + (1 \u{2212} s) / n), is fitted to the medians of {threads} threads, those \
             that have a core each, by least squares of a + b / n; s = a / (a + b)."
        )
    },
    method_law_exact: "Two numbers of threads determine the law: it goes through both and is not tested by them.",
    method_efficiency: "Speed-up is the median with one thread over the median with n; efficiency is the speed-up over n.",
    method_over_cores: |threads, cores| {
        let threads = if threads == 1 { "1 thread".to_owned() } else { format!("{threads} threads") };
        format!(
            "\u{201c}Over cores\u{201d} is how much longer it takes than with {threads}, the most measured that have one of the \
             {cores} cores each."
        )
    },
    method_noise: |effect, reference| {
        format!(
            "Rays are spread over {effect}. Noise is the root of the mean squared difference of linear light from a picture \
             of {reference} rays per pixel. The rays of a picture are the first of that picture\u{2019}s, so that the noise of \
             n rays is told too low by a factor of about \u{221a}(1 \u{2212} n/{reference})."
        )
    },
    method_exponent: "An exponent is the slope of the straight line through the logarithms, by least squares.",
    method_meshes: "Each mesh is a bumpy sphere made for the study; smaller triangles in the same shape.",
    more: "docs/study.md of Luch explains every column and every key of study.csv and study.json.",
};

fn plan_error(error: &PlanError) -> String {
    let a_number = |quantity| match quantity {
        Quantity::Threads => "number of threads",
        Quantity::Triangles => "number of triangles",
        Quantity::Rays => "number of rays per pixel",
        Quantity::Tiles => "side of a tile in pixels",
        Quantity::Runs => "number of runs",
        Quantity::WarmUp => "number of warm-up runs",
    };
    let numbers = |quantity| match quantity {
        Quantity::Threads => "numbers of threads",
        Quantity::Triangles => "numbers of triangles",
        Quantity::Rays => "numbers of rays per pixel",
        Quantity::Tiles => "sides of tiles",
        Quantity::Runs => "numbers of runs",
        Quantity::WarmUp => "numbers of warm-up runs",
    };
    match error {
        PlanError::NoValues(quantity) => format!("there is no {} to measure", a_number(*quantity)),
        PlanError::TooManyValues { quantity, count } => {
            format!("{count} {} are more than the {MAX_VALUES} that a study may have", numbers(*quantity))
        }
        PlanError::OutOfRange { quantity, value, least, most } => {
            format!("{value} is not a {} from {least} to {most}", a_number(*quantity))
        }
        PlanError::Twice { quantity, value } => format!("the {} {value} is given twice", a_number(*quantity)),
        PlanError::SameMesh { wanted: [a, b], triangles } => {
            format!("{a} and {b} triangles would be the same mesh, one of {triangles}: leave one out")
        }
        PlanError::Reference { reference, most } => format!(
            "the reference needs more rays per pixel than the {most} that are compared with it; {reference} are not enough"
        ),
        PlanError::TooLarge { width, height } => format!(
            "pictures of {width}x{height} pixels are too large for a study, which makes many: {MAX_PIXELS} pixels at most, \
             as 7680x4320"
        ),
        PlanError::NoScene => "there is no scene to measure".to_owned(),
        PlanError::TooManyScenes { count } => {
            format!("{count} scenes are more than the {MAX_VALUES} that a study may have")
        }
        PlanError::SceneTwice(id) => format!("the scene {id} is given twice"),
        PlanError::NoCamera(id) => format!("the scene {id} has no camera"),
    }
}
