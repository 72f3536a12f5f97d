//! The picture as a texture. Graphics cards have a largest side for those, and pictures may be larger: such a one is
//! uploaded reduced. What is told and picked stays what its own pixels say.

use egui::{Color32, ColorImage, Context, Painter, Rect, TextureFilter, TextureHandle, TextureOptions, pos2};
use luch_render::session::live::Snapshot;

/// The longest side that a texture may have here, in pixels.
pub(crate) fn longest_side(ctx: &Context) -> u32 {
    ctx.input(|i| u32::try_from(i.max_texture_side).unwrap_or(u32::MAX)).max(1)
}

/// The picture on the graphics card.
pub(crate) struct Texture {
    handle: TextureHandle,
    /// The part of it, across and down, that lies in the picture: the last blocks may reach beyond.
    part: [f32; 2],
}

impl Texture {
    /// Uploads a picture, in place of the one before.
    pub(crate) fn of(snapshot: &Snapshot, before: Option<Self>, ctx: &Context) -> Self {
        let sides = [snapshot.width, snapshot.height];
        let (image, step) = reduced(&snapshot.pixels, sides, longest_side(ctx));
        // Enlarged pixels stay squares, so that one can count them; a reduced preview is smoothed instead.
        let magnification = if snapshot.shrink > 1 { TextureFilter::Linear } else { TextureFilter::Nearest };
        let options = TextureOptions { magnification, ..TextureOptions::LINEAR };
        // Blocks may reach beyond the picture twice: those of a preview, and those of a reduced texture.
        let (preview, texture) = (snapshot.extent(), part_within(sides, image.size, step));
        let part = [preview[0] * texture[0], preview[1] * texture[1]];
        let handle = match before {
            Some(Self { mut handle, .. }) => {
                handle.set(image, options);
                handle
            }
            None => ctx.load_texture("picture", image, options),
        };
        Self { handle, part }
    }

    /// Draws the picture, and nothing of what reaches beyond it.
    pub(crate) fn draw(&self, painter: &Painter, rect: Rect) {
        let [right, bottom] = self.part;
        let shown = Rect::from_min_max(pos2(0.0, 0.0), pos2(right, bottom));
        painter.image(self.handle.id(), rect, shown, Color32::WHITE);
    }
}

/// The image of some pixels, and how many of them along its side each block has that became one of the image: the fewest
/// with which no side is longer than `longest`.
fn reduced(pixels: &[[u8; 4]], [width, height]: [u32; 2], longest: u32) -> (ColorImage, u32) {
    let step = width.max(height).div_ceil(longest).max(1);
    let size = [width.div_ceil(step) as usize, height.div_ceil(step) as usize];
    let color = |[r, g, b, _]: [u8; 4]| Color32::from_rgb(r, g, b);
    if step == 1 {
        return (ColorImage::new(size, pixels.iter().copied().map(color).collect()), step);
    }
    let row = width as usize;
    let mut blocks = Vec::with_capacity(size[0] * size[1]);
    for rows in pixels.chunks(row * step as usize) {
        for left in (0..row).step_by(step as usize) {
            let right = row.min(left + step as usize);
            blocks.push(color(mean(rows.chunks(row).flat_map(|row| &row[left..right]))));
        }
    }
    (ColorImage::new(size, blocks), step)
}

/// The mean of sRGB bytes, as the graphics card takes it where it reduces a picture.
fn mean<'a>(pixels: impl Iterator<Item = &'a [u8; 4]>) -> [u8; 4] {
    let (mut sums, mut count) = ([0_u64; 4], 0_u64);
    for pixel in pixels {
        count += 1;
        for (sum, &value) in sums.iter_mut().zip(pixel) {
            *sum += u64::from(value);
        }
    }
    sums.map(|sum| u8::try_from((sum + count / 2) / count.max(1)).unwrap_or(u8::MAX))
}

/// The part of an image, across and down, that lies in a picture of these sides if each of its pixels stands for a block
/// of so many along its side.
pub(crate) fn part_within(sides: [u32; 2], image: [usize; 2], block: u32) -> [f32; 2] {
    [0, 1].map(|axis| sides[axis] as f32 / (image[axis] as f32 * block as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(width: u32, height: u32) -> Vec<[u8; 4]> {
        (0..height).flat_map(|y| (0..width).map(move |x| [(x * 10) as u8, (y * 10) as u8, 7, 255])).collect()
    }

    #[test]
    fn a_picture_that_fits_keeps_its_pixels() {
        for longest in [6, 4096] {
            let (image, step) = reduced(&pixels(6, 4), [6, 4], longest);
            assert_eq!((image.size, step), ([6, 4], 1));
            assert_eq!(image.pixels[6 + 2], Color32::from_rgb(20, 10, 7));
        }
    }

    #[test]
    fn one_that_does_not_is_reduced_by_the_smallest_step_that_makes_it_fit() {
        let (image, step) = reduced(&pixels(7, 5), [7, 5], 4);
        assert_eq!((image.size, step), ([4, 3], 2));
        assert_eq!(image.pixels[0], Color32::from_rgb(5, 5, 7));
        // The last blocks have fewer pixels.
        assert_eq!(image.pixels[3], Color32::from_rgb(60, 5, 7));
        assert_eq!(image.pixels[11], Color32::from_rgb(60, 40, 7));
        for (sides, longest) in [([65_535, 1], 2048), ([1, 65_535], 8192), ([19_200, 3], 16_384), ([5, 5], 1)] {
            let (image, step) = reduced(&pixels(sides[0], sides[1]), sides, longest);
            assert!(image.size.into_iter().all(|side| side as u32 <= longest), "{sides:?} {longest}");
            assert!(
                sides.into_iter().max().unwrap().div_ceil(step - 1) > longest,
                "{sides:?}: {step} is more than needed"
            );
        }
    }

    #[test]
    fn blocks_that_reach_beyond_the_picture_are_not_shown_whole() {
        assert_eq!(part_within([8, 4], [4, 2], 2), [1.0, 1.0]);
        assert_eq!(part_within([7, 5], [4, 3], 2), [7.0 / 8.0, 5.0 / 6.0]);
    }
}
