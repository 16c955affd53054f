//! The words that arguments can be.

use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::figure::words::{self, Words};
use camera_lab_words::Lang;

/// A parser of an argument that is one of `values`, each by its name.
pub(in crate::cli) fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    values: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    // Other texts are refused before they get here.
    PossibleValuesParser::new(values.map(name)).try_map(move |text| {
        values.into_iter().find(|value| name(*value) == text).ok_or_else(|| format!("no value has the name {text}"))
    })
}

/// A parser of an argument that is one of `words`.
pub(in crate::cli) fn word_of<T: Copy + Send + Sync + 'static>(words: Words<T>) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(words.iter().map(|(word, _)| *word))
        .try_map(move |text| words::value(words, &text).ok_or_else(|| format!("no value has the name {text}")))
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(in crate::cli) enum Format {
    #[default]
    Json,
    Text,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TableFormat {
    #[default]
    Text,
    Json,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DataFormat {
    #[default]
    Text,
    Json,
    Csv,
}

#[derive(Clone, Copy, Debug)]
pub(in crate::cli) struct LangArg(Lang);

impl LangArg {
    pub(in crate::cli) fn lang(self) -> Lang {
        self.0
    }
}

impl ValueEnum for LangArg {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [LangArg; Lang::ALL.len()] = {
            let mut all = [LangArg(Lang::En); Lang::ALL.len()];
            let mut at = 0;
            while at < all.len() {
                all[at] = LangArg(Lang::ALL[at]);
                at += 1;
            }
            all
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.tag()).aliases(self.0.aliases()))
    }
}

/// The language of the output and of texts in pictures, which never depend on the system.
pub(in crate::cli) fn written(asked: Option<LangArg>) -> Lang {
    asked.map_or(Lang::En, LangArg::lang)
}
