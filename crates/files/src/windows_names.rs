//! Names that Windows reserves. A figure saved as `nul.toml` there would be gone without a message.

use std::path::{Component, Path};

/// True if the path has a part that means a device on this system, or a hidden stream of a file (`figure:x.toml`).
pub(super) fn is_reserved(path: &Path) -> bool {
    cfg!(windows) && is_reserved_by_windows(path)
}

fn is_reserved_by_windows(path: &Path) -> bool {
    path.components().any(|part| match part {
        Component::Normal(name) => is_reserved_name(&name.to_string_lossy()),
        _ => false,
    })
}

/// By <https://learn.microsoft.com/windows/win32/fileio/naming-a-file>, with any ending and in any case.
fn is_reserved_name(name: &str) -> bool {
    if name.contains(':') {
        return true;
    }
    let stem = name.split_once('.').map_or(name, |(stem, _)| stem).trim_end().to_uppercase();
    if matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL" | "CONIN$" | "CONOUT$") {
        return true;
    }
    let number = stem.strip_prefix("COM").or_else(|| stem.strip_prefix("LPT"));
    number.is_some_and(|number| {
        let mut digits = number.chars();
        matches!((digits.next(), digits.next()), (Some('0'..='9' | '¹' | '²' | '³'), None))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_differ_from_files_that_look_like_them() {
        for name in
            ["con", "NUL.toml", "aux.figure.png", "Com1.toml", "lpt³", "nul .toml", "a.toml:b", "lecture/PRN/x.toml"]
        {
            assert!(is_reserved_by_windows(Path::new(name)), "{name}");
        }
        for name in ["console.toml", "com.toml", "com10.toml", "nulo.toml", "a.nul", "lpt", "", "../x", "câmera.toml"]
        {
            assert!(!is_reserved_by_windows(Path::new(name)), "{name}");
        }
        assert_eq!(is_reserved(Path::new("nul.toml")), cfg!(windows));
    }
}
