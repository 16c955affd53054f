//! The notes that texts cite as `[0]` … `[4]`. Their titles are Portuguese in both languages.

/// The citations of the notes, and their titles.
const SOURCES: [(&str, &str); 5] = [
    ("[0]", "P. Pagliosa, Câmera virtual"),
    ("[1]", "USP, Espaços de coordenadas"),
    ("[2]", "M. Gattass, L. F. Martha, Modelo de câmera do OpenGL"),
    ("[3]", "Pipeline de visualização tridimensional"),
    ("[4]", "Projeções"),
];

/// A text, and in lines below it the titles of the notes that it cites.
pub fn with_titles(text: &str) -> String {
    let mut whole = text.to_owned();
    for (number, title) in SOURCES {
        if text.contains(number) {
            whole.push_str(&format!("\n{number} {title}"));
        }
    }
    whole
}

#[cfg(test)]
mod tests {
    use super::with_titles;
    use crate::pipeline::Stage;
    use crate::why::{pipeline, reasons};
    use crate::window::{canvas, scenes};
    use crate::{Lang, window};

    #[test]
    fn no_text_cites_notes_without_their_title() {
        let mut cited = 0;
        for lang in [Lang::En, Lang::PtBr] {
            let mut texts: Vec<String> = [
                window::texts(lang).entries(),
                canvas::texts(lang).entries(),
                reasons::texts(lang).entries(),
                scenes::texts(lang).entries(),
            ]
            .concat()
            .into_iter()
            .map(|(_, text)| text.to_owned())
            .collect();
            texts.extend(Stage::ALL.map(|stage| pipeline::purpose(lang, stage).to_owned()));
            for text in texts {
                let whole = with_titles(&text);
                for (at, _) in text.match_indices('[') {
                    let number = &text[at..at + 3];
                    assert!(number.ends_with(']'), "{text}");
                    let title = whole.lines().find_map(|line| line.strip_prefix(number)).unwrap_or("");
                    assert!(title.len() > 8, "{whole}");
                    cited += 1;
                }
            }
        }
        assert!(cited > 40, "{cited}");
    }

    #[test]
    fn each_title_stands_once() {
        assert_eq!(
            with_titles("A = W / H. [0] (5.1), [0] (5.5)"),
            "A = W / H. [0] (5.1), [0] (5.5)\n[0] P. Pagliosa, Câmera virtual"
        );
        assert_eq!(with_titles("A = W / H"), "A = W / H");
    }
}
