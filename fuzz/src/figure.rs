//! A text that reads as a figure is written so that it reads back, and an edit of its own text changes nothing.

use camera_lab::figure::{read, update, write};

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(figure) = read::parse_bytes(bytes) else { return };
    let text = std::str::from_utf8(bytes).expect("what is read is UTF-8");
    assert_eq!(read::parse(&write::to_toml(&figure)).as_ref(), Ok(&figure));
    assert_eq!(update(text, &figure), text);
    let mut other = figure.clone();
    other.image.width = if figure.image.width == 7 { 8 } else { 7 };
    assert_eq!(read::parse(&update(text, &other)).as_ref(), Ok(&other));
}
