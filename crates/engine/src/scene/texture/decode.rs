//! PNG, JPEG and WebP → texels, within limits that hold before anything is unpacked.

use std::io::Cursor;

use image::metadata::Orientation;
use image::{ColorType, DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};

use super::fault::{Alpha, TextureFault};
use crate::appearance::Texture;
use crate::limits::{MAX_HALVED_TEXELS, MAX_TEXELS, MAX_TEXTURE_METADATA, MAX_TEXTURE_SIDE};

/// The picture in the bytes of a file as it's meant to stand, with its levels of detail. One with more than
/// [`MAX_TEXELS`] is made smaller.
///
/// # Errors
/// [`TextureFault`]. A picture that is too large is refused before it's unpacked.
pub(in crate::scene) fn decode(bytes: &[u8], alpha: Alpha) -> Result<Texture, TextureFault> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(|_| TextureFault::Damaged)?;
    let is_lean = match reader.format() {
        None => return Err(TextureFault::Format),
        // The decoder fills a missing rest with grey. It holds all coefficients of a progressive file.
        Some(ImageFormat::Jpeg) => !is_progressive(bytes).ok_or(TextureFault::Damaged)?,
        Some(format) => format == ImageFormat::Png,
    };
    let mut decoder = decoder_of(reader)?;
    let (width, height) = decoder.dimensions();
    let is_lean = is_lean && matches!(decoder.color_type(), ColorType::L8 | ColorType::Rgb8);
    let most = if is_lean { MAX_HALVED_TEXELS } else { MAX_TEXELS };
    let is_large = width.max(height) > MAX_TEXTURE_SIDE || u64::from(width) * u64::from(height) > most;
    if width == 0 || height == 0 {
        return Err(TextureFault::Damaged);
    }
    if is_large {
        return Err(TextureFault::TooLarge { width, height });
    }
    // 16 bits a channel, and as much again for what a decoder works with.
    let mut limits = Limits::default();
    limits.max_alloc = Some(32 * MAX_TEXELS);
    decoder.set_limits(limits).map_err(|_| TextureFault::TooLarge { width, height })?;
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms).to_exif();
    let picture = DynamicImage::from_decoder(decoder).map_err(|_| TextureFault::Damaged)?;
    let is_halved = u64::from(width) * u64::from(height) > MAX_TEXELS;
    let ([width, height], mut rgba) = match (is_halved, orientation) {
        (false, 1) => ([width, height], picture.into_rgba8().into_raw()),
        (false, _) => upright(picture.into_rgba8().as_raw(), [width, height], 1, orientation),
        (true, _) => {
            let fits = |by: &u32| u64::from(width.div_ceil(*by)) * u64::from(height.div_ceil(*by)) <= MAX_TEXELS;
            let by = (2..).find(fits).unwrap_or(MAX_TEXTURE_SIDE);
            upright(picture.as_bytes(), [width, height], by, orientation)
        }
    };
    for texel in rgba.as_chunks_mut::<4>().0.iter_mut().filter(|texel| texel[3] < 255) {
        texel[3] = match alpha {
            Alpha::Kept => texel[3],
            Alpha::Ignored => 255,
            Alpha::Mask(cutoff) => {
                if f32::from(texel[3]) >= 255.0 * cutoff {
                    255
                } else {
                    0
                }
            }
        };
        let alpha = u32::from(texel[3]);
        for channel in &mut texel[..3] {
            #[expect(clippy::cast_possible_truncation, reason = "a product of shares of 255")]
            let product = ((u32::from(*channel) * alpha + 127) / 255) as u8;
            *channel = product;
        }
    }
    Ok(Texture::flat(width, height, rgba).with_levels())
}

