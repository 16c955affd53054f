//! The three pictures in the middle of the window: their layout, their observers, and the interaction with them.
//!
//! Nothing is stored that can be computed: each frame describes anew the request of each visible picture, and only a
//! picture whose request has changed is drawn again.
//!
//! | file | purpose |
//! | --- | --- |
//! | `arrange` | the layout of the pictures in their space: the one that uses most of it, or the user's |
//! | `card` | the card with the coordinates of the pinned probe: its place, and its buttons |
//! | `followed` | dragging a point that is followed, in the world and in the image |
//! | `held` | drags of the pointer: the observer of a picture, a handle of the camera, the gizmo of the selection |
//! | `icons` | small buttons with drawn icons |
//! | `interaction` | keys, and the pointer without a drag; drags are in `held` |
//! | `keyboard_probe` | probing without a pointer: the arrow keys move the probe from pixel to pixel |
//! | `long_work` | work that takes longer than half a second: reported under the pictures, and cancelled with Esc |
//! | `observers` | the observers of the pictures in a frame |
//! | `orbit` | the observers of the two three-dimensional pictures, and their changes by pointer and keys |
//! | `picking` | the target of the pointer, found beside the window's thread in heavy scenes |
//! | `readout` | the coordinates of the target of the pointer, in every space |
//! | `rendering` | has pictures drawn beside the window's thread, each only when something that made it has changed |
//! | `status` | the lines under the pictures: hints and position of the pointer, and the coordinates of the probe |
//! | `strip` | the strip under the pictures: every stage with counts, time and reason |
//! | `texture` | a picture on the screen: its textures, and where each of its pixels is |
//! | `title` | the title of a picture, with its buttons |
//! | `touch` | two fingers on a picture: pan and zoom |
//! | `vertex_name` | the vertex at a point: its number and its object |

mod arrange;
mod card;
mod followed;
mod held;
mod icons;
mod interaction;
mod keyboard_probe;
mod long_work;
mod observers;
mod orbit;
mod picking;
mod readout;
mod rendering;
mod status;
mod strip;
mod texture;
mod title;
mod touch;
mod vertex_name;

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, CursorIcon, Id, Pos2, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui, WidgetInfo, pos2,
};

use self::arrange::{Axis, Framed, Shares, arrange};
use self::card::CardAction;
use self::held::Drag;
use self::keyboard_probe::Probing;
use self::long_work::LongWork;
use self::orbit::Auto;
use self::picking::{PickQuery, PickRequest, Picker};
use self::readout::Cell;
use self::rendering::{Missing, RenderJob, Rendering};
use self::status::{Status, StatusAction};
use self::strip::{Strip, StripAction};
use self::texture::{PictureRect, PictureTexture};
use self::title::{Title, TitleAction};
use self::vertex_name::VertexNames;
use crate::appearance::Rgba;
use crate::figure::{Depth, Observer, Observers};
use crate::gui::coach::{self, Brief};
use crate::gui::explain;
use crate::gui::focus::{self, Region};
use crate::gui::handle_drag::point;
use crate::gui::highlight::Highlight;
use crate::gui::presentation;
use crate::gui::selection_gizmo::Movable;
use crate::gui::state::{Dialog, ExplainTab, Message, ObserverChange, State};
use crate::i18n::canvas::{self as words, CanvasTexts};
use crate::i18n::pictures::labels;
use crate::numbers::{DecimalMark, EXACT_DIGITS};
use crate::picture::RenderReport;
use crate::pipeline::OverBudget;
use crate::views::image_frame;
use crate::views::{Hover, Look, Palette, Probe, Request, Shot, Size, View, aspect_shown};

/// How long a frame waits for its pictures. What takes longer is shown when it is done.
const PATIENCE: Duration = Duration::from_millis(30);
/// Interval between reports of long work.
const TELL: Duration = Duration::from_millis(100);

