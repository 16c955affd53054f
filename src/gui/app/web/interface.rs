//! The interface for other pages, `window.cameraLab`. A page of lecture notes that shows this one in a frame of the
//! same origin can read the figure, set another one, get a link, and lay notes over the pictures. `docs/web.md`
//! describes it.

use eframe::WebRunner;
use eframe::egui::{Key, Modifiers};
use js_sys::{Object, Reflect};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{KeyboardEvent, Window};

use crate::gui::app::file_flow;
use crate::gui::app::file_flow::link_dialog::figure_link;
use crate::gui::app::web::{Page, arrive};
use crate::gui::kit::Command;
use camera_lab_files::disk::page;

/// Offers the object to the page.
pub(in crate::gui) fn offer(window: &Window, runner: &WebRunner) -> Result<(), JsValue> {
    let lab = Object::new();
    let of = runner.clone();
    let figure = Closure::<dyn Fn() -> JsValue>::new(move || {
        of.app_mut::<Page>().map_or(JsValue::NULL, |page| file_flow::text_to_save(&page.app.state.model).into())
    });
    Reflect::set(&lab, &"figure".into(), &figure.into_js_value())?;
    let open = Closure::<dyn Fn(String)>::new(|text: String| {
        let path = std::path::PathBuf::from("figure.toml");
        page::give(path.clone(), text.into_bytes());
        arrive(path);
    });
    Reflect::set(&lab, &"open".into(), &open.into_js_value())?;
    let of = runner.clone();
    let link = Closure::<dyn Fn() -> Result<JsValue, JsValue>>::new(move || {
        let Some(page) = of.app_mut::<Page>() else { return Ok(JsValue::NULL) };
        let address = page.app.state.sharing.own_address.clone().unwrap_or_default();
        let link = figure_link(&page.app.state.model, &address);
        link.map(|(link, ..)| JsValue::from(link)).map_err(|error| js_sys::Error::new(&error.to_string()).into())
    });
    Reflect::set(&lab, &"link".into(), &link.into_js_value())?;
    let of = runner.clone();
    let pictures = Closure::<dyn Fn() -> JsValue>::new(move || {
        of.app_mut::<Page>().and_then(|page| pictures(&page).ok()).map_or(JsValue::NULL, JsValue::from)
    });
    Reflect::set(&lab, &"pictures".into(), &pictures.into_js_value())?;
    let of = runner.clone();
    let ask = Closure::<dyn Fn(String, String, String) -> Result<JsValue, JsValue>>::new(
        move |what: String, one: String, two: String| {
            let Some(mut page) = of.app_mut::<Page>() else { return Err(JsValue::NULL) };
            super::messages::asked(&mut page, &what, one, &two).map(JsValue::from).map_err(JsValue::from)
        },
    );
    Reflect::set(&lab, &"ask".into(), &ask.into_js_value())?;
    Reflect::set(&lab, &"ready".into(), &false.into())?;
    Reflect::set(window, &"cameraLab".into(), &lab)?;
    Ok(())
}

/// The place of each visible picture, in the pixels of style sheets.
fn pictures(page: &Page) -> Result<Object, JsValue> {
    let all = Object::new();
    let zoom = page.app.state.model.settings.zoom;
    for (view, place) in page.app.canvas.places() {
        let place = place * zoom;
        let one = Object::new();
        for (key, value) in
            [("x", place.min.x), ("y", place.min.y), ("width", place.width()), ("height", place.height())]
        {
            Reflect::set(&one, &key.into(), &f64::from(value).into())?;
        }
        Reflect::set(&all, &view.name().into(), &one)?;
    }
    Ok(all)
}

/// Signals that the first picture is there, with `cameraLab.ready`, a mark of that name on the page's time line, and an
/// event of the window.
pub(in crate::gui) fn say_ready() {
    let Some(window) = crate::gui::app::web::window() else { return };
    if let Ok(lab) = Reflect::get(&window, &"cameraLab".into()) {
        let _ = Reflect::set(&lab, &"ready".into(), &true.into());
    }
    if let Some(performance) = window.performance() {
        let _ = performance.mark("camera-lab-ready");
    }
    if let Ok(event) = web_sys::Event::new("camera-lab-ready") {
        let _ = window.dispatch_event(&event);
    }
}

/// Keeps the browser from acting on the keys of this program. It still gets those that it reserves for itself.
pub(in crate::gui) fn keep_from_browser(window: &Window) -> Result<(), JsValue> {
    let pressed = Closure::<dyn FnMut(KeyboardEvent)>::new(|event: KeyboardEvent| {
        let modifiers = Modifiers {
            alt: event.alt_key(),
            ctrl: event.ctrl_key(),
            shift: event.shift_key(),
            mac_cmd: event.meta_key(),
            command: event.ctrl_key() || event.meta_key(),
        };
        // With Alt, some keyboards write other signs, so the key itself counts.
        let key = Key::from_name(&event.key()).or_else(|| Key::from_name(&event.code()));
        if key.is_some_and(|key| Command::any_has_in_browser(key, modifiers)) {
            event.prevent_default();
        }
    });
    let options = web_sys::AddEventListenerOptions::new();
    options.set_capture(true);
    let listener = pressed.as_ref().unchecked_ref();
    window.add_event_listener_with_callback_and_add_event_listener_options("keydown", listener, &options)?;
    pressed.forget();
    Ok(())
}
