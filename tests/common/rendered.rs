//! Finished pictures, and the figures in them.

use tiny_skia::Pixmap;

use super::picture::assert_same;

/// Compares a finished picture with `tests/images/NAME.png`.
#[track_caller]
pub(crate) fn assert_rendered(name: &str, picture: &camera_lab::picture::Pixels) {
    assert_same(name, picture.width(), picture.height(), picture.rgba());
}

/// A small PNG with the text of a figure in it, and nothing else.
pub(crate) fn png_with(text: &str) -> Vec<u8> {
    use camera_lab::export::png;
    use camera_lab::progress::{Progress, at_once};
    let pixmap = Pixmap::new(2, 2).expect("two by two");
    at_once(png::encode(pixmap, text, None, None, &Progress::default())).expect("encoded")
}