/// Pixels of one byte, three or four as RGBA, each the mean of `by` × `by` of them, turned as Exif says (1 … 8), with
/// their size.
fn upright(bytes: &[u8], size: [u32; 2], by: u32, exif: u8) -> ([u32; 2], Vec<u8>) {
    let small = size.map(|side| side.div_ceil(by));
    // 5 … 8 exchange rows and columns.
    let is_across = exif >= 5;
    let turned = if is_across { [small[1], small[0]] } else { small };
    let channels = bytes.len() / (size[0] as usize * size[1] as usize);
    let mut rgba = Vec::with_capacity(4 * turned[0] as usize * turned[1] as usize);
    for (y, x) in (0..turned[1]).flat_map(|y| (0..turned[0]).map(move |x| (y, x))) {
        let (x, y) = if is_across { (y, x) } else { (x, y) };
        let x = if matches!(exif, 2 | 3 | 7 | 8) { small[0] - 1 - x } else { x };
        let y = if matches!(exif, 3 | 4 | 6 | 7) { small[1] - 1 - y } else { y };
        let (mut sums, mut count) = ([0; 4], 0);
        for row in y * by..size[1].min((y + 1) * by) {
            for column in x * by..size[0].min((x + 1) * by) {
                let texel = &bytes[(row as usize * size[0] as usize + column as usize) * channels..][..channels];
                let texel = if let [grey] = texel { &[*grey; 3] } else { texel };
                sums = [0, 1, 2, 3].map(|k| sums[k] + texel.get(k).map_or(255, |x| u32::from(*x)));
                count += 1;
            }
        }
        #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
        rgba.extend(sums.map(|sum| ((sum + count / 2) / count) as u8));
    }
    (turned, rgba)
}

/// True for a progressive JPEG file; `None` without its last marker, because something is cut off. Goes from marker to
/// marker, since a thumbnail inside has markers of its own.
fn is_progressive(bytes: &[u8]) -> Option<bool> {
    const END: u8 = 0xd9;
    const PROGRESSIVE: u8 = 0xc2;
    let (mut at, mut is_progressive) = (0, false);
    while let Some(next) = bytes[at..].iter().position(|byte| *byte == 0xff) {
        at += next + 1;
        at += match bytes.get(at..) {
            Some([END, ..]) => return Some(is_progressive),
            // Fill bytes, data, and markers without a segment.
            Some([0xff | 0x00 | 0x01 | 0xd0..=0xd8, ..]) => 0,
            Some([marker, high, low, ..]) => {
                is_progressive |= *marker == PROGRESSIVE;
                1 + usize::from(u16::from_be_bytes([*high, *low]))
            }
            _ => return None,
        };
        if at > bytes.len() {
            return None;
        }
    }
    None
}

