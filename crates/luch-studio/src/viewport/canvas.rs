//! How large the picture is shown and which part of it: pixels zoomed and moved, the camera left alone.

use crate::command::{Command, Zoom};
use crate::state::Desk;
use egui::{Context, Id, PointerButton, Pos2, Rect, Response, Ui, Vec2, vec2};
use luch_scene::ImageSize;

/// Free space around a picture that fits, in points.
const MARGIN: f32 = 12.0;
/// The smallest and largest zoom: screen pixels for one of the picture.
const ZOOM: [f32; 2] = [0.02, 64.0];

/// Where the picture's middle lies, in points from the middle of the area.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Canvas {
    pan: Vec2,
    /// The zoom that "fit" comes to, to start from when zooming.
    fitting: f32,
}

impl Canvas {
    fn id() -> Id {
        Id::unique("canvas")
    }

    pub(super) fn load(ctx: &Context) -> Self {
        ctx.data(|d| d.get_temp(Self::id())).unwrap_or_default()
    }

    pub(super) fn store(self, ctx: &Context) {
        ctx.data_mut(|d| d.insert_temp(Self::id(), self));
    }

    /// Zooms with the wheel and the command key or a pinch, about the pointer; moves with the middle button.
    pub(super) fn take_input(&mut self, ui: &Ui, response: &Response, desk: &mut Desk<'_>) {
        if response.dragged_by(PointerButton::Middle) {
            self.pan += response.drag_delta();
        }
        if desk.state.zoom == Zoom::Fit {
            self.pan = Vec2::ZERO;
        }
        let Some(pointer) = response.hover_pos() else { return };
        let factor = ui.input(egui::InputState::zoom_delta);
        if factor != 1.0 && self.fitting > 0.0 {
            let old = self.factor(desk.state.zoom);
            let new = (old * factor).clamp(ZOOM[0], ZOOM[1]);
            // The pixel under the pointer stays where it is.
            let from_middle = pointer - response.rect.center();
            self.pan = from_middle - (from_middle - self.pan) * (new / old);
            desk.send(Command::SetZoom(Zoom::Factor(new)));
        }
    }

    /// Screen pixels for one of the picture.
    fn factor(&self, zoom: Zoom) -> f32 {
        match zoom {
            Zoom::Fit => self.fitting,
            Zoom::Factor(factor) => factor,
        }
    }

    /// Where the picture lies in the area: never stretched.
    pub(super) fn picture_rect(&mut self, area: Rect, size: ImageSize, zoom: Zoom, pixels_per_point: f32) -> Rect {
        let pixels = vec2(size.width() as f32, size.height() as f32);
        let room = (area.size() - Vec2::splat(2.0 * MARGIN)).max(Vec2::splat(16.0)) * pixels_per_point;
        self.fitting = (room / pixels).min_elem();
        let points = pixels * self.factor(zoom) / pixels_per_point;
        // Something of the picture stays in sight.
        let reach = (area.size() + points) * 0.5 - Vec2::splat(48.0);
        self.pan = self.pan.clamp(-reach.max(Vec2::ZERO), reach.max(Vec2::ZERO));
        let min = area.center() + self.pan - points * 0.5;
        // Whole screen pixels, so that one to one is sharp.
        let snap = |v: f32| (v * pixels_per_point).round() / pixels_per_point;
        Rect::from_min_size(Pos2::new(snap(min.x), snap(min.y)), points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_is_never_stretched_and_fits() {
        let area = Rect::from_min_size(Pos2::new(10.0, 20.0), vec2(800.0, 600.0));
        for (width, height) in [(960, 720), (1920, 100), (10, 4000), (1, 1)] {
            let size = ImageSize::new(width, height).unwrap();
            for scale in [1.0, 1.5, 2.0] {
                let rect = Canvas::default().picture_rect(area, size, Zoom::Fit, scale);
                assert!(area.expand(0.5).contains_rect(rect), "{width}x{height}");
                let aspect = rect.width() / rect.height();
                assert!((aspect / (width as f32 / height as f32) - 1.0).abs() < 1e-3, "{width}x{height}");
            }
        }
    }

    #[test]
    fn one_to_one_is_a_pixel_for_a_pixel() {
        let area = Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0));
        let size = ImageSize::new(960, 720).unwrap();
        let rect = Canvas::default().picture_rect(area, size, Zoom::Factor(1.0), 1.5);
        assert_eq!(rect.size(), vec2(640.0, 480.0));
        assert_eq!((rect.min.x * 1.5).fract(), 0.0);
    }
}
