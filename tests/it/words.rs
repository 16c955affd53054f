//! The texts of `assets/words`.

use std::path::{Path, PathBuf};

use camera_lab_words::Lang;

/// The files below a folder whose names end with `ending`.
pub(crate) fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder can be read").flatten().map(|entry| entry.path());
    entries
        .flat_map(|path| if path.is_dir() { files_below(&path, ending) } else { vec![path] })
        .filter(|path| path.to_string_lossy().ends_with(ending))
        .collect()
}

/// Every text in a language, in an order that all languages have.
pub(crate) fn words(lang: Lang) -> Vec<String> {
    fn texts(item: &toml_edit::Item) -> Vec<String> {
        let list = |list: &toml_edit::Array| list.iter().filter_map(|text| Some(text.as_str()?.to_owned())).collect();
        match (item.as_str(), item.as_array(), item.as_table()) {
            (Some(text), ..) => vec![text.to_owned()],
            (_, Some(array), _) => list(array),
            (.., Some(table)) => table.iter().flat_map(|(_, item)| texts(item)).collect(),
            _ => Vec::new(),
        }
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/words").join(lang.tag());
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a file of words can be read");
        let document: toml_edit::DocumentMut = text.parse().unwrap_or_else(|error| panic!("{path:?}: {error}"));
        texts(document.as_item())
    };
    let mut files = files_below(&folder, ".toml");
    files.sort();
    files.into_iter().flat_map(read).collect()
}
