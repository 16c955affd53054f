//! Files that the user gives to the page: chosen with the browser's own dialog, or dropped.

use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::rc::Rc;

use eframe::egui;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{Event, File, HtmlInputElement};

use crate::files::disk::page;
use crate::gui::native::{FileAnswer, FileQuestion};
use crate::gui::state::MESH_ENDINGS;
use crate::limits::MAX_FILE_BYTES;

thread_local! {
    /// What is woken when a file has been read.
    static WAKE: RefCell<Option<egui::Context>> = const { RefCell::new(None) };
}

/// Has frames of this window called for when files arrive.
pub(super) fn listen_to(ctx: &egui::Context) {
    WAKE.set(Some(ctx.clone()));
}

pub(super) fn wake() {
    WAKE.with_borrow(|ctx| ctx.iter().for_each(egui::Context::request_repaint));
}

/// Reads a file, gives it to the page, and says under which path. One that cannot be read, or is larger than any, is not given:
/// opening it says so.
pub(super) fn read(file: File, then: impl FnOnce(PathBuf) + 'static) {
    wasm_bindgen_futures::spawn_local(async move {
        let path = PathBuf::from(file.name());
        #[expect(clippy::cast_precision_loss, reason = "a power of two")]
        let is_too_large = file.size() > MAX_FILE_BYTES as f64;
        if !is_too_large && let Ok(bytes) = wasm_bindgen_futures::JsFuture::from(file.array_buffer()).await {
            page::give(path.clone(), js_sys::Uint8Array::new(&bytes).to_vec());
        }
        then(path);
        wake();
    });
}

/// Of files that come together, first what the others are for: a figure, else a mesh.
pub(super) fn figures_first(mut paths: Vec<PathBuf>) -> Vec<PathBuf> {
    paths.sort_by_key(|path| {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let is_link = crate::share::link_of(path).is_some();
        match ending.as_str() {
            _ if is_link => 0,
            "toml" | "png" => 1,
            mesh if MESH_ENDINGS.contains(&mesh) => 2,
            _ => 3,
        }
    });
    paths
}

/// The browser's dialog, which is open.
#[derive(Debug)]
pub(in crate::gui) struct OpenFileDialog {
    answer: Rc<RefCell<Option<FileAnswer>>>,
}

impl OpenFileDialog {
    /// Opens the dialog. Browsers allow that only soon after a key or button was pressed.
    pub(in crate::gui) fn start(_: &egui::Context, question: FileQuestion) -> Self {
        let answer = Rc::new(RefCell::new(None));
        if Self::open(&question, &answer).is_none() {
            answer.replace(Some(FileAnswer::Cancelled));
        }
        Self { answer }
    }

    fn open(question: &FileQuestion, answer: &Rc<RefCell<Option<FileAnswer>>>) -> Option<()> {
        let document = super::window()?.document()?;
        let input: HtmlInputElement = document.create_element("input").ok()?.dyn_into().ok()?;
        input.set_type("file");
        // A mesh comes with what it names.
        input.set_multiple(true);
        let endings = question.filters.iter().flat_map(|(_, endings)| endings.iter());
        let is_mesh = endings.clone().any(|ending| MESH_ENDINGS.contains(ending));
        if !is_mesh {
            input.set_accept(&endings.map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(","));
        }
        let (chosen, dialog) = (Rc::clone(answer), input.clone());
        listen(&input, "change", move || {
            let files: Vec<File> =
                dialog.files().map(|list| (0..list.length()).filter_map(|i| list.get(i)).collect()).unwrap_or_default();
            let left = Rc::new(Cell::new(files.len()));
            let paths = Rc::new(RefCell::new(Vec::new()));
            for file in files {
                let (left, paths, chosen) = (Rc::clone(&left), Rc::clone(&paths), Rc::clone(&chosen));
                read(file, move |path| {
                    paths.borrow_mut().push(path);
                    left.set(left.get() - 1);
                    if left.get() == 0 {
                        let first = figures_first(paths.take()).into_iter().next();
                        chosen.replace(Some(first.map_or(FileAnswer::Cancelled, FileAnswer::Chosen)));
                    }
                });
            }
        })?;
        let cancelled = Rc::clone(answer);
        listen(&input, "cancel", move || {
            cancelled.replace(Some(FileAnswer::Cancelled));
            wake();
        })?;
        input.click();
        Some(())
    }

    /// The answer, once there is one.
    pub(in crate::gui) fn poll(&mut self) -> Option<FileAnswer> {
        self.answer.take()
    }
}

/// Calls `then` at each event of this name, as long as the page is there: a dialog does not say when nobody needs it any more.
fn listen(input: &HtmlInputElement, event: &str, then: impl FnMut() + 'static) -> Option<()> {
    let mut then = then;
    let closure = Closure::<dyn FnMut(Event)>::new(move |_| then());
    input.add_event_listener_with_callback(event, closure.as_ref().unchecked_ref()).ok()?;
    closure.forget();
    Some(())
}
