//! One triangle step by step: its corners in each space, the cuts, the pixels that it covers and their depths.

use std::sync::Arc;

use eframe::egui::{self, DragValue, RichText, Ui};
use glam::DVec3;

use crate::gui::noted::{noted, noted_row};
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::notes;
use crate::i18n::pictures::labels;
use crate::i18n::triangle::{self as words, Texts};
use crate::numbers::DecimalMark;
use crate::picture::TrianglePixels;
use crate::pipeline::Stage;
use crate::pipeline::one_triangle::TriangleSteps;
use crate::views::{Labels, Request, Size, Stepped, TriangleStep, View};

/// What a step is written with.
struct Page<'a> {
    t: &'a Texts,
    labels: &'a Labels,
    mark: DecimalMark,
    digits: usize,
}

/// Shows the chooser, and the steps of what is chosen.
pub(super) fn ui(ui: &mut Ui, state: &mut State) {
    let t = words::texts(state.settings.lang);
    ui.label(RichText::new(t.heading).strong());
    ui.label(RichText::new(t.hint).weak());
    let size = Size { width: 1, height: 1, scale: 1.0 };
    let scene = state.scene_cache.scene().clone();
    let labels = labels(state.settings.lang);
    let document = &state.document;
    let request = Request::of(document.figure(), View::Image, document.camera(), &scene, labels, size);
    chooser(ui, t, state, &request);
    let Some((steps, pixels)) = state.explain.triangle.found(&request) else { return };
    choose_step(ui, t, state);
    let page = Page { t, labels, mark: state.settings.lang.mark(), digits: state.settings.digits };
    let step = state.explain.triangle.step;
    let top = ui.cursor().min;
    match step {
        TriangleStep::View => page.spaces(ui, &steps),
        TriangleStep::Facing => page.facing(ui, &steps),
        TriangleStep::Outcodes => page.outcodes(ui, &steps),
        TriangleStep::Cuts => page.cuts(ui, &steps),
        TriangleStep::Divide => page.divide(ui, &steps),
        TriangleStep::Viewport => page.viewport(ui, &steps),
        TriangleStep::Pixels => page.pixels(ui, pixels.as_deref()),
        TriangleStep::Depth => page.depth(ui, pixels.as_deref(), state),
    }
    let row = egui::Rect::from_min_max(top, egui::pos2(ui.max_rect().right(), ui.cursor().min.y));
    noted_row(ui, row, notes::of_stage(stage_of(step)));
    let triangle = &mut state.explain.triangle;
    triangle.shown = Some(Arc::new(Stepped {
        step,
        corners: steps.corners.map(|corner| corner.world),
        outside: steps.corners.map(|corner| corner.outside.contains(&true)),
        left: steps.left.iter().map(|corner| (corner.name, corner.world)).collect(),
        rows: pixels.as_ref().map(|pixels| pixels.rows.clone()).unwrap_or_default(),
        pixel: pixels.as_ref().and_then(|pixels| tested_pixel(pixels, triangle.pixel)),
    }));
}

/// The stage that does a step.
fn stage_of(step: TriangleStep) -> Stage {
    match step {
        TriangleStep::View => Stage::Transform,
        TriangleStep::Facing => Stage::CullFaces,
        TriangleStep::Outcodes | TriangleStep::Cuts => Stage::Clip,
        TriangleStep::Divide => Stage::Divide,
        TriangleStep::Viewport => Stage::Viewport,
        TriangleStep::Pixels => Stage::Fill,
        TriangleStep::Depth => Stage::HiddenSurfaces,
    }
}

/// The pixel that was asked for; without one, one in the middle of the triangle.
fn tested_pixel(pixels: &TrianglePixels, asked: Option<[u32; 2]>) -> Option<[u32; 2]> {
    let [y, first, after] = *pixels.rows.get(pixels.rows.len() / 2)?;
    Some(asked.unwrap_or([u32::midpoint(first, after.saturating_sub(1)), y]))
}

