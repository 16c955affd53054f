//! The same figure in another way, shown beside it: the `[compare]` section of a figure.

use crate::camera::Operation;

/// A figure in two ways: as it is, and with other values of some keys or after operations.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Keys of the figure, `style.visibility`, with their other values as TOML.
    pub with: Vec<(String, String)>,
    /// Operations on the camera, done after the keys are set.
    pub ops: Vec<Operation>,
    /// The name of one of the figure's other cameras, which provides the image.
    pub camera: Option<String>,
    /// The share of the picture, from the left, that shows the figure as it is: 0 … 1.
    pub wiper: f64,
    /// Two halves with a whole picture each, and no wiper.
    pub beside: bool,
    /// True if differing pixels are marked.
    pub differences: bool,
}

impl Default for Comparison {
    fn default() -> Self {
        Self { with: Vec::new(), ops: Vec::new(), camera: None, wiper: 0.5, beside: false, differences: false }
    }
}

impl Comparison {
    /// The image of another camera of the figure, beside its own.
    pub fn of_camera(name: &str) -> Self {
        Self { camera: Some(name.to_owned()), beside: true, ..Self::default() }
    }

    /// A comparison of one key.
    pub fn of_key(key: &str, value: &str) -> Self {
        Self { with: vec![(key.to_owned(), value.to_owned())], ..Self::default() }
    }
}
