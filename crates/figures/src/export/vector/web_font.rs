//! The letters of a page as subsets of the fonts in a form that browsers accept: those for PDF, with the tables that
//! these lack.

/// The name of a table.
type Tag = [u8; 4];

/// A font with these glyphs of another one, renumbered, and their characters by number. `None` if either isn't a font.
///
/// *Guarantees*: the same glyphs give the same bytes.
pub(super) fn web_font(original: &[u8], subset: &[u8], characters: &[(u16, char)]) -> Option<Vec<u8>> {
    // Weight, width and heights of the letters.
    let (_, os_2) = tables_of(original)?.into_iter().find(|(tag, _)| tag == b"OS/2")?;
    let mut tables = vec![(*b"OS/2", os_2), (*b"cmap", characters_table(characters)?)];
    tables.extend(tables_of(subset)?);
    tables.sort_by_key(|(tag, _)| *tag);
    file_of(&tables)
}

/// The tables of a font. `None` if it isn't one.
fn tables_of(font: &[u8]) -> Option<Vec<(Tag, Vec<u8>)>> {
    let number = |at: usize| Some(u32::from_be_bytes(*font.get(at..)?.first_chunk()?) as usize);
    let count = usize::from(u16::from_be_bytes(*font.get(4..)?.first_chunk()?));
    let record = |k: usize| {
        let at = 12 + 16 * k;
        let (from, length) = (number(at + 8)?, number(at + 12)?);
        Some((*font.get(at..)?.first_chunk()?, font.get(from..from.checked_add(length)?)?.to_vec()))
    };
    (0..count).map(record).collect()
}

/// The table from characters to glyphs, a group for each.
fn characters_table(characters: &[(u16, char)]) -> Option<Vec<u8>> {
    let mut groups: Vec<[u32; 3]> =
        characters.iter().map(|(glyph, c)| [u32::from(*c), u32::from(*c), u32::from(*glyph)]).collect();
    groups.sort_unstable();
    let count = u32::try_from(groups.len()).ok()?;
    let mut bytes = Vec::new();
    // Version 0 with one table: Windows (3), all of Unicode (10), after these 12 bytes.
    bytes.extend([0_u16, 1, 3, 10].iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(12_u32.to_be_bytes());
    // Format 12: its length, no language.
    bytes.extend([12_u16, 0].iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend([16 + 12 * count, 0, count].iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(groups.iter().flatten().flat_map(|number| number.to_be_bytes()));
    Some(bytes)
}

/// The file of these tables, in the order of their tags.
fn file_of(tables: &[(Tag, Vec<u8>)]) -> Option<Vec<u8>> {
    let count = u16::try_from(tables.len()).ok()?;
    let power = count.max(1).ilog2();
    let range = 16 * 2_u16.pow(power);
    let mut file = 0x0001_0000_u32.to_be_bytes().to_vec();
    file.extend([count, range, u16::try_from(power).ok()?, 16 * count - range].iter().flat_map(|n| n.to_be_bytes()));
    let mut at = 12 + 16 * tables.len();
    for (tag, table) in tables {
        file.extend(tag);
        file.extend(sum_of(table).to_be_bytes());
        file.extend(u32::try_from(at).ok()?.to_be_bytes());
        file.extend(u32::try_from(table.len()).ok()?.to_be_bytes());
        at += table.len().next_multiple_of(4);
    }
    for (_, table) in tables {
        file.extend(table);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    Some(file)
}

/// The sum of the words of a table, whose last one may be short.
fn sum_of(table: &[u8]) -> u32 {
    table.chunks(4).fold(0, |sum, chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        sum.wrapping_add(u32::from_be_bytes(word))
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use subsetter::{GlyphRemapper, subset};

    use super::*;
    use crate::text::{Face, glyph};

    #[test]
    fn a_subset_has_its_letters_and_the_tables_that_browsers_ask_for() {
        for face in Face::ALL {
            let mut numbers = GlyphRemapper::new();
            let characters: Vec<(u16, char)> = "vCF".chars().map(|c| (numbers.remap(glyph(face, c)), c)).collect();
            let small = subset(face.bytes(), 0, &numbers).unwrap();
            let bytes = web_font(face.bytes(), &small, &characters).unwrap();
            let tables = tables_of(&bytes).unwrap();
            for tag in ["OS/2", "cmap", "glyf", "head", "hhea", "hmtx", "loca", "maxp", "name", "post"] {
                assert!(tables.iter().any(|(of, table)| of == tag.as_bytes() && !table.is_empty()), "{face:?} {tag}");
            }
            assert!(tables.is_sorted_by_key(|(tag, _)| *tag), "{face:?}");
            // In the order of the characters, whatever the order of their glyphs.
            let of_characters = &tables.iter().find(|(tag, _)| tag == b"cmap").unwrap().1;
            let groups: Vec<u32> =
                of_characters[28..].as_chunks().0.iter().map(|chunk| u32::from_be_bytes(*chunk)).collect();
            let [v, c, f] = [1, 2, 3];
            assert_eq!(groups, [67, 67, c, 70, 70, f, 118, 118, v], "{face:?}");
            assert_eq!(
                of_characters.len(),
                12 + usize::try_from(u32::from_be_bytes(*of_characters[16..].first_chunk().unwrap())).unwrap()
            );
        }
        assert_eq!(web_font(b"no font", &[0; 40], &[(1, 'a')]), None);
    }
}
