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

        impl Texts {
            /// Name and text of each entry, for tests.
            #[must_use]
            pub fn entries(&self) -> Vec<(&'static str, &'static str)> {
                vec![$((stringify!($name), self.$name),)*]
            }
        }
    };
}

mod cameras;
pub mod canvas;
pub mod command_line;
mod expressions;
pub mod faults;
mod figure_files;
mod files;
mod meshes;
pub mod messages;
pub mod pictures;
pub mod pipeline;
pub mod scenes;
mod unreadable;
pub mod window;

/// A language of the interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Brazilian Portuguese.
    PtBr,
}