/// A decoder that has read the head of a file. A PNG's color profile counts against [`MAX_TEXTURE_METADATA`]. It
/// unpacks to a thousand times its size, and texels are taken as sRGB without it.
fn decoder_of(mut reader: ImageReader<Cursor<&[u8]>>) -> Result<impl ImageDecoder, TextureFault> {
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_TEXTURE_METADATA);
    reader.limits(limits);
    reader.into_decoder().map_err(|error| match error {
        ImageError::Unsupported(_) => TextureFault::Format,
        _ => TextureFault::Damaged,
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use image::{ExtendedColorType, ImageEncoder as _};

    use super::*;

    fn png(width: u32, height: u32, texels: &[u8], kind: ExtendedColorType) -> Vec<u8> {
        let mut bytes = Vec::new();
        image::codecs::png::PngEncoder::new(&mut bytes).write_image(texels, width, height, kind).unwrap();
        bytes
    }

    #[test]
    fn a_picture_is_premultiplied_and_has_its_levels() {
        let bytes = png(2, 1, &[200, 100, 50, 255, 200, 100, 50, 128], ExtendedColorType::Rgba8);
        let texture = decode(&bytes, Alpha::Kept).unwrap();
        assert_eq!(texture.levels()[0].rgba, [200, 100, 50, 255, 100, 50, 25, 128]);
        assert_eq!(texture.levels().len(), 2);
    }

    #[test]
    fn sixteen_bits_and_grey_are_read_too() {
        let grey = decode(&png(1, 1, &[77], ExtendedColorType::L8), Alpha::Kept).unwrap();
        assert_eq!(grey.levels()[0].rgba, [77, 77, 77, 255]);
        let deep: Vec<u8> = [0xffff_u16, 0x8080, 0].iter().flat_map(|v| v.to_ne_bytes()).collect();
        let deep = decode(&png(1, 1, &deep, ExtendedColorType::Rgb16), Alpha::Kept).unwrap();
        assert_eq!(deep.levels()[0].rgba, [255, 128, 0, 255]);
    }

    /// The eight orientations of Exif, each as the rows that are seen.
    const SEEN: [(u8, &[&[u8]]); 8] = [
        (1, &[&[1, 2, 3], &[4, 5, 6]]),
        (2, &[&[3, 2, 1], &[6, 5, 4]]),
        (3, &[&[6, 5, 4], &[3, 2, 1]]),
        (4, &[&[4, 5, 6], &[1, 2, 3]]),
        (5, &[&[1, 4], &[2, 5], &[3, 6]]),
        (6, &[&[4, 1], &[5, 2], &[6, 3]]),
        (7, &[&[6, 3], &[5, 2], &[4, 1]]),
        (8, &[&[3, 6], &[2, 5], &[1, 4]]),
    ];

    /// A block of Exif, big-endian, with nothing but an orientation.
    fn exif(orientation: u8) -> Vec<u8> {
        let mut block = b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".to_vec();
        block.extend([orientation, 0, 0, 0, 0, 0, 0]);
        block
    }

    #[test]
    fn a_picture_stands_as_its_camera_was_held() {
        for (orientation, rows) in SEEN {
            let stored: Vec<u8> = [1, 2, 3, 4, 5, 6].map(|grey| grey * 40).to_vec();
            let mut bytes = Vec::new();
            let mut encoder = image::codecs::png::PngEncoder::new(&mut bytes);
            encoder.set_exif_metadata(exif(orientation)).unwrap();
            encoder.write_image(&stored, 3, 2, ExtendedColorType::L8).unwrap();
            let texture = decode(&bytes, Alpha::Kept).unwrap();
            let seen: Vec<u8> = texture.levels()[0].rgba.iter().step_by(4).map(|grey| grey / 40).collect();
            assert_eq!([texture.width(), texture.height()].map(|side| side as usize), [rows[0].len(), rows.len()]);
            assert_eq!(seen, rows.concat(), "{orientation}");
        }
    }

    #[test]
    fn a_picture_of_too_many_texels_is_halved_if_it_can_be_read_in_little_memory() {
        // Columns of 0 and 100 in turns have the mean 50. The last one stands alone.
        let (width, height) = (4097_u32, 4098_u32);
        let stored: Vec<u8> = (0..width * height).map(|i| if i % width % 2 == 0 { 0 } else { 100 }).collect();
        let texture = decode(&png(width, height, &stored, ExtendedColorType::L8), Alpha::Kept).unwrap();
        assert_eq!([texture.width(), texture.height()], [2049, 2049]);
        let rgba = &texture.levels()[0].rgba;
        assert_eq!((&rgba[..4], &rgba[2048 * 4..2049 * 4]), (&[50, 50, 50, 255][..], &[0, 0, 0, 255][..]));
        let pairs: Vec<u8> = stored.iter().flat_map(|grey| [*grey, 255]).collect();
        let clear = png(width, height, &pairs, ExtendedColorType::La8);
        assert_eq!(decode(&clear, Alpha::Kept), Err(TextureFault::TooLarge { width, height }));
    }

    #[test]
    fn what_is_no_whole_picture_is_told_why() {
        assert_eq!(decode(b"v 0 0 0\n", Alpha::Kept), Err(TextureFault::Format));
        assert_eq!(decode(b"", Alpha::Kept), Err(TextureFault::Format));
        // A format that is known to the library and not read here.
        assert_eq!(decode(b"GIF89a\x01\0\x01\0\0\0\0", Alpha::Kept), Err(TextureFault::Format));
        let whole = png(16, 16, &[9; 1024], ExtendedColorType::Rgba8);
        for end in [8, 20, 40, whole.len() - 20] {
            assert!(matches!(decode(&whole[..end], Alpha::Kept), Err(TextureFault::Damaged)), "{end}");
        }
    }

    #[test]
    fn a_picture_that_is_cut_off_anywhere_is_refused_in_every_format() {
        let noise: Vec<u8> = (0..64 * 64 * 3_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        let mut jpeg = Vec::new();
        let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut jpeg, 90);
        encoder.write_image(&noise, 64, 64, ExtendedColorType::Rgb8).unwrap();
        // With a thumbnail in front that has an end of its own.
        let mut segment = vec![0xff, 0xe1, 0, 0];
        segment.extend(&jpeg);
        let length = u16::try_from(segment.len() - 2).unwrap();
        segment[2..4].copy_from_slice(&length.to_be_bytes());
        let mut with_thumbnail = jpeg.clone();
        with_thumbnail.splice(2..2, segment);
        let mut webp = Vec::new();
        let encoder = image::codecs::webp::WebPEncoder::new_lossless(&mut webp);
        encoder.write_image(&noise, 64, 64, ExtendedColorType::Rgb8).unwrap();
        for (name, whole) in [
            ("JPEG", jpeg),
            ("thumbnail", with_thumbnail),
            ("WebP", webp),
            ("PNG", png(64, 64, &noise, ExtendedColorType::Rgb8)),
        ] {
            assert!(decode(&whole, Alpha::Kept).is_ok(), "{name}");
            assert!(decode(&[&whole[..], b"trailing"].concat(), Alpha::Kept).is_ok() || name != "JPEG");
            for tenths in 1..10 {
                let cut = &whole[..whole.len() * tenths / 10];
                assert_eq!(decode(cut, Alpha::Kept), Err(TextureFault::Damaged), "{name} {tenths}");
            }
        }
    }

    #[test]
    fn a_color_profile_that_unpacks_to_too_much_is_left_out() {
        for (profile, is_read) in [(1 << 10, true), (64 << 20, false)] {
            let mut bytes = Vec::new();
            let mut encoder = image::codecs::png::PngEncoder::new(&mut bytes);
            encoder.set_icc_profile(vec![0; profile]).unwrap();
            encoder.write_image(&[9, 8, 7], 1, 1, ExtendedColorType::Rgb8).unwrap();
            let reader = ImageReader::new(Cursor::new(&bytes[..])).with_guessed_format().unwrap();
            assert_eq!(decoder_of(reader).unwrap().icc_profile().unwrap().is_some(), is_read, "{profile}");
            assert_eq!(decode(&bytes, Alpha::Kept).unwrap().levels()[0].rgba, [9, 8, 7, 255]);
        }
    }

    #[test]
    fn a_bomb_is_refused_by_what_it_says_of_itself() {
        let mut bytes = png(1, 1, &[0], ExtendedColorType::L8);
        // Width and height are the first numbers after the name of the first chunk, whose checksum is no longer right
        // then.
        for (width, height) in [(65_535_u32, 1_u32), (16_000, 16_000)] {
            bytes[16..20].copy_from_slice(&width.to_be_bytes());
            bytes[20..24].copy_from_slice(&height.to_be_bytes());
            let sum = crc(&bytes[12..29]);
            bytes[29..33].copy_from_slice(&sum.to_be_bytes());
            assert_eq!(decode(&bytes, Alpha::Kept), Err(TextureFault::TooLarge { width, height }));
        }
    }

    /// The checksum of a chunk (ISO 3309).
    fn crc(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(!0_u32, |crc, byte| {
            (0..8).fold(crc ^ u32::from(*byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 })
        })
    }
}
