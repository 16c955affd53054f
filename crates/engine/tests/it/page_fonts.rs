//! The fonts of the page: fewer characters than the program's, with the same outlines.

#![expect(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::DrawSettings;
use skrifa::{FontRef, MetadataProvider};

/// Advance and outline of a character, as text.
fn glyph(bytes: &[u8], c: char) -> Option<String> {
    let font = FontRef::new(bytes).unwrap();
    let glyph = font.charmap().map(c)?;
    let advance = font.glyph_metrics(Size::unscaled(), LocationRef::default()).advance_width(glyph);
    let mut pen = skrifa::outline::pen::SvgPen::default();
    let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
    font.outline_glyphs().get(glyph).unwrap().draw(settings, &mut pen).unwrap();
    Some(format!("{advance:?} {pen}"))
}

#[test]
fn the_page_has_the_same_letters_and_all_that_the_program_writes() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut written = std::collections::BTreeSet::new();
    let mut waiting =
        ["src", "crates", "assets/notes", "assets/exercises", "assets/figures"].map(|at| root.join(at)).to_vec();
    while let Some(at) = waiting.pop() {
        if at.is_dir() {
            waiting.extend(std::fs::read_dir(at).unwrap().map(|entry| entry.unwrap().path()));
        } else {
            // Fonts lie among the files.
            let text = std::fs::read_to_string(at).unwrap_or_default();
            written.extend(text.chars().filter(|c| !c.is_control()));
        }
    }
    let read = |folder: &str, name: &str| std::fs::read(root.join(folder).join(name)).unwrap();
    // Code and columns of numbers use few characters. Missing ones are taken from the other font.
    let fonts = [("crates/engine/fonts", "DejaVuSans.ttf", 520), ("assets/fonts", "DejaVuSansMono.ttf", 110)];
    // Those of mathematics have only lost their instructions, and the bold one letters that no vector has.
    let of_mathematics = [("Main-Regular", 200), ("Math-Italic", 80), ("Main-Bold", 100)];
    let of_mathematics =
        of_mathematics.map(|(name, least)| ("crates/engine/fonts", format!("KaTeX_{name}.ttf"), least));
    let of_sizes = (1..=4).map(|size| ("assets/fonts", format!("KaTeX_Size{size}-Regular.ttf"), 20));
    let fonts = fonts.map(|(folder, name, least)| (folder, name.to_owned(), least));
    for (folder, name, least) in fonts.into_iter().chain(of_mathematics).chain(of_sizes) {
        let name = name.as_str();
        let (whole, page) = (read(folder, name), read(folder, &format!("page/{name}")));
        let page_font = FontRef::new(&page).unwrap();
        let held: Vec<char> = page_font.charmap().mappings().filter_map(|(c, _)| char::from_u32(c)).collect();
        assert!(held.len() >= least, "{name}: {}", held.len());
        for &c in &held {
            assert_eq!(glyph(&page, c), glyph(&whole, c), "{c} of {name}");
        }
        if name == "DejaVuSans.ttf" {
            let missing: String =
                written.iter().filter(|&&c| glyph(&whole, c).is_some() && glyph(&page, c).is_none()).collect();
            assert_eq!(missing, "");
        }
    }
}
