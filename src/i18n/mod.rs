//! Every text in both languages, as typed Rust values.

/// A struct of texts, and both languages of it: `name: "English", "Português";`.
macro_rules! texts {
    ($($name:ident: $en:literal, $pt:literal;)*) => {
        /// Every text of this place in one language.
        #[derive(Debug)]
        pub struct Texts {
            /// The language.
            pub lang: crate::i18n::Lang,
            $(#[doc = concat!("`", $en, "`")] pub $name: &'static str,)*
        }

        static EN: Texts = Texts { lang: crate::i18n::Lang::En, $($name: $en,)* };
        static PT_BR: Texts = Texts { lang: crate::i18n::Lang::PtBr, $($name: $pt,)* };

        /// The words of a language.
        pub const fn texts(lang: crate::i18n::Lang) -> &'static Texts {
            match lang {
                crate::i18n::Lang::En => &EN,
                crate::i18n::Lang::PtBr => &PT_BR,
            }
        }

        impl Texts {
            /// Name and text of each entry, for tests.
            pub fn entries(&self) -> Vec<(&'static str, &'static str)> {
                vec![$((stringify!($name), self.$name),)*]
            }
        }
    };
}

/// One of two values of any type, by the language: `pick!(lang; english, portuguese)`.
macro_rules! pick {
    ($lang:expr; $en:expr, $pt:expr) => {
        match $lang {
            crate::i18n::Lang::En => $en,
            crate::i18n::Lang::PtBr => $pt,
        }
    };
}

/// A text in one language, with the same values in both: `both!(lang; "{n} objects", "{n} objetos")`. The `;` keeps
/// rustfmt from giving each argument a line of its own.
macro_rules! both {
    ($lang:expr; $en:literal, $pt:literal $(; $($value:tt)*)?) => {
        match $lang {
            crate::i18n::Lang::En => format!($en $(, $($value)*)?),
            crate::i18n::Lang::PtBr => format!($pt $(, $($value)*)?),
        }
    };
}

/// Functions that give texts with values: `name(lang, count: usize): "{count} objects", "{count} objetos";`. Values
/// that aren't inserted unchanged follow in parentheses: `(file = escaped(file))`.
macro_rules! texts_with_values {
    ($($(#[$doc:meta])* $name:ident($lang:ident $(, $value:ident: $type:ty)*):
        $en:literal, $pt:literal $(($($written:tt)*))?;)*) => {
        $(
            $(#[$doc])*
            pub fn $name($lang: crate::i18n::Lang $(, $value: $type)*) -> String {
                both!($lang; $en, $pt $(; $($written)*)?)
            }
        )*
    };
}

/// An error in one language: its own words in English, and a row for each of its variants in Portuguese, whose values
/// follow in parentheses: `translated! { lang, error; Fault::Name(name) => "“{}” é longo" (escaped(name)); }`.
macro_rules! translated {
    ($lang:expr, $error:expr; $($pattern:pat $(if $guard:expr)? => $pt:literal $(($($value:tt)*))?;)*) => {
        match ($lang, $error) {
            (crate::i18n::Lang::En, error) => error.to_string(),
            $((crate::i18n::Lang::PtBr, $pattern) $(if $guard)? => format!($pt $(, $($value)*)?),)*
        }
    };
}

pub mod command_line;
pub mod families;
pub mod file_names;
pub mod learn;
pub mod messages;
pub mod pictures;
pub mod why;
pub mod window;

use crate::figure::Bilingual;
use crate::numbers::DecimalMark;

/// A text of a file, in a language.
pub fn told(lang: Lang, text: &Bilingual) -> &str {
    pick!(lang; &text.en, &text.pt_br)
}

/// A text of a file, to change it in a language.
pub fn told_mut(lang: Lang, text: &mut Bilingual) -> &mut String {
    pick!(lang; &mut text.en, &mut text.pt_br)
}

/// A language of the interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Brazilian Portuguese.
    PtBr,
}

impl Lang {
    /// Its decimal mark.
    pub const fn mark(self) -> DecimalMark {
        match self {
            Self::En => DecimalMark::Point,
            Self::PtBr => DecimalMark::Comma,
        }
    }

    /// The other one.
    pub const fn other(self) -> Self {
        pick!(self; Self::PtBr, Self::En)
    }

    /// Its tag in files for others: `en`, `pt-BR`.
    pub const fn tag(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::PtBr => "pt-BR",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Lang, families, pictures};
    use crate::i18n::learn::{exercise_window, lessons};
    use crate::i18n::why::{conventions, order, reasons};
    use crate::i18n::window::{canvas, coach, scenes, sharing};

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
