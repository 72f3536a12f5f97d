//! Where a thing is and how large: position, rotation, size.

use crate::command::Command;
use crate::selection::Part;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::{NumberField, field_of, show_complaint};
use crate::widgets::row;
use egui::Ui;
use glam::Vec3;
use luch_scene::{Direction, Edit, MeshInstance, ObjectEdit, Point, Rotation, Shape, Size};

/// Coordinates and lengths.
const LENGTH: NumberFormat = NumberFormat { range: -1e9..=1e9, decimals: 3, suffix: "" };
const POSITIVE: NumberFormat = NumberFormat { range: 1e-9..=1e9, decimals: 3, suffix: "" };
const ANGLE: NumberFormat = NumberFormat { range: -1e6..=1e6, decimals: 2, suffix: "°" };

/// The position of a part.
pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, part: Part) {
    let texts = desk.texts;
    let Some(position) = part.position(desk.scene()) else { return };
    if let Some(to) = triple(ui, desk, [texts.position(), texts.position_tip()], position.get(), &LENGTH)
        && let Ok(to) = Point::new(to)
    {
        desk.send(Command::Edit(part.move_to(to), Gesture::Single));
    }
}

/// What else the geometry of an object has.
pub(super) fn show_shape(ui: &mut Ui, desk: &mut Desk<'_>, index: usize) {
    let Some(shape) = desk.scene().objects.get(index).map(|object| object.shape.clone()) else { return };
    let changed = match shape {
        Shape::Sphere { center, radius } => sphere(ui, desk, center, radius),
        Shape::Cuboid { center, size, rotation } => cuboid(ui, desk, center, size, rotation),
        Shape::Wall { point, normal, size } => wall(ui, desk, point, normal, size),
        Shape::Mesh(instance) => mesh(ui, desk, &instance),
    };
    if let Some((shape, gesture)) = changed {
        desk.send(Command::Edit(Edit::Object(index, ObjectEdit::SetShape(shape)), gesture));
    }
}

fn sphere(ui: &mut Ui, desk: &Desk<'_>, center: Point, radius: Size) -> Option<(Shape, Gesture)> {
    let (radius, gesture) = length(ui, desk, [desk.texts.radius(), desk.texts.radius_tip()], radius)?;
    Some((Shape::Sphere { center, radius }, gesture))
}

fn cuboid(
    ui: &mut Ui,
    desk: &Desk<'_>,
    center: Point,
    size: [Size; 3],
    rotation: Rotation,
) -> Option<(Shape, Gesture)> {
    let sides = Vec3::from_array(size.map(Size::get));
    let names = [desk.texts.sides(), desk.texts.sides_tip()];
    let typed = triple(ui, desk, names, sides, &POSITIVE).and_then(sizes);
    let turned = turn(ui, desk, rotation);
    if typed.is_none() && turned.is_none() {
        return None;
    }
    let (size, rotation) = (typed.unwrap_or(size), turned.unwrap_or(rotation));
    Some((Shape::Cuboid { center, size, rotation }, Gesture::Single))
}

fn wall(
    ui: &mut Ui,
    desk: &Desk<'_>,
    point: Point,
    normal: Direction,
    size: Option<[Size; 2]>,
) -> Option<(Shape, Gesture)> {
    let texts = desk.texts;
    let names = [texts.normal(), texts.normal_tip()];
    let facing = triple(ui, desk, names, normal.get(), &LENGTH).and_then(|v| Direction::new(v).ok());
    let mut bounded = size.is_some();
    let switched = ui.checkbox(&mut bounded, texts.wall_bounded()).on_hover_text(texts.wall_bounded_tip()).changed();
    let mut sides = if switched { bounded.then(|| [Size::clamped(4.0); 2]) } else { size };
    let mut gesture = Gesture::Single;
    let mut sized = false;
    if let Some([width, height]) = &mut sides {
        let width_names = [texts.wall_width(), texts.wall_width_tip()];
        let height_names = [texts.wall_height(), texts.wall_height_tip()];
        for (names, side) in [(width_names, width), (height_names, height)] {
            if let Some((typed, typed_gesture)) = length(ui, desk, names, *side) {
                (*side, gesture, sized) = (typed, typed_gesture, true);
            }
        }
    }
    (facing.is_some() || switched || sized)
        .then(|| (Shape::Wall { point, normal: facing.unwrap_or(normal), size: sides }, gesture))
}

fn mesh(ui: &mut Ui, desk: &Desk<'_>, instance: &MeshInstance) -> Option<(Shape, Gesture)> {
    let turned = turn(ui, desk, instance.rotation)
        .map(|rotation| (MeshInstance { rotation, ..instance.clone() }, Gesture::Single));
    let scaled = length(ui, desk, [desk.texts.scale(), desk.texts.scale_tip()], instance.scale);
    let scaled = scaled.map(|(scale, gesture)| (MeshInstance { scale, ..instance.clone() }, gesture));
    let triangles = instance.mesh.triangles().len();
    ui.weak(desk.texts.mesh_facts(triangles, &instance.path));
    turned.or(scaled).map(|(instance, gesture)| (Shape::Mesh(instance), gesture))
}

/// A length with a slider around the one it has.
fn length(ui: &mut Ui, desk: &Desk<'_>, [name, tip]: [String; 2], value: Size) -> Option<(Size, Gesture)> {
    let field = NumberField::new(&name, f64::from(value.get()), POSITIVE).tooltip(&tip);
    let field = field.slider(0.01..=20.0).logarithmic();
    let (typed, gesture) = field.show(ui, desk.texts)?;
    Some((Size::try_from(typed).ok()?, gesture))
}

fn turn(ui: &mut Ui, desk: &Desk<'_>, rotation: Rotation) -> Option<Rotation> {
    let names = [desk.texts.rotation(), desk.texts.rotation_tip()];
    let typed = triple(ui, desk, names, rotation.degrees(), &ANGLE)?;
    Rotation::new(typed).ok()
}

fn sizes(sides: Vec3) -> Option<[Size; 3]> {
    let [x, y, z] = sides.to_array().map(|side| Size::new(side).ok());
    Some([x?, y?, z?])
}

/// Three numbers in a line, named by the axes.
fn triple(ui: &mut Ui, desk: &Desk<'_>, [name, tip]: [String; 2], value: Vec3, format: &NumberFormat) -> Option<Vec3> {
    let ids = ["x", "y", "z"].map(|axis| ui.scope_id().with((&name, axis)));
    let mut changed = None;
    row::labelled(ui, &name, &tip, |ui, _| {
        let gap = ui.spacing().item_spacing.x;
        let width = ((ui.available_width() - 2.0 * gap) / 3.0).max(36.0);
        for ((axis, letter), id) in ["X", "Y", "Z"].into_iter().enumerate().zip(ids) {
            let (response, typed) = field_of(ui, id, f64::from(value[axis]), format, width, desk.texts);
            let label = format!("{name} {letter}");
            response.ctx.accesskit_node_builder(response.id, |node| node.set_label(label.clone()));
            row::tip(&response, &format!("{label}. {tip}"));
            if let Some(typed) = typed {
                let mut new = value;
                new[axis] = typed as f32;
                changed = Some(new);
            }
        }
    });
    for (axis, id) in ids.into_iter().enumerate() {
        show_complaint(ui, id, f64::from(value[axis]));
    }
    changed
}
