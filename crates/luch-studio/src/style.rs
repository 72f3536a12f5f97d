//! How the window looks, beyond what egui has.

use egui::{Color32, Context, FontFamily, FontId, Stroke, TextStyle, Theme, Visuals};

/// Sets spacing, letters and colours of both themes.
pub(crate) fn apply(ctx: &Context) {
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = egui::vec2(8.0, 5.0);
        style.spacing.button_padding = egui::vec2(8.0, 3.0);
        style.spacing.interact_size.y = 22.0;
        style.spacing.scroll = egui::style::ScrollStyle::thin();
        // What is wrong with an input is said in small letters, and is to be read all the same.
        style.text_styles.insert(TextStyle::Small, FontId::new(11.0, FontFamily::Proportional));
    });
    ctx.style_mut_of(Theme::Dark, |style| dark(&mut style.visuals));
    ctx.style_mut_of(Theme::Light, |style| light(&mut style.visuals));
}

/// Letters that stand out from the dark, and a red and an orange that do.
fn dark(visuals: &mut Visuals) {
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.fg_stroke.color = Color32::from_gray(175);
    widgets.inactive.fg_stroke.color = Color32::from_gray(205);
    visuals.weak_text_color = Some(Color32::from_gray(135));
    visuals.error_fg_color = Color32::from_rgb(255, 115, 105);
    visuals.warn_fg_color = Color32::from_rgb(255, 176, 64);
}

/// Panels a little darker than the fields in them, edges around what can be clicked, and colours dark enough to read.
fn light(visuals: &mut Visuals) {
    let widgets = &mut visuals.widgets;
    let edge = Stroke::new(1.0, Color32::from_gray(196));
    widgets.noninteractive.fg_stroke.color = Color32::from_gray(60);
    widgets.inactive.fg_stroke.color = Color32::from_gray(35);
    widgets.inactive.bg_fill = Color32::from_gray(222);
    widgets.inactive.weak_bg_fill = Color32::from_gray(228);
    widgets.inactive.bg_stroke = edge;
    widgets.active.bg_fill = Color32::from_gray(190);
    widgets.active.weak_bg_fill = Color32::from_gray(200);
    visuals.weak_text_color = Some(Color32::from_gray(110));
    visuals.panel_fill = Color32::from_gray(243);
    visuals.error_fg_color = Color32::from_rgb(190, 20, 20);
    visuals.warn_fg_color = Color32::from_rgb(165, 80, 0);
}
