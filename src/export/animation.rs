//! Pictures one after the other, as GIF and as APNG.

use tiny_skia::Pixmap;

/// A format of animations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnimationFormat {
    /// 256 colours in each picture; every program plays it.
    Gif,
    /// Every colour; browsers and most viewers play it.
    Apng,
}

impl AnimationFormat {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Gif, Self::Apng];

    /// What people call it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gif => "GIF",
            Self::Apng => "APNG",
        }
    }

    /// What the names of its files end in.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Gif => "gif",
            Self::Apng => "apng",
        }
    }

    /// The format of a name with this ending.
    #[must_use]
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.ending().eq_ignore_ascii_case(ending))
    }
}

/// One unit of a picture's time is so many seconds.
pub const TICK: f64 = 0.01;

/// The file of so many pictures, which begins again at its end. `next` gives each of them, of one size and without transparency, with the ticks of
/// [`TICK`] for which it is shown; of the pictures only one is in memory.
///
/// # Errors
/// Why there is no picture, or why the encoder gave up.
pub fn animation(
    format: AnimationFormat,
    [width, height]: [u32; 2],
    pictures: u32,
    mut next: impl FnMut(u32) -> Result<(Pixmap, u16), String>,
) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    match format {
        AnimationFormat::Gif => {
            let whole = |side: u32| u16::try_from(side).map_err(|_| format!("{side} > 65535"));
            let (width, height) = (whole(width)?, whole(height)?);
            let mut encoder = gif::Encoder::new(&mut bytes, width, height, &[]).map_err(|e| e.to_string())?;
            encoder.set_repeat(gif::Repeat::Infinite).map_err(|e| e.to_string())?;
            for picture in 0..pictures {
                let (pixmap, ticks) = next(picture)?;
                // 1 looks for colours in every pixel and is slow, 30 in few; lines and faces of few colours need no more than this.
                let mut frame = gif::Frame::from_rgb_speed(width, height, &rgb(&pixmap), 10);
                frame.delay = ticks;
                encoder.write_frame(&frame).map_err(|e| e.to_string())?;
            }
        }
        AnimationFormat::Apng => {
            let mut encoder = png::Encoder::new(&mut bytes, width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_depth(png::BitDepth::Eight);
            encoder.set_animated(pictures, 0).map_err(|e| e.to_string())?;
            let mut writer = encoder.write_header().map_err(|e| e.to_string())?;
            for picture in 0..pictures {
                let (pixmap, ticks) = next(picture)?;
                writer.set_frame_delay(ticks, 100).map_err(|e| e.to_string())?;
                writer.write_image_data(&rgb(&pixmap)).map_err(|e| e.to_string())?;
            }
            writer.finish().map_err(|e| e.to_string())?;
        }
    }
    Ok(bytes)
}

fn rgb(picture: &Pixmap) -> Vec<u8> {
    picture.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
}
