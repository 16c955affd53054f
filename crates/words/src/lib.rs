//! Every text in every language, as typed Rust values.
//!
//! Texts are lines of `assets/words/LANG/PLACE.toml`. The module of a place has a struct [`Texts`](window::Texts) of
//! them, and functions for those with values or grammar.

/// The texts of a file of `assets/words`, which `build.rs` writes as Rust: the struct `Texts`, and a macro `text!` for
/// its `[lines]`: `text!(lang, key)` is a `&'static str` or an array of them, `text!(lang, key, name, count = n + 1)` a
/// `String` with values. It brings [`Lang`] along.
macro_rules! texts {
    ($file:literal) => {
        use crate::Lang;

        include!(concat!(env!("OUT_DIR"), "/words/", $file, ".rs"));
    };
}

/// A value that's inserted into a text: that of the variable with this name, or the one given.
macro_rules! value {
    ($name:ident) => {
        $name
    };
    ($name:ident $value:expr) => {
        $value
    };
}

/// One of two values of any type, by the grammar: `pick!(lang; english, portuguese)`.
macro_rules! pick {
    ($lang:expr; $en:expr, $pt:expr) => {
        match $lang.grammar() {
            crate::Grammar::English => $en,
            crate::Grammar::Portuguese => $pt,
        }
    };
}

