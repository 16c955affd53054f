//! The three pictures in the middle of the window: where they lie, who looks at them, and what the pointer does in them.
//!
//! Nothing is stored that can be computed: each frame says anew what each visible picture is made from, and only a picture
//! for which that has changed is drawn again.

mod act;
mod arrange;
mod easel;
mod icons;
mod look;
mod paint;
mod probe;
mod screen;
mod seek;
mod status;
mod strip;
mod title;

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Context, CursorIcon, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui, WidgetInfo, pos2,
};

use self::act::Drag;
use self::arrange::{Axis, Shares, arrange};
use self::easel::Job;
use self::look::Auto;
use self::paint::Painter;
use self::screen::{Place, Screen};
use self::seek::{Question, Seeker, What};
use self::status::{Status, StatusAction};
use self::strip::{Strip, StripAction};
use self::title::{Title, TitleAction};
use super::handles::point;
use super::highlight::{Highlight, Movable};
use super::state::{Look, State};
use crate::appearance::Rgba;
use crate::figure::{Depth, Figure, Observer};
use crate::i18n::canvas::{self as words, CanvasTexts};
use crate::i18n::pictures::labels;
use crate::picture::Account;
use crate::views::{self, Extras, Palette, Probe, Setup, View};

/// How long a frame waits for its pictures. What takes longer is shown when it is done.
const PATIENCE: Duration = Duration::from_millis(30);

/// Draws the pictures and keeps what belongs to them from one frame to the next.
pub struct Canvas {
    /// How long a frame waits for its pictures; tests have more of it than a hand that drags.
    pub patience: Duration,
    painter: Option<Painter>,
    screens: [Screen; 3],
    /// How the pictures on the screen came about.
    accounts: [Option<Account>; 3],
    shares: Shares,
    /// What the two three-dimensional pictures are seen from where the figure does not say, and in this frame.
    autos: [Auto; 2],
    seen: [Observer; 2],
    /// What a title's button asked for.
    asked: Option<(View, Look)>,
    extras: Extras,
    highlight: Highlight,
    /// What looks for what is pointed at, and for its depth.
    seeker: Seeker,
    depth_seeker: Seeker,
    drag: Option<Drag>,
    pinned: Option<Probe>,
    /// For a double-click, whose first click was not meant to pin.
    pinned_before: Option<Probe>,
}

impl Default for Canvas {
    fn default() -> Self {
        let nobody =
            Observer { target: glam::DVec3::ZERO, distance: 1.0, azimuth: 0.0, elevation: 0.0, parallel: false };
        Self {
            patience: PATIENCE,
            painter: None,
            screens: Default::default(),
            accounts: Default::default(),
            shares: Shares::default(),
            autos: Default::default(),
            seen: [nobody; 2],
            asked: None,
            extras: Extras::default(),
            highlight: Highlight::default(),
            seeker: Seeker::default(),
            depth_seeker: Seeker::default(),
            drag: None,
            pinned: None,
            pinned_before: None,
        }
    }
}

/// A picture in this frame.
struct Pane {
    picture: View,
    place: Place,
    response: Response,
}

/// What the views need to know, for a picture of this size.
fn setup<'a>(state: &'a State, extras: &'a Extras, size: views::Size) -> Setup<'a> {
    Setup {
        figure: state.document.figure(),
        camera: state.document.camera(),
        scene: state.scenery.scene(),
        labels: labels(state.settings.lang),
        size,
        extras,
    }
}

/// What is asked about the scene as it is now.
fn question(state: &State, extras: &Extras, what: What) -> Question {
    let figure = state.document.figure();
    Question {
        what,
        figure: Figure {
            image: figure.image,
            viewport: figure.viewport,
            style: figure.style,
            reveal: figure.reveal,
            ..Figure::default()
        },
        camera: state.document.camera().clone(),
        scene: Arc::clone(state.scenery.scene()),
        extras: Extras { bounds: extras.bounds, ..Extras::default() },
    }
}

impl Canvas {
    /// How often each picture has been drawn since the window was opened, in the order of [`View::ALL`].
    #[must_use]
    pub fn drawn(&self) -> [u64; 3] {
        self.painter.as_ref().map_or([0; 3], Painter::drawn)
    }

