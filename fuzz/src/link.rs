//! A link holds the figure or lesson that was put into it, whatever a mail program adds. Any other text that looks like
//! one is a text, an error, or no link.

use arbitrary::{Arbitrary, Unstructured};
use camera_lab::limits::{MAX_FIGURE_BYTES, MAX_LINK_CHARACTERS};
use camera_lab_files::share::{Held, link, text_in};

#[derive(Arbitrary, Debug)]
struct Input<'a> {
    address: &'a str,
    text: &'a str,
    is_lesson: bool,
    /// The text in place of the packed figure.
    packed: &'a str,
    /// A change on the way: its place, and the new character.
    damage: Option<(u16, char)>,
}

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(input) = Input::arbitrary_take_rest(Unstructured::new(bytes)) else { return };
    let held = if input.is_lesson { Held::Lesson } else { Held::Figure };
    if let Some(Ok(found)) = text_in(&format!("{}{}{}", input.address, held.key(), input.packed)) {
        assert!(found.len() <= MAX_FIGURE_BYTES);
    }
    let Ok(link) = link(input.address, held, input.text) else { return };
    assert!(link.len() <= MAX_LINK_CHARACTERS);
    for added in ["", ".", ")", "> ", "\"", "=="] {
        let found = text_in(&format!("{link}{added}")).expect("a link").expect("whole");
        assert_eq!(found, input.text.as_bytes());
    }
    if let Some((place, letter)) = input.damage {
        let mut damaged: Vec<char> = link.chars().collect();
        let place = usize::from(place) % damaged.len();
        damaged[place] = letter;
        // Whatever comes of it is no panic, and no more than a figure may have.
        if let Some(Ok(found)) = text_in(&damaged.into_iter().collect::<String>()) {
            assert!(found.len() <= MAX_FIGURE_BYTES);
        }
    }
}
