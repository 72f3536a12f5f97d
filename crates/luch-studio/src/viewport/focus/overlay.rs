//! What is in focus, shown over the picture: what is too near is tinted orange, what is too far blue, the more the more
//! it is blurred; what is sharp stays as it is, and a line runs where the focus is exact.

use super::blur::{Blur, SHARP};
use crate::texture::{longest_side, part_within};
use crate::viewport::frame::PictureFrame;
use egui::{Color32, ColorImage, Context, Id, Painter, Rect, TextureHandle, TextureOptions, pos2};
use luch_render::CompiledScene;
use luch_render::session::live::{DepthMap, Snapshot, depths};
use luch_scene::{Camera, ImageSize};
use std::sync::Arc;

/// Rays for a map of distances, at most: a few milliseconds.
const RAYS: u64 = 60_000;
/// The blur, in pixels beyond the sharp, that half of the tint is for.
const HALF: f64 = 8.0;
/// The strongest tint, of 255.
const STRONGEST: f64 = 190.0;
/// Colours that stay apart for every eye.
const NEAR: [u8; 3] = [235, 120, 0];
const FAR: [u8; 3] = [0, 90, 200];
const EXACT: Color32 = Color32::from_rgb(255, 255, 255);
/// Neighbours blurred by more, in pixels, lie on different things: the focus is between them, but on neither.
const NEIGHBOURS: f64 = 8.0;

/// What was drawn last, to be drawn again.
#[derive(Clone)]
struct Kept {
    compiled: Arc<CompiledScene>,
    camera: Camera,
    size: ImageSize,
    map: Arc<DepthMap>,
    blur: Blur,
    texture: TextureHandle,
}

fn id() -> Id {
    Id::unique("focus overlay")
}

pub(super) fn draw(painter: &Painter, frame: &PictureFrame, snapshot: &Snapshot, blur: Blur) {
    let ctx = painter.ctx();
    let kept: Option<Kept> = ctx.data(|d| d.get_temp(id()));
    let known = kept.as_ref().filter(|kept| kept.shows(snapshot));
    let blur = blur.opened();
    let kept = match known {
        Some(kept) if kept.blur == blur => kept.clone(),
        _ => {
            let map = known.map_or_else(|| Arc::new(map_of(snapshot, longest_side(ctx))), |kept| Arc::clone(&kept.map));
            let image = tints(&map, blur);
            let texture = match kept {
                Some(mut kept) => {
                    kept.texture.set(image, TextureOptions::LINEAR);
                    kept.texture
                }
                None => ctx.load_texture("focus", image, TextureOptions::LINEAR),
            };
            let (compiled, camera) = (Arc::clone(&snapshot.compiled), snapshot.job.camera.clone());
            let kept = Kept { compiled, camera, size: snapshot.job.size, map, blur, texture };
            ctx.data_mut(|d| d.insert_temp(id(), kept.clone()));
            kept
        }
    };
    // The last blocks may reach beyond the picture.
    let (sides, blocks) = ([kept.size.width(), kept.size.height()], [kept.map.columns(), kept.map.rows()]);
    let [right, bottom] = part_within(sides, blocks.map(|side| side as usize), kept.map.shrink());
    let shown = Rect::from_min_max(pos2(0.0, 0.0), pos2(right, bottom));
    painter.image(kept.texture.id(), frame.rect, shown, Color32::WHITE);
}

/// Lets go of what was kept, and with it of the scene.
pub(super) fn forget(ctx: &Context) {
    ctx.data_mut(|d| d.remove::<Kept>(id()));
}

impl Kept {
    /// Whether the distances in a picture are those that are known: the lens does not change them.
    fn shows(&self, snapshot: &Snapshot) -> bool {
        let (own, other) = (&self.camera, &snapshot.job.camera);
        Arc::ptr_eq(&self.compiled, &snapshot.compiled)
            && self.size == snapshot.job.size
            && (own.position, own.aim, own.fov) == (other.position, other.aim, other.fov)
    }
}

fn map_of(snapshot: &Snapshot, longest: u32) -> DepthMap {
    depths(&snapshot.compiled, &snapshot.job, side_of_blocks(snapshot.job.size, longest))
}