    /// Fills the room that is left in `ui` with the pictures, and lets the pointer and the keys act on them.
    pub fn ui(&mut self, ui: &mut Ui, state: &mut State) {
        let room = ui.available_rect_before_wrap();
        ui.take_available_space();
        ui.painter().rect_filled(room, 0.0, ui.visuals().panel_fill);
        let texts = words::canvas(state.settings.lang);
        let lines = status::height(ui, room.width());
        let (room, lines) = room.split_top_bottom_at_y((room.bottom() - lines).max(room.top()));
        let stages = if state.layout.strip { strip::height(ui, room.width()) } else { 0.0 };
        let (pictures, stages) = room.split_top_bottom_at_y((room.bottom() - stages).max(room.top()));

        let ctx = ui.ctx().clone();
        if state.tree.settle() {
            ctx.request_repaint();
        }
        if let Err(error) = state.scenery.update(&ctx, &state.document, self.patience) {
            state.say_error(crate::i18n::messages::scene(state.settings.lang, &error));
        }
        self.extras.ghost = state.ghost.clone();
        self.extras.bounds = state.scenery.bounds();
        self.extras.arrows = Movable::selected(state).and_then(|movable| movable.arrows(None));
        let panes = self.panes(ui, pictures, state, texts);
        for pane in &panes {
            state.picture_sizes[pane.picture.index()] = [pane.place.size.width, pane.place.size.height];
            state.screen_scale = pane.place.size.scale;
        }
        self.settle_observers(ui, state, &panes);
        let mut status = self.act(ui, state, &panes, texts);
        state.probe = self.extras.probe;
        self.draw(ui, state, &panes);
        self.decorate(ui, state, &panes, texts);

        if state.layout.strip {
            self.strip(ui, stages, state, texts);
        }

        self.describe_probe(&ctx, state, &mut status, texts);
        status.strip = state.layout.strip;
        let loading = loading(state);
        if !loading.is_empty() {
            status.message = loading;
        }
        status.hidden = if state.layout.maximized.is_none() {
            View::ALL.into_iter().filter(|p| !state.layout.shown[p.index()]).collect()
        } else {
            Vec::new()
        };
        status.arrangement = (panes.len() > 1).then_some(state.layout.arrangement);
        match status.show(ui, lines, texts) {
            None => {}
            Some(StatusAction::ShowAgain(picture)) => state.layout.shown[picture.index()] = true,
            Some(StatusAction::Arrange(arrangement)) => state.layout.arrangement = arrangement,
            Some(StatusAction::Strip) => state.layout.strip = !state.layout.strip,
        }
    }

    /// The stages of the pipeline, as they were for the picture that is on the screen.
    fn strip(&self, ui: &mut Ui, room: Rect, state: &mut State, texts: &CanvasTexts) {
        let picture = state.layout.strip_of;
        let hidden = !state.layout.is_shown(picture);
        let account = self.accounts[picture.index()].as_ref().filter(|_| !hidden);
        let strip = Strip { lang: state.settings.lang, texts, picture, account, hidden };
        match strip.show(ui, room) {
            None => return,
            Some(StripAction::Of(picture)) => state.layout.strip_of = picture,
            Some(StripAction::Close) => state.layout.strip = false,
        }
        ui.request_repaint();
    }

