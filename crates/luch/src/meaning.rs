//! What `luch render`'s arguments mean: checks that need no scene at once, the rest as edits of the scene and a job.

use crate::args::{Bits, CameraArgs, EditArgs, PictureArgs, RenderArgs};
use crate::exit::{Code, Failure};
use crate::set;
use crate::values::Rays;
use luch_io::PictureFormat;
use luch_io::scene_file::nearest;
use luch_render::{Crop, RenderJob, SimdLevel};
use luch_scene::{
    CameraEdit, Edit, EditError, ImageSize, LightEdit, ObjectEdit, RenderSettings, Sampling, Scene, SettingsEdit,
};
use std::path::{Path, PathBuf};

/// Bytes that a pixel takes while a picture is made: three sums and three means of 32 bits.
const BYTES_PER_PIXEL: u64 = 24;

/// A kind of picture file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Png8,
    Png16,
    Exr,
}

/// Where the figures of a render go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Stats {
    Nowhere,
    Stdout,
    File(PathBuf),
}

/// A render as it was asked for, right but for what only the scene can tell.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) scene: PathBuf,
    pub(crate) output: PathBuf,
    pub(crate) format: Format,
    pub(crate) stats: Stats,
    pub(crate) threads: usize,
    pub(crate) simd: SimdLevel,
    pub(crate) memory: Option<u64>,
    pub(crate) quiet: bool,
    picture: PictureArgs,
    camera: CameraArgs,
    edits: EditArgs,
}

impl Request {
    /// Checks everything that needs no scene, so that nobody waits for a picture that cannot be written.
    ///
    /// # Errors
    /// Usage, or an output that cannot be written.
    pub(crate) fn of(args: RenderArgs) -> Result<Self, Failure> {
        let RenderArgs { scene, output, picture, camera, edits, work } = args;
        let format = format_of(&output, picture.bits)?;
        let stats = match work.stats {
            None => Stats::Nowhere,
            Some(path) if path == output => return Err(Failure::usage("--stats and --output name the same place")),
            Some(path) if path == Path::new("-") => Stats::Stdout,
            Some(path) => Stats::File(path),
        };
        Ok(Self {
            scene,
            output,
            format,
            stats,
            threads: threads(work.threads),
            simd: available(work.simd)?,
            memory: work.memory,
            quiet: work.quiet,
            picture,
            camera,
            edits,
        })
    }

    /// The files that will be written.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = &Path> {
        let stats = if let Stats::File(path) = &self.stats { Some(path.as_path()) } else { None };
        [self.output.as_path()].into_iter().chain(stats)
    }

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

    /// The job, its crop inside the picture.
    ///
    /// # Errors
    /// Usage, if the crop reaches out of the picture.
    pub(crate) fn job(&self, scene: &Scene, camera: usize) -> Result<RenderJob, Failure> {
        let mut job = RenderJob::of_scene(scene, camera);
        if let Some(part) = self.picture.crop {
            let crop = Crop { x: part.x, y: part.y, width: part.width, height: part.height };
            if crop.within(job.size) != Some(crop) {
                return Err(crop_outside(crop, job.size));
            }
            job.crop = Some(crop);
        }
        job.integrator = self.picture.integrator;
        job.threads = self.threads;
        job.simd = self.simd;
        Ok(job)
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
        let PictureArgs { size, antialiasing, depth_of_field, depth, .. } = self.picture;
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

/// Bytes that the picture takes while it is made.
pub(crate) fn picture_bytes(job: &RenderJob) -> u64 {
    let pixels = job.pixels().map_or(0, |part| u64::from(part.width) * u64::from(part.height));
    pixels.saturating_mul(BYTES_PER_PIXEL)
}

/// The threads asked for, or as many as the machine has.
pub(crate) fn threads(asked: Option<u32>) -> usize {
    match asked {
        Some(count) => count as usize,
        None => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
    }
}

/// The level asked for, if this machine has it.
///
/// # Errors
/// Usage, with the levels that it has.
pub(crate) fn available(level: SimdLevel) -> Result<SimdLevel, Failure> {
    if level.is_available() {
        return Ok(level);
    }
    let words: Vec<&str> = SimdLevel::available().into_iter().map(SimdLevel::word).collect();
    Err(Failure::usage(format!("--simd {}: this machine cannot run it", level.word()))
        .hint(format!("it can run auto, {}", words.join(", "))))
}

fn format_of(output: &Path, bits: Option<Bits>) -> Result<Format, Failure> {
    let refused = |e: luch_io::Error| Failure { code: Code::Usage, ..Failure::from(e) };
    match (PictureFormat::of(output).map_err(refused)?, bits) {
        (PictureFormat::Png, None | Some(Bits::Eight)) => Ok(Format::Png8),
        (PictureFormat::Png, Some(Bits::Sixteen)) => Ok(Format::Png16),
        (PictureFormat::Exr, None) => Ok(Format::Exr),
        (PictureFormat::Exr, Some(_)) => {
            Err(Failure::usage("--bits is for PNG: an EXR picture always has 32 bits for each colour"))
        }
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

fn crop_outside(crop: Crop, size: ImageSize) -> Failure {
    let Crop { x, y, width, height } = crop;
    let picture = format!("{}x{}", size.width(), size.height());
    Failure::usage(format!("--crop {x},{y},{width},{height} reaches out of the picture, which has {picture} pixels"))
        .hint("X + W may be the width at most, and Y + H the height")
}
