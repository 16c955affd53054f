//! The chart of a study: error against time.

use super::{Key, Study, Value, Way};
use crate::chart::{Axis, Chart, Look, Series};
use crate::numbers::DecimalMark;

/// The words of the chart, in some language.
pub struct ChartWords<'a> {
    /// Above the chart.
    pub title: &'a str,
    /// To the right: the time.
    pub time: &'a str,
    /// Upwards: the share of differing pixels.
    pub share: &'a str,
    /// The line through the ways that no other beats.
    pub front: &'a str,
    /// The figure's own way.
    pub yours: &'a str,
    /// The notation of numbers.
    pub mark: DecimalMark,
    /// A value.
    pub value: &'a dyn Fn(Key, Value) -> String,
}

impl Study {
    /// The key whose values change the error most: that of the colours.
    pub fn telling(&self) -> Option<usize> {
        let spread = |k: usize| {
            let mean = |value: usize| {
                let with = || self.ways.iter().filter(|way| way.combination.get(k) == Some(&value));
                with().map(|way| way.cost.different).sum::<f64>() / (with().count().max(1) as f64)
            };
            let means: Vec<f64> = (0..self.choices[k].values.len()).map(mean).collect();
            let [least, most] = [f64::min, f64::max].map(|pick| means.iter().copied().reduce(pick).unwrap_or(0.0));
            most - least
        };
        (0..self.choices.len()).max_by(|&a, &b| spread(a).total_cmp(&spread(b)))
    }

    /// The place of a way in the chart. An error of 0 is drawn at half a pixel.
    pub fn place(&self, way: &Way) -> [f64; 2] {
        let pixels = f64::from(self.size[0]) * f64::from(self.size[1]);
        [way.ms.median, way.cost.different.max(0.5 / pixels)]
    }

    /// Error against time, with the intervals of the times, in the colours of the values of a choice.
    pub fn chart(&self, by: Option<usize>, words: &ChartWords) -> Chart {
        let mut series = Vec::new();
        let color = |way: &Way| by.and_then(|k| way.combination.get(k)).copied();
        for way in &self.ways {
            let [_, error] = self.place(way);
            let points = vec![[way.ms.low, error], [way.ms.high, error]];
            series.push(Series { name: String::new(), color: color(way), points, look: Look::Line });
        }
        let mut front: Vec<[f64; 2]> = self.ways.iter().filter(|way| way.front).map(|way| self.place(way)).collect();
        front.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        // Some are on the front for their memory alone, which the chart doesn't show.
        let mut least = f64::INFINITY;
        front.retain(|[_, error]| {
            let is_better = *error < least;
            least = least.min(*error);
            is_better
        });
        series.push(Series { name: words.front.to_owned(), color: None, points: front, look: Look::Line });
        let dots = |name: String, color: Option<usize>, ways: &mut dyn Iterator<Item = &Way>, look: Look| Series {
            name,
            color,
            points: ways.map(|way| self.place(way)).collect(),
            look,
        };
        let yours = self.ways.get(self.yours);
        series.push(dots(words.yours.to_owned(), Some(BLACK), &mut yours.into_iter(), Look::Ring));
        match by.and_then(|k| self.choices.get(k)) {
            Some(choice) => series.extend(choice.values.iter().enumerate().map(|(value, &of)| {
                let mut ways = self.ways.iter().filter(|way| color(way) == Some(value));
                dots((words.value)(choice.key, of), Some(value), &mut ways, Look::Dots)
            })),
            None => series.push(dots(String::new(), None, &mut self.ways.iter(), Look::Dots)),
        }
        Chart {
            title: words.title.to_owned(),
            x_label: words.time.to_owned(),
            y_label: words.share.to_owned(),
            axes: [Axis::Linear, Axis::Logarithmic],
            mark: words.mark,
            series,
        }
    }
}

/// The place of black among the colours of charts.
const BLACK: usize = 7;
