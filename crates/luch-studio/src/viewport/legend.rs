//! What the colours of a picture mean that shows something else than light.

use crate::l10n::Texts;
use egui::epaint::Mesh;
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, pos2, vec2};
use luch_render::Integrator;
use luch_render::film::heat::{HEAT_END, HEAT_TICKS, heat_color, heat_place};
use luch_render::film::tonemap::srgb8;

/// The size of a bar, in points.
const BAR: [f32; 2] = [232.0, 12.0];
/// The steps that a bar is drawn in.
const STEPS: u16 = 64;
const FONT: f32 = 11.5;
/// The count at which the view of the cost is full.
const COST_END: u32 = 64;

/// What a view is called, and what it shows.
pub(crate) fn name(texts: &Texts, integrator: Integrator) -> [String; 2] {
    match integrator {
        Integrator::Classic => [texts.view_classic(), texts.view_classic_tip()],
        Integrator::Normal => [texts.view_normal(), texts.view_normal_tip()],
        Integrator::Depth => [texts.view_depth(), texts.view_depth_tip()],
        Integrator::Objects => [texts.view_objects(), texts.view_objects_tip()],
        Integrator::Cost => [texts.view_cost(), texts.view_cost_tip()],
        Integrator::Nodes => [texts.view_nodes(), texts.view_nodes_tip()],
        Integrator::Triangles => [texts.view_triangles(), texts.view_triangles_tip()],
    }
}

/// A bar of colours with what is written below it.
struct Bar {
    color: fn(f32) -> [f32; 3],
    /// Texts and their places along the bar.
    ticks: Vec<(f32, String)>,
}

fn bars(texts: &Texts, integrator: Integrator) -> Option<(String, Vec<Bar>)> {
    let counts = || {
        let text = |tick: u32| if tick == HEAT_END { format!("{tick}+") } else { tick.to_string() };
        Bar { color: heat_color, ticks: HEAT_TICKS.map(|tick| (heat_place(tick), text(tick))).to_vec() }
    };
    let cost = |color, what: String| Bar {
        color,
        ticks: vec![(0.0, "0".to_owned()), (0.5, what), (1.0, format!("{COST_END}+"))],
    };
    Some(match integrator {
        Integrator::Classic | Integrator::Objects => return None,
        Integrator::Nodes => (texts.legend_nodes(), vec![counts()]),
        Integrator::Triangles => (texts.legend_triangles(), vec![counts()]),
        Integrator::Cost => {
            let bars =
                vec![cost(|v| [v, 0.0, 0.0], texts.legend_boxes()), cost(|v| [0.0, v, 0.0], texts.legend_shapes())];
            (texts.legend_cost(), bars)
        }
        Integrator::Depth => {
            let ticks = vec![(0.0, texts.legend_near()), (0.5, texts.legend_half()), (1.0, texts.legend_far())];
            (texts.legend_depth(), vec![Bar { color: |v| [1.0 - v; 3], ticks }])
        }
        Integrator::Normal => {
            let axis =
                |color, name: &str| Bar { color, ticks: vec![(0.0, format!("−{name}")), (1.0, format!("+{name}"))] };
            let bars = vec![axis(|v| [v, 0.5, 0.5], "x"), axis(|v| [0.5, v, 0.5], "y"), axis(|v| [0.5, 0.5, v], "z")];
            (texts.legend_normal(), bars)
        }
    })
}

/// Draws the legend of a view into the lower right of the picture; light needs none.
pub(super) fn draw(painter: &Painter, picture: Rect, integrator: Integrator, texts: &Texts) {
    let Some((title, bars)) = bars(texts, integrator) else { return };
    let row = BAR[1] + FONT + 8.0;
    let size = vec2(BAR[0] + 36.0, FONT + 14.0 + row * bars.len() as f32 + 4.0);
    let seen = painter.clip_rect().intersect(picture);
    if seen.width() < size.x + 16.0 || seen.height() < size.y + 16.0 {
        return;
    }
    let area = Align2::RIGHT_BOTTOM.align_size_within_rect(size, seen.shrink(8.0));
    painter.rect_filled(area, 4.0, Color32::from_black_alpha(200));
    let font = FontId::proportional(FONT);
    painter.text(area.min + vec2(18.0, 6.0), Align2::LEFT_TOP, title, FontId::proportional(FONT + 1.0), Color32::WHITE);
    for (bar, place) in bars.iter().zip(0_u8..) {
        let top = area.top() + FONT + 14.0 + row * f32::from(place);
        let rect = Rect::from_min_size(pos2(area.left() + 18.0, top), BAR.into());
        gradient(painter, rect, bar.color);
        for (along, text) in &bar.ticks {
            let at = pos2(rect.left() + rect.width() * along, rect.bottom() + 2.0);
            // Words at the ends stay within the bar; numbers stand in the middle of their tick.
            let align = match *along {
                0.0 if text.len() > 3 => Align2::LEFT_TOP,
                1.0 if text.len() > 4 => Align2::RIGHT_TOP,
                _ => Align2::CENTER_TOP,
            };
            painter.text(at, align, text, font.clone(), Color32::WHITE);
        }
    }
}

fn gradient(painter: &Painter, rect: Rect, color: fn(f32) -> [f32; 3]) {
    let mut mesh = Mesh::default();
    for step in 0..=STEPS {
        let along = f32::from(step) / f32::from(STEPS);
        let bytes = srgb8(&color(along));
        let color = Color32::from_rgb(bytes[0], bytes[1], bytes[2]);
        let x = rect.left() + rect.width() * along;
        mesh.colored_vertex(Pos2::new(x, rect.top()), color);
        mesh.colored_vertex(Pos2::new(x, rect.bottom()), color);
        if step > 0 {
            let last = u32::from(step) * 2;
            mesh.add_triangle(last - 2, last - 1, last);
            mesh.add_triangle(last - 1, last, last + 1);
        }
    }
    painter.add(mesh);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::l10n::Language;

    #[test]
    fn the_heat_maps_have_their_scale_and_light_has_none() {
        let texts = Language::En.load();
        for integrator in Integrator::ALL {
            let legend = bars(&texts, integrator);
            assert_eq!(legend.is_none(), matches!(integrator, Integrator::Classic | Integrator::Objects));
        }
        let (_, heat) = bars(&texts, Integrator::Nodes).unwrap();
        assert_eq!(heat[0].ticks.first().unwrap(), &(0.0, "0".to_owned()));
        assert_eq!(heat[0].ticks.last().unwrap(), &(1.0, "255+".to_owned()));
    }
}
