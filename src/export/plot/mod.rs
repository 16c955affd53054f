//! Charts as SVG, PDF or PNG, drawn by one plotting library, in the bundled font.
//!
//! | file | purpose |
//! | --- | --- |
//! | `pdf` | one page of PDF as a back end of the plotting library |

mod pdf;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;

use crate::appearance::Rgba;
use crate::chart::{Axis, Chart, Look, Series};

/// A file of charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlotFormat {
    /// Vector, for pages.
    Svg,
    /// Pixels.
    Png,
    /// Vector, for print; letters are outlines.
    Pdf,
}

impl PlotFormat {
    /// Each with the ending of its files.
    pub const ALL: [(&'static str, Self); 3] = [("svg", Self::Svg), ("png", Self::Png), ("pdf", Self::Pdf)];

    /// The format of a file with this ending.
    #[must_use]
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(e, _)| e.eq_ignore_ascii_case(ending)).map(|(_, format)| format)
    }
}

/// Why charts cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlotError {
    /// The plotting library gave up.
    #[error("the charts cannot be drawn ({0})")]
    Drawing(String),
}

/// A title over rows of charts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// The title of its charts.
    pub title: String,
    /// The charts of a row stand side by side.
    pub rows: Vec<Vec<Chart>>,
}

/// Width of a chart in units, of which an SVG has as many pixels; a PNG has twice as many.
const WIDTH: u32 = 620;
/// Height of a chart.
const HEIGHT: u32 = 380;
/// Height of a block's title.
const TITLE: u32 = 44;
/// The colours of the series, in turn: Okabe and Ito (2008), with black, darkened so that thin lines are seen on white.
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
const GREY: RGBColor = RGBColor(0x70, 0x70, 0x70);
const FONT: &str = "DejaVu Sans";

/// The file of some blocks of charts, one below the other.
///
/// *Guarantees*: the same charts give the same bytes.
///
/// # Errors
/// [`PlotError`] where the library or the encoder gives up.
pub fn encode(blocks: &[Block], format: PlotFormat) -> Result<Vec<u8>, PlotError> {
    if !has_font() {
        return Err(PlotError::Drawing("font".to_owned()));
    }
    let height: u32 = blocks.iter().map(|block| TITLE + rows(block) * HEIGHT).sum();
    let size = (columns(blocks) * WIDTH, height.max(1));
    match format {
        PlotFormat::Svg => {
            let mut svg = String::new();
            draw(SVGBackend::with_string(&mut svg, size).into_drawing_area(), blocks, 1)?;
            Ok(svg.into_bytes())
        }
        PlotFormat::Pdf => {
            let mut content = pdf::Content::new(size);
            draw(pdf::PdfBackend::new(&mut content).into_drawing_area(), blocks, 1)?;
            Ok(content.finish())
        }
        PlotFormat::Png => {
            let (width, height) = (2 * size.0, 2 * size.1);
            let mut rgb = vec![0; 3 * width as usize * height as usize];
            draw(BitMapBackend::with_buffer(&mut rgb, (width, height)).into_drawing_area(), blocks, 2)?;
            pixels(&rgb, (width, height)).map_err(|e| PlotError::Drawing(e.to_string()))
        }
    }
}

/// Gives the bundled font to the library.
#[cfg(not(target_arch = "wasm32"))]
fn has_font() -> bool {
    use plotters::style::{FontStyle, register_font};
    register_font(FONT, FontStyle::Normal, crate::text::FONT_BYTES).is_ok()
}

/// In a browser the library has the fonts of the page.
#[cfg(target_arch = "wasm32")]
fn has_font() -> bool {
    true
}

/// Without a figure inside: a plot is not one.
fn pixels(rgb: &[u8], (width, height): (u32, u32)) -> Result<Vec<u8>, ::png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, width, height);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(rgb)?;
    Ok(file)
}

fn rows(block: &Block) -> u32 {
    u32::try_from(block.rows.len()).unwrap_or(u32::MAX)
}

/// The number of charts in the longest row, at least 1.
fn columns(blocks: &[Block]) -> u32 {
    let longest = blocks.iter().flat_map(|block| &block.rows).map(Vec::len).max().unwrap_or(1);
    u32::try_from(longest).unwrap_or(u32::MAX).max(1)
}

/// A drawing area of any kind of file.
type Area<DB> = DrawingArea<DB, Shift>;

/// `zoom`: pixels per unit.
fn draw<DB: DrawingBackend>(root: Area<DB>, blocks: &[Block], zoom: u32) -> Result<(), PlotError> {
    let error = |e: DrawingAreaErrorKind<DB::ErrorType>| PlotError::Drawing(e.to_string());
    root.fill(&WHITE).map_err(error)?;
    let mut rest = root.clone();
    let columns = columns(blocks) as usize;
    for block in blocks {
        let (title, below) = rest.split_vertically(TITLE * zoom);
        let (charts, below) = below.split_vertically(HEIGHT * zoom * rows(block));
        let style = (FONT, 19 * zoom).into_font().color(&BLACK);
        let (x, y) = (i32::try_from(16 * zoom).unwrap_or(0), i32::try_from(14 * zoom).unwrap_or(0));
        title.draw_text(&block.title, &style, (x, y)).map_err(error)?;
        for (charts, row) in block.rows.iter().zip(charts.split_evenly((block.rows.len(), 1))) {
            for (chart, area) in charts.iter().zip(row.split_evenly((1, columns))) {
                draw_chart(&area, chart, zoom).map_err(error)?;
            }
        }
        rest = below;
    }
    root.present().map_err(error)
}

