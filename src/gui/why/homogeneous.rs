//! The explanation of w: points in (x_r, w_r), the image of a midpoint, and a floor with and without w.

use eframe::egui::{self, Align2, Color32, FontId, Pos2, Rect, RichText, Sense, Shape, Stroke, TextStyle, vec2};
use glam::{DVec2, DVec3, DVec4};

use crate::camera::{Camera, Projection};
use crate::explain::homogeneous::{Floor, projected_share};
use crate::gui::kit::{Explained, NumberField, Step, complain, help_topic, help_topic_row, section, theme};
use crate::gui::why::state::explain::Explain;
use crate::sanitize;
use crate::views::{Palette, Probe};
use camera_lab_desk::Model;
use camera_lab_words::why::homogeneous::{self, Texts};
use camera_lab_words::window;

/// A displayed point, or a direction (w = 0 in the world).
struct Shown {
    name: String,
    clip: DVec4,
    color: Color32,
}

/// Shows the tab.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain) {
    let t = homogeneous::texts(model.settings.lang);
    part(ui, t.plane_title, ("w plane", "w"), |ui| plane(ui, t, model));
    part(ui, t.middle_title, ("w middle", "5.6"), |ui| middle(ui, t, model, explain));
    part(ui, t.floor_title, ("w floor", "stage-interpolate"), |ui| floor(ui, t, model));
    let mut reveal = model.desk.shown.figure().reveal;
    let hint = window::texts(model.settings.lang).vanishing_hint;
    let vanishing = ui.checkbox(&mut reveal.vanishing, t.vanishing).explained(hint);
    help_topic(&vanishing, "ideal-point");
    model.desk.shown.set(|figure| &mut figure.reveal, reveal);
}

/// A section, with the note on its subject.
fn part(ui: &mut egui::Ui, title: &str, (id, note): (&str, &'static str), body: impl FnOnce(&mut egui::Ui)) {
    let shown = ui.scope(|ui| section(ui, title, id, true, body));
    help_topic_row(ui, shown.response.rect, note);
}

fn colored(rgba: crate::appearance::Rgba) -> Color32 {
    Color32::from_rgba_unmultiplied(rgba.r, rgba.g, rgba.b, rgba.a)
}

/// The points to show: those of the figure and the probe's, or without any, corners of the volume. Then the directions
/// x, y, z.
fn shown(model: &Model, palette: Palette) -> (Vec<Shown>, bool) {
    let camera = model.desk.shown.camera();
    let probe = match model.frame.probe {
        Some(Probe::Point(p)) => Some(("P".to_owned(), p)),
        Some(Probe::Window(_)) | None => None,
    };
    let named = model.desk.shown.figure().points.iter().map(|point| (sanitize::escaped(&point.name), point.position));
    let mut points: Vec<(String, DVec3)> = named.chain(probe).collect();
    let own = !points.is_empty();
    if !own {
        let corners = camera.volume_corners();
        let half = |a: usize, b: usize| corners[a].midpoint(corners[b]);
        let names = ["l F", "r F", "l B", "r B"].map(str::to_owned);
        points = names.into_iter().zip([half(0, 3), half(1, 2), half(4, 7), half(5, 6)]).collect();
    }
    let color = colored(palette.probe);
    let at = points.into_iter().map(|(name, p)| Shown { name, clip: camera.clip_point(p), color });
    let size = camera.distance();
    let ideal = [(DVec3::X, "(±x, 0)"), (DVec3::Y, "(±y, 0)"), (DVec3::Z, "(±z, 0)")]
        .into_iter()
        .zip(palette.axes)
        .map(|((direction, name), color)| {
            let clip = camera.clip_from_world() * (direction * size).extend(0.0);
            // A direction and the opposite one are the same ideal point.
            let clip = if clip.w < 0.0 { -clip } else { clip };
            Shown { name: name.to_owned(), clip, color: colored(color) }
        });
    let finite = |shown: &Shown| shown.clip.is_finite();
    (at.chain(ideal).filter(finite).collect(), own)
}

/// A picture of this width, and its ground.
fn canvas(ui: &mut egui::Ui, height: f32, name: &str) -> (Rect, egui::Painter) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, name));
    let painter = ui.painter_at(rect);
    painter.rect(rect, 3.0, ui.visuals().extreme_bg_color, ui.visuals().window_stroke, egui::StrokeKind::Inside);
    (rect, painter)
}