/// Draws the pictures and stores their state from one frame to the next.
pub struct Canvas {
    /// Time that a frame waits for its pictures; tests have more of it than a hand that drags.
    pub patience: Duration,
    rendering: Rendering,
    textures: [PictureTexture; 3],
    /// How the pictures on the screen came about.
    accounts: [Option<RenderReport>; 3],
    /// Why there is none, and what could not be done in it, by picture.
    missing: [Option<Missing>; 3],
    too_much: [Option<OverBudget>; 3],
    shares: Shares,
    /// From where each picture is seen where the figure does not say, and in this frame.
    autos: [Auto; 3],
    seen: Observers,
    /// What a button or a key has framed last, and for a picture of which size.
    framed: [Option<(Observer, Size)>; 3],
    /// What a title's button asked for.
    asked: Option<(View, ObserverChange)>,
    /// What the pictures of this frame show, and what the pointer adds to it.
    shot: Shot,
    hover: Hover,
    highlight: Highlight,
    /// What looks for what is pointed at, and for its depth.
    picker: Picker,
    depth_picker: Picker,
    drag: Option<Drag>,
    /// What the card speaks of.
    on_card: Option<Probe>,
    /// Number of frames until the card has settled in its place.
    card_settles: u8,
    vertex_names: VertexNames,
    /// For a double-click, whose first click was not meant to pin.
    pinned_before: Option<Probe>,
    /// What the arrow keys move the probe over, and in which picture.
    probing: Option<(View, Probing)>,
    /// Where each picture is on the screen, in points.
    places: [Option<Rect>; 3],
}

impl Default for Canvas {
    fn default() -> Self {
        Self {
            patience: PATIENCE,
            rendering: Rendering::default(),
            textures: Default::default(),
            accounts: Default::default(),
            missing: [None; 3],
            too_much: Default::default(),
            shares: Shares::default(),
            autos: Default::default(),
            seen: Observers::default(),
            framed: [None; 3],
            asked: None,
            shot: Shot::default(),
            hover: Hover::default(),
            highlight: Highlight::default(),
            picker: Picker::default(),
            depth_picker: Picker::default(),
            drag: None,
            on_card: None,
            card_settles: 0,
            vertex_names: VertexNames::default(),
            pinned_before: None,
            probing: None,
            places: [None; 3],
        }
    }
}

/// A picture in this frame.
struct Pane {
    view: View,
    rect: PictureRect,
    response: Response,
}

impl Canvas {
    /// How often each picture has been drawn since the window was opened, in the order of [`View::ALL`].
    #[must_use]
    pub fn drawn(&self) -> [u64; 3] {
        self.rendering.drawn()
    }

    /// Where each picture is on the screen, in points, in the order of [`View::ALL`].
    #[must_use]
    pub fn places(&self) -> [Option<Rect>; 3] {
        self.places
    }

    /// A picture as it is now, seen from where it is seen in this frame, with the overlays that it shows.
    fn request(&self, state: &State, view: View, size: Size) -> Request {
        let (camera, scene) = (state.document.drawn_camera(), state.scene_cache.scene());
        let request = Request::new(&self.shot, view, camera, scene, labels(state.settings.lang), size);
        Request { hover: self.hover.seen_in(view), ..request }
    }

    /// True where Esc would let go of something in a picture.
    #[must_use]
    pub fn holds_something(&self, state: &State) -> bool {
        self.drag.is_some()
            || state.pinned().is_some()
            || state.shown_stage().is_some()
            || state.shown().triangle.is_some()
    }

