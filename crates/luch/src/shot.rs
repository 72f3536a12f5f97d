//! What a command means of the scene, its camera and the frame: the same for all that make or explain a picture.

use crate::args::{CameraArgs, EditArgs, FrameArgs};
use crate::exit::{Code, Failure};
use crate::set;
use crate::values::Rays;
use luch_io::scene_file::nearest;
use luch_render::RenderJob;
use luch_scene::{CameraEdit, Edit, EditError, LightEdit, ObjectEdit, RenderSettings, Sampling, Scene, SettingsEdit};

/// The changes of a scene, the camera and the frame that were asked for.
#[derive(Debug)]
pub(crate) struct Shot {
    pub(crate) frame: FrameArgs,
    pub(crate) camera: CameraArgs,
    pub(crate) edits: EditArgs,
}

impl Shot {
    /// Changes the scene as asked and answers with the place of the chosen camera.
    ///
    /// Flags that mean the whole scene come first, then `--set` in the order given, then the camera's own flags.
    ///
    /// # Errors
    /// Usage, for names that the scene has not.
    pub(crate) fn apply(&self, scene: &mut Scene) -> Result<usize, Failure> {
        apply_all(scene, self.whole_scene_edits(scene))?;
        for assignment in &self.edits.set {
            set::apply(assignment, scene)?;
        }
        let camera = camera_of(scene, &self.camera.name)?;
        apply_all(scene, self.camera_edits(camera))?;
        Ok(camera)
    }

    /// What is right but will not do what the user hopes for.
    pub(crate) fn advice(&self, job: &RenderJob) -> Vec<String> {
        let mut advice = Vec::new();
        let mut blur = |flag: bool, name: &str| {
            if flag && !job.depth_of_field.on {
                advice.push(format!("--{name} has no effect while depth of field is off: add --depth-of-field 64"));
            }
        };
        blur(self.camera.focal_distance.is_some(), "focal-distance");
        blur(self.camera.lens_radius.is_some(), "lens-radius");
        if job.depth_of_field.on && job.camera.lens_radius.get() == 0.0 {
            advice.push("nothing will blur: the camera's lens has the radius 0: add --lens-radius R".to_owned());
        }
        advice
    }

    fn whole_scene_edits(&self, scene: &Scene) -> Vec<Edit> {
        let FrameArgs { size, antialiasing, depth_of_field, depth } = self.frame;
        let RenderSettings { antialiasing: aa, depth_of_field: dof, .. } = scene.settings;
        let settings = [
            size.map(SettingsEdit::SetSize),
            depth.map(SettingsEdit::SetDepth),
            antialiasing.map(|rays| SettingsEdit::SetAntialiasing(sampling(aa, rays))),
            depth_of_field.map(|rays| SettingsEdit::SetDepthOfField(sampling(dof, rays))),
            self.edits.shading.map(SettingsEdit::SetShading),
        ];
        let mut edits: Vec<Edit> = settings.into_iter().flatten().map(Edit::Settings).collect();
        if self.edits.shading.is_some() {
            edits.extend((0..scene.objects.len()).map(|i| Edit::Object(i, ObjectEdit::SetShading(None))));
        }
        if let Some(intensity) = self.edits.light_intensity {
            edits.extend((0..scene.lights.len()).map(|i| Edit::Light(i, LightEdit::SetIntensity(intensity))));
        }
        edits
    }

    fn camera_edits(&self, camera: usize) -> Vec<Edit> {
        let edits = [
            self.camera.fov.map(CameraEdit::SetFov),
            self.camera.focal_distance.map(|d| CameraEdit::SetFocalDistance(Some(d))),
            self.camera.lens_radius.map(CameraEdit::SetLensRadius),
        ];
        edits.into_iter().flatten().map(|edit| Edit::Camera(camera, edit)).collect()
    }
}

fn sampling(now: Sampling, asked: Rays) -> Sampling {
    match asked {
        Rays::Off => Sampling { on: false, ..now },
        Rays::On(rays) => Sampling { on: true, rays },
    }
}

fn apply_all(scene: &mut Scene, edits: Vec<Edit>) -> Result<(), Failure> {
    let refused = |e: EditError| Failure::new(Code::Usage, e.to_string());
    Edit::Group(edits).apply(scene).map(|_| ()).map_err(refused)
}

/// The camera of that name, or of that number from 1.
fn camera_of(scene: &Scene, word: &str) -> Result<usize, Failure> {
    if let Some(index) = scene.camera_named(word) {
        return Ok(index);
    }
    let names = || set::quoted(scene.cameras.iter().map(|c| c.name.as_str()));
    let count = scene.cameras.len();
    match word.parse::<usize>() {
        Ok(number) if (1..=count).contains(&number) => Ok(number - 1),
        Ok(_) => Err(Failure::usage(format!("--camera {word}: the scene has the cameras 1 to {count}")).hint(names())),
        Err(_) => {
            let known = scene.cameras.iter().map(|c| c.name.as_str());
            let meant = nearest(word, known).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
            Err(Failure::usage(format!("--camera: the scene has no camera \"{word}\"{meant}"))
                .hint(format!("its cameras, from 1: {}", names())))
        }
    }
}
