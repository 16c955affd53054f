//! Names of files from titles.

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
