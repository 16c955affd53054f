//! The browser's dialog for files, and the reading of files that the user gives to a page.

use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use eframe::egui;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{Event, File, HtmlInputElement};

use super::{FileAnswer, FileQuestion};
use camera_lab_files::disk::page;

/// Reads a file, gives it to the page, and returns its path there. A file that is unreadable, or larger than any, isn't
/// given. Opening it reports that.
pub(in crate::gui) fn read(ctx: &egui::Context, file: File, then: impl FnOnce(PathBuf) + 'static) {
    let ctx = ctx.clone();
    wasm_bindgen_futures::spawn_local(async move {
        let path = PathBuf::from(file.name());
        #[expect(clippy::cast_precision_loss, reason = "a power of two")]
        let is_too_large = file.size() > crate::limits::MAX_FILE_BYTES as f64;
        if !is_too_large && let Ok(bytes) = wasm_bindgen_futures::JsFuture::from(file.array_buffer()).await {
            page::give(path.clone(), js_sys::Uint8Array::new(&bytes).to_vec());
        }
        then(path);
        ctx.request_repaint();
    });
}

/// The answer, for the window and for the callbacks of the browser.
type Answer = Rc<RefCell<Option<FileAnswer>>>;

/// The browser's dialog while it's open.
#[derive(Debug)]
pub(in crate::gui) struct OpenFileDialog {
    answer: Answer,
}

impl OpenFileDialog {
    /// Opens the dialog. Browsers allow that only soon after a key or button press.
    pub(in crate::gui) fn start(ctx: &egui::Context, question: FileQuestion, _: &eframe::Frame) -> Self {
        let answer = Answer::default();
        if open(ctx, question, &answer).is_none() {
            answer.replace(Some(FileAnswer::Cancelled));
        }
        Self { answer }
    }

    /// The answer, once there is one.
    pub(in crate::gui) fn poll(&mut self) -> Option<FileAnswer> {
        self.answer.take()
    }
}

fn open(ctx: &egui::Context, question: FileQuestion, answer: &Answer) -> Option<()> {
    let document = web_sys::window()?.document()?;
    let input: HtmlInputElement = document.create_element("input").ok()?.dyn_into().ok()?;
    input.set_type("file");
    // A figure comes with its meshes, and a mesh with the files it names, so all kinds of files can be chosen together.
    input.set_multiple(true);
    let endings: Vec<&str> = question.filters.iter().flat_map(|(_, endings)| endings.iter().copied()).collect();
    let (chosen, dialog, wake) = (Rc::clone(answer), input.clone(), ctx.clone());
    listen(&input, "change", move || {
        let files: Vec<File> =
            dialog.files().into_iter().flat_map(|list| (0..list.length()).filter_map(move |i| list.get(i))).collect();
        let left = Rc::new(Cell::new(files.len()));
        let paths = Rc::new(RefCell::new(Vec::new()));
        for file in files {
            let (left, paths, chosen, endings) =
                (Rc::clone(&left), Rc::clone(&paths), Rc::clone(&chosen), endings.clone());
            read(&wake, file, move |path| {
                paths.borrow_mut().push(path);
                left.set(left.get() - 1);
                if left.get() == 0 {
                    let first = first_of(paths.take(), &endings);
                    chosen.replace(Some(first.map_or(FileAnswer::Cancelled, FileAnswer::Chosen)));
                }
            });
        }
    })?;
    let (cancelled, wake) = (Rc::clone(answer), ctx.clone());
    listen(&input, "cancel", move || {
        cancelled.replace(Some(FileAnswer::Cancelled));
        wake.request_repaint();
    })?;
    input.click();
    Some(())
}

/// The requested file. The others are those that it names.
fn first_of(paths: Vec<PathBuf>, endings: &[&str]) -> Option<PathBuf> {
    let is_asked_for = |path: &Path| {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        endings.contains(&ending.as_str())
    };
    paths.iter().find(|path| is_asked_for(path)).or(paths.first()).cloned()
}

/// Calls `then` at each event of this name, as long as the page exists, because a dialog doesn't report when it's no
/// longer needed.
fn listen(input: &HtmlInputElement, event: &str, mut then: impl FnMut() + 'static) -> Option<()> {
    let closure = Closure::<dyn FnMut(Event)>::new(move |_| then());
    input.add_event_listener_with_callback(event, closure.as_ref().unchecked_ref()).ok()?;
    closure.forget();
    Some(())
}
