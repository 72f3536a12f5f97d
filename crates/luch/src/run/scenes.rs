//! `luch scenes`: the scenes inside the program.

use crate::args::ScenesArgs;
use crate::exit::Failure;
use crate::run::info::{Named, ObjectEntry};
use crate::signals::Watch;
use crate::{output, source};
use serde::Serialize;
use std::path::Path;

#[derive(Debug, Serialize)]
struct Entry {
    id: &'static str,
    name: String,
    cameras: Vec<Named>,
    objects: Vec<ObjectEntry>,
}

pub(crate) fn run(args: &ScenesArgs, watch: &Watch) -> Result<(), Failure> {
    let mut entries = Vec::new();
    for id in luch_io::builtin::ids() {
        let scene = source::load(Path::new(id), None, watch)?.scene;
        let cameras = scene.cameras.iter().map(|c| Named { name: c.name.clone() }).collect();
        let objects = scene.objects.iter().map(ObjectEntry::of).collect();
        entries.push(Entry { id, name: scene.name, cameras, objects });
    }
    if args.json {
        return output::json(&entries);
    }
    let mut text = String::new();
    for Entry { id, name, cameras, objects } in &entries {
        let cameras: Vec<&str> = cameras.iter().map(|c| c.name.as_str()).collect();
        text += &format!("{id:<12} {name}: {} objects; {}\n", objects.len(), cameras.join(", "));
    }
    output::result(&text)
}
