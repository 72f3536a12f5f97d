//! The rays of a pixel from above, as SVG: x to the right, the camera below.

use luch_render::explain::{PixelAccount, RayEnd, RayKind};
use luch_scene::{Scene, Shape};
use std::fmt::Write as _;

/// Pixels of a scene unit.
const UNIT: f32 = 44.0;
/// The part of the plane that is shown: least and greatest x, least and greatest z.
const PART: [f32; 4] = [-4.4, 4.4, -4.4, 6.4];
/// A legend below it.
const LEGEND: f32 = 34.0;

/// Colours of the kinds that people who see no red or green can tell apart (Okabe and Ito, 2008).
const KINDS: [(RayKind, &str, &str); 3] = [
    (RayKind::Camera, "#0072b2", "camera ray"),
    (RayKind::Mirror, "#d55e00", "mirror ray"),
    (RayKind::Shadow, "#009e73", "shadow ray"),
];

fn at(x: f32, z: f32) -> (f32, f32) {
    ((x - PART[0]) * UNIT, (z - PART[2]) * UNIT)
}

/// Draws the rays of a pixel and what is around them.
pub(crate) fn draw(account: &PixelAccount, scene: &Scene) -> String {
    let (width, height) = ((PART[1] - PART[0]) * UNIT, (PART[3] - PART[2]) * UNIT);
    let full = height + LEGEND;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {full:.0}\" width=\"{width:.0}\" \
         height=\"{full:.0}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n<defs>\n"
    );
    for (kind, color, _) in KINDS {
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            "<marker id=\"{}\" viewBox=\"0 0 8 8\" refX=\"7.5\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" \
             orient=\"auto\"><path d=\"M0,0.8 L8,4 L0,7.2 z\" fill=\"{color}\"/></marker>",
            kind.word()
        );
    }
    svg += "</defs>\n";
    objects(scene, &mut svg);
    rays(account, scene, &mut svg);
    lights(scene, &mut svg);
    legend(height, &mut svg);
    svg + "</svg>\n"
}

fn objects(scene: &Scene, svg: &mut String) {
    for object in &scene.objects {
        match &object.shape {
            Shape::Sphere { center, radius } => {
                let (x, y) = at(center.get().x, center.get().z);
                let fill = object.material.color.map(luch_scene::Color::to_srgb8).unwrap_or_default();
                let [r, g, b] = fill;
                let _ = writeln!(
                    svg,
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{:.1}\" fill=\"rgb({r},{g},{b})\" fill-opacity=\"0.35\" \
                     stroke=\"#555555\"/>",
                    radius.get() * UNIT
                );
                let _ = writeln!(
                    svg,
                    "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"#444444\">{}</text>",
                    y + radius.get() * UNIT + 15.0,
                    object.name
                );
            }
            // Walls that stand upright across an axis.
            Shape::Wall { point, normal, .. } => {
                let (p, n) = (point.get(), normal.unit());
                let line = if n.x.abs() > 0.5 {
                    Some((at(p.x, PART[2]), at(p.x, PART[3])))
                } else if n.z.abs() > 0.5 && p.z < PART[3] {
                    Some((at(PART[0], p.z), at(PART[1], p.z)))
                } else {
                    None
                };
                if let Some(((x1, y1), (x2, y2))) = line {
                    let _ = writeln!(
                        svg,
                        "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#777777\" \
                         stroke-width=\"3\"/>"
                    );
                }
            }
            Shape::Cuboid { .. } | Shape::Mesh(_) => {}
        }
    }
}

fn rays(account: &PixelAccount, scene: &Scene, svg: &mut String) {
    // Shadow rays first: they are the most and the least.
    for (kind, color, _) in KINDS.into_iter().rev() {
        for segment in account.segments().filter(|segment| segment.kind == kind) {
            let ((x1, y1), (x2, y2)) = (at(segment.start.x, segment.start.z), at(segment.end.x, segment.end.z));
            let style = match (kind, segment.blocked) {
                (RayKind::Shadow, false) => " stroke-dasharray=\"6 3\" stroke-width=\"1.2\"",
                (RayKind::Shadow, true) => " stroke-dasharray=\"2 3\" stroke-width=\"1.6\"",
                _ => " stroke-width=\"2\"",
            };
            let _ = writeln!(
                svg,
                "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"{color}\"{style} \
                 marker-end=\"url(#{})\"/>",
                kind.word()
            );
            if let RayEnd::Blocked { light, .. } = account.rays[segment.ray as usize].end {
                let lamp = scene.lights[account.lights[light as usize].light as usize].position.get();
                let (x3, y3) = at(lamp.x, lamp.z);
                let _ = writeln!(
                    svg,
                    "<line x1=\"{x2:.1}\" y1=\"{y2:.1}\" x2=\"{x3:.1}\" y2=\"{y3:.1}\" stroke=\"#999999\" \
                     stroke-dasharray=\"1 4\"/>"
                );
                let _ = writeln!(
                    svg,
                    "<path d=\"M{:.1},{:.1} l10,10 m0,-10 l-10,10\" stroke=\"#000000\" stroke-width=\"2\"/>",
                    x2 - 5.0,
                    y2 - 5.0
                );
            }
        }
    }
}

fn lights(scene: &Scene, svg: &mut String) {
    for light in &scene.lights {
        let (x, y) = at(light.position.get().x, light.position.get().z);
        let _ = writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\" fill=\"#f0e442\" stroke=\"#555555\"/>\n\
             <text x=\"{:.1}\" y=\"{:.1}\" fill=\"#444444\">{}</text>",
            x + 10.0,
            y + 4.0,
            light.name
        );
    }
}

fn legend(top: f32, svg: &mut String) {
    let y = top + LEGEND / 2.0;
    for (number, (kind, color, name)) in (0_u8..).zip(KINDS) {
        let x = 12.0 + f32::from(number) * 126.0;
        let dashes = if kind == RayKind::Shadow { " stroke-dasharray=\"6 3\"" } else { "" };
        let _ = writeln!(
            svg,
            "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{:.1}\" y2=\"{y:.1}\" stroke=\"{color}\" \
             stroke-width=\"2\"{dashes} marker-end=\"url(#{})\"/>\n<text x=\"{:.1}\" y=\"{:.1}\">{name}</text>",
            x + 32.0,
            kind.word(),
            x + 38.0,
            y + 4.0
        );
    }
}
