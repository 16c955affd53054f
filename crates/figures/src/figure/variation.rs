//! The same figure at several values of a key, or after several amounts of an operation, for a sheet of small pictures.

use super::Figure;
use super::edit::varied_together;
use super::error::FigureError;
use crate::camera::{Camera, CameraError, Convention, Operation, OperationError};
use crate::limits::{MAX_FAMILY, MAX_FRAMES};
use crate::numbers::{EXACT_DIGITS, significant};

/// A key of a figure, or an operation on its camera, with the chosen values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variation {
    /// `camera.view_angle`, `style.visibility`, `show.step.at`, or the name of an operation.
    pub key: String,
    /// The values as written. An empty one removes the key.
    pub values: Vec<String>,
}

/// The reason why there's no family.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum VariationError {
    /// No key, or no values.
    #[error("it has no values; allowed: KEY=VALUE,VALUE,…")]
    NoValues,
    /// A range without an end, or with an impossible number of values.
    #[error("{found} is no range; allowed: FROM..TO:COUNT with a COUNT from 2 to {limit}")]
    Range {
        /// The range as written.
        found: String,
        /// The most values.
        limit: usize,
    },
    /// More pictures than allowed.
    #[error("are {count} pictures; allowed: at most {limit}")]
    TooMany {
        /// The number of pictures.
        count: usize,
        /// The greatest number allowed.
        limit: usize,
    },
    /// A value that the figure can't have.
    #[error("{key}={value}: {error}")]
    Figure {
        /// With its section, such as `camera.near`.
        key: String,
        /// As the author wrote it.
        value: String,
        /// The reason why not. Its line is meaningless.
        error: Box<FigureError>,
    },
    /// An impossible amount for an operation.
    #[error("{key}={value}: {error}")]
    Operation {
        /// The word of the operation, such as `azimuth`.
        key: String,
        /// As the author wrote it.
        value: String,
        /// The reason why not.
        error: Box<OperationError>,
    },
}

/// One figure of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The figure, with the camera's parameters.
    pub figure: Figure,
    /// Its camera, which has more digits than they do.
    pub camera: Camera,
    /// Its values, in the order of the variations.
    pub at: Vec<VariedValue>,
}

/// The value of one variation.
#[derive(Clone, Debug, PartialEq)]
pub enum VariedValue {
    /// A key, and its value without quotes; `None` means that it's removed.
    Key(String, Option<String>),
    /// An operation of the camera with its amount.
    Operation(Operation),
}

impl Variation {
    /// Reads `KEY=VALUE,VALUE,…`. Commas between brackets, braces and quotes separate nothing. `FROM..TO:COUNT` are
    /// evenly spaced numbers. Without `:COUNT` there are `frames` of them, if there is such a number.
    ///
    /// # Errors
    /// [`VariationError`] if there are no values, or too many.
    pub fn parse(text: &str, frames: Option<usize>) -> Result<Self, VariationError> {
        let (key, list) = text.split_once('=').ok_or(VariationError::NoValues)?;
        Self::new(key, list, frames)
    }

    /// The same for a key and a list of values.
    ///
    /// # Errors
    /// As for [`parse`](Self::parse).
    pub fn new(key: &str, list: &str, frames: Option<usize>) -> Result<Self, VariationError> {
        let key = key.trim();
        if key.is_empty() || list.trim().is_empty() {
            return Err(VariationError::NoValues);
        }
        let limit = if frames.is_some() { MAX_FRAMES } else { MAX_FAMILY };
        let mut values = Vec::new();
        for value in items(list) {
            match range(value, frames, limit)? {
                Some(range) => values.extend(range),
                None => values.push(value.to_owned()),
            }
        }
        if values.len() > limit {
            return Err(VariationError::TooMany { count: values.len(), limit });
        }
        Ok(Self { key: key.to_owned(), values })
    }

    /// True for an operation.
    pub fn is_operation(&self) -> bool {
        Operation::names().contains(&&*self.key)
    }
}

/// The parts of a list between its commas.
fn items(list: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut begin) = (0_u32, false, 0);
    let mut items = Vec::new();
    for (at, c) in list.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' | '{' | '(' if !quoted => depth += 1,
            ']' | '}' | ')' if !quoted => depth = depth.saturating_sub(1),
            ',' if !quoted && depth == 0 => {
                items.push(list[begin..at].trim());
                begin = at + 1;
            }
            _ => {}
        }
    }
    items.push(list[begin..].trim());
    items
}

