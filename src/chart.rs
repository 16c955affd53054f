//! A chart as data: for SVG, PDF or pixels, and for the window. Both axes are logarithmic.

/// Curves over a pair of logarithmic axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// Its title.
    pub title: String,
    /// The quantity to the right, with its unit.
    pub x_label: String,
    /// The quantity upwards, with its unit.
    pub y_label: String,
    /// In the order of the legend.
    pub series: Vec<Series>,
}

/// One curve, or points without a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Index of the colour in the palette; `None`: grey.
    pub color: Option<usize>,
    /// All greater than 0.
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
    /// Large dots alone.
    Dots,
    /// Small dots alone, pale.
    Shadow,
}

impl Chart {
    /// The whole powers of ten between which all points lie, at least one decade along each axis:
    /// `[[x₀, x₁], [y₀, y₁]]`.
    #[must_use]
    pub fn range(&self) -> [[f64; 2]; 2] {
        let points = || self.series.iter().flat_map(|series| &series.points);
        std::array::from_fn(|axis| {
            let logs = points().map(|p| p[axis].log10()).filter(|x| x.is_finite());
            let (low, high) = logs.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
            if low > high {
                return [0.1, 10.0];
            }
            // A point on the border is not cut in half.
            let (low, high) = ((low - 0.1).floor(), (high + 0.1).ceil());
            [10f64.powf(low), 10f64.powf(high)]
        })
    }
}

/// A power of ten as it is written: 10⁻¹², but 1 and 10.
#[must_use]
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
}
