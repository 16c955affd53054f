//! A picture as PNG with its figure file inside, so the picture always carries the figure.

use std::borrow::Cow;
use std::io::{Cursor, Write as _};

use png::{BitDepth, ColorType, Compression, DecodeOptions, Decoder, DecodingError, Encoder, PixelDimensions, Unit};
use tiny_skia::Pixmap;

use crate::progress::{Activity, Progress};

/// The keyword of the iTXt chunk that holds the figure file.
pub const KEYWORD: &str = "camera-lab-figure";

/// The keyword of the format for the description of a picture.
const DESCRIPTION: &str = "Description";

/// The first bytes of every PNG.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Bytes of packed pixels in a chunk.
const CHUNK: usize = 1 << 20;

/// The reason why a picture can't be written or read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PngError {
    /// The encoder gave up.
    #[error("the image cannot be written as PNG ({0})")]
    Encode(String),
    /// The bytes are a damaged PNG.
    #[error("the PNG is damaged: {0}")]
    Damaged(Damage),
    /// The figure in it exceeds the limit.
    #[error("the figure in this PNG is too long; allowed: at most {limit} bytes")]
    TooLong {
        /// The limit in bytes.
        limit: usize,
    },
    /// The picture contains no figure.
    #[error("this image contains no figure; allowed: a figure file, or an image that camera-lab wrote")]
    NoFigure,
}

/// Damage to a PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Damage {
    /// The file ends early.
    #[error("it ends early")]
    Truncated,
    /// A checksum doesn't match, because bytes have changed on the way.
    #[error("a checksum does not match")]
    Checksum,
    /// The text of the figure can't be unpacked.
    #[error("its text cannot be unpacked")]
    Text,
    /// Its parts contradict the format.
    #[error("its parts contradict the format")]
    Format,
}

impl From<DecodingError> for PngError {
    fn from(error: DecodingError) -> Self {
        Self::Damaged(match error {
            DecodingError::IoError(_) => Damage::Truncated,
            // The decoder's kinds of errors differ only in their messages.
            error if error.to_string().starts_with("CRC error") => Damage::Checksum,
            _ => Damage::Format,
        })
    }
}

/// The PNG of `pixmap`, with `figure` (the text of a figure file) and the description `said` in iTXt chunks. For paper,
/// `dpi` (pixels per inch) goes into a pHYs chunk, as pixels per metre. A resolution too fine or too coarse for that
/// chunk is left out. Opaque pictures have no alpha channel. Pauses after each row.
///
/// *Guarantees*: the same picture and text give the same bytes.
///
/// # Errors
/// [`PngError::Encode`] if the encoder fails or the work is cancelled.
pub async fn encode(
    pixmap: Pixmap,
    figure: &str,
    said: Option<&str>,
    dpi: Option<f64>,
    progress: &Progress,
) -> Result<Vec<u8>, PngError> {
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
    encoder.set_pixel_dims(dpi.and_then(density));
    if !figure.is_empty() {
        encoder.add_itxt_chunk(KEYWORD.to_owned(), figure.to_owned()).map_err(error)?;
    }
    if let Some(said) = said {
        encoder.add_itxt_chunk(DESCRIPTION.to_owned(), said.to_owned()).map_err(error)?;
    }
    let mut writer = encoder.write_header().map_err(error)?;
    progress.begin(Activity::Encoding, height as usize);
    let mut stream = writer.stream_writer_with_size(CHUNK).map_err(error)?;
    for row in data.chunks(data.len() / height as usize) {
        if progress.is_cancelled() {
            return Err(PngError::Encode("cancelled".to_owned()));
        }
        stream.write_all(row).map_err(|e| PngError::Encode(e.to_string()))?;
        progress.advance_and_pause(1).await;
    }
    stream.finish().map_err(error)?;
    writer.finish().map_err(error)?;
    Ok(bytes)
}

/// Pixels per inch as pixels per metre, of which a PNG has 31 bits.
fn density(dpi: f64) -> Option<PixelDimensions> {
    let per_metre = (dpi / 0.0254).round();
    if !(1.0..=f64::from(i32::MAX)).contains(&per_metre) {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a whole number in the range of a PNG")]
    let per_metre = per_metre as u32;
    Some(PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter })
}

