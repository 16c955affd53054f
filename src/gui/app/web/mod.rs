//! The window as a page of a browser. It's the same program, with the page's own ways to files, to storage, and to its
//! address.

mod interface;
mod messages;
mod reader;
mod store;

use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};

use eframe::egui;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{HtmlCanvasElement, Window};

use crate::appearance::Theme;
use crate::export::format::FIGURE_ENDINGS;
use crate::gui::app::file_flow;
use crate::gui::kit::handheld::PHONE;
use crate::gui::platform::native;
use crate::gui::{App, GuiError, LaunchOptions, Start, State};
use crate::scene::import::MESH_ENDINGS;
use camera_lab_desk::document::fresh;
use camera_lab_files::disk::page::KEPT;
use camera_lab_files::{self as files, SourceFile, share};
use camera_lab_words::Lang;

/// The identifier of the page's canvas for the window.
const CANVAS: &str = "camera-lab";

thread_local! {
    /// Files that have been read, and links that have been followed, since the last frame.
    static ARRIVED: RefCell<Vec<PathBuf>> = const { RefCell::new(Vec::new()) };
    /// The context to wake then.
    static WAKE: RefCell<Option<egui::Context>> = const { RefCell::new(None) };
    /// Names and licences of all libraries, once they have arrived. The text is empty until then, and None before the
    /// first request.
    static THIRD_PARTY: Cell<Option<&'static str>> = const { Cell::new(None) };
}

/// Opens a file or a link in the next frame.
fn arrive(path: PathBuf) {
    ARRIVED.with_borrow_mut(|arrived| arrived.push(path));
    WAKE.with_borrow(|ctx| ctx.iter().for_each(egui::Context::request_repaint));
}

/// Sorts files that arrive together by importance: a figure, else a mesh.
fn figures_first(mut paths: Vec<PathBuf>) -> Vec<PathBuf> {
    paths.sort_by_key(|path| match path {
        _ if share::link_of(path).is_some() => 0,
        _ if files::has_ending(path, &FIGURE_ENDINGS) => 1,
        _ if files::has_ending(path, MESH_ENDINGS) => 2,
        _ => 3,
    });
    paths
}

fn window() -> Option<Window> {
    web_sys::window()
}

/// Calls a function of the page, defined in `index.html`, with a text. Returns None if the page lacks the function or
/// it throws.
fn call(name: &str, text: &str) -> Option<JsValue> {
    let function = window().and_then(|window| js_sys::Reflect::get(&window, &name.into()).ok())?;
    function.dyn_into::<js_sys::Function>().ok()?.call1(&JsValue::NULL, &text.into()).ok()
}

/// Names and licences of all libraries. The page keeps them beside the program, so the program loads sooner. Returns
/// None until they have arrived, and wakes the window then.
pub(in crate::gui) fn third_party(ctx: &egui::Context) -> Option<&'static str> {
    if THIRD_PARTY.get().is_none() {
        THIRD_PARTY.set(Some(""));
        let promise: js_sys::Promise = call("cameraLabThirdParty", "")?.dyn_into().ok()?;
        let ctx = ctx.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let (Ok(text) | Err(text)) = wasm_bindgen_futures::JsFuture::from(promise).await;
            // Once in the life of a page.
            THIRD_PARTY.set(text.as_string().map(|text| &*text.leak()));
            ctx.request_repaint();
        });
    }
    THIRD_PARTY.get().filter(|text| !text.is_empty())
}

/// Shows the window in the page's canvas.
pub fn run() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        before(info);
        call("cameraLabFault", &info.to_string());
    }));
    wasm_bindgen_futures::spawn_local(async {
        store::begin().await;
        if let Err(why) = start().await {
            call("cameraLabNoWindow", &why.as_string().unwrap_or_else(|| format!("{why:?}")));
        }
    });
}

async fn start() -> Result<(), JsValue> {
    let window = window().ok_or("no window")?;
    let canvas = window.document().and_then(|document| document.get_element_by_id(CANVAS));
    let canvas: HtmlCanvasElement = canvas.ok_or("no canvas")?.dyn_into().map_err(|_| "no canvas")?;
    interface::keep_from_browser(&window)?;
    let runner = eframe::WebRunner::new();
    interface::offer(&window, &runner)?;
    // The page's own reaction when its fragment changes.
    let followed = Closure::<dyn FnMut()>::new(|| {
        if let Some(link) = linked() {
            arrive(link);
        }
    });
    window.add_event_listener_with_callback("hashchange", followed.as_ref().unchecked_ref())?;
    followed.forget();
    let options = eframe::WebOptions { dithering: false, ..eframe::WebOptions::default() };
    runner.start(canvas, options, Box::new(|context| Ok(Box::new(Page::new(&context.egui_ctx)?)))).await
}

/// The link that the page was called by, if it holds a figure and this page hasn't opened it before.
fn linked() -> Option<PathBuf> {
    let fragment = window()?.location().hash().ok()?;
    // Opening it reports its faults.
    let _ = share::text_in(&fragment)?;
    store::is_new_here(&fragment).then(|| PathBuf::from(fragment))
}

/// True if the page is embedded in another one.
fn is_framed(window: &Window) -> bool {
    !matches!(window.parent(), Ok(Some(parent)) if parent == *window)
}

/// True if the user has set a media query for every page.
fn wanted(query: &str) -> bool {
    window().and_then(|window| window.match_media(query).ok().flatten()).is_some_and(|list| list.matches())
}

