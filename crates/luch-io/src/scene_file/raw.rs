//! What the file says, before names are given and meshes are loaded: every number checked, nothing opened.

use super::fields::{Context, Field, Fields, Schema};
use super::objects::{OBJECT, RawObject};
use super::sections::Sections;
use super::syntax;
use super::text::SceneText;
use crate::error::{Error, ErrorKind, Result};
use luch_scene::{
    Aim, Camera, Color, Direction, FieldOfView, ImageSize, Light, NonNegative, Point, Positive, RayCount,
    RenderSettings, Sampling, Scene, Shading,
};
use std::collections::HashMap;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// The longest section, in bytes. TOML's tree of it takes some hundred times as much memory.
const MAX_SECTION: usize = 2 << 20;

/// A scene file as it was read.
///
/// Lights, cameras and objects that the file gives no name have an empty one here.
#[derive(Debug)]
pub(super) struct RawScene {
    pub(super) name: Option<String>,
    pub(super) background: Color,
    pub(super) ambient: NonNegative,
    pub(super) attenuation: Positive,
    pub(super) lights: Vec<Light>,
    pub(super) cameras: Vec<Camera>,
    pub(super) objects: Vec<RawObject>,
    pub(super) settings: RenderSettings,
    /// The names of objects and lights, each with its place in the file.
    pub(super) names: HashMap<String, usize>,
    /// The names of cameras, each with its place in the file.
    pub(super) camera_names: HashMap<String, usize>,
}

const FILE: Schema = Schema {
    what: "a scene file",
    keys: &["luch", "name", "background", "ambient", "attenuation", "light", "camera", "object", "render"],
    elsewhere: &[
        ("sphere", "shapes stand in objects: [[object]], then sphere = { center = [x, y, z], radius = r }"),
        ("mesh", "shapes stand in objects: [[object]], then mesh = \"model.obj\""),
        ("scene", "the keys of the scene stand at the top of the file, under no header"),
    ],
};
const LIGHT: Schema =
    Schema { what: "a light", keys: &["name", "position", "intensity", "color", "hidden"], elsewhere: &[] };
const CAMERA: Schema = Schema {
    what: "a camera",
    keys: &["name", "position", "look_at", "direction", "fov", "focal_distance", "lens_radius"],
    elsewhere: &[("aperture", "the lens is given by its radius in scene units: lens_radius = 0.1")],
};
const RENDER: Schema = Schema {
    what: "[render]",
    keys: &["size", "depth", "antialiasing", "depth_of_field", "shading"],
    elsewhere: &[
        ("width", "write size = [width, height]"),
        ("height", "write size = [width, height]"),
        ("rays", "rays belong to antialiasing or depth_of_field: antialiasing = { on = true, rays = 64 }"),
    ],
};
const SAMPLING: Schema = Schema { what: "the effect", keys: &["on", "rays"], elsewhere: &[] };

/// Reads the text of a scene file.
///
/// # Errors
/// `Malformed` at the first thing that is wrong, `Limit` for a section that is too long.
pub(super) fn read(text: SceneText<'_>) -> Result<RawScene> {
    let mut reader = Reader { text, scene: RawScene::empty(), given: Vec::new() };
    for section in Sections::new(text.text) {
        reader.section(section.span, section.header)?;
    }
    Ok(reader.scene)
}

impl RawScene {
    fn empty() -> Self {
        let Scene { background, ambient, attenuation, settings, .. } = Scene::new("");
        Self {
            name: None,
            background,
            ambient,
            attenuation,
            lights: Vec::new(),
            cameras: Vec::new(),
            objects: Vec::new(),
            settings,
            names: HashMap::new(),
            camera_names: HashMap::new(),
        }
    }
}

struct Reader<'a> {
    text: SceneText<'a>,
    scene: RawScene,
    /// Keys that may not come again, each with its place: those of the top of the file, and `[render]`.
    given: Vec<(&'static str, usize)>,
}

