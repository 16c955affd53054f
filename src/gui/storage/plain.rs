//! The value of a preference as it is in the window, compared in each frame. It becomes TOML only to be written.

use std::borrow::Cow;

use toml_edit::Value;

/// A value of a preference.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::gui) enum Plain<'t> {
    Switch(bool),
    Whole(i64),
    Number(f64),
    Text(Cow<'t, str>),
    List(Vec<Self>),
}

impl Plain<'_> {
    /// The same value, with texts of its own.
    pub(in crate::gui) fn into_owned(self) -> Plain<'static> {
        match self {
            Self::Switch(value) => Plain::Switch(value),
            Self::Whole(value) => Plain::Whole(value),
            Self::Number(value) => Plain::Number(value),
            Self::Text(text) => Plain::Text(text.into_owned().into()),
            Self::List(values) => values.into_iter().map(Plain::into_owned).collect(),
        }
    }
}

impl From<bool> for Plain<'_> {
    fn from(value: bool) -> Self {
        Self::Switch(value)
    }
}

impl From<i64> for Plain<'_> {
    fn from(value: i64) -> Self {
        Self::Whole(value)
    }
}

impl From<f64> for Plain<'_> {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl<'t> From<&'t str> for Plain<'t> {
    fn from(text: &'t str) -> Self {
        Self::Text(text.into())
    }
}

impl From<String> for Plain<'_> {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl<'t, T: Into<Self>> FromIterator<T> for Plain<'t> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Self::List(values.into_iter().map(Into::into).collect())
    }
}

impl From<&Plain<'_>> for Value {
    fn from(value: &Plain<'_>) -> Self {
        match value {
            Plain::Switch(value) => (*value).into(),
            Plain::Whole(value) => (*value).into(),
            Plain::Number(value) => (*value).into(),
            Plain::Text(text) => text.as_ref().into(),
            Plain::List(values) => values.iter().map(Self::from).collect(),
        }
    }
}
