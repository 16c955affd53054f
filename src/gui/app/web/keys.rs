//! Keys that call a command here, and whose other action in the browser is prevented.

use eframe::egui::{Key, Modifiers};
use wasm_bindgen::JsCast as _;
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;
use web_sys::{KeyboardEvent, Window};

use crate::gui::kit::Command;

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