/// The side of the blocks that one ray each is traced for: so few that the map is soon there and fits in a texture.
fn side_of_blocks(size: ImageSize, longest: u32) -> u32 {
    let fits = |side: u32| {
        let long = size.width().max(size.height()).div_ceil(side);
        size.pixels() / u64::from(side).pow(2) <= RAYS && long <= longest
    };
    (1..=ImageSize::MAX_SIDE).find(|&side| fits(side)).unwrap_or(ImageSize::MAX_SIDE)
}

fn tints(map: &DepthMap, blur: Blur) -> ColorImage {
    let columns = map.columns() as usize;
    let of = map.depths();
    let pixels = of.iter().enumerate().map(|(place, &depth)| {
        let beside = (place % columns + 1 < columns).then(|| of[place + 1]);
        let below = of.get(place + columns).copied();
        let is_exact = [beside, below].into_iter().flatten().any(|other| passes(blur, depth, other));
        if is_exact { EXACT } else { tint(blur, f64::from(depth)) }
    });
    ColorImage::new([columns, map.rows() as usize], pixels.collect())
}

/// Whether the focus lies between two neighbours on one surface.
fn passes(blur: Blur, here: f32, there: f32) -> bool {
    let [here, there] = [here, there].map(f64::from);
    (here < blur.focus) != (there < blur.focus) && blur.diameter(here).max(blur.diameter(there)) < NEIGHBOURS
}

fn tint(blur: Blur, depth: f64) -> Color32 {
    let [r, g, b] = if depth < blur.focus { NEAR } else { FAR };
    let beyond = (blur.diameter(depth) - SHARP).max(0.0);
    Color32::from_rgba_unmultiplied(r, g, b, (STRONGEST * beyond / (beyond + HALF)) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Aim, NonNegative, Point, Positive};

    fn blur() -> Blur {
        let mut camera = Camera::new("c", Point::clamped(Vec3::new(0.0, 0.0, 5.0)), Aim::At(Point::ORIGIN));
        camera.lens_radius = NonNegative::new(0.1).unwrap();
        camera.focal_distance = Some(Positive::new(4.0).unwrap());
        Blur::of(&camera, ImageSize::new(960, 720).unwrap())
    }

    #[test]
    fn the_sharp_is_untouched_the_near_orange_the_far_blue_and_more_so_with_more_blur() {
        assert_eq!(tint(blur(), 4.0).a(), 0);
        assert_eq!(tint(blur(), 4.02).a(), 0);
        let [near, nearer, far, farther] = [3.0, 2.0, 5.0, f64::INFINITY].map(|depth| tint(blur(), depth));
        assert!(near.r() > near.b() && far.b() > far.r());
        assert!(nearer.a() > near.a() && farther.a() > far.a() && far.a() > 20);
    }

    #[test]
    fn the_map_of_any_picture_is_soon_there_and_fits_in_a_texture() {
        for (width, height) in [(960, 720), (65_535, 1), (1, 65_535), (65_535, 1024), (8192, 8192), (1, 1)] {
            let size = ImageSize::new(width, height).unwrap();
            for longest in [512, 2048, 16_384] {
                let side = side_of_blocks(size, longest);
                let [columns, rows] = [width, height].map(|pixels| pixels.div_ceil(side));
                assert!(columns.max(rows) <= longest, "{width} x {height}: {columns} x {rows}");
                assert!(u64::from(columns) * u64::from(rows) <= RAYS + u64::from(columns.max(rows)) * 2);
            }
        }
        assert_eq!(side_of_blocks(ImageSize::new(200, 300).unwrap(), 2048), 1);
    }

    #[test]
    fn the_line_runs_where_the_focus_is_exact_and_not_along_edges() {
        assert!(passes(blur(), 3.99, 4.01));
        assert!(!passes(blur(), 4.01, 4.02));
        assert!(!passes(blur(), 3.0, 9.0), "an edge");
        assert!(!passes(blur(), 3.99, f32::INFINITY), "an outline");
    }
}