/// Light or dark, and true if motion is to be reduced.
fn system() -> (Theme, bool) {
    let theme = if wanted("(prefers-color-scheme: dark)") { Theme::Dark } else { Theme::Light };
    (theme, wanted("(prefers-reduced-motion: reduce)"))
}

/// The window's program in a page.
struct Page {
    app: App,
    title: String,
    system: (Theme, bool),
    /// True if the page fills the screen, as far as this program knows.
    full_screen: bool,
    /// True if the readiness of the pictures has been reported.
    told: bool,
    /// The state that the page around this one has heard of.
    known: messages::Known,
}

impl Page {
    fn new(ctx: &egui::Context) -> Result<Self, GuiError> {
        let window = window().ok_or_else(|| GuiError::NoWindow("no window".to_owned()))?;
        let location = window.location();
        let (asked, unknown) = LaunchOptions::of_query(&location.search().unwrap_or_default());
        for pair in unknown {
            web_sys::console::warn_1(&format!("Camera Lab does not know what {pair} asks for").into());
        }
        let lang = window.navigator().language().map_or(Lang::En, |locale| Lang::of_locale(&locale));
        let link = linked();
        // A lesson is played in the first frame.
        let (lesson, figure) = link
            .as_deref()
            .map_or((None, None), |link| if files::is_lesson(link) { (Some(link), None) } else { (None, Some(link)) });
        let (figure, file, fault) = match figure.map(read_link) {
            Some(Ok((figure, file))) => (figure, Some(file), None),
            Some(Err(error)) => (fresh(), None, Some(error)),
            None => (fresh(), None, None),
        };
        let restore = file.is_none() && lesson.is_none();
        let mut state = State::new(Start { figure, file, lang, allow_files: false, lesson: None, later: None })?;
        state.sharing.own_address = own_address(&location);
        let width = window.inner_width().ok().and_then(|width| width.as_f64());
        if !is_framed(&window) && width.is_some_and(|width| width < f64::from(PHONE)) {
            // The picture needs all the available space, until a panel is requested.
            state.model.settings.panels_mut().wanted = [false; 3];
        }
        let system = system();
        (state.model.settings.theme, state.model.settings.reduce_motion) = system;
        ctx.add_plugin(reader::Reader::default());
        let mut app = App::new(ctx, state);
        if is_framed(&window) {
            // A figure embedded in a page changes nothing stored in this browser.
            asked.apply(&mut app.state.model);
        } else {
            app.keep_preferences(ctx, Path::new(KEPT), asked);
            app.keep_session(Path::new(KEPT), restore);
        }
        app.state.file_flow.given.extend(lesson.map(Path::to_owned));
        if let Some(open) = asked.open_lesson() {
            // If the user left changes here, the link replaces the figure only after a question.
            file_flow::begin(ctx, &mut app.state, camera_lab_desk::Intent::Lesson(open));
        }
        if let Some(error) = fault {
            app.state.model.say(camera_lab_desk::message::Message::File(PathBuf::new(), error));
        }
        WAKE.set(Some(ctx.clone()));
        Ok(Self {
            app,
            title: String::new(),
            system,
            full_screen: false,
            told: false,
            known: messages::Known::default(),
        })
    }

    /// The title of the page, and how much of the screen it takes.
    fn follow_window(&mut self) {
        let Some(document) = window().and_then(|window| window.document()) else { return };
        if self.app.title() != self.title {
            self.app.title().clone_into(&mut self.title);
            document.set_title(&self.title);
        }
        let fills = document.fullscreen_element().is_some();
        let wanted = self.app.state.model.settings.presentation;
        if self.full_screen && !fills {
            // The browser's own key has ended it.
            self.app.state.model.settings.presentation = false;
            self.full_screen = false;
        } else if wanted != self.full_screen {
            self.full_screen = wanted;
            if wanted {
                // If the browser refuses, the presentation is as large as the page.
                let _ = document.document_element().map(|all| all.request_fullscreen());
            } else {
                document.exit_fullscreen();
            }
        }
        if self.full_screen && wanted && !fills {
            self.full_screen = false;
        }
    }
}

/// The figure of a link, and its text.
fn read_link(link: &Path) -> Result<(crate::figure::Figure, SourceFile), files::FileError> {
    Ok(files::open_figure(link)?.at(link))
}

/// The address of the page, if others can open it. They can't open a file on this machine.
fn own_address(location: &web_sys::Location) -> Option<String> {
    let address = format!("{}{}", location.origin().ok()?, location.pathname().ok()?);
    address.starts_with("http").then_some(address)
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let arrived = ARRIVED.with_borrow_mut(std::mem::take);
        self.app.state.file_flow.given.extend(figures_first(arrived));
        let system = system();
        if system != self.system {
            self.system = system;
            self.app.follow_system(system.0, system.1);
        }
        self.app.show(ui);
        file_flow::open_dialog(ui.ctx(), &mut self.app.state.file_flow, frame);
        self.follow_window();
        // A low frame has room for no picture, but it answers.
        let is_drawn = self.app.canvas.drawn().iter().any(|count| *count > 0);
        if !self.told && (is_drawn || self.app.canvas.places().all(|(_, place)| !place.is_positive())) {
            self.told = true;
            interface::say_ready();
        }
        if self.told {
            messages::tell(self);
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        eframe::App::clear_color(&self.app, visuals)
    }

    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        for file in std::mem::take(&mut input.dropped_files) {
            if let Some(file) = file.web_file() {
                native::read(ctx, file.clone(), arrive);
            }
        }
        eframe::App::raw_input_hook(&mut self.app, ctx, input);
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }
}
