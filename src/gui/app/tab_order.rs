//! Keys in their order. Text typed before Tab is for the field that has the focus then, and text after it for the next
//! one, even if both come in one frame. The focus moves at the beginning of a frame, before any field reads the text.

use eframe::egui::{Event, Key};

/// Hands the events on frame by frame.
#[derive(Debug, Default)]
pub(in crate::gui) struct KeyOrder {
    waiting: Vec<Event>,
}

impl KeyOrder {
    /// Leaves of the events of a frame those up to the next Tab, or a Tab alone. True if others wait for the next
    /// frame.
    pub(in crate::gui) fn hold(&mut self, events: &mut Vec<Event>) -> bool {
        let mut all = std::mem::take(&mut self.waiting);
        all.append(events);
        let is_tab = |event: &Event| matches!(event, Event::Key { key: Key::Tab, pressed: true, .. });
        let now = match all.iter().position(is_tab) {
            Some(0) => 1,
            Some(tab) => tab,
            None => all.len(),
        };
        self.waiting = all.split_off(now);
        *events = all;
        !self.waiting.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use eframe::egui::Modifiers;

    use super::*;

    #[test]
    fn text_before_and_after_a_tab_comes_in_separate_frames() {
        let tab = || Event::Key {
            key: Key::Tab,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        let text = |text: &str| Event::Text(text.to_owned());
        let mut order = KeyOrder::default();
        let mut events = vec![text("640"), tab(), text("480"), tab()];
        assert!(order.hold(&mut events));
        assert_eq!(events, [text("640")]);
        let mut frames = Vec::new();
        loop {
            let mut events = if frames.is_empty() { vec![text("x")] } else { Vec::new() };
            let more = order.hold(&mut events);
            frames.push(events);
            if !more {
                break;
            }
        }
        assert_eq!(frames, [vec![tab()], vec![text("480")], vec![tab()], vec![text("x")]]);
        let mut none = Vec::new();
        assert!(!order.hold(&mut none) && none.is_empty());
    }
}