    /// Lays the pictures out, with their titles and the bars between them.
    fn panes(&mut self, ui: &mut Ui, room: Rect, state: &mut State, texts: &CanvasTexts) -> Vec<Pane> {
        let visible: Vec<View> = match state.layout.maximized {
            Some(picture) => vec![picture],
            None => View::ALL.into_iter().filter(|p| state.layout.shown[p.index()]).collect(),
        };
        let (rects, bars) = arrange(room, &visible, state.layout.arrangement, &self.shares);
        for (i, bar) in bars.iter().enumerate() {
            let response = ui.interact(bar.rect, Id::unique(("between pictures", i)), Sense::CLICK | Sense::DRAG);
            let cursor = if bar.axis == Axis::X { CursorIcon::ResizeHorizontal } else { CursorIcon::ResizeVertical };
            let response = response.on_hover_and_drag_cursor(cursor);
            if response.double_clicked() {
                self.shares.reset(bar);
            } else if response.dragged()
                && let Some(pointer) = response.interact_pointer_pos()
            {
                self.shares.drag(bar, pointer);
            }
        }
        let mut panes = Vec::new();
        for (picture, rect) in rects {
            let height = ui.spacing().interact_size.y + 4.0;
            let (title, below) = rect.split_top_bottom_at_y((rect.top() + height).min(rect.bottom()));
            let action = Title {
                picture,
                texts,
                linked: state.layout.linked,
                maximized: state.layout.maximized == Some(picture),
                can_hide: state.layout.maximized.is_none() && visible.len() > 1,
            }
            .show(ui, title);
            self.take_action(ui, state, picture, action);
            let place = Place::in_room(below, ui.pixels_per_point(), state.settings.stroke_scale());
            let response = ui.interact(place.rect, Id::unique(("picture", picture)), Sense::click_and_drag());
            let description = describe(state, picture);
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &description));
            panes.push(Pane { picture, place, response });
        }
        panes
    }

    fn take_action(&mut self, ui: &Ui, state: &mut State, picture: View, action: Option<TitleAction>) {
        match action {
            None => return,
            Some(TitleAction::Look(look)) => self.asked = Some((picture, look)),
            Some(TitleAction::ToggleLink) => state.layout.linked = !state.layout.linked,
            Some(TitleAction::ToggleMaximized) => toggle_maximized(state, picture),
            Some(TitleAction::Hide) => state.layout.shown[picture.index()] = false,
        }
        ui.request_repaint();
    }

    /// Decides from where the three-dimensional pictures are seen in this frame.
    fn settle_observers(&mut self, ui: &Ui, state: &mut State, panes: &[Pane]) {
        let wanted = state.look.take();
        let asked = self.asked.take();
        let steady = ui.input(|i| i.pointer.any_down());
        for pane in panes.iter().filter(|pane| pane.picture != View::Image) {
            let (picture, i) = (pane.picture, pane.picture.index());
            let look = wanted.or(asked.filter(|(p, _)| *p == picture || state.layout.linked).map(|(_, look)| look));
            if let Some(look) = look {
                self.autos[i].forget();
                let setup = setup(state, &self.extras, pane.place.size);
                let observer = look::looked(picture, &setup, look, &self.seen[i]);
                *look::slot(state.document.observers_mut(), picture) = observer;
            }
            self.seen[i] = match look::told(&state.document.figure().observers, picture) {
                Some(observer) => observer,
                None => {
                    let setup = setup(state, &self.extras, pane.place.size);
                    let scene = (state.scenery.scene(), state.scenery.subject());
                    self.autos[i].observer(picture, &setup, scene, steady)
                }
            };
        }
    }

    /// Looks at a picture from somewhere else.
    fn turn(&mut self, state: &mut State, picture: View, observer: Observer) {
        self.seen[picture.index()] = observer;
        *look::slot(state.document.observers_mut(), picture) = Some(observer);
    }

    /// Asks for the pictures that have changed, takes those that are done, and shows the newest of each.
    fn draw(&mut self, ui: &Ui, state: &State, panes: &[Pane]) {
        let ctx = ui.ctx();
        let painter = self.painter.get_or_insert_with(|| Painter::new(ctx));
        let (max_side, moving) = ui.input(|i| (i.max_texture_side, i.pointer.any_down()));
        let figure = state.document.figure();
        let scene = self.highlight.scene(state);
        for pane in panes {
            if pane.place.size.width == 0 || pane.place.size.height == 0 {
                continue;
            }
            let only_world = pane.picture == View::World;
            painter.ask(Job {
                picture: pane.picture,
                figure: Figure {
                    image: figure.image,
                    viewport: figure.viewport,
                    style: figure.style,
                    reveal: figure.reveal,
                    ..Figure::default()
                },
                camera: state.document.camera().clone(),
                scene: Arc::clone(&scene),
                labels: labels(state.settings.lang),
                size: pane.place.size,
                draft: moving && figure.style.antialias > 1 && painter.is_heavy(pane.picture, self.patience),
                observer: (pane.picture != View::Image).then(|| self.seen[pane.picture.index()]),
                extras: Extras {
                    probe: self.extras.probe,
                    ghost: self.extras.ghost.clone().filter(|_| only_world),
                    hot: self.extras.hot.filter(|_| only_world),
                    arrows: self.extras.arrows.filter(|_| only_world),
                    bounds: self.extras.bounds.filter(|_| only_world),
                    ..Extras::default()
                },
                max_side,
                accounted: state.layout.strip && state.layout.strip_of == pane.picture,
            });
        }
        for (i, sheet) in painter.collect(self.patience).into_iter().enumerate() {
            if let Some(mut sheet) = sheet {
                self.accounts[i] = sheet.as_mut().and_then(|sheet| sheet.account.take());
                self.screens[i].set(ctx, words::canvas(state.settings.lang).view(View::ALL[i]), sheet);
            }
        }
        let palette = Palette::of(figure.style.theme);
        for pane in panes {
            let ground = if pane.picture == View::Image { palette.surround } else { palette.paper };
            let Rgba { r, g, b, .. } = ground;
            ui.painter().rect_filled(pane.place.rect, 0.0, eframe::egui::Color32::from_rgb(r, g, b));
            self.screens[pane.picture.index()].paint(ui, &pane.place);
        }
    }

    /// What lies over the pictures: borders, the ring of the keyboard's focus, the cross of lines under the pointer.
    fn decorate(&self, ui: &Ui, state: &State, panes: &[Pane], texts: &CanvasTexts) {
        for pane in panes {
            let rect = pane.place.rect;
            let border = ui.visuals().widgets.noninteractive.bg_stroke;
            ui.painter().rect_stroke(rect, 0.0, border, StrokeKind::Inside);
            if pane.response.has_focus() {
                let ring = Stroke::new(2.0, ui.visuals().hyperlink_color);
                ui.painter().rect_stroke(rect, 0.0, ring, StrokeKind::Inside);
            }
            if self.screens[pane.picture.index()].failed() {
                let font = TextStyle::Body.resolve(ui.style());
                let color = ui.visuals().error_fg_color;
                ui.painter().text(rect.center(), Align2::CENTER_CENTER, texts.not_drawn, font, color);
            }
            note(ui, rect, &loading(state));
            if pane.picture == View::Image && pane.response.hovered() && self.drag.is_none() {
                cross(ui, state, pane);
            }
        }
    }

    fn describe_probe(&mut self, ctx: &Context, state: &State, status: &mut Status, texts: &'static CanvasTexts) {
        let Some(probe) = self.extras.probe else {
            status.note = texts.probe_hint;
            return;
        };
        let setup = setup(state, &self.extras, views::Size { width: 1, height: 1, scale: 1.0 });
        let digits = state.settings.digits;
        let asks = matches!(probe, Probe::Window(_)) && setup.figure.reveal.depth != Depth::Off;
        let depths = asks
            .then(|| self.depth_seeker.ask(ctx, question(state, &self.extras, What::Depths(probe))).depths)
            .flatten();
        status.cells = probe::cells(probe, depths, &setup, digits.min(4), texts);
        status.exact = probe::cells(probe, depths, &setup, digits, texts);
        if self.pinned.is_some() {
            status.aside = if status.aside.is_empty() {
                texts.pinned.to_owned()
            } else {
                format!("{} · {}", texts.pinned, status.aside)
            };
        }
    }
}