fn draw_chart<DB: DrawingBackend>(
    area: &Area<DB>,
    chart: &Chart,
    zoom: u32,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let range = chart.range();
    let [x, y] = [0, 1].map(|k| {
        let [low, high] = range[k].map(|end| chart.axes[k].along(end));
        match chart.axes[k] {
            Axis::Logarithmic => Places { low: low.round(), high: high.round(), axis: Axis::Logarithmic },
            Axis::Linear => Places { low, high, axis: Axis::Linear },
        }
    });
    let written = |k: usize| move |place: &f64| chart.axes[k].written(*place, chart.mark);
    let [x_mark, y_mark] = [written(0), written(1)];
    let letters = |size: u32| (FONT, size * zoom).into_font();
    let mut plot = ChartBuilder::on(area)
        .caption(&chart.title, letters(15))
        .margin(8 * zoom)
        .margin_right(180 * zoom)
        .x_label_area_size(42 * zoom)
        .y_label_area_size(64 * zoom)
        .build_cartesian_2d(x, y)?;
    plot.configure_mesh()
        .x_labels(9)
        .y_labels(12)
        .x_label_formatter(&x_mark)
        .y_label_formatter(&y_mark)
        .x_desc(&chart.x_label)
        .y_desc(&chart.y_label)
        .label_style(letters(12))
        .axis_desc_style(letters(13))
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .draw()?;
    for series in &chart.series {
        draw_series(&mut plot, series, chart.axes, zoom)?;
    }
    draw_legend(area, chart, zoom)
}

fn draw_series<DB: DrawingBackend>(
    plot: &mut ChartContext<'_, DB, Cartesian2d<Places, Places>>,
    series: &Series,
    axes: [Axis; 2],
    zoom: u32,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let color = color_of(series);
    let points = || series.points.iter().map(|p| (axes[0].along(p[0]), axes[1].along(p[1])));
    let line = match series.look {
        Look::Curve => Some(color.stroke_width(2 * zoom)),
        Look::BoldCurve => Some(color.stroke_width(4 * zoom)),
        Look::Line => Some(color.stroke_width(zoom)),
        Look::BoldLine => Some(color.stroke_width(3 * zoom)),
        Look::Dots | Look::Shadow => None,
    };
    if let Some(line) = line {
        plot.draw_series(LineSeries::new(points(), line))?;
    }
    let radius = match series.look {
        Look::Curve => 3,
        Look::BoldCurve => 4,
        Look::Dots => 6,
        Look::Shadow => 3,
        Look::Line | Look::BoldLine => return Ok(()),
    };
    let fill = if series.look == Look::Shadow { color.mix(0.3) } else { color.to_rgba() };
    plot.draw_series(points().map(|p| Circle::new(p, radius * zoom, fill.filled())))?;
    Ok(())
}

/// To the right of the chart: the name of each series beside a piece of it. Shadows are not named again.
fn draw_legend<DB: DrawingBackend>(
    area: &Area<DB>,
    chart: &Chart,
    zoom: u32,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let zoom_i = i32::try_from(zoom).unwrap_or(1);
    let left = i32::try_from(WIDTH - 174).unwrap_or(0) * zoom_i;
    for (i, series) in chart.series.iter().filter(|series| series.look != Look::Shadow).enumerate() {
        let y = (40 + 20 * i32::try_from(i).unwrap_or(0)) * zoom_i;
        let color = color_of(series);
        let middle = y + 6 * zoom_i;
        if series.look == Look::Dots {
            area.draw(&Circle::new((left + 8 * zoom_i, middle), 5 * zoom, color.filled()))?;
        } else {
            area.draw(&PathElement::new(
                vec![(left, middle), (left + 16 * zoom_i, middle)],
                color.stroke_width(if matches!(series.look, Look::BoldCurve | Look::BoldLine) { 4 } else { 2 } * zoom),
            ))?;
        }
        let style = (FONT, 12 * zoom).into_font().color(&BLACK);
        area.draw_text(&series.name, &style, (left + 22 * zoom_i, y))?;
    }
    Ok(())
}

fn color_of(series: &Series) -> RGBColor {
    series.color.map_or(GREY, |i| {
        let Rgba { r, g, b, .. } = COLORS[i % COLORS.len()];
        RGBColor(r, g, b)
    })
}

/// The places along an axis: logarithms, or the numbers themselves.
#[derive(Clone, Copy)]
struct Places {
    low: f64,
    high: f64,
    axis: Axis,
}

impl Ranged for Places {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    #[expect(clippy::cast_possible_truncation, reason = "a place in a picture")]
    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let share = (value - self.low) / (self.high - self.low);
        limit.0 + (f64::from(limit.1 - limit.0) * share).round() as i32
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "a small number of marks")]
    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let length = self.high - self.low;
        let most = hint.max_num_points() as f64;
        let step = self.axis.step(length, most);
        let first = (self.low / step).ceil() as i64;
        (first..).map(|k| k as f64 * step).take_while(|x| *x <= self.high).collect()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Places {
    /// The marks are written by the formatters of the chart.
    fn format(value: &f64) -> String {
        value.to_string()
    }
}