    /// Fills the room that is left in `ui` with the pictures, and lets the pointer and the keys act on them.
    pub fn ui(&mut self, ui: &mut Ui, state: &mut State) {
        let room = ui.available_rect_before_wrap();
        ui.take_available_space();
        ui.painter().rect_filled(room, 0.0, ui.visuals().panel_fill);
        let texts = words::texts(state.settings.lang);
        let lines = status::height(ui, room.width());
        let (room, lines) = room.split_top_bottom_at_y((room.bottom() - lines).max(room.top()));
        let stages = if state.layout.strip { strip::height(ui, room.width()) } else { 0.0 };
        let (pictures, stages) = room.split_top_bottom_at_y((room.bottom() - stages).max(room.top()));

        let ctx = ui.ctx().clone();
        if state.tree.settle() {
            ctx.request_repaint();
        }
        if let Err(error) = state.scene_cache.update(&ctx, &state.document, state.settings.theme, self.patience) {
            state.say(Message::Scene(error));
        }
        self.hover = Hover {
            ghost: state.hover.ghost.clone(),
            measured: state.hover.measured.clone(),
            object: explain::object_transform(state),
            gizmo: Movable::selected(state).map(|movable| movable.gizmo),
            ..Hover::default()
        };
        self.shot = state.shot(self.seen);
        let panes = self.panes(ui, pictures, state, texts);
        self.places = [None; 3];
        for pane in &panes {
            self.places[pane.view.index()] = Some(pane.rect.rect);
            state.picture_sizes[pane.view.index()] = [pane.rect.size.width, pane.rect.size.height];
            state.screen_scale = pane.rect.size.scale;
        }
        self.settle_observers(ui, state, &panes);
        let mut status = self.interact(ui, state, &panes, texts);
        state.probe = state.pinned().or(self.hover.probe);
        state.seen = self.seen;
        self.draw(ui, state, &panes);
        self.decorate(ui, state, &panes, texts);

        if state.layout.strip {
            self.strip(ui, stages, state, texts);
        }

        // Below the titles, whose buttons a card would cover.
        let room = panes.iter().map(|pane| pane.rect.rect).reduce(|a, b| a.union(b)).unwrap_or(pictures);
        let place = self.place_of_card(&ctx, state, &panes, room);
        self.describe_probe((ui, room), place, state, &mut status, texts);
        self.say_why_empty(ui, state, &panes);
        status.coach = Brief::of(state);
        status.strip = state.layout.strip;
        status.keys = presentation::keys(&ctx, state);
        let loading = loading(state);
        if !loading.is_empty() {
            status.message = loading;
        }
        status.work = LongWork::of(self, state);
        if self.rendering.running().is_some() || state.runs() {
            ctx.request_repaint_after(TELL);
        }
        status.hidden = if state.layout.maximized.is_none() {
            View::ALL.into_iter().filter(|p| !state.layout.shown[p.index()]).collect()
        } else {
            Vec::new()
        };
        status.arrangement = (panes.len() > 1).then_some(state.layout.arrangement);
        match status.show(ui, lines, texts) {
            None => {}
            Some(StatusAction::ShowAgain(view)) => state.layout.shown[view.index()] = true,
            Some(StatusAction::Arrange(arrangement)) => state.layout.arrangement = arrangement,
            Some(StatusAction::Strip) => state.layout.strip = !state.layout.strip,
            Some(StatusAction::Coach) => state.file_flow.dialog = Some(Dialog::Coach),
        }
    }

    /// Explains an empty image, in it.
    fn say_why_empty(&self, ui: &mut Ui, state: &mut State, panes: &[Pane]) {
        let image = panes.iter().find(|pane| pane.view == View::Image);
        if let Some(pane) = image.filter(|_| self.drag.is_none() && self.missing[View::Image.index()].is_none()) {
            coach::why_empty(ui, pane.rect.rect, state);
        }
    }

    /// The stages of the pipeline, as they were for the picture that is on the screen.
    fn strip(&self, ui: &mut Ui, room: Rect, state: &mut State, texts: &CanvasTexts) {
        let view = state.layout.strip_of;
        let hidden = !state.layout.is_shown(view);
        let account = self.accounts[view.index()].as_ref().filter(|_| !hidden);
        focus::region(ui, room, Region::Strip, texts.strip);
        let strip = Strip { lang: state.settings.lang, texts, view, account, hidden, shown: state.shown_stage() };
        match strip.show(ui, room) {
            None => return,
            Some(StripAction::Of(view)) => state.list_stages_of(view),
            Some(StripAction::Close) => state.layout.strip = false,
            Some(StripAction::Show(stage)) => state.toggle_stage(stage),
        }
        ui.request_repaint();
    }

