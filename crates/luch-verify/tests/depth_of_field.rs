//! The blur of depth of field is that of a thin lens.
//!
//! A point at the distance z along the view, seen through a lens of radius R that is focused at f, spreads evenly over a
//! disk of radius R |z - f| / f at its own distance. On a picture whose height of h pixels covers the angle `fov` that
//! is `R |z - f| / (f z) * h / (2 tan(fov / 2))` pixels, wherever in the picture the point is.

use glam::Vec3;
use luch_render::RenderJob;
use luch_scene::{Aim, Camera, Color, Direction, FieldOfView, NonNegative, Positive, Scene};
use luch_verify::{job, picture, sampling, scenes};

const SIZE: [u32; 2] = [96, 72];

/// A bright ball against black, where it stands before a lens.
#[derive(Debug, Clone, Copy)]
struct Case {
    lens_radius: f32,
    focus: f32,
    fov: f32,
    /// The ball's distance along the view.
    z: f32,
    /// The ball's place in the picture, in pixels from its middle.
    beside: [f32; 2],
}

const PLAIN: Case = Case { lens_radius: 0.25, focus: 4.0, fov: 40.0, z: 4.0, beside: [0.0, 0.0] };

/// The ball's radius in pixels.
const BALL: f32 = 2.0;

impl Case {
    /// Pixels that a length of one takes at distance one.
    fn scale(&self) -> f32 {
        SIZE[1] as f32 / (2.0 * (f64::from(self.fov).to_radians() / 2.0).tan() as f32)
    }

    /// The radius of the blur in pixels, by the thin lens.
    fn blur(&self) -> f64 {
        f64::from(self.lens_radius * (self.z - self.focus).abs() / (self.focus * self.z) * self.scale())
    }

    /// How much longer than wide the ball's picture is: towards the edges a ball is an ellipse.
    fn stretch(&self) -> f64 {
        let tan = self.beside.map(|pixels| f64::from(pixels / self.scale()));
        (1.0 + tan[0] * tan[0] + tan[1] * tan[1]).sqrt()
    }

    /// The ball, lit by nothing but ambient light, and the camera in some awkward direction.
    fn scene(&self) -> Scene {
        let along = Direction::new(Vec3::new(0.4, -0.3, -1.0)).expect("a direction");
        let mut camera = Camera::new("Camera", scenes::point(1.0, 2.0, 3.0), Aim::Along(along));
        camera.fov = FieldOfView::new(self.fov).expect("an angle in range");
        camera.lens_radius = NonNegative::new(self.lens_radius).expect("a radius");
        camera.focal_distance = Some(Positive::new(self.focus).expect("a distance"));
        let [right, up, forward] = camera.frame();
        let pixel = self.z / self.scale();
        let [x, y] = self.beside;
        let center = camera.position.get() + forward * self.z + right * (x * pixel) - up * (y * pixel);
        let mut scene = Scene::new("A ball in the dark");
        scene.background = Color::from_hex("#000000").expect("a colour");
        scene.ambient = NonNegative::ONE;
        let center = scenes::point(center.x, center.y, center.z);
        scene.objects = vec![scenes::sphere("Ball", center, BALL * pixel, "#ffffff")];
        scene.cameras = vec![camera];
        scene
    }

    fn job(&self, scene: &Scene) -> RenderJob {
        let mut job = job(scene, 0, SIZE, 1);
        job.depth_of_field = sampling(256);
        job
    }

    /// The light at every pixel.
    fn picture(&self) -> Vec<f64> {
        let scene = self.scene();
        picture(&scene, &self.job(&scene)).chunks_exact(3).map(|p| f64::from(p[0])).collect()
    }
}

/// Where the light of a picture is.
#[derive(Debug)]
struct Spread {
    /// All of it, in pixels.
    total: f64,
    /// The distance of its middle from where it should be.
    off: f64,
    /// The mean of the squared distance from its middle.
    squared: f64,
    /// The largest distance from its middle.
    reach: f64,
    /// The share that is nearer to the middle than some radius.
    within: f64,
}