fn chooser(ui: &mut Ui, t: &Texts, state: &mut State, request: &Request) {
    let objects: Vec<(&str, usize)> = request
        .scene
        .objects
        .iter()
        .filter(|object| object.faces && !object.mesh.triangles.is_empty())
        .map(|object| (object.name.as_str(), object.mesh.triangles.len()))
        .collect();
    let triangle = &mut state.explain.triangle;
    let mut chosen = triangle.chosen.clone();
    ui.horizontal_wrapped(|ui| {
        let name = chosen.as_ref().map_or("–", |(name, _)| name).to_owned();
        let response = egui::ComboBox::from_id_salt("object of the triangle")
            .selected_text(crate::foreign::shown(&name))
            .show_ui(ui, |ui| {
                for (object, _) in &objects {
                    if ui.selectable_label(name == *object, crate::foreign::shown(object)).clicked() {
                        chosen = Some(((*object).to_owned(), 0));
                    }
                }
            })
            .response;
        response.explained(t.object).accessible_name(t.object);
        if let Some((name, index)) = &mut chosen {
            let count = objects.iter().find(|(object, _)| object == name).map_or(0, |(_, count)| *count);
            let last = u32::try_from(count.saturating_sub(1)).unwrap_or(u32::MAX);
            ui.add(DragValue::new(index).range(0..=last).speed(1.0)).explained(t.number).accessible_name(t.number);
            ui.label(format!("0 … {last}"));
            if ui.button("✕").explained(t.release).accessible_name(t.release).clicked() {
                chosen = None;
            }
        }
    });
    if chosen != triangle.chosen {
        (triangle.chosen, triangle.pixel) = (chosen, None);
        ui.ctx().request_repaint();
    }
}

fn choose_step(ui: &mut Ui, t: &Texts, state: &mut State) {
    let triangle = &mut state.explain.triangle;
    let at = triangle.step as usize;
    let mut to = at;
    ui.horizontal_wrapped(|ui| {
        for (sign, name, next) in [("◀", t.previous, at.saturating_sub(1)), ("▶", t.next, at + 1)] {
            if ui.button(sign).explained(name).accessible_name(name).clicked() {
                to = next.min(TriangleStep::ALL.len() - 1);
            }
        }
        for (i, step) in TriangleStep::ALL.into_iter().enumerate() {
            let button = egui::Button::selectable(i == to, words::step(t, step)).frame_when_inactive(true);
            let response = ui.add(button);
            noted(&response, notes::of_stage(stage_of(step)));
            if response.clicked() {
                to = i;
            }
        }
    });
    if to != at {
        triangle.step = TriangleStep::ALL[to];
        ui.ctx().request_repaint();
    }
}

