//! Every edit answers with the edit that undoes it.

use glam::Vec3;
use luch_scene::*;
use proptest::prelude::*;

fn point(x: f32, y: f32, z: f32) -> Point {
    Point::new(Vec3::new(x, y, z)).unwrap()
}

fn sphere(name: &str, x: f32) -> Object {
    Object::new(name, Shape::Sphere { center: point(x, 1.0, 0.0), radius: Size::ONE })
}

fn scene() -> Scene {
    let mut scene = Scene::new("Test");
    scene.objects = vec![sphere("Left", -2.0), sphere("Middle", 0.0), sphere("Right", 2.0)];
    scene.lights = vec![Light::new("Lamp", point(0.0, 5.0, 5.0)), Light::new("Window", point(9.0, 5.0, 5.0))];
    scene.cameras = vec![
        Camera::new("Camera 1", point(0.0, 1.0, 8.0), Aim::At(Point::ORIGIN)),
        Camera::new("Camera 2", point(8.0, 1.0, 0.0), Aim::At(Point::ORIGIN)),
    ];
    scene
}

fn any_unit() -> impl Strategy<Value = Unit> {
    (0.0_f32..=1.0).prop_map(|v| Unit::new(v).unwrap())
}

fn any_point() -> impl Strategy<Value = Point> {
    (-1e3_f32..1e3, -1e3_f32..1e3, -1e3_f32..1e3).prop_map(|(x, y, z)| point(x, y, z))
}

fn any_color() -> impl Strategy<Value = Color> {
    any::<[u8; 3]>().prop_map(Color::srgb8)
}

fn any_name() -> impl Strategy<Value = String> {
    prop_oneof!["[a-z]{0,3}", Just("Left".to_owned()), Just("Lamp".to_owned()), Just("Camera 2".to_owned())]
}

fn any_object_edit() -> impl Strategy<Value = ObjectEdit> {
    prop_oneof![
        any_name().prop_map(ObjectEdit::Rename),
        proptest::option::of(any_color()).prop_map(ObjectEdit::SetColor),
        any_unit().prop_map(ObjectEdit::SetReflection),
        proptest::option::of(any_unit()).prop_map(ObjectEdit::SetGloss),
        proptest::sample::select(Shading::ALL.to_vec()).prop_map(|s| ObjectEdit::SetShading(Some(s))),
        any_point().prop_map(ObjectEdit::MoveTo),
        any_point().prop_map(|p| ObjectEdit::SetShape(Shape::Wall { point: p, normal: Direction::UP, size: None })),
        any::<bool>().prop_map(ObjectEdit::SetHidden),
        any_color().prop_map(|color| ObjectEdit::SetChecker(Some(Checker { size: Size::ONE, color }))),
    ]
}

fn any_edit() -> impl Strategy<Value = Edit> {
    let leaf = prop_oneof![
        (0..5_usize, any_object_edit()).prop_map(|(i, e)| Edit::Object(i, e)),
        (0..6_usize, any_name()).prop_map(|(i, n)| Edit::AddObject(i, Box::new(sphere(&n, 7.0)))),
        (0..5_usize).prop_map(Edit::RemoveObject),
        (0..5_usize).prop_map(Edit::DuplicateObject),
        (0..4_usize, any_point()).prop_map(|(i, p)| Edit::Light(i, LightEdit::MoveTo(p))),
        (0..4_usize, any_name()).prop_map(|(i, n)| Edit::Light(i, LightEdit::Rename(n))),
        (0..4_usize, any_name(), any_point()).prop_map(|(i, n, p)| Edit::AddLight(i, Light::new(n, p))),
        (0..4_usize).prop_map(Edit::RemoveLight),
        (0..4_usize).prop_map(Edit::DuplicateLight),
        (0..3_usize, any_point()).prop_map(|(i, p)| Edit::Camera(i, CameraEdit::SetAim(Aim::At(p)))),
        (0..3_usize, any_name()).prop_map(|(i, n)| Edit::Camera(i, CameraEdit::Rename(n))),
        (0..3_usize).prop_map(Edit::RemoveCamera),
        any_color().prop_map(|c| Edit::Scene(SceneEdit::SetBackground(c))),
        (0..20_000_u32).prop_map(|d| Edit::Settings(SettingsEdit::SetDepth(d))),
    ];
    leaf.prop_recursive(2, 12, 4, |inner| proptest::collection::vec(inner, 0..4).prop_map(Edit::Group))
}

proptest! {
    #[test]
    fn undoing_in_reverse_gives_every_earlier_scene_back(edits in proptest::collection::vec(any_edit(), 1..30)) {
        let mut now = scene();
        let mut history = Vec::new();
        for edit in edits {
            let before = now.clone();
            match edit.apply(&mut now) {
                Ok(inverse) => history.push((before, inverse)),
                Err(_) => prop_assert_eq!(&before, &now, "a refused edit changes nothing"),
            }
            let mut names: Vec<&str> =
                now.objects.iter().map(|o| o.name.as_str()).chain(now.lights.iter().map(|l| l.name.as_str())).collect();
            names.sort_unstable();
            prop_assert!(names.windows(2).all(|w| w[0] != w[1]), "names stay unique");
            prop_assert!(!now.cameras.is_empty());
        }
        for (before, inverse) in history.into_iter().rev() {
            let after = now.clone();
            let redo = inverse.apply(&mut now).unwrap();
            prop_assert_eq!(&before, &now);
            let mut again = now.clone();
            redo.apply(&mut again).unwrap();
            prop_assert_eq!(&after, &again, "the inverse of the inverse does the edit again");
        }
    }
}

#[test]
fn a_copy_of_what_has_the_longest_name_gets_a_shorter_one() {
    for name in ["a".repeat(256), "a".repeat(255), "я".repeat(128), format!("{}я", "a".repeat(253))] {
        let mut scene = scene();
        Edit::Object(0, ObjectEdit::Rename(name.clone())).apply(&mut scene).unwrap();
        for _ in 0..12 {
            Edit::DuplicateObject(0).apply(&mut scene).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        let base: String = name.chars().take(120).collect();
        let copies: Vec<_> = scene.objects.iter().filter(|object| object.name.starts_with(&base)).collect();
        assert_eq!(copies.len(), 13);
        assert!(copies.iter().any(|copy| copy.name.ends_with(" 13")));
    }
}

#[test]
fn a_copy_gets_a_free_name_and_stands_behind_its_original() {
    let mut scene = scene();
    Edit::DuplicateObject(0).apply(&mut scene).unwrap();
    Edit::DuplicateObject(0).apply(&mut scene).unwrap();
    let names: Vec<&str> = scene.objects.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["Left", "Left 3", "Left 2", "Middle", "Right"]);
}

#[test]
fn refusals_say_why() {
    let mut s = scene();
    let error = Edit::Object(0, ObjectEdit::Rename("Lamp".into())).apply(&mut s).unwrap_err();
    assert_eq!(error.to_string(), "the name \"Lamp\" is taken");
    assert_eq!(Edit::RemoveLight(2).apply(&mut s).unwrap_err().to_string(), "there is no light 2");
    Edit::RemoveCamera(0).apply(&mut s).unwrap();
    assert_eq!(Edit::RemoveCamera(0).apply(&mut s).unwrap_err(), EditError::LastCamera);
}
