//! Errors and warnings, in both languages, for both shells.

pub(super) mod cameras;
pub(super) mod expressions;
pub mod faults;
pub(super) mod figure_files;
pub(super) mod files;
pub(super) mod meshes;
pub(super) mod scene_errors;
pub(super) mod unreadable;

/// Complaints of the TOML parser. In English these are the beginnings of its own words.
pub mod toml_complaints {
    texts!("messages/toml_complaints");
}

/// The wording of one error or warning in one language.
pub(super) mod wording {
    /// The wording of an error or a warning. Both forms come from one place, so that they agree.
    pub(crate) struct Wording {
        /// For files and options, with the keys, the value found, and the values allowed.
        pub(crate) full: String,
        /// In the notes' symbols, as in the window's fields. The value found is in the field.
        pub(crate) in_symbols: String,
    }

    impl Wording {
        pub(crate) fn new(full: impl Into<String>, in_symbols: impl Into<String>) -> Self {
            Self { full: full.into(), in_symbols: in_symbols.into() }
        }
    }
}

pub use crate::messages::cameras::{camera, inspect, no_way_back, operation, warning};
pub use crate::messages::expressions::{at_most_characters, expression, not_whole, outside};
pub use crate::messages::figure_files::{figure, without_line};
pub use crate::messages::files::{encoder, file, left_out, link, not_beside, not_printed, opened, out_of_reach, png};
pub use crate::messages::meshes::notice as mesh_notice;
pub use crate::messages::scene_errors::{opened_mesh, scene, scene_in_window};
pub use crate::messages::unreadable::without_file;
pub use crate::window::progress::over_budget;

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

    use std::path::{Path, PathBuf};

    /// The Rust files of a folder and its folders.
    fn sources(folder: PathBuf) -> Vec<String> {
        let mut texts = Vec::new();
        let mut waiting = vec![folder];
        while let Some(at) = waiting.pop() {
            if at.is_dir() {
                waiting.extend(std::fs::read_dir(at).unwrap().map(|entry| entry.unwrap().path()));
            } else if at.extension().is_some_and(|ending| ending == "rs") {
                texts.push(std::fs::read_to_string(at).unwrap());
            }
        }
        texts
    }

    /// The compiler demands an arm for the rest of an enum that may grow, so it doesn't find a variant without one.
    #[test]
    fn errors_of_the_engine_are_all_translated() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let words = sources(crates.join("words/src")).join("\n");
        let mut variants = 0;
        for text in sources(crates.join("engine/src")) {
            for found in text.split("#[non_exhaustive]\npub enum ").skip(1) {
                let (name, body) = found.split_once(" {\n").unwrap();
                let body = body.split_once("\n}").unwrap().0;
                let indented = body.lines().filter_map(|line| line.strip_prefix("    "));
                for line in indented.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase())) {
                    let variant: String = line.chars().take_while(char::is_ascii_alphanumeric).collect();
                    assert!(words.contains(&format!("{name}::{variant}")), "{name}::{variant} has no translation");
                    variants += 1;
                }
            }
        }
        assert!(variants > 80, "{variants}");
    }
}