/// The figure file in a PNG, of at most `limit` bytes; `None` for a PNG without one.
///
/// # Errors
/// [`PngError::Damaged`] if the bytes aren't a whole PNG, [`PngError::TooLong`] for a longer text, however well it's
/// packed.
pub fn figure_text(bytes: &[u8], limit: usize) -> Result<Option<String>, PngError> {
    // A faulty text of another program doesn't concern us. Only if there's no figure, it may have been the figure's.
    if let Some(text) = text_with(DecodeOptions::default(), bytes, limit)? {
        return Ok(Some(text));
    }
    let mut strict = DecodeOptions::default();
    strict.set_skip_ancillary_crc_failures(false);
    text_with(strict, bytes, limit)
}

fn text_with(options: DecodeOptions, bytes: &[u8], limit: usize) -> Result<Option<String>, PngError> {
    let mut reader = Decoder::new_with_options(Cursor::new(bytes), options).read_info()?;
    if let Some(text) = find(reader.info(), limit)? {
        return Ok(Some(text));
    }
    // Other programs write texts after the pixels.
    reader.finish()?;
    find(reader.info(), limit)
}

fn find(info: &png::Info<'_>, limit: usize) -> Result<Option<String>, PngError> {
    let Some(chunk) = info.utf8_text.iter().find(|chunk| chunk.keyword == KEYWORD) else { return Ok(None) };
    let mut chunk = chunk.clone();
    // A few packed megabytes can hold gigabytes, so a text longer than the limit is never unpacked.
    chunk.decompress_text_with_limit(limit).map_err(|error| match error.to_string() {
        text if text.contains("decompression space") => PngError::TooLong { limit },
        _ => PngError::Damaged(Damage::Text),
    })?;
    let text = chunk.get_text().map_err(|_| PngError::Damaged(Damage::Text))?;
    if text.len() > limit { Err(PngError::TooLong { limit }) } else { Ok(Some(text)) }
}

/// True if the bytes begin like a PNG.
pub fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(SIGNATURE)
}

