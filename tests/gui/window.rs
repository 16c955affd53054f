//! The whole window in a harness, without a display, as the tests of the window need it.

use std::time::{Duration, Instant};

use camera_lab::figure::Explanation;
use camera_lab::gui::kit::theme;
use camera_lab::gui::{App, Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_desk::Theirs;
use camera_lab_desk::layout::Side;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2, Rect, Shape, Ui, UiBuilder, Vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, Node};

use super::painter::{Painter, Textures};

/// The window in a harness.
pub(crate) struct Window {
    /// The harness.
    pub(crate) harness: Harness<'static, Option<App>>,
    /// The textures that egui draws with.
    textures: Textures,
}

/// The names of an explanation's question and of itself in the window.
pub(crate) fn names(lang: Lang, explanation: Explanation) -> [&'static str; 2] {
    let t = camera_lab_words::why::explain::texts(lang);
    match explanation {
        Explanation::Matrices => [t.question_where, t.matrices],
        Explanation::Point => [t.question_where, t.point],
        Explanation::Homogeneous => [t.question_where, t.homogeneous],
        Explanation::Order => [t.question_where, t.order],
        Explanation::Steps => [t.question_happens, t.steps],
        Explanation::Stages => [t.question_happens, t.stages],
        Explanation::Triangle => [t.question_happens, t.triangle],
        Explanation::HiddenSurfaces => [t.question_happens, t.hidden_surfaces],
        Explanation::Clipping => [t.question_happens, t.clipping],
        Explanation::Depth => [t.question_happens, t.depth],
        Explanation::Dialects => [t.question_called, t.dialects],
        Explanation::Code => [t.question_called, t.code],
        Explanation::Conventions => [t.question_called, t.conventions],
        Explanation::Exercises => [t.question_able, t.exercises],
        Explanation::Notes => [t.question_able, t.notes],
    }
}

/// The state of a window with a figure file, and only one view in it.
pub(crate) fn opened(path: &std::path::Path, view: View) -> State {
    let opened = camera_lab_files::open_figure(path).expect("a figure file");
    let (figure, file) = opened.at(path);
    let mut state = State::new(Start { figure, file: Some(file), allow_files: false, ..Start::default() })
        .expect("a possible camera");
    state.file_flow.native = false;
    state.model.layout.maximized = Some(view);
    state
}

impl Window {
    /// Opens the side of explanations, a question and one of its answers, as a user does.
    pub(crate) fn explain(&mut self, explanation: Explanation) {
        if !self.state().model.settings.panels().is_shown(Side::Explain) {
            self.harness.key_press_modifiers(Modifiers::ALT, Key::E);
            self.run();
        }
        for name in names(self.state().model.settings.lang, explanation) {
            // The bar and the line under the pictures have switches of the same names.
            let named = self.harness.get_all_by_label(name).filter(|node| node.rect().top() > 26.0);
            let at_right = named.max_by(|a, b| a.rect().left().total_cmp(&b.rect().left()));
            at_right.expect("a question and its answer").click();
            self.run();
        }
        assert!(self.state().model.shows_explanation(explanation));
    }

    /// A window of the usual size with the camera that it begins with. There is little to draw in it, because pictures
    /// take their time without optimisation.
    pub(crate) fn new(lang: Lang) -> Self {
        let mut figure = camera_lab_desk::document::fresh();
        figure.scene.preset = Preset::Empty;
        figure.style.antialias = camera_lab::appearance::Samples::One;
        let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
            .expect("a possible camera");
        state.file_flow.native = false;
        state.model.layout.maximized = Some(View::Image);
        Self::with_state(state, [1280.0, 800.0])
    }

    /// A window with a figure file, and only the image in it.
    pub(crate) fn opened(path: &std::path::Path) -> Self {
        Self::with_state(opened(path, View::Image), [1280.0, 800.0])
    }

    /// A window with a state.
    pub(crate) fn with_state(state: State, size: [f32; 2]) -> Self {
        Self::at_scale(state, size, 1.0)
    }

