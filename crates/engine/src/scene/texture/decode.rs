//! PNG, JPEG and WebP → texels, within limits that hold before anything is unpacked.

use std::io::Cursor;

use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};

use super::fault::{Alpha, TextureFault};
use crate::appearance::Texture;
use crate::limits::{MAX_TEXELS, MAX_TEXTURE_METADATA, MAX_TEXTURE_SIDE};

/// The picture in the bytes of a file, with its levels of detail.
///
/// # Errors
/// [`TextureFault`]. A picture that is too large is refused before it's unpacked.
pub(in crate::scene) fn decode(bytes: &[u8], alpha: Alpha) -> Result<Texture, TextureFault> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(|_| TextureFault::Damaged)?;
    match reader.format() {
        None => return Err(TextureFault::Format),
        // The decoder fills a missing rest with grey.
        Some(ImageFormat::Jpeg) if !has_end(bytes) => return Err(TextureFault::Damaged),
        Some(_) => {}
    }
    let mut decoder = decoder_of(reader)?;
    let (width, height) = decoder.dimensions();
    let is_large = width.max(height) > MAX_TEXTURE_SIDE || u64::from(width) * u64::from(height) > MAX_TEXELS;
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
    let picture = DynamicImage::from_decoder(decoder).map_err(|_| TextureFault::Damaged)?;
    let mut rgba = picture.into_rgba8().into_raw();
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

/// True for a JPEG file that has its last marker, so nothing is cut off. Goes from marker to marker, since a thumbnail
/// inside has one of its own.
fn has_end(bytes: &[u8]) -> bool {
    const END: u8 = 0xd9;
    let mut at = 0;
    while let Some(next) = bytes[at..].iter().position(|byte| *byte == 0xff) {
        at += next + 1;
        at += match bytes.get(at..) {
            Some([END, ..]) => return true,
            // Fill bytes, data, and markers without a segment.
            Some([0xff | 0x00 | 0x01 | 0xd0..=0xd8, ..]) => 0,
            Some([_, high, low, ..]) => 1 + usize::from(u16::from_be_bytes([*high, *low])),
            _ => return false,
        };
        if at > bytes.len() {
            return false;
        }
    }
    false
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