/// The bytes of the figure file in `bytes`, which are a figure file themselves or a picture that contains one of at
/// most `limit` bytes.
///
/// # Errors
/// [`PngError`] for a picture that's damaged, or contains no figure, or too long a one.
pub fn figure_bytes(bytes: &[u8], limit: usize) -> Result<Cow<'_, [u8]>, PngError> {
    if !is_png(bytes) {
        return Ok(Cow::Borrowed(bytes));
    }
    figure_text(bytes, limit)?.map(|text| Cow::Owned(text.into_bytes())).ok_or(PngError::NoFigure)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::progress::at_once;
    use tiny_skia::{Color, PremultipliedColorU8};

    const LIMIT: usize = 1 << 20;

    /// A PNG with this chunk before its pixels.
    fn with_chunk(kind: [u8; 4], data: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(ColorType::Grayscale);
        let mut writer = encoder.write_header().unwrap();
        writer.write_chunk(png::chunk::ChunkType(kind), data).unwrap();
        writer.write_image_data(&[7]).unwrap();
        writer.finish().unwrap();
        bytes
    }

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
        let bytes = at_once(encode(picture(255), text, None, None, &Progress::default())).unwrap();
        assert_eq!(figure_text(&bytes, LIMIT).unwrap().as_deref(), Some(text));
        assert_eq!(figure_bytes(&bytes, LIMIT).unwrap().as_ref(), text.as_bytes());
        assert_eq!(figure_bytes(text.as_bytes(), LIMIT).unwrap().as_ref(), text.as_bytes());
    }

    #[test]
    fn paper_has_its_pixels_per_metre_and_the_figure_is_there_as_well() {
        let dims = |dpi| {
            let bytes = at_once(encode(picture(255), "near = 1", None, dpi, &Progress::default())).unwrap();
            assert_eq!(figure_text(&bytes, LIMIT).unwrap().as_deref(), Some("near = 1"));
            let reader = Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
            reader.info().pixel_dims.map(|dims| (dims.xppu, dims.yppu, dims.unit == Unit::Meter))
        };
        let of = |per_metre| Some((per_metre, per_metre, true));
        assert_eq!([dims(Some(300.0)), dims(Some(72.0)), dims(None)], [of(11_811), of(2835), None]);
        assert_eq!([dims(Some(1e-3)), dims(Some(1e12)), dims(Some(f64::INFINITY))], [None; 3]);
    }

    #[test]
    fn opaque_pictures_are_rgb_and_others_have_straight_alpha() {
        let (color, data) = pixels(&at_once(encode(picture(255), "", None, None, &Progress::default())).unwrap());
        assert_eq!((color, &data[..6]), (ColorType::Rgb, &[200, 100, 50, 127, 0, 255][..]));
        let (color, data) = pixels(&at_once(encode(picture(128), "", None, None, &Progress::default())).unwrap());
        assert_eq!((color, &data[..8]), (ColorType::Rgba, &[200, 100, 50, 255, 128, 0, 255, 128][..]));
    }

    #[test]
    fn a_figure_behind_the_pixels_is_found() {
        let with = at_once(encode(picture(255), "near the end", None, None, &Progress::default())).unwrap();
        let start = with.windows(4).position(|w| w == b"iTXt").unwrap() - 4;
        let length = 12 + u32::from_be_bytes(with[start..start + 4].try_into().unwrap()) as usize;
        let mut moved = with.clone();
        let chunk: Vec<u8> = moved.drain(start..start + length).collect();
        let end = moved.len() - 12;
        moved.splice(end..end, chunk);
        assert_eq!(figure_text(&moved, LIMIT).unwrap().as_deref(), Some("near the end"));
    }

    #[test]
    fn pictures_without_a_figure_or_without_an_end_are_errors() {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[7]).unwrap();
        assert_eq!(figure_bytes(&bytes, LIMIT), Err(PngError::NoFigure));
        let whole = at_once(encode(picture(255), "text", None, None, &Progress::default())).unwrap();
        for end in [8, 20, 40, 60] {
            assert!(matches!(figure_bytes(&whole[..end], LIMIT), Err(PngError::Damaged(_))), "{end}");
        }
    }

    #[test]
    fn a_text_that_swells_is_refused_and_not_unpacked() {
        // 16 MiB of one letter, packed.
        let mut long = png::text_metadata::ITXtChunk::new(KEYWORD, "#".repeat(16 << 20));
        long.compressed = true;
        long.compress_text().unwrap();
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(ColorType::Grayscale);
        let mut writer = encoder.write_header().unwrap();
        writer.write_text_chunk(&long).unwrap();
        writer.write_image_data(&[7]).unwrap();
        writer.finish().unwrap();
        assert!(bytes.len() < LIMIT);
        assert_eq!(figure_text(&bytes, LIMIT), Err(PngError::TooLong { limit: LIMIT }));
        assert_eq!(figure_text(&bytes, 16 << 20).unwrap().map(|text| text.len()), Some(16 << 20));
        let whole = at_once(encode(picture(255), "text", None, None, &Progress::default())).unwrap();
        assert_eq!(figure_text(&whole, 3), Err(PngError::TooLong { limit: 3 }));
    }

    #[test]
    fn a_figure_whose_checksum_does_not_fit_is_damage() {
        let mut bytes = at_once(encode(picture(255), "near = 1", None, None, &Progress::default())).unwrap();
        let at = bytes.windows(8).position(|w| w == b"near = 1").unwrap();
        bytes[at] ^= 1;
        assert_eq!(figure_text(&bytes, LIMIT), Err(PngError::Damaged(Damage::Checksum)));
        assert_eq!(figure_text(&bytes[..40], LIMIT), Err(PngError::Damaged(Damage::Truncated)));
    }

    #[test]
    fn a_damaged_text_of_another_program_does_not_hide_the_figure() {
        let with = at_once(encode(picture(255), "mine", None, None, &Progress::default())).unwrap();
        let other = with_chunk(*b"tEXt", b"Comment\0theirs");
        let start = other.windows(4).position(|w| w == b"tEXt").unwrap() - 4;
        let length = 12 + u32::from_be_bytes(other[start..start + 4].try_into().unwrap()) as usize;
        let mut chunk = other[start..start + length].to_vec();
        chunk[12] ^= 1;
        let mut both = with.clone();
        both.splice(33..33, chunk);
        assert_eq!(figure_text(&both, LIMIT).unwrap().as_deref(), Some("mine"));
    }
}
