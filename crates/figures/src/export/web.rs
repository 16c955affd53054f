//! Pictures as WebP and as JPEG, for pages and slides. They carry no figure.

use image::codecs::jpeg::{JpegEncoder, PixelDensity};
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use tiny_skia::Pixmap;

/// Out of 100. Lines and letters are clean, and the file is still much smaller than a PNG.
const QUALITY: u8 = 92;

/// A picture as WebP, without loss.
///
/// # Errors
/// The reason why the encoder gave up.
pub fn webp(pixmap: Pixmap) -> Result<Vec<u8>, String> {
    let (width, height) = (pixmap.width(), pixmap.height());
    let mut bytes = Vec::new();
    let encoder = WebPEncoder::new_lossless(&mut bytes);
    let rgba = pixmap.take_demultiplied();
    encoder.write_image(&rgba, width, height, ExtendedColorType::Rgba8).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// A picture as JPEG, for paper with its pixels per inch. Transparent pixels become white.
///
/// # Errors
/// The reason why the encoder gave up.
pub fn jpeg(pixmap: &Pixmap, dpi: Option<f64>) -> Result<Vec<u8>, String> {
    // Premultiplied, so white shows through by the complement of alpha.
    let on_white = |p: &tiny_skia::PremultipliedColorU8| [p.red(), p.green(), p.blue()].map(|c| c + (255 - p.alpha()));
    let rgb: Vec<u8> = pixmap.pixels().iter().flat_map(on_white).collect();
    let mut bytes = Vec::new();
    let mut encoder = JpegEncoder::new_with_quality(&mut bytes, QUALITY);
    if let Some(dpi) = dpi.map(f64::round).filter(|dpi| (1.0..=f64::from(u16::MAX)).contains(dpi)) {
        #[expect(clippy::cast_possible_truncation, reason = "a whole number in the range of a JPEG")]
        encoder.set_pixel_density(PixelDensity::dpi(dpi as u16));
    }
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
    fn jpeg_has_its_pixels_per_inch() {
        // JFIF: the version, the unit (0: only a ratio, 1: inches), and the density across and down.
        let of = |dpi| {
            let bytes = jpeg(&Pixmap::new(8, 8).unwrap(), dpi).unwrap();
            let start = bytes.windows(5).position(|w| w == b"JFIF\0").unwrap() + 7;
            <[u8; 5]>::try_from(&bytes[start..start + 5]).unwrap()
        };
        assert_eq!(of(Some(300.0)), [1, 1, 44, 1, 44]);
        assert_eq!([of(None), of(Some(0.2)), of(Some(1e9))], [[0, 0, 1, 0, 1]; 3]);
    }

    #[test]
    fn jpeg_is_about_the_same_and_stands_on_white() {
        let mut pixmap = Pixmap::new(16, 16).unwrap();
        pixmap.fill(Color::from_rgba8(200, 100, 50, 255));
        let back = image::load_from_memory(&jpeg(&pixmap, None).unwrap()).unwrap().to_rgb8();
        assert!(back.pixels().all(|p| p.0.iter().zip([200_u8, 100, 50]).all(|(a, b)| a.abs_diff(b) < 4)));
        let clear = image::load_from_memory(&jpeg(&Pixmap::new(8, 8).unwrap(), None).unwrap()).unwrap().to_rgb8();
        assert!(clear.pixels().all(|p| p.0.iter().all(|c| *c > 250)));
    }
}
