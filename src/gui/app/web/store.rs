//! Storage in the browser, downloads, and the locks that keep its tabs apart.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::io;

use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Storage, Url};

use crate::clock;
use camera_lab_files::disk::page::{self, Page};

/// The prefix of stored names, because other pages of the same address have names of their own.
const PREFIX: &str = "camera-lab/";

/// Time for which a download stays in memory, because browsers read it some time after the click.
const TAKEN_MS: i32 = 60_000;

thread_local! {
    /// The locks that other tabs held when this page began.
    static ELSEWHERE: RefCell<BTreeSet<String>> = const { RefCell::new(BTreeSet::new()) };
    /// Functions that release the locks of this page.
    static OWN: RefCell<BTreeMap<String, js_sys::Function>> = const { RefCell::new(BTreeMap::new()) };
}

/// Finds out which tabs there are, and sets the functions of the page.
pub(in crate::gui) async fn begin() {
    let held = held_locks().await.unwrap_or_default();
    ELSEWHERE.with_borrow_mut(|elsewhere| *elsewhere = held);
    page::begin(Page {
        kept,
        keep,
        download,
        held_elsewhere: |name| ELSEWHERE.with_borrow(|elsewhere| elsewhere.contains(name)),
        hold,
        clock: clock::seconds_since_1970,
    });
}

/// Without permission to store, there is no storage, and storing fails.
fn storage() -> io::Result<Storage> {
    let storage = crate::gui::app::web::window().and_then(|window| window.local_storage().ok().flatten());
    storage.ok_or_else(|| io::ErrorKind::PermissionDenied.into())
}

fn kept(name: &str) -> Option<String> {
    storage().ok()?.get_item(&format!("{PREFIX}{name}")).ok().flatten()
}

fn keep(name: &str, text: Option<&str>) -> io::Result<()> {
    let (storage, key) = (storage()?, format!("{PREFIX}{name}"));
    let done = match text {
        Some(text) => storage.set_item(&key, text),
        None => storage.remove_item(&key),
    };
    done.map_err(|_| io::ErrorKind::QuotaExceeded.into())
}

/// True for a link that this tab hasn't opened yet. If the page is loaded again, the work continues instead.
pub(in crate::gui) fn is_new_here(link: &str) -> bool {
    const KEY: &str = "camera-lab/link";
    let Some(storage) = crate::gui::app::web::window().and_then(|window| window.session_storage().ok().flatten())
    else {
        return true;
    };
    if storage.get_item(KEY).ok().flatten().as_deref() == Some(link) {
        return false;
    }
    // If it can't be recorded, the link is opened again.
    let _ = storage.set_item(KEY, link);
    true
}

fn download(name: &str, bytes: &[u8]) -> io::Result<()> {
    downloaded(name, bytes).map_err(|_| io::ErrorKind::PermissionDenied.into())
}

/// Hands bytes over, as a click on a link would.
fn downloaded(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let window = crate::gui::app::web::window().ok_or("no window")?;
    let document = window.document().ok_or("no document")?;
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    // A type that no browser displays instead of saving.
    let kind = BlobPropertyBag::new();
    kind.set_type("application/octet-stream");
    let url = Url::create_object_url_with_blob(&Blob::new_with_u8_array_sequence_and_options(&parts, &kind)?)?;
    let link: HtmlAnchorElement = document.create_element("a")?.dyn_into().map_err(|_| "no link")?;
    link.set_href(&url);
    link.set_download(name);
    link.click();
    let forget = Closure::once_into_js(move || {
        let _ = Url::revoke_object_url(&url);
    });
    window.set_timeout_with_callback_and_timeout_and_arguments_0(forget.unchecked_ref(), TAKEN_MS)?;
    Ok(())
}

/// The object that has the locks of all tabs of this origin. Older browsers have none, and pages from disk may not use
/// it.
fn locks() -> Option<JsValue> {
    let locks = js_sys::Reflect::get(&crate::gui::app::web::window()?.navigator(), &"locks".into()).ok()?;
    locks.is_object().then_some(locks)
}

fn method(of: &JsValue, name: &str) -> Option<js_sys::Function> {
    js_sys::Reflect::get(of, &name.into()).ok()?.dyn_into().ok()
}

/// The names of the locks that tabs hold.
async fn held_locks() -> Option<BTreeSet<String>> {
    let locks = locks()?;
    let asked = method(&locks, "query")?.call0(&locks).ok()?;
    let found = wasm_bindgen_futures::JsFuture::from(js_sys::Promise::from(asked)).await.ok()?;
    let held = js_sys::Array::from(&js_sys::Reflect::get(&found, &"held".into()).ok()?);
    let name = |lock: JsValue| js_sys::Reflect::get(&lock, &"name".into()).ok()?.as_string();
    Some(held.iter().filter_map(name).filter_map(|name| name.strip_prefix(PREFIX).map(str::to_owned)).collect())
}

/// Takes or releases a lock. That comes about a moment later, so of two tabs that start in the same moment, both may
/// think that they have it.
fn hold(name: &str, wanted: bool) {
    if !wanted {
        if let Some(release) = OWN.with_borrow_mut(|own| own.remove(name)) {
            let _ = release.call0(&JsValue::NULL);
        }
        return;
    }
    let Some(locks) = locks() else { return };
    let Some(request) = method(&locks, "request") else { return };
    // Held as long as this promise is open.
    let open = js_sys::Promise::new(&mut |resolve, _| {
        OWN.with_borrow_mut(|own| own.insert(name.to_owned(), resolve));
    });
    let granted = Closure::once_into_js(move |_lock: JsValue| open);
    if let Ok(asked) = request.call2(&locks, &format!("{PREFIX}{name}").into(), &granted) {
        // A page that may not have locks works without them.
        let refused = Closure::once_into_js(|_: JsValue| {});
        let _ = method(&asked, "catch").map(|catch| catch.call1(&asked, &refused));
    }
}