fn plane(ui: &mut egui::Ui, t: &Texts, model: &Model) {
    let palette = Palette::of(model.style().theme);
    let (points, own) = shown(model, palette);
    ui.label(RichText::new(t.plane_hint).weak());
    if model.desk.shown.camera().projection() == Projection::Parallel {
        ui.label(t.plane_parallel);
    }
    let (rect, painter) = canvas(ui, 230.0, t.plane_title);
    let greatest = points.iter().map(|p| p.clip.x.abs().max(p.clip.w.abs())).fold(1.2, f64::max);
    // As much above w = 0 as needed, and below it the points behind the eye.
    let lowest = points.iter().map(|p| p.clip.w).fold(-0.25 * greatest, f64::min);
    let highest = points.iter().map(|p| p.clip.w).fold(1.2, f64::max);
    let scale = (f64::from(rect.height()) * 0.88 / (highest - lowest)).min(f64::from(rect.width()) * 0.45 / greatest);
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let place = |x: f64, w: f64| {
        let up = (w - lowest) * scale + 0.06 * f64::from(rect.height());
        egui::pos2(rect.center().x + (x * scale) as f32, rect.bottom() - up as f32)
    };
    let weak = Stroke::new(1.0, ui.visuals().weak_text_color());
    let reach = f64::from(rect.width()) / scale;
    // Inside: |x| ≤ w.
    let inside = vec![place(0.0, 0.0), place(reach, reach), place(-reach, reach)];
    painter.add(Shape::convex_polygon(inside, colored(palette.volume), Stroke::NONE));
    let below = Rect::from_min_max(egui::pos2(rect.left(), place(0.0, 0.0).y), rect.max);
    painter.rect_filled(below, 0.0, colored(palette.wrong).gamma_multiply(0.10));
    painter.line_segment([place(-reach, 0.0), place(reach, 0.0)], weak);
    painter.line_segment([place(0.0, lowest - greatest), place(0.0, reach)], weak);
    painter.line_segment([place(-reach, 1.0), place(reach, 1.0)], Stroke::new(1.5, colored(palette.volume_edge)));
    let font = TextStyle::Small.resolve(ui.style());
    let text = |at: Pos2, align: Align2, text: &str, color: Color32| {
        painter.text(at, align, text, font.clone(), color);
    };
    let ink = ui.visuals().text_color();
    let edge = rect.right() - 6.0;
    text(egui::pos2(edge, place(0.0, 1.0).y - 2.0), Align2::RIGHT_BOTTOM, "w = 1", colored(palette.volume_edge));
    text(egui::pos2(edge, place(0.0, 0.0).y - 2.0), Align2::RIGHT_BOTTOM, "w = 0", ink);
    text(egui::pos2(rect.left() + 6.0, below.top() + 2.0), Align2::LEFT_TOP, t.behind, colored(palette.wrong));
    text(place(0.0, 0.0) + vec2(5.0, -34.0), Align2::LEFT_BOTTOM, t.inside, ink);
    for point in &points {
        ray(&painter, point, place, &font, t, colored(palette.wrong));
    }
    if !own {
        ui.label(RichText::new(t.no_points).small().weak());
    }
}

/// A point, and the line through the origin to w = 1.
fn ray(
    painter: &egui::Painter,
    point: &Shown,
    place: impl Fn(f64, f64) -> Pos2,
    font: &FontId,
    t: &Texts,
    wrong: Color32,
) {
    let DVec4 { x, w, .. } = point.clip;
    let at = place(x, w);
    let noise = 1e-12 * x.abs();
    let (color, said) = if w.abs() <= noise {
        painter.line_segment([place(-x, -w), at], Stroke::new(1.0, point.color));
        (point.color, format!("{} {}", point.name, t.ideal))
    } else {
        let target = place(x / w, 1.0);
        if w > 0.0 {
            painter.line_segment([place(0.0, 0.0), if w < 1.0 { target } else { at }], Stroke::new(1.0, point.color));
        } else {
            painter.add(Shape::dashed_line(&[at, target], Stroke::new(1.0, wrong), 4.0, 3.0));
        }
        painter.circle_filled(target, 2.5, if w > 0.0 { point.color } else { wrong });
        let turned = if w > 0.0 { String::new() } else { format!(" {}", t.turned_over) };
        (if w > 0.0 { point.color } else { wrong }, format!("{}{turned}", point.name))
    };
    painter.circle_filled(at, 4.0, color);
    let galley = painter.layout_no_wrap(said, font.clone(), color);
    let (room, beside) = (painter.clip_rect().shrink(4.0), vec2(7.0, -2.0 - galley.size().y / 2.0));
    // On the other side if it would leave the picture.
    let right = at.x + beside.x + galley.size().x <= room.right();
    let left = if right { at.x + beside.x } else { at.x - beside.x - galley.size().x };
    let top = (at.y + beside.y).clamp(room.top(), (room.bottom() - galley.size().y).max(room.top()));
    painter.galley(egui::pos2(left, top), galley, color);
}

/// The ends of the segment: the first two points of the figure, or an edge of the floor that runs away from the eye.
fn ends(model: &Model) -> [(String, DVec3); 2] {
    if let [a, b, ..] = model.desk.shown.figure().points.as_slice() {
        return [(sanitize::escaped(&a.name), a.position), (sanitize::escaped(&b.name), b.position)];
    }
    let [far, _, _, near] = Floor::new(model.desk.shown.camera()).corners;
    [("A".to_owned(), near), ("B".to_owned(), far)]
}