/// Which mesh files are being read, in a sentence; empty where none is.
fn loading(state: &State) -> String {
    let files = state.scenery.loading();
    if files.is_empty() {
        return String::new();
    }
    format!("{} {}…", crate::i18n::scenes::texts(state.settings.lang).loading, files.join(", "))
}

/// A sentence over a picture.
fn note(ui: &Ui, picture: Rect, text: &str) {
    if text.is_empty() {
        return;
    }
    let font = TextStyle::Body.resolve(ui.style());
    let color = ui.visuals().text_color();
    let galley = ui.painter().layout(text.to_owned(), font, color, (picture.width() - 24.0).max(40.0));
    let place = Align2::CENTER_CENTER.anchor_size(picture.center(), galley.size());
    ui.painter().rect_filled(place.expand2(eframe::egui::vec2(8.0, 4.0)), 3.0, ui.visuals().panel_fill);
    ui.painter().galley(place.min, galley, color);
}

/// Gives a picture all the room, or gives it back.
fn toggle_maximized(state: &mut State, picture: View) {
    state.layout.maximized = if state.layout.maximized == Some(picture) { None } else { Some(picture) };
}

/// A picture in words.
fn describe(state: &State, picture: View) -> String {
    let lang = state.settings.lang;
    match picture {
        View::World => {
            let camera = state.document.camera();
            words::describe_world(lang, &point(camera.position(), 4), &point(camera.focal_point(), 4))
        }
        View::Canonical => words::describe_canonical(lang),
        View::Image => {
            let image = state.document.figure().image;
            words::describe_image(lang, image.width, image.height)
        }
    }
}

/// Two lines that cross at the pointer, within the frame of the image.
#[expect(clippy::cast_precision_loss, reason = "sides of a screen are far below 2²⁴")]
fn cross(ui: &Ui, state: &State, pane: &Pane) {
    let Some(pointer) = pane.response.hover_pos() else { return };
    let f = views::image::frame(pane.place.size, state.document.camera().window());
    let frame = pane.place.rect_of(f.x as f32, f.y as f32, f.width as f32, f.height as f32);
    if !frame.contains(pointer) {
        return;
    }
    let stroke = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.5));
    let gap = 8.0;
    let painter = ui.painter().with_clip_rect(frame);
    for (a, b) in [
        (pos2(frame.left(), pointer.y), pos2(pointer.x - gap, pointer.y)),
        (pos2(pointer.x + gap, pointer.y), pos2(frame.right(), pointer.y)),
        (pos2(pointer.x, frame.top()), pos2(pointer.x, pointer.y - gap)),
        (pos2(pointer.x, pointer.y + gap), pos2(pointer.x, frame.bottom())),
    ] {
        painter.line_segment([a, b], stroke);
    }
    ui.set_cursor_icon(CursorIcon::Crosshair);
}
