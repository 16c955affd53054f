//! The letters of a page as subsets of the fonts, for PDF and SVG.

use std::collections::{BTreeMap, BTreeSet};

use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, Str};
use subsetter::{GlyphRemapper, subset};

use super::web_font::web_font;
use crate::text::{self, Face};

/// The names of the fonts in the resources of a page, by [`Face`].
pub(super) const FONTS_NAMED: [Name<'static>; 4] = [Name(b"F"), Name(b"FR"), Name(b"FB"), Name(b"FI")];
const SYSTEM: SystemInfo<'static> = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// The data of a font.
struct Description {
    /// With six capital letters before the name of a subset, as PDF requires.
    name: Name<'static>,
    /// Heights from the font's file, in thousandths of an em.
    ascent: f32,
    descent: f32,
    capitals: f32,
    /// Degrees from the upright, counter-clockwise.
    italic_angle: f32,
    /// The width of upright strokes, in thousandths of an em.
    stem: f32,
}

impl Description {
    const fn of(face: Face) -> Self {
        let katex =
            Self { name: Name(b""), ascent: 900.0, descent: -200.0, capitals: 683.0, italic_angle: 0.0, stem: 70.0 };
        match face {
            Face::Plain => Self {
                name: Name(b"CAMLAB+DejaVuSans"),
                ascent: 928.0,
                descent: -236.0,
                capitals: 729.0,
                italic_angle: 0.0,
                stem: 80.0,
            },
            Face::Roman => Self { name: Name(b"CAMLAB+KaTeX_Main-Regular"), ..katex },
            Face::Bold => Self { name: Name(b"CAMLAB+KaTeX_Main-Bold"), stem: 140.0, ..katex },
            Face::Italic => Self { name: Name(b"CAMLAB+KaTeX_Math-Italic"), italic_angle: -14.0, ..katex },
        }
    }
}

/// The used glyphs, with their characters.
#[derive(Default)]
pub(super) struct Glyphs {
    face: Face,
    numbers: GlyphRemapper,
    characters: BTreeMap<u16, char>,
}

impl Glyphs {
    /// Starts with none.
    pub(super) fn of(face: Face) -> Self {
        Self { face, ..Self::default() }
    }

    /// Adds a text, and returns the bytes that show it.
    pub(super) fn show(&mut self, text: &str) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(2 * text.len());
        for c in text.chars().filter(|c| !c.is_control()) {
            let number = self.numbers.remap(text::glyph(self.face, c));
            self.characters.entry(number).or_insert(c);
            bytes.extend(number.to_be_bytes());
        }
        bytes
    }

    /// Adds a text.
    pub(super) fn take(&mut self, text: &str) {
        self.show(text);
    }

    /// The used characters, in their order.
    pub(super) fn characters(&self) -> impl Iterator<Item = char> {
        self.characters.values().copied().collect::<BTreeSet<char>>().into_iter()
    }

    /// The font for browsers. `None` if it can't be cut.
    pub(super) fn web_font(&self) -> Option<Vec<u8>> {
        let characters: Vec<(u16, char)> = self.characters.iter().map(|(number, c)| (*number, *c)).collect();
        web_font(self.face.bytes(), &subset(self.face.bytes(), 0, &self.numbers).ok()?, &characters)
    }

    /// True if there's no text.
    pub(super) fn is_empty(&self) -> bool {
        self.characters.is_empty()
    }

    /// Writes the font with references of its own: itself, the descendant, its description, its file, its characters.
    /// `None` if the font can't be cut.
    pub(super) fn write(&self, pdf: &mut Pdf, [font, cid, descriptor, file, map]: [Ref; 5]) -> Option<()> {
        let Description { name, ascent, descent, capitals, italic_angle, stem } = Description::of(self.face);
        let bytes = subset(self.face.bytes(), 0, &self.numbers).ok()?;
        pdf.type0_font(font)
            .base_font(name)
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(map);
        let mut descendant = pdf.cid_font(cid);
        descendant.subtype(CidFontType::Type2).base_font(name).system_info(SYSTEM).font_descriptor(descriptor);
        descendant.default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
        let advances = self.numbers.remapped_gids().map(|glyph| 1000.0 * text::advance(self.face, glyph));
        descendant.widths().consecutive(0, advances);
        descendant.finish();
        pdf.font_descriptor(descriptor)
            .name(name)
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(-1021.0, -463.0, 1793.0, 1232.0))
            .italic_angle(italic_angle)
            .ascent(ascent)
            .descent(descent)
            .cap_height(capitals)
            .stem_v(stem)
            .font_file2(file);
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&bytes, 6);
        let length = i32::try_from(bytes.len()).ok()?;
        pdf.stream(file, &packed).filter(Filter::FlateDecode).pair(Name(b"Length1"), length);
        let mut characters = UnicodeCmap::new(Name(b"CameraLab"), SYSTEM);
        for (glyph, c) in &self.characters {
            characters.pair(*glyph, *c);
        }
        pdf.cmap(map, &characters.finish());
        Some(())
    }
}