fn middle(ui: &mut egui::Ui, t: &Texts, model: &Model, explain: &mut Explain) {
    ui.label(RichText::new(t.middle_hint).weak());
    let [(a, from), (b, to)] = ends(model);
    let camera = model.desk.shown.camera();
    let [w_a, w_b] = [from, to].map(|p| camera.clip_point(p).w);
    let share = &mut explain.share;
    let lang = model.settings.lang;
    let output = ui.horizontal(|ui| {
        let slider = egui::Slider::new(share, 0.0..=1.0).show_value(false);
        ui.add(slider).explained(t.share_hint).accessible_name(t.share);
        let field = NumberField::new(t.share, Step::Add(0.1)).within(0.0..=1.0).hint(t.share_hint);
        let output = field.show(ui, window::texts(lang), share);
        ui.label(t.share);
        output
    });
    let share = *share;
    complain(ui, lang, [&output.inner]);
    if !(w_a > 0.0 && w_b > 0.0) {
        ui.label(t.behind_middle);
        return;
    }
    let seen = projected_share(share, w_a, w_b);
    let (rect, painter) = canvas(ui, 96.0, t.middle_title);
    let font = TextStyle::Small.resolve(ui.style());
    let palette = Palette::of(model.style().theme);
    let (ink, good) = (ui.visuals().text_color(), colored(palette.probe));
    let (left, right) = (rect.left() + 70.0, rect.right() - 30.0);
    for (y, title, at) in [(rect.top() + 28.0, t.world, share), (rect.top() + 68.0, t.image, seen)] {
        painter.text(egui::pos2(rect.left() + 8.0, y), Align2::LEFT_CENTER, title, font.clone(), ink);
        painter.line_segment([egui::pos2(left, y), egui::pos2(right, y)], Stroke::new(1.5, ink));
        for (x, name) in [(left, &a), (right, &b)] {
            painter.circle_filled(egui::pos2(x, y), 3.0, ink);
            painter.text(egui::pos2(x, y - 6.0), Align2::CENTER_BOTTOM, name, font.clone(), ink);
        }
        #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
        let x = left + (right - left) * at as f32;
        painter.circle_filled(egui::pos2(x, y), 4.5, good);
    }
    let number = |x: f64| model.settings.lang.mark().number(x, model.settings.digits);
    let [ws, wb, wa] = [seen, w_b, w_a].map(number);
    let (t_b, t_a) = (number(share), number(1.0 - share));
    ui.label(theme::symbol(ui, "s = t w_B / ((1 − t) w_A + t w_B)"));
    ui.label(format!("s = {t_b}·{wb}/({t_a}·{wa} + {t_b}·{wb}) = {ws}"));
}

/// Pixels along the longer side of a picture of the floor.
const PIXELS: u32 = 150;

fn floor(ui: &mut egui::Ui, t: &Texts, model: &Model) {
    ui.label(RichText::new(t.floor_hint).weak());
    let camera = model.desk.shown.camera();
    if camera.projection() == Projection::Parallel {
        ui.label(t.same);
    }
    let palette = Palette::of(model.style().theme);
    let width = (ui.available_width() - 8.0) / 2.0;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 8.0;
        for (with_w, name, key) in [(false, t.affine, "affine floor"), (true, t.correct, "right floor")] {
            ui.vertical(|ui| {
                ui.set_width(width);
                let texture = chequered(ui, camera, with_w, palette, key);
                let size = texture.size_vec2();
                let image = egui::Image::new((texture.id(), size)).fit_to_exact_size(size * (width / size.x));
                ui.add(image.alt_text(name));
                ui.label(RichText::new(name).small());
            });
        }
    });
}

/// The floor as pixels, drawn again only for another camera.
fn chequered(ui: &egui::Ui, camera: &Camera, with_w: bool, palette: Palette, key: &str) -> egui::TextureHandle {
    type CachedFloor = (Camera, Color32, egui::TextureHandle);
    let id = egui::Id::unique(("floor", key));
    let paper = colored(palette.paper);
    if let Some((made_for, ground, texture)) = ui.data(|data| data.get_temp::<CachedFloor>(id))
        && made_for == *camera
        && ground == paper
    {
        return texture;
    }
    let aspect = camera.window_aspect().clamp(0.2, 5.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "30 … 750 pixels")]
    let height = (f64::from(PIXELS) / aspect).round().max(1.0) as u32;
    let floor = Floor::new(camera);
    let window = camera.window();
    let (dark, light) = (colored(palette.axes[0]), colored(palette.soft));
    let pixels = (0..height).flat_map(|j| (0..PIXELS).map(move |i| (i, j))).map(|(i, j)| {
        let share =
            DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / DVec2::new(f64::from(PIXELS), f64::from(height));
        let point = DVec2::new(window.left + window.width() * share.x, window.top - window.height() * share.y);
        floor.is_dark(point, with_w).map_or(paper, |is_dark| if is_dark { dark } else { light })
    });
    let image = egui::ColorImage::new([PIXELS as usize, height as usize], pixels.collect());
    let texture = ui.ctx().load_texture(key, image, egui::TextureOptions::NEAREST);
    ui.data_mut(|data| data.insert_temp(id, (camera.clone(), paper, texture.clone())));
    texture
}