/// Functions that give texts with values: `name(lang, count: usize);`. If its values aren't the parameters unchanged,
/// all of them follow in parentheses: `name(lang, file: &str): (file = escaped(file));`.
macro_rules! texts_with_values {
    (@text $lang:ident $name:ident ($($value:ident),+)) => { text!($lang, $name, $($value),+) };
    (@text $lang:ident $name:ident ()) => { text!($lang, $name).to_owned() };
    (@text $lang:ident $name:ident ($($value:ident),*) ($($written:tt)+)) => { text!($lang, $name, $($written)+) };
    ($($(#[$doc:meta])* $name:ident($lang:ident $(, $value:ident: $type:ty)*) $(: ($($written:tt)*))?;)*) => {
        $(
            $(#[$doc])*
            pub fn $name($lang: crate::Lang $(, $value: $type)*) -> String {
                texts_with_values!(@text $lang $name ($($value),*) $(($($written)*))?)
            }
        )*
    };
}

/// An error in one language: its own words in English, and a row for each of its variants in Portuguese, whose values
/// follow in parentheses: `translated! { lang, error; Fault::Name(name) => "“{}” é longo" (escaped(name)); }`.
macro_rules! translated {
    ($lang:expr, $error:expr; $($pattern:pat $(if $guard:expr)? => $pt:literal $(($($value:tt)*))?;)*) => {
        match ($lang.grammar(), $error) {
            (crate::Grammar::English, error) => error.to_string(),
            $((crate::Grammar::Portuguese, $pattern) $(if $guard)? => format!($pt $(, $($value)*)?),)*
            // Enums of the engine may grow. A test finds variants without a translation.
            #[allow(unreachable_patterns, reason = "others have all their variants above")]
            (crate::Grammar::Portuguese, error) => error.to_string(),
        }
    };
}

/// The pages of `assets` in a language, or in English if it has none.
mod pages {
    include!(concat!(env!("OUT_DIR"), "/pages.rs"));
}

pub mod class;
pub mod command_line;
pub mod handout;
pub mod learn;
pub mod messages;
pub mod pictures;
pub mod why;
pub mod window;

/// Names of files from titles.
pub mod file_names {
    use crate::window::search::folded;

    /// The greatest length of a name made from a title.
    const MAX_NAME: usize = 60;

    /// The words of a title as the name of a file, without accents. `None` if nothing is left of them.
    pub fn name_of_title(title: &str) -> Option<String> {
        let folded = folded(title);
        let words = folded.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        let mut name = String::new();
        for word in words.filter(|word| word.len() <= MAX_NAME) {
            if name.len() + word.len() >= MAX_NAME {
                break;
            }
            name.push_str(if name.is_empty() { "" } else { "-" });
            name.push_str(word);
        }
        Some(name).filter(|name| !name.is_empty())
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn names_come_from_titles() {
            for (title, name) in [
                ("A camera in numbers", Some("a-camera-in-numbers")),
                ("Uma câmera: “três” números", Some("uma-camera-tres-numeros")),
                ("§ θ", None),
            ] {
                assert_eq!(name_of_title(title).as_deref(), name);
            }
            assert!(
                name_of_title(&"word ".repeat(40)).is_some_and(|name| name.len() <= MAX_NAME && name.ends_with("word"))
            );
        }
    }
}

/// The words about families of pictures, with the reasons why some keys can't be varied.
pub mod families {
    use super::messages;
    use crate::figure::variation::VariationError;
    use crate::limits::{MAX_FAMILY, MAX_FRAMES};
    use crate::sanitize::escaped;

    texts!("families");

    /// The reason why there is no family.
    pub fn error(lang: Lang, error: &VariationError) -> String {
        match error {
            VariationError::NoValues => text!(lang, error_no_values).to_owned(),
            VariationError::Range { found, limit } => text!(lang, error_range, found = escaped(found), limit),
            VariationError::TooMany { count, limit } => text!(lang, error_too_many, count, limit),
            VariationError::Figure { key, value, error } => {
                format!("{} = {}: {}", escaped(key), escaped(value), messages::without_line(lang, error))
            }
            VariationError::Operation { key, value, error } => {
                format!("{} = {}: {}", escaped(key), escaped(value), messages::operation(lang, error))
            }
        }
    }

    texts_with_values! {
        /// A number of columns that no sheet has.
        columns(lang, text: &str): (text = escaped(text), MAX_FAMILY);

        /// A number of pictures that no animation has.
        frames(lang, text: &str): (text = escaped(text), MAX_FRAMES);

        /// A number of variations that a command can't use.
        variations(lang, count: usize, most: usize);

        /// Rows that wouldn't have the pictures of a figure below one another.
        uneven_rows(lang, count: usize, columns: usize);
    }
}

use camera_lab_engine::{appearance, camera, expression, limits, numbers, pipeline, progress, sanitize, scene, stage};
use camera_lab_figures::{explain, export, figure, formula, inspect, picture, views};
use camera_lab_teaching::{exercises, lessons, numerics};

use crate::figure::Localized;
use crate::numbers::DecimalMark;

/// A text of a file, in a language.
pub fn told(lang: Lang, text: &Localized) -> &str {
    text.get(lang.tag())
}

/// A text of a file, to change it in a language.
pub fn told_mut(lang: Lang, text: &mut Localized) -> &mut String {
    text.get_mut(lang.tag())
}

/// A language of the interface. Its texts are in the folder of `assets/words` with its tag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Brazilian Portuguese.
    PtBr,
}

/// The language of the sentences that Rust builds, and of errors. A language without a grammar of its own has English
/// ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grammar {
    /// That of English.
    English,
    /// That of Portuguese.
    Portuguese,
}

impl Lang {
    /// Every language, in the order in which a switch goes through them.
    pub const ALL: [Self; 2] = [Self::En, Self::PtBr];

    /// Every language with its tag.
    pub const TAGGED: [(&'static str, Self); Self::ALL.len()] = {
        let mut tagged = [("", Self::En); Self::ALL.len()];
        let mut at = 0;
        while at < tagged.len() {
            tagged[at] = (Self::ALL[at].tag(), Self::ALL[at]);
            at += 1;
        }
        tagged
    };

    /// Tag, other words for it, decimal mark, grammar.
    const fn row(self) -> (&'static str, &'static [&'static str], DecimalMark, Grammar) {
        match self {
            Self::En => ("en", &[], DecimalMark::Point, Grammar::English),
            Self::PtBr => ("pt-BR", &["pt", "pt_BR"], DecimalMark::Comma, Grammar::Portuguese),
        }
    }

    /// Its tag in files and options: `en`, `pt-BR`.
    pub const fn tag(self) -> &'static str {
        self.row().0
    }

    /// Other words for it in options.
    pub const fn aliases(self) -> &'static [&'static str] {
        self.row().1
    }

    /// Its name in the language itself.
    pub const fn name(self) -> &'static str {
        window::texts(self).language
    }

    /// Its decimal mark.
    pub const fn mark(self) -> DecimalMark {
        self.row().2
    }

    /// The grammar of sentences that Rust builds.
    pub const fn grammar(self) -> Grammar {
        self.row().3
    }

    /// The language after this one. The first one follows the last.
    pub const fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }

    /// The language of a system or a browser that calls its own `pt_PT` or `en-GB`. English if it's none of ours.
    pub fn of_locale(locale: &str) -> Self {
        let primary = |tag: &str| tag.split(['-', '_', '.']).next().unwrap_or_default().to_lowercase();
        Self::ALL.into_iter().find(|lang| primary(lang.tag()) == primary(locale)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::{Lang, families, pictures};
    use crate::learn::{exercise_window, lessons};
    use crate::why::{conventions, order, reasons};
    use crate::window::{canvas, coach, scenes, sharing};

    /// The words of the window itself have a test of their own, in the window.
    #[test]
    fn both_languages_are_complete_and_differ() {
        let mut same = Vec::new();
        let mut check = |en: Vec<(&'static str, &'static str)>, pt: Vec<(&'static str, &'static str)>| {
            for ((name, en), (_, pt)) in en.into_iter().zip(pt) {
                assert!(!en.trim().is_empty() && !pt.trim().is_empty(), "{name}");
                if en == pt {
                    same.push(name);
                }
            }
        };
        check(canvas::texts(Lang::En).entries(), canvas::texts(Lang::PtBr).entries());
        check(families::texts(Lang::En).entries(), families::texts(Lang::PtBr).entries());
        check(coach::texts(Lang::En).entries(), coach::texts(Lang::PtBr).entries());
        check(exercise_window::texts(Lang::En).entries(), exercise_window::texts(Lang::PtBr).entries());
        check(lessons::texts(Lang::En).entries(), lessons::texts(Lang::PtBr).entries());
        check(order::texts(Lang::En).entries(), order::texts(Lang::PtBr).entries());
        check(conventions::texts(Lang::En).entries(), conventions::texts(Lang::PtBr).entries());
        check(pictures::texts(Lang::En).entries(), pictures::texts(Lang::PtBr).entries());
        check(reasons::texts(Lang::En).entries(), reasons::texts(Lang::PtBr).entries());
        check(sharing::texts(Lang::En).entries(), sharing::texts(Lang::PtBr).entries());
        check(scenes::texts(Lang::En).entries(), scenes::texts(Lang::PtBr).entries());
        assert_eq!(
            same,
            [
                "space_ndc",
                "space_pixel",
                "space_viewport",
                "outcode",
                "parts",
                "slide",
                "infinite",
                "pan",
                "address_hint",
                "link",
                "filter_bilinear",
                "filter_trilinear",
                "texture_texels",
                "shadow_bias",
                "shape_cone",
            ]
        );
    }
}
