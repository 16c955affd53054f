//! A figure or a lesson in a link: its text, packed, after the `#` of an address.
//!
//! A browser doesn't send that part to the server of the page.

use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_zlib_with_limit};

use crate::limits::{MAX_FIGURE_BYTES, MAX_LINK_CHARACTERS};

/// The content of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// A figure.
    Figure,
    /// A lesson.
    Lesson,
}

impl Held {
    const ALL: [Self; 2] = [Self::Figure, Self::Lesson];

    /// The text between the address and the content.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Figure => "#figure=",
            Self::Lesson => "#lesson=",
        }
    }
}

/// As small as possible. Packing a figure takes only a moment.
const LEVEL: u8 = 10;

/// The reason why there is no link to a figure or a lesson, or neither in a link. Displayed, it's a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ShareError {
    /// The link would have more characters than programs pass on whole.
    #[error(
        "the link would have {0} characters; allowed: at most {MAX_LINK_CHARACTERS}, which mail and chat programs pass on whole. Save it and send the file instead"
    )]
    TooLong(usize),
    /// A part of the link is missing, or was changed.
    #[error("the link does not hold a whole figure or lesson: a part of it is missing or was changed on the way")]
    Damaged,
    /// Unpacked, the figure is longer than any.
    #[error("the figure or lesson in the link is too long; allowed: at most {MAX_FIGURE_BYTES} bytes")]
    TooLarge,
}

/// The link to the figure or lesson with this text. `address` is that of the page which opens it. If it's empty, the
/// result is only the part after the address.
///
/// # Errors
/// [`ShareError::TooLong`].
pub fn link(address: &str, held: Held, text: &str) -> Result<String, ShareError> {
    let address = address.split('#').next().unwrap_or_default();
    let link = format!("{address}{}", fragment(held, text));
    if link.len() > MAX_LINK_CHARACTERS { Err(ShareError::TooLong(link.len())) } else { Ok(link) }
}

/// The end of a link, from the `#` on: letters, digits, `-`, `_` and `=`.
pub fn fragment(held: Held, text: &str) -> String {
    format!("{}{}", held.key(), URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(text.as_bytes(), LEVEL)))
}

/// The text of the figure or lesson in a link, or in its part from the `#` on. `None` if there is neither in it.
pub fn text_in(link: &str) -> Option<Result<Vec<u8>, ShareError>> {
    let (_, packed) = Held::ALL.iter().find_map(|held| link.split_once(held.key()))?;
    // Characters added at the end by a mail program or a person.
    let is_added = |c: char| c.is_whitespace() || matches!(c, '=' | '.' | ',' | ')' | '>' | '"' | '\'');
    let packed = packed.trim_end_matches(is_added).trim_start();
    Some(unpacked(packed))
}

fn unpacked(packed: &str) -> Result<Vec<u8>, ShareError> {
    // A longer one can't be a readable figure, because base64 takes four characters for three bytes.
    if packed.len() / 4 > MAX_FIGURE_BYTES / 3 {
        return Err(ShareError::TooLarge);
    }
    let packed = URL_SAFE_NO_PAD.decode(packed).map_err(|_| ShareError::Damaged)?;
    decompress_to_vec_zlib_with_limit(&packed, MAX_FIGURE_BYTES).map_err(|error| match error.status {
        TINFLStatus::HasMoreOutput => ShareError::TooLarge,
        _ => ShareError::Damaged,
    })
}

/// The kind of content that a link claims to have. `None` if the text isn't such a link.
pub fn held_in(link: &str) -> Option<Held> {
    Held::ALL.into_iter().find(|held| link.contains(held.key()))
}

/// The link in the place of a path. `None` for paths.
pub fn link_of(path: &Path) -> Option<&str> {
    path.to_str().filter(|text| held_in(text).is_some())
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    const TEXT: &str = "# Ângulo θ\n[camera]\nnear = 0.5\n";

    #[test]
    fn a_link_gives_its_text_back_and_needs_no_quoting() {
        for address in
            ["", "https://example.org/lab/", "https://example.org/lab/?view=image&lang=pt-BR", "file:///a%20b.html"]
        {
            let link = link(address, Held::Figure, TEXT).unwrap();
            assert!(link.starts_with(&format!("{address}#figure=")), "{link}");
            let figure = link.rsplit('=').next().unwrap();
            assert!(figure.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'-' || c == b'_'), "{figure}");
            assert_eq!(text_in(&link), Some(Ok(TEXT.as_bytes().to_vec())));
            // As it appears in a sentence, or between brackets.
            for added in [".", "> ", ") \n", "\".\r\n"] {
                assert_eq!(text_in(&format!("{link}{added}")), Some(Ok(TEXT.as_bytes().to_vec())), "{added:?}");
            }
        }
        // A link to another figure is replaced, not continued.
        let again =
            link(&link("https://example.org/", Held::Lesson, TEXT).unwrap(), Held::Figure, "[camera]\n").unwrap();
        assert_eq!(text_in(&again), Some(Ok(b"[camera]\n".to_vec())));
        assert_eq!((text_in("https://example.org/#part"), text_in("")), (None, None));
        assert_eq!(link_of(Path::new("figures/a#b.toml")), None);
    }

    #[test]
    fn any_part_that_is_lost_or_changed_is_noticed() {
        let link = link("", Held::Figure, TEXT).unwrap();
        for end in Held::Figure.key().len()..link.len() {
            assert_eq!(text_in(&link[..end]), Some(Err(ShareError::Damaged)), "{end}");
        }
        for at in Held::Figure.key().len()..link.len() - 1 {
            let other = if &link[at..=at] == "A" { "B" } else { "A" };
            let changed = format!("{}{other}{}", &link[..at], &link[at + 1..]);
            assert_eq!(text_in(&changed), Some(Err(ShareError::Damaged)), "{at}");
        }
    }

    #[test]
    fn too_long_a_link_is_refused_and_a_small_one_cannot_hold_a_huge_text() {
        // Incompressible data: the digits of a simple generator.
        let mut state = 1_u32;
        let digits: String = (0..20_000)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                char::from(b'0' + u8::try_from((state >> 24) % 10).unwrap())
            })
            .collect();
        let Err(ShareError::TooLong(length)) = link("", Held::Figure, &digits) else { panic!("too long") };
        assert!(length > MAX_LINK_CHARACTERS);
        assert!(ShareError::TooLong(length).to_string().contains(&length.to_string()));
        let bomb = "a".repeat(MAX_FIGURE_BYTES + 1);
        let packed = URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(bomb.as_bytes(), LEVEL));
        assert_eq!(text_in(&format!("#lesson={packed}")), Some(Err(ShareError::TooLarge)));
        assert_eq!(text_in(&format!("#figure={}", "A".repeat(2 * MAX_FIGURE_BYTES))), Some(Err(ShareError::TooLarge)));
    }
}
