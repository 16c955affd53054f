//! A chart as data, for SVG, PDF or pixels, and for the window.

use crate::numbers::{DecimalMark, nice_above};

/// Curves over a pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// Above the chart.
    pub title: String,
    /// The quantity to the right, with its unit.
    pub x_label: String,
    /// The quantity upwards, with its unit.
    pub y_label: String,
    /// To the right and upwards.
    pub axes: [Axis; 2],
    /// The notation of numbers at linear axes.
    pub mark: DecimalMark,
    /// In the order of the legend.
    pub series: Vec<Series>,
}

/// The scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// Logarithmic. All numbers are greater than 0.
    #[default]
    Logarithmic,
    /// Linear.
    Linear,
}

impl Axis {
    /// The place of a number along it.
    pub fn along(self, x: f64) -> f64 {
        match self {
            Self::Logarithmic => x.log10(),
            Self::Linear => x,
        }
    }

    /// The distance between the marks along it, of which at most `most` fit into `length`.
    pub fn step(self, length: f64, most: f64) -> f64 {
        let step = match self {
            Self::Logarithmic => {
                let steps = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];
                steps.into_iter().find(|step| length / step <= most)
            }
            Self::Linear => nice_above(length / most.max(1.0)),
        };
        step.unwrap_or(length)
    }

    /// A number at a place along it, as the text beside it.
    pub fn written(self, place: f64, mark: DecimalMark) -> String {
        match self {
            Self::Logarithmic => power_of_ten(10f64.powf(place)),
            Self::Linear => mark.number(place, 3),
        }
    }
}

/// One curve, or points without a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend, in which it doesn't stand without one.
    pub name: String,
    /// Index of the colour in the palette; `None` means grey.
    pub color: Option<usize>,
    /// In the units of the axes.
    pub points: Vec<[f64; 2]>,
    /// Drawing of the points.
    pub look: Look,
}

/// Drawing of the points of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Dots joined by lines.
    Curve,
    /// Larger dots joined by a thicker line.
    BoldCurve,
    /// A line without dots.
    Line,
    /// A thicker one.
    BoldLine,
    /// Large dots alone.
    Dots,
    /// Small dots alone, pale.
    Shadow,
    /// Discs larger than large dots, of which these leave a ring.
    Ring,
}

impl Chart {
    /// The numbers between which all points lie, `[[x₀, x₁], [y₀, y₁]]`. Along a logarithmic axis they're whole powers
    /// of ten, at least one decade apart. Along a linear one they're the ends of nice steps.
    pub fn range(&self) -> [[f64; 2]; 2] {
        let points = || self.series.iter().flat_map(|series| &series.points);
        std::array::from_fn(|axis| {
            let places = points().map(|p| self.axes[axis].along(p[axis])).filter(|x| x.is_finite());
            let (low, high) = places.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
            if self.axes[axis] == Axis::Linear {
                let step = nice_above((high - low) / 10.0).unwrap_or(1.0);
                let ends =
                    if low > high { [0.0, 1.0] } else { [(low / step).floor() * step, (high / step).ceil() * step] };
                return if ends[0] < ends[1] { ends } else { [ends[0] - 1.0, ends[0] + 1.0] };
            }
            if low > high {
                return [0.1, 10.0];
            }
            // A point on the border isn't cut in half.
            let (low, high) = ((low - 0.1).floor(), (high + 0.1).ceil());
            [10f64.powf(low), 10f64.powf(high)]
        })
    }
}

/// A power of ten as text: 10⁻¹², but 1 and 10.
pub fn power_of_ten(x: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let exponent = x.log10().round();
    if exponent == 0.0 || exponent == 1.0 {
        return if exponent == 0.0 { "1" } else { "10" }.to_owned();
    }
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    };
    format!("10{}", format!("{exponent:.0}").chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_hold_all_points_and_begin_and_end_with_whole_powers() {
        let series = |points: &[[f64; 2]]| Series {
            name: String::new(),
            color: None,
            points: points.to_vec(),
            look: Look::Dots,
        };
        let chart = Chart { series: vec![series(&[[3.0, 1e-16], [250.0, 2e-3]])], ..Chart::default() };
        let [x, y] = chart.range();
        assert_eq!((power_of_ten(x[0]), power_of_ten(x[1])), ("1".to_owned(), "10³".to_owned()));
        assert_eq!((power_of_ten(y[0]), power_of_ten(y[1])), ("10⁻¹⁷".to_owned(), "10⁻²".to_owned()));
        assert_eq!(Chart::default().range(), [[0.1, 10.0]; 2]);
    }

    #[test]
    fn a_linear_axis_ends_at_nice_numbers_around_all_points() {
        let points = vec![[2.0, -1.0], [12.3, 0.97]];
        let series = vec![Series { name: String::new(), color: None, points, look: Look::Line }];
        let linear = Chart { axes: [Axis::Linear; 2], series, ..Chart::default() };
        let [x, y] = linear.range();
        assert_eq!(x, [2.0, 14.0]);
        assert!((y[0] + 1.0).abs() < 1e-12 && (y[1] - 1.0).abs() < 1e-12, "{y:?}");
        assert_eq!(Axis::Linear.written(0.5, DecimalMark::Comma), "0,5");
        assert_eq!(Chart { axes: [Axis::Linear; 2], ..Chart::default() }.range(), [[0.0, 1.0]; 2]);
    }
}
