//! A picture as PNG, with the figure file that it shows inside: whoever has the picture has the figure.

use std::borrow::Cow;
use std::io::Cursor;

use png::{BitDepth, ColorType, Compression, Decoder, Encoder};
use tiny_skia::Pixmap;

/// The keyword of the iTXt chunk that holds the figure file.
pub const KEYWORD: &str = "camera-lab-figure";

/// The first bytes of every PNG.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Why a picture cannot be written or read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PngError {
    /// The encoder gave up.
    #[error("the picture cannot be encoded: {0}")]
    Encode(String),
    /// The bytes are a damaged PNG.
    #[error("damaged PNG: {0}")]
    Damaged(String),
    /// The picture holds no figure.
    #[error("the PNG holds no figure")]
    NoFigure,
}

/// The PNG of `pixmap`, with `figure` (the text of a figure file) in an iTXt chunk. Opaque pictures have no alpha channel.
///
/// *Guarantees*: the same picture and text give the same bytes.
///
/// # Errors
/// [`PngError::Encode`] when the encoder fails.
pub fn encode(pixmap: Pixmap, figure: &str) -> Result<Vec<u8>, PngError> {
    let error = |e: png::EncodingError| PngError::Encode(e.to_string());
    let (width, height) = (pixmap.width(), pixmap.height());
    let opaque = pixmap.pixels().iter().all(|p| p.alpha() == u8::MAX);
    let rgba = pixmap.take_demultiplied();
    let (color, data) = if opaque {
        (ColorType::Rgb, rgba.as_chunks::<4>().0.iter().flat_map(|p| [p[0], p[1], p[2]]).collect())
    } else {
        (ColorType::Rgba, rgba)
    };
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.add_itxt_chunk(KEYWORD.to_owned(), figure.to_owned()).map_err(error)?;
    let mut writer = encoder.write_header().map_err(error)?;
    writer.write_image_data(&data).map_err(error)?;
    writer.finish().map_err(error)?;
    Ok(bytes)
}

/// The figure file in a PNG; `None` for a PNG without one.
///
/// # Errors
/// [`PngError::Damaged`] when the bytes are not a whole PNG.
pub fn figure_text(bytes: &[u8]) -> Result<Option<String>, PngError> {
    let error = |e: png::DecodingError| PngError::Damaged(e.to_string());
    let mut reader = Decoder::new(Cursor::new(bytes)).read_info().map_err(error)?;
    if let Some(text) = find(reader.info())? {
        return Ok(Some(text));
    }
    // Other programs write texts behind the pixels.
    reader.finish().map_err(error)?;
    find(reader.info())
}

fn find(info: &png::Info<'_>) -> Result<Option<String>, PngError> {
    let chunk = info.utf8_text.iter().find(|chunk| chunk.keyword == KEYWORD);
    chunk.map(png::text_metadata::ITXtChunk::get_text).transpose().map_err(|e| PngError::Damaged(e.to_string()))
}

/// The bytes of the figure file in `bytes`, which are a figure file themselves or a picture that holds one.
///
/// # Errors
/// [`PngError`] for a picture that is damaged or holds no figure.
pub fn figure_bytes(bytes: &[u8]) -> Result<Cow<'_, [u8]>, PngError> {
    if !bytes.starts_with(SIGNATURE) {
        return Ok(Cow::Borrowed(bytes));
    }
    figure_text(bytes)?.map(|text| Cow::Owned(text.into_bytes())).ok_or(PngError::NoFigure)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use tiny_skia::{Color, PremultipliedColorU8};

    fn picture(alpha: u8) -> Pixmap {
        let mut pixmap = Pixmap::new(3, 2).unwrap();
        pixmap.fill(Color::from_rgba8(200, 100, 50, 255));
        pixmap.pixels_mut()[1] = PremultipliedColorU8::from_rgba(alpha / 2, 0, alpha, alpha).unwrap();
        pixmap
    }

    fn pixels(bytes: &[u8]) -> (ColorType, Vec<u8>) {
        let mut reader = Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        (info.color_type, data)
    }

    #[test]
    fn the_figure_comes_back_with_accents_and_line_ends() {
        let text = "[camera] # câmera θ\nnear = 1\r\n";
        let bytes = encode(picture(255), text).unwrap();
        assert_eq!(figure_text(&bytes).unwrap().as_deref(), Some(text));
        assert_eq!(figure_bytes(&bytes).unwrap().as_ref(), text.as_bytes());
        assert_eq!(figure_bytes(text.as_bytes()).unwrap().as_ref(), text.as_bytes());
    }

    #[test]
    fn opaque_pictures_are_rgb_and_others_have_straight_alpha() {
        let (color, data) = pixels(&encode(picture(255), "").unwrap());
        assert_eq!((color, &data[..6]), (ColorType::Rgb, &[200, 100, 50, 127, 0, 255][..]));
        let (color, data) = pixels(&encode(picture(128), "").unwrap());
        assert_eq!((color, &data[..8]), (ColorType::Rgba, &[200, 100, 50, 255, 128, 0, 255, 128][..]));
    }

    #[test]
    fn a_figure_behind_the_pixels_is_found() {
        let with = encode(picture(255), "near the end").unwrap();
        let start = with.windows(4).position(|w| w == b"iTXt").unwrap() - 4;
        let length = 12 + u32::from_be_bytes(with[start..start + 4].try_into().unwrap()) as usize;
        let mut moved = with.clone();
        let chunk: Vec<u8> = moved.drain(start..start + length).collect();
        let end = moved.len() - 12;
        moved.splice(end..end, chunk);
        assert_eq!(figure_text(&moved).unwrap().as_deref(), Some("near the end"));
    }

    #[test]
    fn pictures_without_a_figure_or_without_an_end_are_errors() {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[7]).unwrap();
        assert_eq!(figure_bytes(&bytes), Err(PngError::NoFigure));
        let whole = encode(picture(255), "text").unwrap();
        for end in [8, 20, 40, 60] {
            assert!(matches!(figure_bytes(&whole[..end]), Err(PngError::Damaged(_))), "{end}");
        }
    }
}
