//! [`Request`](crate::views::Request) → pixels. This is the only place that makes pictures, so the screen, the output
//! of `render` and the exports of the window are the same, byte for byte.

mod animation;
mod compared;
mod composite;
mod cost;
mod error;
pub mod exact_image;
mod exact_width;
mod export_spec;
mod family;
mod file;
mod handout;
mod handout_formula;
mod plate;
mod render_report;
mod renderer;
pub mod shadow_truth;
mod sweep;
pub mod tiles;
mod triangle;
mod vector_faces;
mod vectors;

use tiny_skia::{IntSize, Pixmap};

use crate::appearance::{Rgba, Texture};
use crate::drawing::Drawing;
use crate::export::crop::cropped;
use crate::export::png::{self, PngError};
use crate::export::sheet::{Layout, sheet};
use crate::progress::Progress;
use crate::views::Arrangement;
pub use animation::{Animation, FilmFormat};
pub use composite::{Composite, Crowded, NoComposite, OnPaper, gap};
pub use cost::{Costs, PricedFace};
pub use error::PictureError;
pub use export_spec::ExportSpec;
pub use family::{Family, SheetSize, have_same_scene, members};
pub use file::{Beside, FileOptions, Metadata, PER_INCH, PictureFile, assembled, file, file_beside};
pub use handout::{Handout, HandoutEntry, HandoutPart, Paragraph};
pub use handout_formula::FormulaPart;
pub use render_report::RenderReport;
pub use renderer::Renderer;
pub use sweep::Sweep;
pub use triangle::{FollowedTriangle, Tested, TrianglePixels};
pub use vectors::{Faces, NoAreas};

/// A finished picture, without pixels until something is drawn on it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pixels {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
}

impl Pixels {
    /// A picture of opaque pixels, 4 bytes each. `None` if their number isn't that of the size.
    pub fn opaque([width, height]: [u32; 2], rgba: Vec<u8>) -> Option<Self> {
        (rgba.len() as u64 == 4 * u64::from(width) * u64::from(height)).then_some(Self { width, height, rgba })
    }

    /// Pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Premultiplied RGBA, rows from the top.
    pub fn rgba(&self) -> &[u8] {
        &self.rgba
    }

    /// The picture without the empty background around its content, except for a margin in pixels.
    pub fn cropped(mut self, margin: u32) -> Self {
        self.take_pixmap().map_or_else(Self::default, |pixmap| cropped(pixmap, margin).0.into())
    }

    /// The picture as a PNG with a figure file in it, with the description `said`, and with the number of pixels per
    /// inch of its paper. Pauses after each row.
    ///
    /// *Guarantees*: the same picture and text give the same bytes.
    ///
    /// # Errors
    /// [`PngError::Encode`] for a picture without pixels, and if the encoder fails or the work is cancelled.
    pub async fn into_png(
        mut self,
        figure: &str,
        said: Option<&str>,
        dpi: Option<f64>,
        progress: &Progress,
    ) -> Result<Vec<u8>, PngError> {
        let pixmap = self.take_pixmap().ok_or_else(|| PngError::Encode("no pixels".to_owned()))?;
        png::encode(pixmap, figure, said, dpi, progress).await
    }

    /// Pictures at their places on a sheet with a background. `None` if the sheet would be empty or too large for
    /// memory.
    fn arranged(pictures: Vec<Self>, layout: &Layout, ground: Rgba) -> Option<Self> {
        let pixmaps: Option<Vec<Pixmap>> = pictures.into_iter().map(|mut picture| picture.take_pixmap()).collect();
        sheet(&pixmaps?, layout, ground).map(Self::from)
    }

    /// Width and height.
    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The pixels, without copying them. The picture has none afterwards.
    fn take_pixmap(&mut self) -> Option<Pixmap> {
        let Self { width, height, rgba } = std::mem::take(self);
        Pixmap::from_vec(rgba, IntSize::from_wh(width, height)?)
    }

    fn into_texture(self) -> Texture {
        let Self { width, height, rgba } = self;
        Texture::flat(width, height, rgba)
    }
}

impl Composite {
    /// The places of its pictures, which may be cropped to these sizes. `None` if there are none, or too many pixels.
    fn layout(&self, sizes: &[[u32; 2]], crop: bool) -> Option<Layout> {
        if let Some(grid) = &self.grid {
            let least = if crop { [0, 0] } else { grid.least };
            return Layout::grid(sizes, grid.columns, [self.gap, grid.below], least);
        }
        layout(sizes, self.arrangement, self.gap)
    }

    /// The captions under each row, each with the corner of its strip.
    fn strips(&self, layout: &Layout, sizes: &[[u32; 2]]) -> Vec<([u32; 2], Drawing)> {
        let Some(grid) = self.grid.as_ref().filter(|grid| grid.below > 0) else { return Vec::new() };
        let unit = |pixels: u32| pixels as f32;
        let cells: Vec<(usize, f32, f32, u32)> = (0..)
            .zip(layout.corners.iter().zip(sizes))
            .map(|(place, ([left, top], [width, height]))| (place, unit(*left), unit(*width), top + height))
            .collect();
        let strip = |row: &[(usize, f32, f32, u32)]| {
            let top = row.first()?.3;
            let row: Vec<(usize, f32, f32)> =
                row.iter().map(|(place, left, width, _)| (*place, *left, *width)).collect();
            let size = [layout.size[0], grid.below.min(layout.size[1].checked_sub(top)?)];
            Some(([0, top], grid.captions.strip(&row, size)))
        };
        cells.chunks(grid.columns.max(1)).filter_map(strip).collect()
    }
}

/// The places of pictures of these sizes. `None` if there are none, or too many pixels.
fn layout(sizes: &[[u32; 2]], arrangement: Arrangement, gap: u32) -> Option<Layout> {
    let with_rest = |rest: Layout, all: fn(&[[u32; 2]], u32) -> Option<Layout>| {
        Some(all(&[*sizes.first()?, rest.size], gap)?.ending_in(&rest))
    };
    match (arrangement, sizes) {
        (Arrangement::Row, _) | (Arrangement::Above | Arrangement::Beside, [_]) => Layout::row(sizes, gap),
        (Arrangement::Column, _) => Layout::column(sizes, gap),
        (Arrangement::Above | Arrangement::Beside, []) => None,
        (Arrangement::Above, [_, rest @ ..]) => with_rest(Layout::row(rest, gap)?, Layout::column),
        (Arrangement::Beside, [_, rest @ ..]) => with_rest(Layout::column(rest, gap)?, Layout::row),
    }
}

impl From<Pixmap> for Pixels {
    fn from(pixmap: Pixmap) -> Self {
        Self { width: pixmap.width(), height: pixmap.height(), rgba: pixmap.take() }
    }
}
