//! The description of a scene: plain data that is right by construction.
//!
//! Nothing here opens a file, starts a thread or builds a tree. Every number in a [`Scene`] is finite and in range,
//! because its type admits no other ([`number`]); every change is an [`Edit`] that answers with its own inverse.

#![forbid(unsafe_code)]

pub mod camera;
pub mod color;
pub mod edit;
pub mod light;
pub mod mesh;
pub mod number;
pub mod object;
pub mod scene;
pub mod settings;
pub mod shape;
pub mod vector;

pub use camera::{Aim, Camera};
pub use color::Color;
pub use edit::{CameraEdit, Edit, EditError, LightEdit, ObjectEdit, SceneEdit, SettingsEdit};
pub use light::Light;
pub use mesh::{Mesh, MeshData, MeshError, MeshId, MeshMaterial};
pub use number::{FieldOfView, Finite, NonNegative, NumberError, Positive, Size, Unit};
pub use object::{Checker, Material, Object, Shading};
pub use scene::{NameError, Scene};
pub use settings::{ImageSize, RayCount, RenderSettings, Sampling};
pub use shape::{MeshInstance, Shape};
pub use vector::{Direction, Point, Rotation};
