//! Charts as pages of vectors, in every picture format.

use std::path::Path;

use super::format::PictureFormat;
use super::vector::{self, Beside, Item, Letters, Page};
use super::{png, web};
use crate::appearance::Rgba;
use crate::chart::{Axis, Chart, Look, Series};
use crate::drawing::Anchor;
use crate::progress::{Progress, at_once};
use crate::text::{Element, literal};

/// The reason why charts can't be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlotError {
    /// They need more pixels than a picture can have.
    #[error("the charts are too large for pixels")]
    TooLarge,
    /// The font can't be cut for a PDF.
    #[error("the font of the charts cannot be written")]
    Font,
    /// The encoder of pixels gave up.
    #[error("the charts cannot be written ({0})")]
    Encode(String),
}

/// A title over rows of charts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// The title of its charts.
    pub title: String,
    /// The charts of a row stand side by side.
    pub rows: Vec<Vec<Chart>>,
}

/// Pixels of a picture per unit of a page.
const ZOOM: f32 = 2.0;
/// Size of a chart in units, which are pixels of CSS.
const WIDTH: f32 = 620.0;
const HEIGHT: f32 = 380.0;
/// Left, top, right and bottom of the axes in a chart. The legend is to the right of them.
const LEFT: f32 = 64.0;
const TOP: f32 = 54.0;
const RIGHT: f32 = 440.0;
const BOTTOM: f32 = 332.0;
/// Height of a block's title.
const TITLE: f32 = 44.0;
/// The length of a tick.
const TICK: f32 = 5.0;

/// The colours of the series, in turn, from Okabe and Ito (2008), with black, darkened so that thin lines are visible
/// on white.
pub const COLORS: [Rgba; 9] = [
    Rgba::rgb(0xe0, 0x8a, 0x00),
    Rgba::rgb(0x56, 0xa5, 0xd9),
    Rgba::rgb(0x00, 0x8a, 0x64),
    Rgba::rgb(0xb5, 0xa3, 0x00),
    Rgba::rgb(0x00, 0x5f, 0xa3),
    Rgba::rgb(0xc1, 0x50, 0x00),
    Rgba::rgb(0xb0, 0x5a, 0x8a),
    Rgba::rgb(0x20, 0x20, 0x20),
    Rgba::rgb(0x80, 0x80, 0x80),
];
const WHITE: Rgba = Rgba::rgb(0xff, 0xff, 0xff);
const BLACK: Rgba = Rgba::rgb(0, 0, 0);
const GREY: Rgba = Rgba::rgb(0x70, 0x70, 0x70);
const GRID: Rgba = Rgba::rgba(0, 0, 0, 0x1f);

/// The file at `path` with some blocks of charts, one below the other, and the file beside it. `language` is the tag of
/// their texts.
///
/// *Guarantees*: the same charts give the same bytes.
///
/// # Errors
/// [`PlotError`]
pub fn encode(
    blocks: &[Block],
    language: &'static str,
    format: PictureFormat,
    path: &Path,
) -> Result<(Vec<u8>, Option<Beside>), PlotError> {
    let page = page(blocks, language);
    if format.is_vector() {
        return vector::file(&page, format, Letters::Text, "", &vector::stem(path)).ok_or(PlotError::Font);
    }
    let pixels = vector::pixels(&page, ZOOM).ok_or(PlotError::TooLarge)?;
    let bytes = match format {
        PictureFormat::WebP => web::webp(pixels),
        PictureFormat::Jpeg => web::jpeg(&pixels, None),
        _ => at_once(png::encode(pixels, "", None, None, &Progress::default())).map_err(|error| error.to_string()),
    };
    Ok((bytes.map_err(PlotError::Encode)?, None))
}

fn page(blocks: &[Block], language: &'static str) -> Page {
    let (mut width, mut y) = (WIDTH, 0.0);
    let mut items = Vec::new();
    for Block { title, rows } in blocks {
        items.push(words(title, [16.0, y + 30.0], 19.0, Anchor::Left));
        y += TITLE;
        for row in rows {
            let mut x = 0.0;
            for chart in row {
                items.push(Item::group([x, y], [0.0, 0.0, WIDTH, HEIGHT], drawn(chart)));
                x += WIDTH;
            }
            width = width.max(x);
            y += HEIGHT;
        }
    }
    let size = [width, y.max(1.0)];
    let [right, bottom] = size;
    let mut ground = line([0.0; 2], [right, 0.0]);
    ground.extend([Element::Line(size), Element::Line([0.0, bottom]), Element::Close]);
    items.insert(0, Item::Fill { path: ground, color: WHITE });
    let title = blocks.iter().map(|block| block.title.as_str()).collect::<Vec<_>>().join("; ");
    Page { size, points: 0.75, title, description: String::new(), language, items }
}

