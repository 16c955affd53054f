//! Pictures as WebP and as JPEG, for pages and slides. They carry no figure.

use image::codecs::jpeg::JpegEncoder;
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use tiny_skia::Pixmap;

/// Of 100: lines and letters are clean, and the file is still much smaller than a PNG.
const QUALITY: u8 = 92;

/// A picture as WebP, without loss.
///
/// # Errors
/// Why the encoder gave up.
pub fn webp(pixmap: Pixmap) -> Result<Vec<u8>, String> {
    let (width, height) = (pixmap.width(), pixmap.height());
    let mut bytes = Vec::new();
    let encoder = WebPEncoder::new_lossless(&mut bytes);
    let rgba = pixmap.take_demultiplied();
    encoder.write_image(&rgba, width, height, ExtendedColorType::Rgba8).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// A picture as JPEG; what is transparent becomes white.
///
/// # Errors
/// Why the encoder gave up.
pub fn jpeg(pixmap: &Pixmap) -> Result<Vec<u8>, String> {
    // Premultiplied: white shows through by what alpha lacks.
    let on_white = |p: &tiny_skia::PremultipliedColorU8| [p.red(), p.green(), p.blue()].map(|c| c + (255 - p.alpha()));
    let rgb: Vec<u8> = pixmap.pixels().iter().flat_map(on_white).collect();
    let mut bytes = Vec::new();
    let encoder = JpegEncoder::new_with_quality(&mut bytes, QUALITY);
    encoder
        .write_image(&rgb, pixmap.width(), pixmap.height(), ExtendedColorType::Rgb8)
        .map_err(|error| error.to_string())?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use tiny_skia::{Color, PremultipliedColorU8};

    fn picture() -> Pixmap {
        let mut pixmap = Pixmap::new(16, 8).unwrap();
        pixmap.fill(Color::from_rgba8(200, 100, 50, 255));
        pixmap.pixels_mut()[1] = PremultipliedColorU8::from_rgba(60, 0, 100, 100).unwrap();
        pixmap.pixels_mut()[127] = PremultipliedColorU8::from_rgba(0, 0, 0, 0).unwrap();
        pixmap
    }

    #[test]
    fn webp_loses_nothing() {
        let back = image::load_from_memory(&webp(picture()).unwrap()).unwrap().to_rgba8();
        assert_eq!(back.into_raw(), picture().take_demultiplied());
    }

    #[test]
    fn jpeg_is_about_the_same_and_stands_on_white() {
        let mut pixmap = Pixmap::new(16, 16).unwrap();
        pixmap.fill(Color::from_rgba8(200, 100, 50, 255));
        let back = image::load_from_memory(&jpeg(&pixmap).unwrap()).unwrap().to_rgb8();
        assert!(back.pixels().all(|p| p.0.iter().zip([200_u8, 100, 50]).all(|(a, b)| a.abs_diff(b) < 4)));
        let clear = image::load_from_memory(&jpeg(&Pixmap::new(8, 8).unwrap()).unwrap()).unwrap().to_rgb8();
        assert!(clear.pixels().all(|p| p.0.iter().all(|c| *c > 250)));
    }
}