impl Page<'_> {
    fn tuple(&self, values: &[f64]) -> String {
        self.mark.tuple(values, self.digits)
    }

    fn number(&self, value: f64) -> String {
        self.mark.number(value, self.digits)
    }

    fn point(&self, p: DVec3) -> String {
        self.tuple(&p.to_array())
    }

    fn line(&self, ui: &mut Ui, text: &str) {
        ui.add(egui::Label::new(RichText::new(text).monospace()).wrap());
    }

    fn spaces(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for (name, corner) in ('a'..).zip(&steps.corners) {
            ui.label(RichText::new(name).strong());
            for (space, p) in [(self.t.local, corner.local), (self.t.world, corner.world), (self.t.view, corner.view)] {
                self.line(ui, &format!("{space:<6} {}", self.point(p)));
            }
        }
    }

    fn facing(&self, ui: &mut Ui, steps: &TriangleSteps) {
        self.line(ui, &format!("N · (C − a) = {}", self.number(steps.facing)));
        ui.label(if steps.facing > 0.0 { self.t.is_front } else { self.t.is_back });
    }

    /// The six distances of each corner; those that are negative are the bits of its outcode.
    fn outcodes(&self, ui: &mut Ui, steps: &TriangleSteps) {
        const NAMES: [&str; 6] = ["w + x", "w − x", "w + y", "w − y", "d − F", "B − d"];
        for (name, corner) in ('a'..).zip(&steps.corners) {
            ui.label(RichText::new(name).strong());
            self.line(ui, &format!("(x_c, y_c, w) = {}", self.tuple(&[corner.clip.x, corner.clip.y, corner.w])));
            for (plane, value) in corner.distances.into_iter().enumerate() {
                let is_outside = corner.outside[plane];
                let sign = if is_outside { "< 0 → 1" } else { "" };
                let text = format!("{} = {} {sign} {}", NAMES[plane], self.number(value), self.labels.planes[plane]);
                let text = RichText::new(text).monospace();
                ui.label(if is_outside { text.color(ui.visuals().error_fg_color) } else { text });
            }
            let out: Vec<&str> = (0..6).filter(|&i| corner.outside[i]).map(|i| self.labels.planes[i]).collect();
            let code: String = corner.outside.iter().map(|out| if *out { '1' } else { '0' }).collect();
            ui.label(match out.as_slice() {
                [] => self.t.inside.to_owned(),
                out => format!("{} {} · {code}", self.t.outside, out.join(", ")),
            });
        }
        if steps.is_outside {
            ui.label(self.t.all_outside);
        }
    }

    fn cuts(&self, ui: &mut Ui, steps: &TriangleSteps) {
        if steps.is_outside {
            ui.label(self.t.all_outside);
        } else if steps.cuts.is_empty() {
            ui.label(self.t.no_cut);
        }
        for cut in &steps.cuts {
            ui.label(RichText::new(self.labels.planes[cut.plane]).strong());
            for made in &cut.made {
                let [d1, d2] = made.distances;
                let (name, inside, outside) = (made.name, made.inside, made.outside);
                self.line(ui, &format!("{name} = {inside} + t ({outside} − {inside})"));
                let numbers = [d1, -d2, made.t].map(|v| self.number(v));
                let [d1, d2, t] = numbers;
                self.line(ui, &format!("  t = d₁/(d₁ + d₂) = {d1}/({d1} + {d2}) = {t}"));
            }
            let left = if cut.left.len() < 3 { self.t.nothing_left } else { &cut.left };
            ui.label(format!("{} {left}", self.t.left));
        }
    }

    fn divide(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for corner in &steps.left {
            let ndc = self.tuple(&[corner.ndc.x, corner.ndc.y]);
            let clip = self.tuple(&[corner.clip.x, corner.clip.y]);
            self.line(ui, &format!("{}: {clip} ÷ {} = {ndc}", corner.name, self.number(corner.w)));
        }
        self.nothing(ui, steps);
    }

    fn viewport(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for corner in &steps.left {
            let ndc = self.tuple(&[corner.ndc.x, corner.ndc.y]);
            let pixels = self.tuple(&corner.image.map(f64::from));
            self.line(ui, &format!("{}: {ndc} → {pixels} px", corner.name));
        }
        self.nothing(ui, steps);
    }

    fn nothing(&self, ui: &mut Ui, steps: &TriangleSteps) {
        if steps.left.is_empty() {
            ui.label(self.t.nothing_left);
        }
    }

    /// False where nothing is covered, which is said.
    fn covers(&self, ui: &mut Ui, pixels: Option<&TrianglePixels>) -> bool {
        match pixels {
            None => ui.label(self.t.too_large),
            Some(pixels) if pixels.rows.is_empty() => ui.label(self.t.covers_none),
            Some(_) => return true,
        };
        false
    }

    fn pixels(&self, ui: &mut Ui, pixels: Option<&TrianglePixels>) {
        if let Some(pixels) = pixels.filter(|pixels| self.covers(ui, Some(pixels))) {
            let rows = pixels.rows.len();
            ui.label(format!("{} {} · {rows} {}", pixels.count(), self.t.covers, self.t.rows));
        } else if pixels.is_none() {
            self.covers(ui, None);
        }
    }

    fn depth(&self, ui: &mut Ui, pixels: Option<&TrianglePixels>, state: &mut State) {
        if !self.covers(ui, pixels) {
            return;
        }
        let Some((pixels, pixel)) = pixels.and_then(|p| Some((p, tested_pixel(p, state.explain.triangle.pixel)?)))
        else {
            return;
        };
        let image = state.document.figure().image;
        let mut now = pixel;
        ui.label(self.t.pixel);
        ui.horizontal(|ui| {
            for ((name, size), value) in [("i", image.width), ("j", image.height)].into_iter().zip(&mut now) {
                ui.label(name);
                let field = DragValue::new(value).range(0..=size.saturating_sub(1)).speed(1.0);
                ui.add(field).explained(self.t.pixel_hint).accessible_name(name);
            }
        });
        if now != pixel {
            state.explain.triangle.pixel = Some(now);
            ui.ctx().request_repaint();
        }
        let Some(tested) = pixels.test(now) else {
            ui.label(self.t.not_covered);
            return;
        };
        self.line(ui, &format!("{}: {}", self.t.z_own, self.number(tested.z)));
        match tested.before {
            Some(before) => self.line(ui, &format!("{}: {}", self.t.z_before, self.number(before))),
            None => self.line(ui, self.t.z_nothing),
        }
        ui.label(RichText::new(if tested.kept { self.t.kept } else { self.t.rejected }).strong());
        ui.label(RichText::new(self.t.before_hint).weak());
    }
}

/// What a click in the image does while the tab is shown: at the depth test a pixel of the triangle is chosen, else a triangle. False where
/// there is neither.
pub(in crate::gui) fn clicked(state: &mut State, request: &Request, pointer: glam::DVec2) -> bool {
    use crate::views::pick::{image_pixel, triangle_in_image};
    let triangle = &mut state.explain.triangle;
    let pixel = image_pixel(request, pointer);
    let is_covered = |[x, y]: [u32; 2]| {
        let rows = triangle.shown.as_ref().map(|shown| shown.rows.as_slice()).unwrap_or_default();
        rows.iter().any(|[row, first, after]| *row == y && (*first..*after).contains(&x))
    };
    if triangle.step == TriangleStep::Depth
        && let Some(pixel) = pixel.filter(|pixel| is_covered(*pixel))
    {
        triangle.pixel = Some(pixel);
    } else if let Some((object, index)) = triangle_in_image(request, pointer) {
        triangle.choose(&request.scene.objects[object].name, index);
    } else {
        return false;
    }
    true
}
