//! Display of text from outside: paths, names, words of files. Characters that a terminal would obey, and those that
//! reverse the writing direction, are written as escapes. Five megabytes are cut short.

use std::path::Path;

/// The most characters of a foreign text that are shown in a message.
const LONGEST: usize = 40;

/// The most characters of a path that are shown. Its end says which file it is.
const LONGEST_PATH: usize = 160;

/// A foreign text as a part of a message: on one line, without control characters, at most 40 characters and `…`.
pub fn escaped(text: &str) -> String {
    within(text, LONGEST)
}

/// Like [`escaped`], with at most `longest` characters.
pub fn within(text: &str, longest: usize) -> String {
    let mut shown = String::new();
    let mut room = longest;
    for c in text.chars() {
        let piece = Piece::of(c);
        match room.checked_sub(piece.len()) {
            Some(left) => room = left,
            None => {
                shown.push('…');
                break;
            }
        }
        piece.write(&mut shown);
    }
    shown
}

/// A path as a part of a message. Like [`escaped`], but longer, and only the end of a path that is too long.
pub fn path(path: &Path) -> String {
    path_text(&path.to_string_lossy())
}

/// Like [`path`], for a path that is a text.
pub fn path_text(path: &str) -> String {
    let mut room = LONGEST_PATH;
    let mut start = path.len();
    for (at, c) in path.char_indices().rev() {
        let Some(left) = room.checked_sub(Piece::of(c).len()) else { break };
        (room, start) = (left, at);
    }
    let end = printable(&path[start..]);
    if start == 0 { end } else { format!("…{end}") }
}

/// The whole text, with escapes for characters that a terminal would obey.
pub fn printable(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    text.chars().for_each(|c| Piece::of(c).write(&mut shown));
    shown
}

/// A character, or its escape.
enum Piece {
    Itself(char),
    Escape(std::char::EscapeDefault),
}

impl Piece {
    fn of(c: char) -> Self {
        if is_obeyed(c) { Self::Escape(c.escape_default()) } else { Self::Itself(c) }
    }

    fn len(&self) -> usize {
        match self {
            Self::Itself(_) => 1,
            Self::Escape(escape) => escape.len(),
        }
    }

    fn write(self, into: &mut String) {
        match self {
            Self::Itself(c) => into.push(c),
            Self::Escape(escape) => into.extend(escape),
        }
    }
}

/// True if a character is a control character, a line end, invisible, or reverses the writing direction.
pub fn is_obeyed(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200b}' | '\u{200e}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}')
        || matches!(c, '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_would_obey_is_written_as_an_escape() {
        assert_eq!(escaped("\u{1b}[31mEVIL\u{9b}2J\0\r\n"), "\\u{1b}[31mEVIL\\u{9b}2J\\u{0}\\r\\n");
        assert_eq!(printable("a\u{202e}txt.obj"), "a\\u{202e}txt.obj");
        assert_eq!(path(Path::new("a\u{7}b")), "a\\u{7}b");
        // Words of any language, quotes and backslashes stay as they are.
        let plain = "câmera “θ” \"a\" C:\\x 照相机 👩\u{200d}🔬";
        assert_eq!([escaped(plain), printable(plain), path_text(plain)], [plain; 3]);
    }

    #[test]
    fn long_texts_are_cut_at_their_end_and_long_paths_at_their_start() {
        assert_eq!(escaped(&"é".repeat(40)), "é".repeat(40));
        assert_eq!(escaped(&"é".repeat(5_000_000)), format!("{}…", "é".repeat(40)));
        assert_eq!(within("\u{1b}\u{1b}", 7), "\\u{1b}…", "an escape is whole or not there");
        let long = format!("{}/meshes/cow.obj", "x".repeat(1000));
        let cut = path_text(&long);
        assert!(cut.starts_with("…x") && cut.ends_with("x/meshes/cow.obj"), "{cut}");
        assert_eq!(cut.chars().count(), 161);
    }
}