impl<'a> Reader<'a> {
    fn section(&mut self, span: Range<usize>, header: Range<usize>) -> Result<()> {
        let source = self.text.text.get(span.clone()).unwrap_or_default();
        if source.len() > MAX_SECTION {
            return Err(Error::new(ErrorKind::Limit, self.text.file, "a table of more than 2 MiB begins here")
                .at(self.text.place(&header))
                .hint("is a quote or a bracket left open? long lists of objects are written as [[object]] headers"));
        }
        let table = DeTable::parse(source).map_err(|e| syntax::error(self.text, span.start, source, &e))?;
        let context = Context { text: self.text, base: span.start };
        let top = header.is_empty();
        if top {
            self.version(context, table.get_ref())?;
        }
        let fields = Fields::new(context, FILE, table.get_ref(), header)?;
        for key in FILE.keys {
            if let Some(field) = fields.get(key) {
                self.field(&field, top)?;
            }
        }
        Ok(())
    }

    /// Checks `luch = 1` before anything else: a later format may have keys that this one does not know.
    fn version(&self, context: Context<'_>, table: &DeTable<'_>) -> Result<()> {
        const HINT: &str = "a scene file begins with the line: luch = 1";
        let Some(value) = table.get("luch") else {
            let first = 0..self.text.text.lines().next().unwrap_or_default().len();
            return Err(context.error(&first, "the file does not say which format it has").hint(HINT));
        };
        let span = context.span(&value.span());
        match value.get_ref() {
            DeValue::Integer(v) if v.radix() == 10 && v.as_str() == "1" => Ok(()),
            DeValue::Integer(v) => {
                let error = context.error(&span, format!("luch = {v}: this program reads format 1"));
                Err(error.hint("open it with a newer Luch, or write luch = 1 if it is a file of format 1"))
            }
            _ => Err(context.error(&span, "`luch` must be the number of the format").hint(HINT)),
        }
    }

    fn field(&mut self, field: &Field<'_, '_>, top: bool) -> Result<()> {
        let many = matches!(field.key, "light" | "camera" | "object");
        if let Some((_, first)) = self.given.iter().find(|(key, _)| *key == field.key) {
            let text = format!("`{}` is given twice, first in line {}", field.key, self.text.line(*first));
            return Err(field.key_error(text));
        }
        if top || !many {
            self.given.push((field.key, field.key_span().start));
        }
        let scene = &mut self.scene;
        match field.key {
            "name" => scene.name = Some(name(field)?.to_owned()),
            "background" => scene.background = field.color()?,
            "ambient" => scene.ambient = field.number()?,
            "attenuation" => scene.attenuation = field.number()?,
            "light" => self.each(field, LIGHT, Self::light)?,
            "camera" => self.each(field, CAMERA, Self::camera)?,
            "object" => self.each(field, OBJECT, Self::object)?,
            "render" => scene.settings = render(field)?,
            // `luch` is checked before.
            _ => {}
        }
        Ok(())
    }

    fn each(
        &mut self,
        field: &Field<'_, '_>,
        schema: Schema,
        read: fn(&mut Self, &Fields<'_, '_>) -> Result<()>,
    ) -> Result<()> {
        for item in field.tables()?.iter() {
            let (context, place) = field.item(item);
            let DeValue::Table(table) = item.get_ref() else {
                let text = format!("`{}` must be a list of tables", field.key);
                return Err(context.error(&place, text).hint(format!("write [[{}]] in double brackets", field.key)));
            };
            read(self, &Fields::new(context, schema, table, place)?)?;
        }
        Ok(())
    }

    fn light(&mut self, fields: &Fields<'_, '_>) -> Result<()> {
        let name = fields.get("name").map(|f| taken_once(&f, self.text, &mut self.scene.names)).transpose()?;
        let position = fields.need("position", "position = [3.0, 6.0, 4.0]")?.vector(Point::new)?;
        let mut light = Light::new(name.unwrap_or_default(), position);
        if let Some(field) = fields.get("intensity") {
            light.intensity = field.number()?;
        }
        if let Some(field) = fields.get("color") {
            light.color = field.color()?;
        }
        if let Some(field) = fields.get("hidden") {
            light.hidden = field.truth()?;
        }
        self.scene.lights.push(light);
        Ok(())
    }

