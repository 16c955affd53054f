//! The charts of a study. For each case they show the error over the parameter, and the error over the time for the
//! stiffest inputs, with the Pareto front.

use super::{Findings, OWN, Row};
use crate::chart::{Chart, Look, Series};

/// The words of the charts, in some language.
pub struct Words<'a> {
    /// The meaning of the parameter.
    pub parameter: &'a str,
    /// The meaning of the error, with its unit.
    pub error: &'a dyn Fn(&Row) -> String,
    /// The time of one item.
    pub time: &'a str,
    /// The line through the methods that no other beats.
    pub front: &'a str,
    /// The title of the chart of errors over times, at this parameter.
    pub at: &'a dyn Fn(f64) -> String,
    /// A case.
    pub case: &'a dyn Fn(&str) -> String,
    /// A method.
    pub method: &'a dyn Fn(&str) -> String,
}

/// A pair of charts, and their rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Error over parameter.
    pub by_parameter: Chart,
    /// Error over time at the stiffest parameter. The others are shadows.
    pub by_time: Chart,
    /// The error drawn for an error of 0.
    pub floor: f64,
}

fn unique<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    names.for_each(|name| {
        if !found.contains(&name) {
            found.push(name);
        }
    });
    found
}

impl Findings {
    /// The cases, in their order.
    pub fn cases(&self) -> Vec<&str> {
        unique(self.rows.iter().map(|row| row.case.as_str()))
    }

    /// The methods, in their order. The index of each is its colour.
    pub fn methods(&self) -> Vec<&'static str> {
        unique(self.rows.iter().map(|row| row.method))
    }

    /// The charts of one case. An error of 0 is drawn a decade below the least that isn't 0.
    pub fn charts(&self, case: &str, words: &Words) -> Pair {
        let rows: Vec<&Row> = self.rows.iter().filter(|row| row.case == case).collect();
        let least = rows.iter().map(|row| row.error).filter(|&e| e > 0.0).fold(f64::INFINITY, f64::min);
        let floor = if least.is_finite() { least / 10.0 } else { 1e-17 };
        let error = |row: &Row| if row.error > 0.0 { row.error } else { floor };
        let methods = self.methods();
        let of = |method: &str| rows.iter().copied().filter(move |row| row.method == method).collect::<Vec<&Row>>();
        let series = |look: &dyn Fn(&str) -> Look, point: &dyn Fn(&Row) -> Option<[f64; 2]>| {
            let series = methods.iter().enumerate().map(|(i, &method)| Series {
                name: (words.method)(method),
                color: Some(i),
                points: of(method).into_iter().filter_map(point).collect(),
                look: look(method),
            });
            series.filter(|series| !series.points.is_empty()).collect::<Vec<_>>()
        };
        let curve = |method: &str| if method == OWN { Look::BoldCurve } else { Look::Curve };
        let error_label = rows.first().map_or_else(String::new, |row| (words.error)(row));
        let by_parameter = Chart {
            title: (words.case)(case),
            x_label: words.parameter.to_owned(),
            y_label: error_label.clone(),
            series: series(&curve, &|row| Some([row.parameter, error(row)])),
            ..Chart::default()
        };
        let stiffest = rows.last().map_or(0.0, |row| row.parameter);
        let at_stiffest = |row: &Row| row.parameter == stiffest;
        let point = |row: &Row| [row.nanos, error(row)];
        let mut by_time = series(&|_| Look::Shadow, &|row| (!at_stiffest(row)).then(|| point(row)));
        let mut front: Vec<[f64; 2]> =
            rows.iter().filter(|row| at_stiffest(row) && row.pareto).map(|row| point(row)).collect();
        front.sort_by(|a, b| a[0].total_cmp(&b[0]));
        // A line needs two ends.
        if front.len() > 1 {
            by_time.push(Series { name: words.front.to_owned(), color: None, points: front, look: Look::Line });
        }
        by_time.extend(series(&|_| Look::Dots, &|row| at_stiffest(row).then(|| point(row))));
        let by_time = Chart {
            title: (words.at)(stiffest),
            x_label: words.time.to_owned(),
            y_label: error_label,
            series: by_time,
            ..Chart::default()
        };
        Pair { by_parameter, by_time, floor }
    }
}
