//! `luch info SCENE`: what is in it.

use crate::args::InfoArgs;
use crate::exit::Failure;
use crate::signals::Watch;
use crate::source::{self, Loaded};
use crate::{clock, output};
use luch_scene::{MeshId, Object, Scene, Shape};
use serde::Serialize;
use std::collections::HashMap;
use std::fmt::Write as _;

/// Something of which only the name is told.
#[derive(Debug, Serialize)]
pub(super) struct Named {
    pub(super) name: String,
}

#[derive(Debug, Serialize)]
pub(super) struct ObjectEntry {
    name: String,
    kind: &'static str,
}

impl ObjectEntry {
    pub(super) fn of(object: &Object) -> Self {
        Self { name: object.name.clone(), kind: object.shape.kind() }
    }
}

#[derive(Debug, Serialize)]
struct Info {
    name: String,
    objects: Vec<ObjectEntry>,
    lights: Vec<Named>,
    cameras: Vec<Named>,
    triangles: u64,
    bounds: Option<Bounds>,
    memory_bytes: u64,
    load_ms: f64,
    warnings: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Bounds {
    min: [f32; 3],
    max: [f32; 3],
}

pub(crate) fn run(args: &InfoArgs, watch: &Watch) -> Result<(), Failure> {
    let clock = clock::Stopwatch::start();
    let Loaded { scene, warnings, .. } = source::load(&args.scene, args.memory, watch)?;
    let info = Info {
        objects: scene.objects.iter().map(ObjectEntry::of).collect(),
        lights: scene.lights.iter().map(|l| Named { name: l.name.clone() }).collect(),
        cameras: scene.cameras.iter().map(|c| Named { name: c.name.clone() }).collect(),
        triangles: scene.triangle_count(),
        bounds: scene.bounds().map(|[min, max]| Bounds { min: min.to_array(), max: max.to_array() }),
        memory_bytes: memory_bytes(&scene),
        load_ms: clock.wall_ms(),
        warnings,
        name: scene.name,
    };
    if args.json { output::json(&info) } else { output::result(&for_people(&info)) }
}

/// Bytes that the scene holds: every mesh once, and what describes the rest.
fn memory_bytes(scene: &Scene) -> u64 {
    let mut meshes: HashMap<MeshId, usize> = HashMap::new();
    for object in &scene.objects {
        if let Shape::Mesh(instance) = &object.shape {
            meshes.insert(instance.mesh.id(), instance.mesh.memory_bytes());
        }
    }
    let parts = size_of_val(scene)
        + size_of_val(scene.objects.as_slice())
        + size_of_val(scene.lights.as_slice())
        + size_of_val(scene.cameras.as_slice());
    meshes.values().sum::<usize>() as u64 + parts as u64
}

fn for_people(info: &Info) -> String {
    let list = |names: &[Named]| names.iter().map(|n| n.name.as_str()).collect::<Vec<_>>().join(", ");
    let mut text = format!(
        "{}\ncameras    {}\nlights     {}\ntriangles  {}\nmemory     {}\n",
        info.name,
        list(&info.cameras),
        list(&info.lights),
        info.triangles,
        luch_io::budget::human_bytes(info.memory_bytes),
    );
    if let Some(Bounds { min: [a, b, c], max: [d, e, f] }) = info.bounds {
        text += &format!("bounds     {a},{b},{c} to {d},{e},{f}\n");
    }
    text += &format!("objects    {}\n", info.objects.len());
    for ObjectEntry { name, kind } in &info.objects {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {kind:<7}  {name}");
    }
    for warning in &info.warnings {
        let _ = writeln!(text, "warning    {warning}");
    }
    text
}
