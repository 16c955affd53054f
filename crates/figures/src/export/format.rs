//! The formats of picture files.

use std::path::Path;
use std::sync::LazyLock;

crate::listed! {
    /// A format of picture files. This is the only list of formats, for the command line and the window.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum PictureFormat {
        /// Pixels, without loss. Carries its figure.
        Png = "PNG",
        /// Pixels, without loss, in fewer bytes.
        WebP = "WebP",
        /// Pixels, with some loss, without transparency.
        Jpeg = "JPEG",
        /// Vectors, for web pages and drawing programs. Carries its figure.
        Svg = "SVG",
        /// Vectors, for print. Carries its figure.
        Pdf = "PDF",
        /// A figure of a LaTeX document in the document's own letters, with a PDF beside it that carries the figure.
        Tex = "LaTeX",
    }
    /// Its common name.
    pub fn name
}

impl PictureFormat {
    /// The extensions of its files, after the dot. The first is the usual one.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Png => &["png"],
            Self::WebP => &["webp"],
            Self::Jpeg => &["jpg", "jpeg"],
            Self::Svg => &["svg"],
            Self::Pdf => &["pdf"],
            Self::Tex => &["tex"],
        }
    }

    /// True if a file carries its figure, and so opens again. For LaTeX it's the PDF beside the file that does.
    pub const fn carries_figure(self) -> bool {
        matches!(self, Self::Png | Self::Svg | Self::Pdf)
    }

    /// The names of the formats that carry their figure: `PNG, SVG and PDF` with an `and` of the caller's language.
    pub fn names_with_figure(and: &str) -> String {
        let names: Vec<&str> = Self::ALL.into_iter().filter(|format| format.carries_figure()).map(Self::name).collect();
        let (last, first) = names.split_last().unwrap_or((&"", &[]));
        format!("{} {and} {last}", first.join(", "))
    }

    /// True if a picture may have no background.
    pub const fn has_transparency(self) -> bool {
        !matches!(self, Self::Jpeg)
    }

    /// True for vectors, whose size on paper doesn't follow from their pixels.
    pub const fn is_vector(self) -> bool {
        matches!(self, Self::Svg | Self::Pdf | Self::Tex)
    }

    /// True for formats whose pictures are made for paper. Choosing one of them means choosing centimetres.
    pub const fn is_for_paper(self) -> bool {
        matches!(self, Self::Pdf | Self::Tex)
    }

    /// The usual one of [`endings`](Self::endings).
    pub const fn ending(self) -> &'static str {
        self.endings()[0]
    }

    /// The format of a file's extension.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?;
        Self::ALL.into_iter().find(|format| format.endings().iter().any(|own| ending.eq_ignore_ascii_case(own)))
    }
}

/// The extensions of all files that hold a figure: figure files, and pictures that carry theirs.
pub static FIGURE_ENDINGS: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let pictures = PictureFormat::ALL.into_iter().filter(|format| format.carries_figure());
    std::iter::once("toml").chain(pictures.flat_map(|format| format.endings().iter().copied())).collect()
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_the_format() {
        for format in PictureFormat::ALL {
            assert_eq!(PictureFormat::of(Path::new("a").with_extension(format.ending()).as_path()), Some(format));
        }
        assert_eq!(PictureFormat::of(Path::new("a.b/c.PNG")), Some(PictureFormat::Png));
        for name in ["png", "a.png.toml", "a", ".png", ""] {
            assert_eq!(PictureFormat::of(Path::new(name)), None, "{name}");
        }
    }
}