/// The numbers of `FROM..TO:COUNT`; `None` if the text isn't a range.
fn range(text: &str, frames: Option<usize>, limit: usize) -> Result<Option<Vec<String>>, VariationError> {
    let Some((from, rest)) = text.split_once("..").filter(|_| !text.starts_with(['"', '[', '{'])) else {
        return Ok(None);
    };
    let refused = || VariationError::Range { found: text.to_owned(), limit };
    let (to, count) = match rest.split_once(':') {
        Some((to, count)) => (to, count.trim().parse().ok()),
        None => (rest, frames),
    };
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    let [from, to] = [number(from).ok_or_else(refused)?, number(to).ok_or_else(refused)?];
    let count = count.filter(|count| (2..=limit).contains(count)).ok_or_else(refused)?;
    let share = |k: usize| k as f64 / (count - 1) as f64;
    let value = |k: usize| from * (1.0 - share(k)) + to * share(k);
    Ok(Some((0..count).map(|k| significant(value(k), EXACT_DIGITS.min(12))).collect()))
}

/// The figures of a family, with each value of the first variation combined with each of the second, and so on. The
/// last one changes first. `camera` is that of the figure.
///
/// # Errors
/// [`VariationError`] names the impossible value.
pub fn variants(
    figure: &Figure,
    camera: &Camera,
    variations: &[Variation],
    convention: Convention,
    limit: usize,
) -> Result<Vec<Variant>, VariationError> {
    let count = variations.iter().map(|variation| variation.values.len()).fold(1, usize::saturating_mul);
    if count > limit {
        return Err(VariationError::TooMany { count, limit });
    }
    let place = |index: usize, depth: usize| {
        let later: usize = variations[depth + 1..].iter().map(|variation| variation.values.len()).product();
        index / later % variations[depth].values.len()
    };
    let chosen = |index: usize| -> Vec<(&str, &str)> {
        let values = variations.iter().enumerate();
        values.map(|(depth, variation)| (&*variation.key, &*variation.values[place(index, depth)])).collect()
    };
    let all: Result<Vec<Variant>, _> =
        (0..count).map(|index| varied_by(figure, camera, &chosen(index), convention)).collect();
    let mut all = all?;
    if all.iter().any(|variant| variant.figure.camera != figure.camera) {
        // The kept operations led to the figure's own camera.
        let kept = |variant: &&mut Variant| variant.figure.show.operations == figure.show.operations;
        all.iter_mut().filter(kept).for_each(|variant| variant.figure.show.operations.clear());
    }
    Ok(all)
}

/// The figure with keys set, and operations applied in their order. `camera` is that of the figure.
///
/// # Errors
/// [`VariationError`] names the impossible value.
pub fn varied_by(
    figure: &Figure,
    camera: &Camera,
    values: &[(&str, &str)],
    convention: Convention,
) -> Result<Variant, VariationError> {
    let is_operation = |key: &str| Operation::names().contains(&key);
    let keys: Vec<(&str, &str)> = values.iter().copied().filter(|(key, _)| !is_operation(key)).collect();
    let refused = |(key, value): (&str, &str), error| VariationError::Figure {
        key: key.to_owned(),
        value: value.to_owned(),
        error: Box::new(error),
    };
    // The message names a value that's impossible by itself.
    let mut figure = match varied_together(figure, &keys) {
        Ok(varied) => varied,
        Err(error) => {
            let alone = keys.iter().find_map(|&(key, value)| {
                let error = varied_together(figure, &[(key, value)]).err()?;
                Some(refused((key, value), error))
            });
            return Err(alone.unwrap_or_else(|| refused(keys.last().copied().unwrap_or_default(), error)));
        }
    };
    let of_camera = |error: CameraError| FigureError { line: 1, key: "[camera]".to_owned(), problem: error.into() };
    let mut camera = if figure.camera == *camera.parameters() {
        camera.clone()
    } else {
        let last = keys.iter().rev().find(|(key, _)| key.starts_with("camera")).copied().unwrap_or_default();
        Camera::new(&figure.camera).map_err(|error| refused(last, of_camera(error)))?
    };
    let mut at = Vec::new();
    for &(key, value) in values {
        if !is_operation(key) {
            let value = value.trim();
            let unquoted = value.strip_prefix('"').and_then(|value| value.strip_suffix('"')).unwrap_or(value);
            at.push(VariedValue::Key(key.to_owned(), Some(unquoted.to_owned()).filter(|value| !value.is_empty())));
            continue;
        }
        // DX,DY is one value between brackets.
        let amount = value.trim_start_matches('[').trim_end_matches(']');
        let operation: Operation = format!("{key}={amount}").parse().map_err(|error| VariationError::Operation {
            key: key.to_owned(),
            value: value.to_owned(),
            error: Box::new(error),
        })?;
        camera = operation.apply(&camera, convention).map_err(|error| refused((key, value), of_camera(error)))?;
        at.push(VariedValue::Operation(operation));
    }
    figure.camera = *camera.parameters();
    Ok(Variant { figure, camera, at })
}