    /// Lays the pictures out, with their titles and the bars between them.
    fn panes(&mut self, ui: &mut Ui, room: Rect, state: &mut State, texts: &CanvasTexts) -> Vec<Pane> {
        let visible: Vec<View> = match state.layout.maximized {
            Some(view) => vec![view],
            None => View::ALL.into_iter().filter(|p| state.layout.shown[p.index()]).collect(),
        };
        let framed: Vec<Framed> = visible
            .iter()
            .map(|view| Framed { view: *view, aspect: aspect_shown(*view, state.document.figure().image) })
            .collect();
        let (rects, bars) = arrange(room, &framed, state.layout.arrangement, &self.shares);
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
        for (view, rect) in rects {
            let height = ui.spacing().interact_size.y + 4.0;
            let (title, below) = rect.split_top_bottom_at_y((rect.top() + height).min(rect.bottom()));
            let action = Title {
                view,
                texts,
                linked: state.layout.linked,
                maximized: state.layout.maximized == Some(view),
                can_hide: state.layout.maximized.is_none() && visible.len() > 1,
                undistorted: undistorted(state).filter(|_| view == View::Image),
                section: (view == View::World).then_some(state.document.figure().world.section),
            }
            .show(ui, title);
            self.take_action(ui, state, view, action);
            let pane_rect = PictureRect::in_room(below, ui.pixels_per_point(), state.settings.stroke_scale());
            let response = ui.interact(pane_rect.rect, Id::unique(("picture", view)), Sense::click_and_drag());
            let description = describe(state, view);
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &description));
            focus::note(ui.ctx(), Region::Picture(view.index()), response.id, rect);
            panes.push(Pane { view, rect: pane_rect, response });
        }
        panes
    }

    fn take_action(&mut self, ui: &Ui, state: &mut State, view: View, action: Option<TitleAction>) {
        match action {
            None => return,
            Some(TitleAction::Observe(change)) => self.asked = Some((view, change)),
            Some(TitleAction::ToggleLink) => state.layout.linked = !state.layout.linked,
            Some(TitleAction::ToggleMaximized) => toggle_maximized(state, view),
            Some(TitleAction::Hide) => state.layout.shown[view.index()] = false,
            Some(TitleAction::ToggleSection) => state.document.edit(|figure| figure.world.section ^= true),
            Some(TitleAction::ToggleUndistorted) => {
                state.document.edit(|figure| figure.undistorted = !figure.undistorted);
            }
        }
        ui.request_repaint();
    }

    /// Asks for the pictures that have changed, takes those that are done, and shows the newest of each.
    fn draw(&mut self, ui: &Ui, state: &mut State, panes: &[Pane]) {
        let ctx = ui.ctx();
        let (max_side, moving) = ui.input(|i| (i.max_texture_side, i.pointer.any_down()));
        let style = state.style();
        let scene = self.highlight.scene(state);
        for pane in panes.iter().filter(|pane| pane.rect.size.width > 0 && pane.rect.size.height > 0) {
            let request = Request { scene: scene.clone(), ..self.request(state, pane.view, pane.rect.size) };
            let heavy = style.antialias > 1 && self.rendering.is_heavy(pane.view, self.patience);
            let accounted = state.accounts_for_stages() && state.layout.strip_of == pane.view;
            if !state.annotations.frozen {
                self.rendering.ask(ctx, RenderJob { request, draft: moving && heavy, max_side, accounted });
            }
        }
        for (view, done) in View::ALL.into_iter().zip(self.rendering.collect(self.patience)) {
            let Some(rendered) = done else { continue };
            let i = view.index();
            self.missing[i] = rendered.as_ref().err().copied();
            let (tiles, account, too_much) =
                rendered.map_or((None, None, None), |r| (Some(r.tiles), r.account, r.too_much));
            self.accounts[i] = account;
            self.textures[i].set(ctx, words::texts(state.settings.lang).view(view), tiles);
            // Said when it comes up; as long as it is so, a note stands in the picture.
            if let Some(too_much) = too_much.as_ref().filter(|_| !self.too_much.contains(&too_much)) {
                state.say(Message::OverBudget(too_much.clone()));
            }
            self.too_much[i] = too_much;
        }
        self.report(ctx, state);
        let palette = Palette::of(style.theme);
        for pane in panes {
            let ground = if pane.view == View::Image { palette.surround } else { palette.paper };
            let Rgba { r, g, b, .. } = ground;
            ui.painter().rect_filled(pane.rect.rect, 0.0, eframe::egui::Color32::from_rgb(r, g, b));
            self.textures[pane.view.index()].paint(ui, &pane.rect);
        }
    }

    /// Tells the side of explanations how the picture came about.
    fn report(&self, ctx: &eframe::egui::Context, state: &mut State) {
        let of = state.layout.strip_of;
        let account = self.accounts[of.index()].as_ref().filter(|_| state.shows_stages() && state.layout.is_shown(of));
        let reports = account.map(|account| account.stages.as_slice()).unwrap_or_default();
        if state.explain.reports != reports {
            state.explain.reports = reports.to_vec();
            ctx.request_repaint();
        }
    }

    /// Overlays of the pictures: borders, the focus ring, the cross hairs of the pointer.
    fn decorate(&self, ui: &Ui, state: &State, panes: &[Pane], texts: &CanvasTexts) {
        for pane in panes {
            let rect = pane.rect.rect;
            let border = ui.visuals().widgets.noninteractive.bg_stroke;
            ui.painter().rect_stroke(rect, 0.0, border, StrokeKind::Inside);
            if pane.response.has_focus() {
                let ring = Stroke::new(2.0, ui.visuals().hyperlink_color);
                ui.painter().rect_stroke(rect, 0.0, ring, StrokeKind::Inside);
            }
            if self.missing[pane.view.index()] == Some(Missing::Cancelled) {
                note(ui, rect, texts.given_up);
            } else if self.textures[pane.view.index()].failed() {
                let font = TextStyle::Body.resolve(ui.style());
                let color = ui.visuals().error_fg_color;
                ui.painter().text(rect.center(), Align2::CENTER_CENTER, texts.not_drawn, font, color);
            }
            note(ui, rect, &loading(state));
            if pane.view == View::Image && pane.response.hovered() && self.drag.is_none() {
                cross(ui, state, pane);
            }
        }
    }

    fn describe_probe(
        &mut self,
        (ui, room): (&Ui, Rect),
        place: Option<Pos2>,
        state: &mut State,
        status: &mut Status,
        texts: &'static CanvasTexts,
    ) {
        let ctx = ui.ctx();
        let Some(probe) = state.probe else {
            status.note = texts.probe_hint;
            return;
        };
        // What is found there does not depend on the size.
        let size = Size { width: 1, height: 1, scale: 1.0 };
        let request = Request { hover: Hover::default(), ..self.request(state, View::Image, size) };
        let digits = state.settings.digits;
        let asks = matches!(probe, Probe::Window(_)) && request.shot.look.reveal.depth != Depth::Off;
        let depths = asks
            .then(|| {
                self.depth_picker
                    .ask(ctx, PickRequest { request: request.clone(), what: PickQuery::Depths(probe) })
                    .depths
            })
            .flatten();
        let (mark, scene) = (texts.lang.mark(), state.scene_cache.scene());
        let vertex = match probe {
            Probe::Point(p) => self.vertex_names.at(p, scene, &state.document.figure().scene),
            Probe::Window(_) => None,
        };
        let vertex: Vec<_> = vertex.iter().map(|name| readout::vertex_cell(name, texts)).collect();
        let cells = |digits, mark| {
            let coordinates = readout::cells(probe, depths, &request, (digits, mark), texts);
            vertex.iter().cloned().chain(coordinates).collect::<Vec<_>>()
        };
        status.cells = cells(digits.min(4), mark);
        status.exact = cells(digits, mark);
        if state.pinned().is_some() {
            let point = match probe {
                Probe::Point(p) => Some(p),
                Probe::Window(_) => None,
            };
            match card::show(ui, room, place, (&status.exact, point.is_some()), texts) {
                None => {}
                Some(CardAction::Follow) => {
                    if let Some(p) = point {
                        state.follow_point(p);
                        state.show_explanation(ExplainTab::Point);
                        ctx.request_repaint();
                    }
                }
                Some(CardAction::Copy) => ctx.copy_text(copied(&cells(EXACT_DIGITS, DecimalMark::Point))),
                Some(CardAction::Release) => {
                    state.pin(None);
                    ctx.request_repaint();
                }
            }
        }
        if state.pinned().is_some() {
            status.aside = if status.aside.is_empty() {
                texts.pinned.to_owned()
            } else {
                format!("{} · {}", texts.pinned, status.aside)
            };
        }
    }
}

