//! From a scene to the text of its file: pretty, stable, and read back as the same scene.

use glam::Vec3;
use luch_scene::{Aim, Camera, Color, Light, Object, Rotation, Sampling, Scene, Shape, Size};
use std::fmt::{self, Write};

/// What a written file tells who opens it in an editor.
const HEADER: &str = "\
# A scene of Luch, format 1. Lengths are in scene units, y is up, angles in degrees.
# Colours are \"#rrggbb\" (sRGB) or [r, g, b] (linear light, 0 to 1).

luch = 1
";

/// The text of a scene file that is read back as this scene.
///
/// Numbers have as few digits as say exactly them, colours are `#rrggbb` where that says exactly them. What has its
/// default value is left out. The cost is proportional to the scene.
#[must_use]
pub fn write_scene(scene: &Scene) -> String {
    let mut text = String::from(HEADER);
    // A String takes whatever is written to it, so there is no error to answer with.
    let _ = write_all(&mut text, scene);
    text
}

fn write_all(out: &mut String, scene: &Scene) -> fmt::Result {
    writeln!(out, "name = {}", Quoted(&scene.name))?;
    writeln!(out, "background = {}", Colored(scene.background))?;
    writeln!(out, "ambient = {:?}", scene.ambient.get())?;
    writeln!(out, "attenuation = {:?}", scene.attenuation.get())?;
    for light in &scene.lights {
        write_light(out, light)?;
    }
    for camera in &scene.cameras {
        write_camera(out, camera)?;
    }
    for object in &scene.objects {
        write_object(out, object)?;
    }
    write_settings(out, scene)
}

fn write_light(out: &mut String, light: &Light) -> fmt::Result {
    writeln!(out, "\n[[light]]\nname = {}", Quoted(&light.name))?;
    writeln!(out, "position = {}", Triple(light.position.get()))?;
    writeln!(out, "intensity = {:?}", light.intensity.get())?;
    writeln!(out, "color = {}", Colored(light.color))?;
    write_hidden(out, light.hidden)
}

fn write_camera(out: &mut String, camera: &Camera) -> fmt::Result {
    writeln!(out, "\n[[camera]]\nname = {}", Quoted(&camera.name))?;
    writeln!(out, "position = {}", Triple(camera.position.get()))?;
    match camera.aim {
        Aim::At(point) => writeln!(out, "look_at = {}", Triple(point.get()))?,
        Aim::Along(direction) => writeln!(out, "direction = {}", Triple(direction.get()))?,
    }
    writeln!(out, "fov = {:?}", camera.fov.get())?;
    if let Some(distance) = camera.focal_distance {
        writeln!(out, "focal_distance = {:?}", distance.get())?;
    }
    if !is_plain_zero(camera.lens_radius.get()) {
        writeln!(out, "lens_radius = {:?}", camera.lens_radius.get())?;
    }
    Ok(())
}

fn write_object(out: &mut String, object: &Object) -> fmt::Result {
    writeln!(out, "\n[[object]]\nname = {}", Quoted(&object.name))?;
    write_shape(out, &object.shape)?;
    let material = &object.material;
    if let Some(color) = material.color {
        writeln!(out, "color = {}", Colored(color))?;
    }
    if !is_plain_zero(material.reflection.get()) {
        writeln!(out, "reflection = {:?}", material.reflection.get())?;
    }
    if let Some(gloss) = material.gloss {
        writeln!(out, "gloss = {:?}", gloss.get())?;
    }
    if let Some(shading) = object.shading {
        writeln!(out, "shading = \"{}\"", shading.word())?;
    }
    if let Some(checker) = material.checker {
        let (size, color) = (checker.size.get(), Colored(checker.color));
        writeln!(out, "pattern = {{ checker = {{ size = {size:?}, color = {color} }} }}")?;
    }
    write_hidden(out, object.hidden)
}

fn write_shape(out: &mut String, shape: &Shape) -> fmt::Result {
    match shape {
        Shape::Sphere { center, radius } => {
            writeln!(out, "sphere = {{ center = {}, radius = {:?} }}", Triple(center.get()), radius.get())
        }
        Shape::Cuboid { center, size: [x, y, z], rotation } => {
            let center = Triple(center.get());
            if x == y && y == z {
                writeln!(out, "cube = {{ center = {center}, side = {:?} }}", x.get())?;
            } else {
                let size = Triple(Vec3::new(x.get(), y.get(), z.get()));
                writeln!(out, "box = {{ center = {center}, size = {size} }}")?;
            }
            write_rotation(out, *rotation)
        }
        Shape::Wall { point, normal, size } => {
            write!(out, "wall = {{ point = {}, normal = {}", Triple(point.get()), Triple(normal.get()))?;
            if let Some([width, height]) = size {
                write!(out, ", size = [{:?}, {:?}]", width.get(), height.get())?;
            }
            writeln!(out, " }}")
        }
        Shape::Mesh(instance) => {
            writeln!(out, "mesh = {}", Quoted(&instance.path))?;
            writeln!(out, "position = {}", Triple(instance.position.get()))?;
            write_rotation(out, instance.rotation)?;
            if instance.scale != Size::ONE {
                writeln!(out, "scale = {:?}", instance.scale.get())?;
            }
            Ok(())
        }
    }
}

fn write_rotation(out: &mut String, rotation: Rotation) -> fmt::Result {
    let degrees = rotation.degrees();
    if degrees.to_array().into_iter().all(is_plain_zero) {
        return Ok(());
    }
    writeln!(out, "rotation = {}", Triple(degrees))
}

/// Whether a number is the default 0. Minus zero is equal to it, but a scene is read back with the same bits.
const fn is_plain_zero(v: f32) -> bool {
    v.to_bits() == 0
}

fn write_hidden(out: &mut String, hidden: bool) -> fmt::Result {
    if hidden { writeln!(out, "hidden = true") } else { Ok(()) }
}

fn write_settings(out: &mut String, scene: &Scene) -> fmt::Result {
    let settings = &scene.settings;
    let effect = |s: Sampling| format!("{{ on = {}, rays = {} }}", s.on, s.rays.get());
    writeln!(out, "\n[render]\nsize = [{}, {}]", settings.size.width(), settings.size.height())?;
    writeln!(out, "depth = {}", settings.depth)?;
    writeln!(out, "antialiasing = {}", effect(settings.antialiasing))?;
    writeln!(out, "depth_of_field = {}", effect(settings.depth_of_field))?;
    writeln!(out, "shading = \"{}\"", settings.shading.word())
}

/// `[x, y, z]` in the fewest digits that say exactly these numbers.
struct Triple(Vec3);

impl fmt::Display for Triple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Debug, unlike Display, always has a point or an exponent: TOML's sign of a float.
        write!(f, "[{:?}, {:?}, {:?}]", self.0.x, self.0.y, self.0.z)
    }
}

struct Colored(Color);

impl fmt::Display for Colored {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bits = |color: Color| color.get().to_array().map(f32::to_bits);
        match self.0.to_hex() {
            Some(hex) if Color::from_hex(&hex).map(bits) == Some(bits(self.0)) => write!(f, "\"{hex}\""),
            _ => write!(f, "{}", Triple(self.0.get())),
        }
    }
}

/// A string in quotes, as TOML writes it.
struct Quoted<'a>(&'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_char('"')?;
        for c in self.0.chars() {
            match c {
                '"' | '\\' => write!(f, "\\{c}")?,
                c if c.is_control() => write!(f, "\\u{:04x}", u32::from(c))?,
                c => f.write_char(c)?,
            }
        }
        f.write_char('"')
    }
}
