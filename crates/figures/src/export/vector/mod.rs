//! Pages of vectors: the list of the things on one, and its writers. The look of a picture is decided before. The
//! writers only express it in their format.

mod embedded;
mod font;
mod pdf;
mod pixels;
mod svg;
mod tex;
mod web_font;

use std::path::Path;
use std::sync::Arc;

use tiny_skia::Pixmap;

use super::format::PictureFormat;
use crate::appearance::Rgba;
use crate::drawing::Anchor;
use crate::text::{self, Element};
pub use embedded::figure_in;
pub use pdf::pdf_of;
pub use pixels::pixels;

/// A page. Its unit is the pixel of the picture. (0, 0) is the upper left corner, and y points down.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Width and height in units.
    pub size: [f32; 2],
    /// Points of paper per unit. A point is 1/72 inch.
    pub points: f32,
    /// The title of the figure.
    pub title: String,
    /// A sentence for readers who can't see it.
    pub description: String,
    /// The language of both, as a tag: `en`, `pt-BR`.
    pub language: &'static str,
    /// The things on it, from back to front.
    pub items: Vec<Item>,
}

/// A thing on a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// Other items in another scale, moved to a corner, and clipped to a rectangle there.
    Group {
        /// The upper left corner, which is (0, 0) in the group.
        corner: [f32; 2],
        /// Units of the page per unit of the group.
        scale: f32,
        /// Left, top, right and bottom of the rectangle, in units of the group.
        clip: [f32; 4],
        /// The things in it. Groups may share them, and a PDF holds shared ones once.
        items: Arc<Vec<Self>>,
    },
    /// A filled area, by the non-zero rule.
    Fill {
        /// Closed contours.
        path: Vec<Element>,
        /// sRGB, with opacity.
        color: Rgba,
    },
    /// A stroke.
    Stroke {
        /// Open or closed lines.
        path: Vec<Element>,
        /// sRGB, with opacity.
        color: Rgba,
        /// In units of the page.
        width: f32,
        /// Lengths of dashes and of the gaps between them, in turn. Empty means none.
        dashes: Vec<f32>,
        /// The length along the path at which the dashes begin, backwards.
        phase: f32,
        /// True if ends and corners are round. Otherwise ends are flat and corners sharp.
        round: bool,
    },
    /// A text.
    Text(PageText),
    /// Pixels, stretched over a rectangle.
    Picture {
        /// The upper left corner.
        corner: [f32; 2],
        /// Width and height.
        size: [f32; 2],
        /// The pixels, premultiplied.
        pixels: Pixmap,
    },
}

/// A text, in which `_c` and `_{abc}` are subscripts, as in [`text`].
#[derive(Clone, Debug, PartialEq)]
pub struct PageText {
    /// The left end of its baseline.
    pub at: [f32; 2],
    /// On one line.
    pub text: String,
    /// Uses mathematical letters, if there are any.
    pub mathematical: bool,
    /// Height of the em.
    pub size: f32,
    /// The colour of its letters.
    pub color: Rgba,
    /// The colour of the halo around them.
    pub halo: Rgba,
    /// The width of the halo's stroke, half of which is outside the letters.
    pub halo_width: f32,
    /// The end that stays in place if another font is wider or narrower.
    pub anchor: Anchor,
}

impl PageText {
    fn outline(&self) -> Vec<Element> {
        text::moved(&text::outline(&self.text, self.size, self.mathematical), self.at)
    }
}

impl Item {
    /// Items in the scale of the page.
    pub fn group(corner: [f32; 2], clip: [f32; 4], items: Vec<Self>) -> Self {
        Self::shared(corner, clip, Arc::new(items))
    }

    /// Items that other groups may have too, in the scale of the page.
    pub fn shared(corner: [f32; 2], clip: [f32; 4], items: Arc<Vec<Self>>) -> Self {
        Self::Group { corner, scale: 1.0, clip, items }
    }

    /// A stroke without dashes.
    pub fn stroke(path: Vec<Element>, color: Rgba, width: f32, round: bool) -> Self {
        Self::Stroke { path, color, width, dashes: Vec::new(), phase: 0.0, round }
    }

    /// A text without a halo, with its anchor at a place.
    pub fn text(text: String, [x, y]: [f32; 2], size: f32, color: Rgba, anchor: Anchor) -> Self {
        let left = match anchor {
            Anchor::Left => 0.0,
            Anchor::Center => 0.5,
            Anchor::Right => 1.0,
        } * text::measure(&text, size, false).width;
        let halo = Rgba::rgba(0, 0, 0, 0);
        Self::Text(PageText {
            at: [x - left, y],
            text,
            mathematical: false,
            size,
            color,
            halo,
            halo_width: 0.0,
            anchor,
        })
    }
}

/// A second file, which the first one refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beside {
    /// Its name, in the folder of the first.
    pub name: String,
    /// The whole content of the file.
    pub bytes: Vec<u8>,
}

/// A page as a file of vectors, with a figure file in it, and the file beside it. `stem` is its name, see [`stem`].
/// `None` if the font can't be cut, or the format is one of pixels.
///
/// *Guarantees*: the same page and figure give the same bytes.
pub fn file(
    page: &Page,
    format: PictureFormat,
    letters: Letters,
    figure: &str,
    stem: &str,
) -> Option<(Vec<u8>, Option<Beside>)> {
    match format {
        PictureFormat::Svg => Some((svg::svg(page, letters, figure).into_bytes(), None)),
        PictureFormat::Pdf => Some((pdf_of(std::slice::from_ref(page), letters, figure)?, None)),
        PictureFormat::Tex => {
            let art = art_of(stem);
            let bytes = pdf_of(&[tex::without_texts(page)], letters, figure)?;
            let beside = Beside { name: format!("{art}.pdf"), bytes };
            Some((tex::tex(page, &art).into_bytes(), Some(beside)))
        }
        PictureFormat::Png | PictureFormat::WebP | PictureFormat::Jpeg => None,
    }
}

/// The name of a file without its extension, in a form in which LaTeX can name the file beside it, because other
/// characters have meanings there.
pub fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' || c == '_' { c } else { '-' }).collect()
}

/// The name, without its extension, of the PDF beside a LaTeX file.
pub fn art_of(stem: &str) -> String {
    format!("{stem}-art")
}

/// The form of letters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Letters {
    /// As text, which users can select, search and edit. The letters that it needs from the fonts go with it.
    #[default]
    Text,
    /// As outlines of the font, which look the same everywhere.
    Outlines,
}

/// Straight pixels of a picture: colours (three bytes each), and opacities if any isn't full.
fn straight(pixels: &Pixmap) -> (Vec<u8>, Option<Vec<u8>>) {
    let mut colors = Vec::with_capacity(3 * pixels.pixels().len());
    let mut opacities = Vec::with_capacity(pixels.pixels().len());
    for pixel in pixels.pixels() {
        let straight = pixel.demultiply();
        colors.extend([straight.red(), straight.green(), straight.blue()]);
        opacities.push(straight.alpha());
    }
    let is_opaque = opacities.iter().all(|opacity| *opacity == 255);
    (colors, (!is_opaque).then_some(opacities))
}

/// A number in its shortest form, to a thousandth of a unit.
fn number(value: f32) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
