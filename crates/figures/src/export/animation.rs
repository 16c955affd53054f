//! Pictures one after the other, as GIF and as APNG.

use std::collections::BTreeMap;

use tiny_skia::{Pixmap, PremultipliedColorU8};

crate::listed! {
    /// A format of animations.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum AnimationFormat {
        /// 256 colours in each picture. Every program plays it.
        Gif = "GIF",
        /// Every colour. Browsers and most viewers play it.
        Apng = "APNG",
    }
    /// Its common name.
    pub fn name
}

impl AnimationFormat {
    /// The extension of its files.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Gif => "gif",
            Self::Apng => "apng",
        }
    }

    /// The format of a name with this ending.
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.ending().eq_ignore_ascii_case(ending))
    }
}

/// The reason why there's no animation.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AnimationError {
    /// One of its pictures couldn't be made, or was cancelled.
    #[error("an image is missing")]
    NoPicture,
    /// The encoder gave up.
    #[error("{0}")]
    Encode(String),
}

/// One unit of a picture's time, in seconds.
pub const TICK: f64 = 0.01;

/// Encodes pictures as a file that loops. `next` returns each of them, of one size and without transparency, with its
/// duration in ticks of [`TICK`]. Only one of the pictures is in memory. Pauses when `next` does.
///
/// # Errors
/// [`AnimationError`].
pub async fn animation(
    format: AnimationFormat,
    [width, height]: [u32; 2],
    pictures: u32,
    mut next: impl AsyncFnMut(u32) -> Option<(Pixmap, u16)>,
) -> Result<Vec<u8>, AnimationError> {
    let encode = |why: String| AnimationError::Encode(why);
    let mut bytes = Vec::new();
    match format {
        AnimationFormat::Gif => {
            let whole = |side: u32| u16::try_from(side).map_err(|_| encode(format!("{side} > 65535")));
            let (width, height) = (whole(width)?, whole(height)?);
            let mut encoder = gif::Encoder::new(&mut bytes, width, height, &[]).map_err(|e| encode(e.to_string()))?;
            encoder.set_repeat(gif::Repeat::Infinite).map_err(|e| encode(e.to_string()))?;
            for picture in 0..pictures {
                let (pixmap, ticks) = next(picture).await.ok_or(AnimationError::NoPicture)?;
                let (palette, indices) = indexed(&pixmap);
                let mut frame = gif::Frame::from_palette_pixels(width, height, indices, palette, None);
                frame.delay = ticks;
                encoder.write_frame(&frame).map_err(|e| encode(e.to_string()))?;
            }
        }
        AnimationFormat::Apng => {
            let mut encoder = png::Encoder::new(&mut bytes, width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_depth(png::BitDepth::Eight);
            encoder.set_animated(pictures, 0).map_err(|e| encode(e.to_string()))?;
            let mut writer = encoder.write_header().map_err(|e| encode(e.to_string()))?;
            for picture in 0..pictures {
                let (pixmap, ticks) = next(picture).await.ok_or(AnimationError::NoPicture)?;
                writer.set_frame_delay(ticks, 100).map_err(|e| encode(e.to_string()))?;
                writer.write_image_data(&rgb(&pixmap)).map_err(|e| encode(e.to_string()))?;
            }
            writer.finish().map_err(|e| encode(e.to_string()))?;
        }
    }
    Ok(bytes)
}

/// The greatest number of colours in a GIF's picture.
const COLORS: usize = 256;

/// The most frequent colours, unchanged, and for each pixel the nearest of them. A quantiser that looks for averages
/// would give thin green and blue lines one colour, because there's so little of each.
fn indexed(picture: &Pixmap) -> (Vec<u8>, Vec<u8>) {
    let color = |p: &PremultipliedColorU8| [p.red(), p.green(), p.blue()];
    // Neighbouring pixels are mostly equal, so their colour is looked up once.
    let runs = || picture.pixels().chunk_by(|a, b| a == b).map(|run| (color(&run[0]), run.len()));
    let mut counts: BTreeMap<[u8; 3], usize> = BTreeMap::new();
    runs().for_each(|(color, length)| *counts.entry(color).or_default() += length);
    let mut palette: Vec<([u8; 3], usize)> = counts.iter().map(|(color, count)| (*color, *count)).collect();
    // Equally frequent colours are ordered by their numbers, so that the same picture gives the same bytes.
    palette.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
    palette.truncate(COLORS);
    let distance =
        |a: [u8; 3], b: [u8; 3]| a.into_iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>();
    let nearest = |color: [u8; 3]| {
        let best = palette.iter().enumerate().min_by_key(|(_, (other, _))| distance(color, *other));
        best.and_then(|(index, _)| u8::try_from(index).ok()).unwrap_or(0)
    };
    let places: BTreeMap<[u8; 3], u8> = counts.keys().map(|color| (*color, nearest(*color))).collect();
    let index = |color| places.get(&color).copied().unwrap_or(0);
    let indices = runs().flat_map(|(color, length)| std::iter::repeat_n(index(color), length)).collect();
    (palette.into_iter().flat_map(|(color, _)| color).collect(), indices)
}

fn rgb(picture: &Pixmap) -> Vec<u8> {
    picture.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]
    use super::*;
    use crate::progress::at_once;

    /// A gradient of thousands of colours, with one line of pure green and one of pure blue.
    #[test]
    fn thin_lines_keep_their_colours_in_a_gif() {
        let mut picture = Pixmap::new(64, 64).unwrap();
        for (i, pixel) in picture.pixels_mut().iter_mut().enumerate() {
            let [x, y] = [i % 64, i / 64].map(|v| u8::try_from(v).unwrap());
            let [r, g, b] = match (x, y) {
                (10, _) => [0, 128, 90],
                (20, _) => [0, 100, 170],
                _ => [200 + x / 2, 200 + y / 2, 220],
            };
            *pixel = PremultipliedColorU8::from_rgba(r, g, b, 255).unwrap();
        }
        let bytes =
            at_once(animation(AnimationFormat::Gif, [64, 64], 1, async |_| Some((picture.clone(), 4)))).unwrap();
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(&bytes[..]).unwrap();
        let frame = decoder.read_next_frame().unwrap().unwrap();
        let at = |x: usize, y: usize| frame.buffer[4 * (64 * y + x)..][..3].to_vec();
        assert_eq!((at(10, 5), at(20, 50)), (vec![0, 128, 90], vec![0, 100, 170]));
        assert!(at(40, 40)[0].abs_diff(220) < 16, "{:?}", at(40, 40));
    }
}
