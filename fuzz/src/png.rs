//! A PNG, whatever it holds, gives a figure or an error.

use camera_lab_files::figure_from;

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
    png.extend_from_slice(bytes);
    let _ = figure_from(&png);
    let _ = figure_from(bytes);
}