/// Whether the image is shown as the eye would see it; `None` where its pixels are square, so that it makes no
/// difference.
fn undistorted(state: &State) -> Option<bool> {
    let figure = state.document.figure();
    let differs = state.document.camera().aspect_warning(figure.image).is_some();
    (differs || figure.undistorted).then_some(figure.undistorted)
}

/// Cells as text, a space in a line, with numbers as programs read them.
fn copied(cells: &[Cell]) -> String {
    cells.iter().map(|cell| format!("{}\t{}\n", cell.space, cell.value)).collect::<String>().replace('−', "-")
}

/// The mesh files being read, in a sentence; empty where there are none.
fn loading(state: &State) -> String {
    let files = state.scene_cache.loading();
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
fn toggle_maximized(state: &mut State, view: View) {
    state.layout.maximized = if state.layout.maximized == Some(view) { None } else { Some(view) };
}

/// A picture in words.
fn describe(state: &State, view: View) -> String {
    let lang = state.settings.lang;
    match view {
        View::World => {
            let camera = state.document.camera();
            let [position, focal_point] = [camera.position(), camera.focal_point()].map(|p| point(p, 4, lang.mark()));
            words::describe_world(lang, &position, &focal_point)
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
    let look = Look::of(state.document.figure());
    let f = image_frame(pane.rect.size, look.image_aspect(state.document.camera()));
    let frame = pane.rect.rect_of(f.x as f32, f.y as f32, f.width as f32, f.height as f32);
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