    fn camera(&mut self, fields: &Fields<'_, '_>) -> Result<()> {
        let name = fields.get("name").map(|f| taken_once(&f, self.text, &mut self.scene.camera_names)).transpose()?;
        let position = fields.need("position", "position = [0.0, 2.0, 7.0]")?.vector(Point::new)?;
        let aim = match (fields.get("look_at"), fields.get("direction")) {
            (Some(at), None) => Aim::At(at.vector(Point::new)?),
            (None, Some(along)) => Aim::Along(along.vector(Direction::new)?),
            (None, None) => {
                return Err(fields.missing("`look_at` or `direction`", "look_at = [0.0, 1.0, 0.0]"));
            }
            (Some(at), Some(along)) => {
                let second = if at.key_span().start > along.key_span().start { at } else { along };
                let error = second.key_error("a camera has either `look_at` or `direction`, not both");
                return Err(error.hint("remove one of the two"));
            }
        };
        let mut camera = Camera::new(name.unwrap_or_default(), position, aim);
        if let Some(field) = fields.get("fov") {
            camera.fov = field.number::<FieldOfView>()?;
        }
        if let Some(field) = fields.get("focal_distance") {
            camera.focal_distance = Some(field.number()?);
        }
        if let Some(field) = fields.get("lens_radius") {
            camera.lens_radius = field.number()?;
        }
        self.scene.cameras.push(camera);
        Ok(())
    }

    fn object(&mut self, fields: &Fields<'_, '_>) -> Result<()> {
        let name = fields.get("name").map(|f| taken_once(&f, self.text, &mut self.scene.names)).transpose()?;
        let object = RawObject::read(fields, name.unwrap_or_default())?;
        self.scene.objects.push(object);
        Ok(())
    }
}

/// A name of good form.
fn name<'a>(field: &Field<'a, '_>) -> Result<&'a str> {
    let name = field.string("a name in quotes")?;
    // An empty scene has no names, so only the form is checked.
    Scene::new("").check_new_name(name).map_err(|e| field.error(e.to_string()))?;
    Ok(name)
}

/// A name of good form that nothing in `names` has; it is put there.
fn taken_once(field: &Field<'_, '_>, text: SceneText<'_>, names: &mut HashMap<String, usize>) -> Result<String> {
    let name = name(field)?;
    if let Some(first) = names.insert(name.to_owned(), field.span().start) {
        let error = field.error(format!("the name {name:?} is taken in line {}", text.line(first)));
        return Err(error.hint("names tell things apart: give this one another"));
    }
    Ok(name.to_owned())
}

/// The words of the shading models.
pub(super) fn shading(field: &Field<'_, '_>) -> Result<Shading> {
    field.word(&Shading::ALL.map(|s| (s.word(), s)))
}

fn render(field: &Field<'_, '_>) -> Result<RenderSettings> {
    // `[[render]]` reads as a list of tables: say so instead of "must be a table".
    if matches!(field.value(), DeValue::Array(_)) {
        return Err(field.key_error("`render` is one table").hint("write [render] in single brackets"));
    }
    let fields = field.table(RENDER, "{ size = [960, 720] }")?;
    let mut settings = RenderSettings::default();
    if let Some(field) = fields.get("size") {
        let [width, height] = field.pair_of_pixels(ImageSize::MAX_SIDE)?;
        settings.size = ImageSize::new(width, height).map_err(|e| field.error(e.to_string()))?;
    }
    if let Some(field) = fields.get("depth") {
        settings.depth = field.whole("a whole number from 0 to 10000", RenderSettings::checked_depth)?;
    }
    if let Some(field) = fields.get("antialiasing") {
        settings.antialiasing = sampling(&field, settings.antialiasing)?;
    }
    if let Some(field) = fields.get("depth_of_field") {
        settings.depth_of_field = sampling(&field, settings.depth_of_field)?;
    }
    if let Some(field) = fields.get("shading") {
        settings.shading = shading(&field)?;
    }
    Ok(settings)
}

fn sampling(field: &Field<'_, '_>, default: Sampling) -> Result<Sampling> {
    let fields = field.table(SAMPLING, "{ on = true, rays = 64 }")?;
    Ok(Sampling {
        on: fields.get("on").map_or(Ok(default.on), |f| f.truth())?,
        rays: fields
            .get("rays")
            .map_or(Ok(default.rays), |f| f.whole("a whole number from 1 to 4096", RayCount::new))?,
    })
}