    /// A window with a state, on a screen with so many pixels to a point.
    pub(crate) fn at_scale(state: State, size: [f32; 2], pixels_per_point: f32) -> Self {
        let mut state = state;
        // At the first start they're folded.
        state.model.settings.numbers_open = true;
        let mut start = Some(state);
        let painter = Painter::default();
        let textures = painter.textures();
        let harness = Harness::builder()
            .with_size(Vec2::from(size))
            .with_pixels_per_point(pixels_per_point)
            .with_theme(eframe::egui::Theme::Light)
            .with_context_setup(|ctx| {
                theme::install_fonts(ctx);
                theme::install_style(ctx);
            })
            // Small pictures come one by one, each with a frame of its own.
            .with_max_steps(100)
            .with_render_cursor(false)
            .renderer(painter)
            .build_ui_state(
                move |ui, app: &mut Option<App>| {
                    let ctx = ui.ctx().clone();
                    let app = app.get_or_insert_with(|| {
                        let mut app = App::new(&ctx, start.take().expect("once"));
                        app.canvas.patience = Some(Duration::from_secs(60));
                        app.state.file_flow.reading.patience = Duration::from_secs(60);
                        app.state.file_flow.saving.patience = Duration::from_secs(60);
                        app
                    });
                    // The harness leaves a margin. The window has none.
                    let whole = UiBuilder::new().max_rect(ctx.content_rect());
                    app.show(&mut Ui::new(ctx, eframe::egui::Id::unique("whole window"), whole));
                },
                None,
            );
        let mut window = Self { harness, textures };
        window.run();
        window
    }

    /// Begins again with another state, in a context that has its fonts already.
    pub(crate) fn begin_again(&mut self, state: State) {
        let ctx = self.harness.ctx.clone();
        ctx.memory_mut(|memory| {
            if let Some(id) = memory.focused() {
                memory.surrender_focus(id);
            }
        });
        eframe::egui::Popup::close_all(&ctx);
        let mut app = App::new(&ctx, state);
        app.canvas.patience = Some(Duration::from_secs(60));
        app.state.file_flow.reading.patience = Duration::from_secs(60);
        app.state.file_flow.saving.patience = Duration::from_secs(60);
        *self.harness.state_mut() = Some(app);
        self.run();
    }

    /// The state of the window.
    pub(crate) fn state(&self) -> &State {
        &self.harness.state().as_ref().expect("it has been shown").state
    }

    /// The content of another program in the figure's file.
    pub(crate) fn theirs(&self) -> Option<&Theirs> {
        self.state().file_flow.watch.theirs(&self.state().model.desk.shown)
    }

    /// The program itself.
    pub(crate) fn app_mut(&mut self) -> &mut App {
        self.harness.state_mut().as_mut().expect("it has been shown")
    }

    /// The pixels (premultiplied RGBA) of the only texture of this size that is on the screen.
    pub(crate) fn pixels(&self, size: [usize; 2]) -> Vec<u8> {
        self.textures.only(size, self.harness.output())
    }

    /// Frames until nothing changes any more.
    pub(crate) fn run(&mut self) {
        self.harness.run();
    }

    /// Frames until `get` has a value, which another thread makes.
    #[track_caller]
    pub(crate) fn wait_until<T>(&mut self, get: impl Fn(&Self) -> Option<T>) -> T {
        let since = Instant::now();
        loop {
            if let Some(value) = get(self) {
                return value;
            }
            assert!(since.elapsed() < Duration::from_secs(300), "{:?}", self.state().model.message);
            std::thread::sleep(Duration::from_millis(5));
            self.harness.step();
        }
    }

    /// Frames until `done`, and then until nothing changes any more.
    #[track_caller]
    pub(crate) fn wait(&mut self, done: impl Fn(&Self) -> bool) {
        self.run();
        self.wait_until(|window| done(window).then_some(()));
        self.run();
    }

    /// Leaves the window alone, and checks that it then neither draws nor requests frames.
    #[track_caller]
    pub(crate) fn assert_rests(&mut self) {
        self.harness.remove_cursor();
        // The check of the camera requests a frame when it ends, and that may be after the last one of `run`.
        self.wait(|window| window.state().model.coach.advice().is_some());
        let drawn = self.app_mut().canvas.drawn();
        for _ in 0..3 {
            self.harness.step();
            let delay = self.harness.output().viewport_output[&eframe::egui::ViewportId::ROOT].repaint_delay;
            assert_eq!(delay, Duration::MAX, "{:?}", self.harness.ctx.repaint_causes());
        }
        assert_eq!(self.app_mut().canvas.drawn(), drawn);
    }

