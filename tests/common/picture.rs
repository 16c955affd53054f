//! Reference pictures: exact, in `tests/images/`.
//!
//! `UPDATE_IMAGES=1 cargo test` writes them again. Look at them before you commit them. On a mismatch a strip expected
//! | difference | actual is written beside the reference, as `NAME.diff.png`.

use std::fs;
use std::path::{Path, PathBuf};

use tiny_skia::{Pixmap, PremultipliedColorU8};

/// Straight RGBA, rows from the top.
#[derive(PartialEq)]
struct Picture {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
}

/// Holds `pixmap` against `tests/images/NAME.png`.
#[track_caller]
pub(crate) fn assert_picture(name: &str, pixmap: &Pixmap) {
    assert_same(name, pixmap.width(), pixmap.height(), pixmap.data());
}

/// The same for straight bytes: premultiplied RGBA, rows from the top.
#[track_caller]
pub(crate) fn assert_same(name: &str, width: u32, height: u32, premultiplied: &[u8]) {
    let color = |p: &[u8; 4]| PremultipliedColorU8::from_rgba(p[0], p[1], p[2], p[3]).expect("premultiplied");
    let (pixels, _) = premultiplied.as_chunks::<4>();
    let actual = Picture { width, height, rgba: pixels.iter().flat_map(|p| straight(color(p).demultiply())).collect() };
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    // The root of the workspace.
    let root = own.ancestors().find(|folder| folder.join("Cargo.lock").exists()).unwrap_or(own);
    let folder = root.join("tests/images");
    let path = folder.join(format!("{name}.png"));
    let strip = folder.join(format!("{name}.diff.png"));
    if std::env::var_os("UPDATE_IMAGES").is_some() {
        write(&path, &actual);
        return;
    }
    let Some(expected) = read(&path) else {
        panic!("{} cannot be read; UPDATE_IMAGES=1 writes it", path.display());
    };
    if expected == actual {
        // A file of an earlier failure. It may well not be there.
        let _ = fs::remove_file(strip);
        return;
    }
    assert_eq!((expected.width, expected.height), (actual.width, actual.height), "{name}: sizes differ");
    write(&strip, &side_by_side(&expected, &actual));
    let differ = expected.rgba.chunks(4).zip(actual.rgba.chunks(4)).filter(|(a, b)| a != b).count();
    let worst = expected.rgba.iter().zip(&actual.rgba).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
    panic!("{name}: {differ} pixels differ, by up to {worst}; see {}", strip.display());
}

fn straight(c: tiny_skia::ColorU8) -> [u8; 4] {
    [c.red(), c.green(), c.blue(), c.alpha()]
}

fn side_by_side(expected: &Picture, actual: &Picture) -> Picture {
    let row = 4 * expected.width as usize;
    let mut rgba = Vec::new();
    for (e, a) in expected.rgba.chunks(row).zip(actual.rgba.chunks(row)) {
        rgba.extend_from_slice(e);
        for (e, a) in e.chunks(4).zip(a.chunks(4)) {
            let d: [u8; 3] = std::array::from_fn(|k| e[k].abs_diff(a[k]).max(e[3].abs_diff(a[3])).saturating_mul(4));
            rgba.extend_from_slice(&[d[0], d[1], d[2], 255]);
        }
        rgba.extend_from_slice(a);
    }
    Picture { width: 3 * expected.width, height: expected.height, rgba }
}

fn read(path: &PathBuf) -> Option<Picture> {
    let bytes = fs::read(path).ok()?;
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    (info.color_type == png::ColorType::Rgba).then_some(Picture { width: info.width, height: info.height, rgba })
}

fn write(path: &PathBuf, picture: &Picture) {
    let file = fs::File::create(path).expect("tests/images can be written");
    let mut encoder = png::Encoder::new(file, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&picture.rgba).expect("the pixels");
}
