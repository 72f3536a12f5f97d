//! The account as JSON, by the schema in `docs/explain.schema.json`.
//!
//! A number is written with the fewest digits that read back to the same 32-bit float; an infinite one is `null`. Rays
//! are written one after the other, none held back, so a large account takes no second place in memory.

mod hit;
mod layout;
mod way;

use crate::number::hex;
use crate::{Explanation, Options};
use hit::Hit;
use luch_render::explain::{RayAccount, RayEnd, Setting, Spread};
use serde::{Serialize, Serializer};
use std::io;
use way::Way;

/// The version of the form.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Pixel<'a> {
    luch_explain: u32,
    scene: &'a str,
    camera: &'a str,
    size: [u32; 2],
    x: u32,
    y: u32,
    pixel: [f32; 3],
    srgb: String,
    setting: SettingJson<'a>,
    samples: Vec<SampleJson>,
    spread: SpreadJson,
    rays: Rays<'a>,
}

#[derive(Serialize)]
struct SettingJson<'a> {
    background: [f32; 3],
    ambient: f32,
    attenuation: f32,
    depth: u32,
    lights: Vec<LightJson<'a>>,
}

#[derive(Serialize)]
struct LightJson<'a> {
    light: u32,
    name: &'a str,
    position: [f32; 3],
    intensity: f32,
    color: [f32; 3],
}

#[derive(Serialize)]
struct SampleJson {
    ray: u32,
    film: [f32; 2],
    lens: [f32; 2],
    color: [f32; 3],
}

#[derive(Serialize)]
struct SpreadJson {
    min: [f32; 3],
    max: [f32; 3],
    mean: [f32; 3],
    std_dev: [f32; 3],
}

/// All rays, made as they are written.
struct Rays<'a> {
    explanation: &'a Explanation<'a>,
    boxes: bool,
}

impl Serialize for Rays<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rays = (0..).zip(&self.explanation.account.rays);
        serializer.collect_seq(rays.map(|(index, ray)| Ray::of(self.explanation, index, ray, self.boxes)))
    }
}

#[derive(Serialize)]
struct Ray<'a> {
    ray: u32,
    kind: &'static str,
    parent: Option<u32>,
    children: Vec<u32>,
    sample: u32,
    depth: u32,
    origin: [f32; 3],
    direction: [f32; 3],
    reach: Option<f32>,
    weight: f32,
    color: [f32; 3],
    end: &'static str,
    end_point: Option<[f32; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<Named<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    blocker: Option<BlockerJson<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    hit: Option<Hit<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    way: Option<Way<'a>>,
}

/// A light or object by its place in the scene's list, and its name.
#[derive(Serialize)]
struct Named<'a> {
    index: u32,
    name: &'a str,
}

#[derive(Serialize)]
struct BlockerJson<'a> {
    object: Named<'a>,
    primitive: u32,
    t: f32,
    position: [f32; 3],
}

impl<'a> Explanation<'a> {
    fn object(&self, index: u32) -> Named<'a> {
        Named { index, name: crate::build::object_name(self, index) }
    }

    fn light(&self, index: u32) -> Named<'a> {
        Named { index, name: crate::build::light_name(self, index) }
    }
}

impl<'a> Ray<'a> {
    fn of(explanation: &Explanation<'a>, index: u32, ray: &RayAccount, boxes: bool) -> Self {
        let account = explanation.account;
        let segment = account.segment(index);
        let (end, light, blocker) = match ray.end {
            RayEnd::Surface(_) => ("surface", None, None),
            RayEnd::Nothing => ("nothing", None, None),
            RayEnd::DepthUsedUp => ("depth used up", None, None),
            RayEnd::Light(place) => ("light", Some(place), None),
            RayEnd::Blocked { light, blocker } => ("blocked", Some(light), Some(blocker)),
        };
        Self {
            ray: index,
            kind: ray.kind.word(),
            parent: ray.parent,
            children: account.children(index).collect(),
            sample: ray.sample,
            depth: ray.depth,
            origin: ray.origin.to_array(),
            direction: ray.direction.to_array(),
            reach: ray.reach.is_finite().then_some(ray.reach),
            weight: ray.weight,
            color: ray.color,
            end,
            end_point: (!segment.open).then(|| segment.end.to_array()),
            light: light.map(|place| explanation.light(account.lights[place as usize].light)),
            blocker: blocker.map(|blocker| BlockerJson {
                object: explanation.object(blocker.object),
                primitive: blocker.primitive,
                t: blocker.t,
                position: segment.end.to_array(),
            }),
            hit: match ray.end {
                RayEnd::Surface(place) => Some(Hit::of(explanation, place)),
                _ => None,
            },
            way: boxes.then(|| Way::of(explanation, index)),
        }
    }
}

/// Writes the account.
pub(crate) fn write(explanation: &Explanation<'_>, options: &Options, to: &mut dyn io::Write) -> io::Result<()> {
    let account = explanation.account;
    let Setting { background, ambient, attenuation, depth, .. } = account.setting;
    let lights = account.setting.lights.iter().map(|light| LightJson {
        light: light.light,
        name: crate::build::light_name(explanation, light.light),
        position: light.position.to_array(),
        intensity: light.intensity,
        color: light.color,
    });
    let samples = account.samples.iter().map(|sample| SampleJson {
        ray: sample.ray,
        film: sample.film,
        lens: sample.lens,
        color: sample.color,
    });
    let Spread { min, max, std_dev } = account.spread;
    let pixel = Pixel {
        luch_explain: VERSION,
        scene: &explanation.scene.name,
        camera: explanation.camera,
        size: [account.size.width(), account.size.height()],
        x: account.x,
        y: account.y,
        pixel: account.pixel,
        srgb: hex(account.pixel),
        setting: SettingJson { background, ambient, attenuation, depth, lights: lights.collect() },
        samples: samples.collect(),
        spread: SpreadJson { min, max, mean: account.pixel, std_dev },
        rays: Rays { explanation, boxes: options.boxes },
    };
    pixel.serialize(&mut serde_json::Serializer::with_formatter(&mut *to, layout::Layout::default()))?;
    to.write_all(b"\n")
}
