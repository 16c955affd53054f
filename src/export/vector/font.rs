//! The letters of a page as a subset of the font, for PDF.

use std::collections::BTreeMap;

use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, Str};
use subsetter::{GlyphRemapper, subset};

use crate::text::{self, FONT_BYTES};

/// The name of the font in the resources of a page.
pub(super) const FONT: Name<'static> = Name(b"F");
/// Six capital letters before the name of a subset, as PDF asks for.
const BASE_FONT: Name<'static> = Name(b"CAMLAB+DejaVuSans");
const SYSTEM: SystemInfo<'static> = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// Heights that the font's file names, in thousandths of an em.
const ASCENT: f32 = 928.0;
const DESCENT: f32 = -236.0;
const CAPITALS: f32 = 729.0;

/// The glyphs that are used, with the characters that they stand for.
#[derive(Default)]
pub(super) struct Glyphs {
    numbers: GlyphRemapper,
    characters: BTreeMap<u16, char>,
}

impl Glyphs {
    /// The bytes that show a text.
    pub(super) fn show(&mut self, text: &str) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(2 * text.len());
        for c in text.chars().filter(|c| !c.is_control()) {
            let number = self.numbers.remap(text::glyph(c));
            self.characters.entry(number).or_insert(c);
            bytes.extend(number.to_be_bytes());
        }
        bytes
    }

    /// True where no text is shown.
    pub(super) fn is_empty(&self) -> bool {
        self.characters.is_empty()
    }

    /// Writes the font with references of its own: itself, the descendant, its description, its file, its characters.
    /// `None` where the font can't be cut.
    pub(super) fn write(&self, pdf: &mut Pdf, [font, cid, descriptor, file, map]: [Ref; 5]) -> Option<()> {
        let bytes = subset(FONT_BYTES, 0, &self.numbers).ok()?;
        pdf.type0_font(font)
            .base_font(BASE_FONT)
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(map);
        let mut descendant = pdf.cid_font(cid);
        descendant.subtype(CidFontType::Type2).base_font(BASE_FONT).system_info(SYSTEM).font_descriptor(descriptor);
        descendant.default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
        let advances = self.numbers.remapped_gids().map(|glyph| 1000.0 * text::advance(glyph));
        descendant.widths().consecutive(0, advances);
        descendant.finish();
        pdf.font_descriptor(descriptor)
            .name(BASE_FONT)
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(-1021.0, -463.0, 1793.0, 1232.0))
            .italic_angle(0.0)
            .ascent(ASCENT)
            .descent(DESCENT)
            .cap_height(CAPITALS)
            .stem_v(80.0)
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
