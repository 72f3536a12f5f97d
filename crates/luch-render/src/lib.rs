//! The renderer of Luch: compile a scene, trace rays, fill a film. No files, no window.
//!
//! ```
//! use luch_render::{MeshTrees, Progress, RenderJob, compile, render};
//! use luch_scene::{Aim, Camera, Light, Object, Point, Scene, Shape, Size};
//!
//! let mut scene = Scene::new("A ball");
//! let ball = Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
//! scene.objects.push(Object::new("Ball", ball));
//! scene.lights.push(Light::new("Lamp", Point::clamped([3.0, 4.0, 5.0].into())));
//! scene.cameras.push(Camera::new("Camera", Point::clamped([0.0, 0.0, 5.0].into()), Aim::At(Point::ORIGIN)));
//!
//! let compiled = compile(&scene, &mut MeshTrees::new(), 1);
//! let job = RenderJob::of_scene(&scene, 0);
//! let film = render(&compiled, &job, &Progress::new()).unwrap();
//! assert_eq!(film.linear().len(), 960 * 720 * 3);
//! ```

#![forbid(unsafe_code)]

pub mod accel;
mod compiled;
pub mod explain;
pub mod film;
mod integrator;
pub mod math;
pub mod sampler;
pub mod session;
mod shading;
pub mod shape;
mod simd;

pub use compiled::{CompiledScene, MeshTrees, compile, highlight_exponent, highlight_strength};
pub use film::Film;
pub use integrator::{Integrator, Lens};
pub use session::live::{
    DepthMap, Epoch, LiveEnd, LivePhase, LiveRequest, LiveSession, LiveStatus, ObjectMap, Pick, Snapshot, depths, pick,
};
pub use session::{Crop, Progress, RenderError, RenderJob, render};
pub use simd::SimdLevel;