fn spread(case: &Case, light: &[f64], radius: f64) -> Spread {
    let places = (0..).map(|i: u32| [f64::from(i % SIZE[0]) + 0.5, f64::from(i / SIZE[0]) + 0.5]);
    let lit: Vec<([f64; 2], f64)> = places.zip(light.iter().copied()).filter(|(_, v)| *v > 0.0).collect();
    let total: f64 = lit.iter().map(|(_, v)| v).sum();
    let middle = [0, 1].map(|axis: usize| lit.iter().map(|(p, v)| p[axis] * v).sum::<f64>() / total);
    let squared = |p: &[f64; 2]| (p[0] - middle[0]).powi(2) + (p[1] - middle[1]).powi(2);
    let expected = [0, 1].map(|axis: usize| f64::from(SIZE[axis]) / 2.0 + f64::from(case.beside[axis]));
    Spread {
        total,
        off: ((middle[0] - expected[0]).powi(2) + (middle[1] - expected[1]).powi(2)).sqrt(),
        squared: lit.iter().map(|(p, v)| squared(p) * v).sum::<f64>() / total,
        reach: lit.iter().map(|(p, _)| squared(p).sqrt()).fold(0.0, f64::max),
        within: lit.iter().filter(|(p, _)| squared(p).sqrt() < radius).map(|(_, v)| v).sum::<f64>() / total,
    }
}

/// Many distances, lenses, angles and places, each with a blur of 1.5 to 26 pixels.
fn blurred_cases() -> Vec<Case> {
    let mut cases: Vec<Case> = [1.5, 2.0, 2.5, 3.0, 5.5, 7.0, 10.0, 20.0, 1e3].map(|z| Case { z, ..PLAIN }).into();
    for z in [2.0, 9.0] {
        cases.push(Case { z, lens_radius: 0.12, ..PLAIN });
        cases.push(Case { z, lens_radius: 0.5, ..PLAIN });
        cases.push(Case { z, fov: 24.0, ..PLAIN });
        cases.push(Case { z, fov: 75.0, lens_radius: 0.4, ..PLAIN });
        cases.push(Case { z, focus: 3.0, ..PLAIN });
        // Towards the edges the blur is no larger: the lens is parallel to the picture.
        cases.push(Case { z, beside: [-30.0, 15.0], lens_radius: 0.2, ..PLAIN });
        cases.push(Case { z, beside: [25.0, -20.0], fov: 80.0, lens_radius: 0.35, ..PLAIN });
    }
    cases
}

#[test]
fn the_blur_has_the_radius_of_the_thin_lens() {
    for case in blurred_cases() {
        let blur = case.blur();
        assert!((1.5..26.0).contains(&blur), "{case:?}: {blur}");
        let seen = spread(&case, &case.picture(), blur / 2.0_f64.sqrt());
        // The mean square of a disk is half its squared radius; that of the blur and that of the ball's picture add up.
        let ball_squared = f64::from(BALL).powi(2) * (1.0 + case.stretch().powi(2)) / 4.0;
        let radius = (2.0 * (seen.squared - ball_squared)).sqrt();
        assert!((radius / blur - 1.0).abs() < 0.03, "{case:?}: {radius} pixels, not {blur}: {seen:?}");
        // A disk with an edge, evenly lit, in the right place, that holds all the light of the ball.
        assert!(seen.reach < blur + f64::from(BALL) * case.stretch() + 1.0, "{case:?}: {seen:?}, {blur}");
        assert!(seen.reach > blur, "{case:?}: {seen:?}, {blur}");
        let is_wide = blur > 4.0 * f64::from(BALL);
        assert!(!is_wide || (seen.within - 0.5).abs() < 0.05, "{case:?}: half the light in half the area: {seen:?}");
        assert!(seen.off < 0.3, "{case:?}: {seen:?}");
        let ball = std::f64::consts::PI * f64::from(BALL).powi(2) * case.stretch();
        assert!((seen.total / ball - 1.0).abs() < 0.1, "{case:?}: {seen:?}, not {ball}");
    }
}

#[test]
fn at_the_focal_distance_the_picture_is_that_of_a_pinhole() {
    for case in [
        PLAIN,
        Case { lens_radius: 0.5, beside: [-30.0, 15.0], ..PLAIN },
        Case { fov: 75.0, focus: 3.0, z: 3.0, ..PLAIN },
        Case { fov: 24.0, focus: 20.0, z: 20.0, beside: [25.0, -20.0], ..PLAIN },
    ] {
        let sharp = Case { lens_radius: 0.0, ..case }.picture();
        let open = case.picture();
        let seen = spread(&case, &open, 1.0);
        assert!(seen.reach < f64::from(BALL) * case.stretch() + 1.0, "{case:?}: {seen:?}");
        // The ball has a thickness, so that its rim is not quite in focus.
        let inside = sharp.iter().zip(&open).filter(|(a, b)| (*a - *b).abs() < 0.1).count();
        assert!(inside + 8 >= sharp.len(), "{case:?}: {} pixels differ", sharp.len() - inside);
    }
}