    /// Frames until a label contains this text.
    #[track_caller]
    pub(crate) fn wait_for(&mut self, text: &str) {
        self.wait_until(|window| window.says(text).then_some(()));
    }

    /// The number field with this name.
    pub(crate) fn field<'a>(&'a self, name: &'a str) -> Node<'a> {
        self.harness.get_by_role_and_label(Role::SpinButton, name)
    }

    /// Unfolds the part behind *More*, by its name.
    pub(crate) fn more(&mut self, what: &str) {
        let more = camera_lab_words::window::texts(self.state().model.settings.lang).more;
        self.click(&format!("{more}: {what}"));
    }

    /// Clicks a field and types into it, without leaving it.
    pub(crate) fn type_into(&mut self, field: &str, text: &str) {
        self.field(field).click();
        self.run();
        self.harness.event(Event::Text(text.to_owned()));
        self.run();
    }

    /// Types into a field and presses Enter.
    pub(crate) fn enter(&mut self, field: &str, text: &str) {
        self.type_into(field, text);
        self.key(Key::Enter);
    }

    /// Presses a key.
    pub(crate) fn key(&mut self, key: Key) {
        self.harness.key_press(key);
        self.run();
    }

    /// Presses a key together with the platform's command key.
    pub(crate) fn command_key(&mut self, key: Key) {
        self.harness.key_press_modifiers(Modifiers::COMMAND, key);
        self.run();
    }

    /// Clicks the control with this label.
    pub(crate) fn click(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.run();
    }

    /// Clicks the control with this label in a dialog. It comes after the panels, which may have the label too.
    pub(crate) fn click_in_dialog(&mut self, label: &str) {
        self.harness.query_all_by_label(label).last().expect("the label").click();
        self.run();
    }

    /// Chooses an entry of a menu.
    pub(crate) fn menu(&mut self, menu: &str, entry: &str) {
        self.click(menu);
        let entry = self
            .harness
            .get_by(|node| node.label().is_some_and(|label| label.trim().trim_start_matches("✔ ").starts_with(entry)));
        entry.click();
        self.run();
    }

    /// Clicks a place of the window.
    pub(crate) fn click_at(&mut self, place: Pos2) {
        self.harness.hover_at(place);
        self.run();
        self.harness.drag_at(place);
        self.harness.drop_at(place);
        self.run();
    }

    /// Takes the pointer to `from`, presses, moves it by `way` in steps, and lets go after `held` has looked at the
    /// window.
    pub(crate) fn drag(&mut self, from: Pos2, way: Vec2, held: impl FnOnce(&mut Self)) {
        self.harness.hover_at(from);
        self.run();
        self.harness.drag_at(from);
        self.run();
        for step in 1..=4 {
            self.harness.hover_at(from + way * (step as f32 / 4.0));
            self.run();
        }
        held(self);
        self.harness.drop_at(from + way);
        self.run();
    }

    /// Every text as it was drawn in the last frame, one for each of its lines (without the parts that were cut off),
    /// and its place.
    pub(crate) fn written(&self) -> Vec<(String, Rect)> {
        fn collect(shape: &Shape, clip: Rect, written: &mut Vec<(String, Rect)>) {
            match shape {
                Shape::Text(text) => written.extend(
                    text.galley
                        .rows
                        .iter()
                        .map(|row| (row.text(), row.rect().translate(text.pos.to_vec2()).intersect(clip))),
                ),
                Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, written)),
                _ => {}
            }
        }
        let mut written = Vec::new();
        for clipped in &self.harness.output().shapes {
            collect(&clipped.shape, clipped.clip_rect, &mut written);
        }
        written
    }

    /// True if some label contains this text.
    pub(crate) fn says(&self, text: &str) -> bool {
        self.harness.query_all_by_label_contains(text).next().is_some()
    }
}