fn drawn(chart: &Chart) -> Vec<Item> {
    let range = chart.range();
    let scale = |k: usize, pixels, most| {
        let axis = chart.axes[k];
        let ends = range[k].map(|end| axis.along(end));
        // Powers of ten are whole, but their logarithms may be a little less.
        let ends = if axis == Axis::Logarithmic { ends.map(f64::round) } else { ends };
        Scale { axis, ends, pixels, most }
    };
    let [x, y] = [scale(0, [LEFT, RIGHT], 9.0), scale(1, [BOTTOM, TOP], 12.0)];
    let mut items = vec![
        words(&chart.title, [LEFT, 20.0], 15.0, Anchor::Left),
        words(&chart.y_label, [16.0, 40.0], 13.0, Anchor::Left),
        words(&chart.x_label, [0.5 * (LEFT + RIGHT), HEIGHT - 10.0], 13.0, Anchor::Center),
    ];
    let (mut grid, mut axes) = (Vec::new(), line([LEFT, TOP], [LEFT, BOTTOM]));
    axes.push(Element::Line([RIGHT, BOTTOM]));
    for (place, here) in x.marks() {
        grid.extend(line([here, TOP], [here, BOTTOM]));
        axes.extend(line([here, BOTTOM], [here, BOTTOM + TICK]));
        items.push(words(&x.axis.written(place, chart.mark), [here, BOTTOM + 18.0], 12.0, Anchor::Center));
    }
    for (place, here) in y.marks() {
        grid.extend(line([LEFT, here], [RIGHT, here]));
        axes.extend(line([LEFT - TICK, here], [LEFT, here]));
        items.push(words(&y.axis.written(place, chart.mark), [LEFT - 9.0, here + 4.0], 12.0, Anchor::Right));
    }
    items.extend([Item::stroke(grid, GRID, 1.0, false), Item::stroke(axes, BLACK, 1.0, false)]);
    for series in &chart.series {
        let places = series.points.iter().map(|p| [x.at(x.axis.along(p[0])), y.at(y.axis.along(p[1]))]);
        let places: Vec<[f32; 2]> = places.filter(|p| p.iter().all(|v| v.is_finite())).collect();
        items.extend(curve(series, &places, false));
    }
    // Shadows don't get a second name.
    let named = chart.series.iter().filter(|series| series.look != Look::Shadow && !series.name.is_empty());
    let mut middle = TOP;
    for series in named {
        let left = RIGHT + 10.0;
        let piece = if matches!(series.look, Look::Dots | Look::Ring) {
            vec![[left + 8.0, middle]]
        } else {
            vec![[left, middle], [left + 16.0, middle]]
        };
        items.extend(curve(series, &piece, true));
        items.push(words(&series.name, [left + 22.0, middle + 4.0], 12.0, Anchor::Left));
        middle += 20.0;
    }
    items
}

/// A line through places, and dots at them. In the legend, lines are without dots.
fn curve(series: &Series, places: &[[f32; 2]], in_legend: bool) -> Vec<Item> {
    let color = series.color.map_or(GREY, |i| COLORS[i % COLORS.len()]);
    let (width, radius) = match series.look {
        Look::Curve => (Some(2.0), Some(3.0)),
        Look::BoldCurve => (Some(4.0), Some(4.0)),
        Look::Line => (Some(1.0), None),
        Look::BoldLine => (Some(3.0), None),
        Look::Dots => (None, Some(6.0)),
        Look::Shadow => (None, Some(3.0)),
        Look::Ring => (None, Some(9.0)),
    };
    let through = places.iter().enumerate().map(|(i, p)| if i == 0 { Element::Move(*p) } else { Element::Line(*p) });
    let through = width.map(|width| Item::stroke(through.collect(), color, width, true));
    // A line of zero length with round ends is a dot.
    let points = places.iter().flat_map(|place| line(*place, *place)).collect();
    let color = if series.look == Look::Shadow { color.with_alpha(0x4d) } else { color };
    let dots = radius.filter(|_| !(in_legend && width.is_some()));
    through.into_iter().chain(dots.map(|radius| Item::stroke(points, color, 2.0 * radius, true))).collect()
}

fn line(from: [f32; 2], to: [f32; 2]) -> Vec<Element> {
    vec![Element::Move(from), Element::Line(to)]
}

fn words(text: &str, at: [f32; 2], size: f32, anchor: Anchor) -> Item {
    Item::text(literal(text), at, size, BLACK, anchor)
}

/// An axis on the page.
struct Scale {
    axis: Axis,
    /// The places on the axis at its ends.
    ends: [f64; 2],
    /// The ends on the page.
    pixels: [f32; 2],
    /// The greatest number of marks.
    most: f64,
}

impl Scale {
    #[expect(clippy::cast_possible_truncation, reason = "a share of the axis")]
    fn at(&self, place: f64) -> f32 {
        let ([low, high], [from, to]) = (self.ends, self.pixels);
        from + ((place - low) / (high - low)) as f32 * (to - from)
    }

    /// The marked places, on the axis and on the page.
    #[expect(clippy::cast_possible_truncation, reason = "a small number of marks")]
    fn marks(&self) -> impl Iterator<Item = (f64, f32)> {
        let [low, high] = self.ends;
        let step = self.axis.step(high - low, self.most);
        let first = (low / step).ceil() as i64;
        (first..)
            .map(move |k| k as f64 * step)
            .take_while(move |place| *place <= high)
            .map(|place| (place, self.at(place)))
    }
}
