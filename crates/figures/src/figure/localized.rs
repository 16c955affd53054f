//! A text of a file in several languages.

/// A text in several languages, by their tags. It keeps every language of its file, also those that the program doesn't
/// have.
#[derive(Clone, Debug, Default)]
pub struct Localized {
    /// In English.
    pub en: String,
    /// In Portuguese.
    pub pt_br: String,
    /// In other languages, each after its tag, in the order of the file.
    pub others: Vec<(String, String)>,
}

/// An empty text is the same as none.
impl PartialEq for Localized {
    fn eq(&self, other: &Self) -> bool {
        self.iter().filter(|(_, text)| !text.is_empty()).eq(other.iter().filter(|(_, text)| !text.is_empty()))
    }
}

impl Eq for Localized {}

impl From<[String; 2]> for Localized {
    fn from([en, pt_br]: [String; 2]) -> Self {
        Self { en, pt_br, others: Vec::new() }
    }
}

impl Localized {
    /// A text that's the same in every language.
    pub fn same(text: &str) -> Self {
        [text.to_owned(), text.to_owned()].into()
    }

    /// A text from its languages. If it lacks English, the first one stands there, and English stands for Portuguese.
    /// `None` if there is no language, or a key isn't the tag of one.
    pub fn from_languages(texts: Vec<(String, String)>) -> Option<Self> {
        let mut found = Self::in_file(texts)?;
        if found.en.is_empty() {
            let first = found.iter().map(|(_, text)| text.to_owned()).find(|text| !text.is_empty());
            found.en = first?;
        }
        if found.pt_br.is_empty() {
            found.pt_br.clone_from(&found.en);
        }
        Some(found)
    }

    /// A text as a file has it: a language that it lacks is empty. `None` for the keys that [`Self::from_languages`]
    /// refuses.
    pub fn in_file(texts: Vec<(String, String)>) -> Option<Self> {
        let mut found = Self::default();
        for (tag, text) in texts {
            match tag.as_str() {
                "en" => found.en = text,
                "pt-BR" => found.pt_br = text,
                _ if is_tag(&tag) => found.others.push((tag, text)),
                _ => return None,
            }
        }
        Some(found)
    }

    /// Tags and texts.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        let ours = [("en", self.en.as_str()), ("pt-BR", self.pt_br.as_str())];
        ours.into_iter().chain(self.others.iter().map(|(tag, text)| (tag.as_str(), text.as_str())))
    }

    /// Tags and texts as a file has them. One language alone stands for all.
    pub fn to_file(&self) -> impl Iterator<Item = (&str, &str)> {
        self.iter().filter(|(tag, text)| !text.is_empty() && (*tag != "pt-BR" || self.pt_br != self.en))
    }

    /// The text in a language. English if it doesn't have it.
    pub fn get(&self, tag: &str) -> &str {
        let own = self.iter().find(|(of, text)| *of == tag && (!text.is_empty() || tag == "pt-BR"));
        own.map_or(&self.en, |(_, text)| text)
    }

    /// The text in a language, to change it.
    pub fn get_mut(&mut self, tag: &str) -> &mut String {
        match tag {
            "en" => &mut self.en,
            "pt-BR" => &mut self.pt_br,
            _ => {
                let at = self.others.iter().position(|(of, _)| of == tag).unwrap_or_else(|| {
                    self.others.push((tag.to_owned(), String::new()));
                    self.others.len() - 1
                });
                &mut self.others[at].1
            }
        }
    }

    /// The text with each language changed.
    ///
    /// # Errors
    /// The first one of `change`, which gets tag and text.
    pub fn try_map<E>(&self, mut change: impl FnMut(&str, &str) -> Result<String, E>) -> Result<Self, E> {
        let [en, pt_br] = [change("en", &self.en)?, change("pt-BR", &self.pt_br)?];
        let others = self.others.iter().map(|(tag, text)| Ok((tag.clone(), change(tag, text)?)));
        Ok(Self { en, pt_br, others: others.collect::<Result<_, _>>()? })
    }

    /// Like [`Self::try_map`], for a change that doesn't fail.
    pub fn map(&self, mut change: impl FnMut(&str, &str) -> String) -> Self {
        let mut text = self.clone();
        (text.en, text.pt_br) = (change("en", &self.en), change("pt-BR", &self.pt_br));
        text.others.iter_mut().for_each(|(tag, text)| *text = change(tag, text));
        text
    }
}

/// True for the tag of a language that the program doesn't have: `es`, `zh-Hant`. `pt` or `en-GB` is a slip, because
/// the program would look for `pt-BR` and `en`.
fn is_tag(tag: &str) -> bool {
    let mut parts = tag.split('-');
    let primary = parts.next().unwrap_or_default();
    let is_primary = (2..=3).contains(&primary.len()) && primary.bytes().all(|b| b.is_ascii_lowercase());
    let is_part = |part: &str| (2..=8).contains(&part.len()) && part.bytes().all(|b| b.is_ascii_alphanumeric());
    is_primary && !["en", "pt"].contains(&primary) && parts.all(is_part)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::figure::{Figure, read, update};

    fn title(text: &str) -> Option<Localized> {
        read::parse(text).ok()?.title
    }

    #[test]
    fn languages_that_the_program_does_not_have_stay_in_a_file() {
        let text = "title = { es = \"Una casa\", en = \"A house\", fr = \"Une maison\" }\n";
        let house = title(text).unwrap();
        assert_eq!(
            ["en", "pt-BR", "es", "fr", "de"].map(|tag| house.get(tag)),
            ["A house", "A house", "Una casa", "Une maison", "A house"]
        );
        let figure = read::parse(text).unwrap();
        assert_eq!(update(text, &figure), text, "an unchanged text stays as it is");
        let renamed = house.map(|tag, text| if tag == "es" { "Una torre".to_owned() } else { text.to_owned() });
        let written = update(text, &Figure { title: Some(renamed.clone()), ..figure });
        assert!(written.contains("{ en = \"A house\", es = \"Una torre\", fr = \"Une maison\" }"), "{written}");
        assert_eq!(title(&written), Some(renamed));
    }

    #[test]
    fn the_first_language_stands_for_english() {
        let house = title("title = { es = \"Una casa\" }").unwrap();
        assert_eq!(["en", "pt-BR", "es"].map(|tag| house.get(tag)), ["Una casa"; 3]);
        assert_eq!(title("title = { pt-BR = \"Uma casa\" }"), Some(Localized::same("Uma casa")));
    }

    #[test]
    fn slips_in_a_tag_are_refused() {
        for tag in ["pt", "en-GB", "english", "EN", "e", "es-"] {
            assert_eq!(title(&format!("title = {{ en = \"A\", {tag} = \"B\" }}")), None, "{tag}");
        }
    }
}
