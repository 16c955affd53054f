//! The textures that are part of the program. A figure with them is whole without any file.

use std::sync::{Arc, LazyLock};

use crate::appearance::Texture;

/// Light and dark of the chequers and of the grid with letters. They're far apart in a grey print, and not so dark that
/// light on them couldn't be seen.
const LIGHT: [u8; 4] = [0xf4, 0xf4, 0xf0, 255];
const DARK: [u8; 4] = [0x4a, 0x52, 0x5c, 255];

/// Eight by eight squares.
pub(super) static CHEQUER: LazyLock<Arc<Texture>> = LazyLock::new(|| {
    const SQUARE: u32 = 64;
    drawn(8 * SQUARE, |x, y| if (x / SQUARE + y / SQUARE).is_multiple_of(2) { LIGHT } else { DARK })
});

/// Four by four cells with the letters A to P, from the top left on. A line between two cells, a red one below, at
/// v = 0, and a green one at the left, at u = 0.
pub(super) static LETTERS: LazyLock<Arc<Texture>> = LazyLock::new(|| {
    /// Texels of a dot of a letter, of a cell (its letter is 5 by 7 dots), and of a line.
    const DOT: u32 = 8;
    const CELL: u32 = 72;
    const LINE: u32 = 4;
    const RED: [u8; 4] = [0xc8, 0x3c, 0x28, 255];
    const GREEN: [u8; 4] = [0x1e, 0x8c, 0x5a, 255];
    drawn(4 * CELL, |x, y| {
        let (column, row) = (x / CELL, y / CELL);
        let (dx, dy) = (x % CELL, y % CELL);
        let (i, j) = (dx.wrapping_sub((CELL - 5 * DOT) / 2) / DOT, dy.wrapping_sub((CELL - 7 * DOT) / 2) / DOT);
        let letter = GLYPHS.get((4 * row + column) as usize);
        let is_inked =
            i < 5 && letter.and_then(|rows| rows.get(j as usize)).is_some_and(|bits| bits >> (4 - i) & 1 == 1);
        let is_dark = (column + row) % 2 == 1;
        if y >= 4 * CELL - LINE {
            RED
        } else if x < LINE {
            GREEN
        } else if is_inked != is_dark {
            DARK
        } else {
            LIGHT
        }
    })
});

/// u in red, v (upwards) in green.
pub(super) static UV: LazyLock<Arc<Texture>> = LazyLock::new(|| {
    const SIDE: u32 = 64;
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let byte = |k: u32| ((2 * k + 1) * 255 / (2 * SIDE)) as u8;
    drawn(SIDE, |x, y| [byte(x), byte(SIDE - 1 - y), 64, 255])
});

/// A square picture, texel by texel from the top left.
fn drawn(side: u32, texel: impl Fn(u32, u32) -> [u8; 4]) -> Arc<Texture> {
    let rgba = (0..side * side).flat_map(|i| texel(i % side, i / side)).collect();
    Arc::new(Texture::flat(side, side, rgba).with_levels())
}

/// A to P, 5 by 7 dots: five bits a row, the leftmost highest.
const GLYPHS: [[u8; 7]; 16] = [
    [0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001],
    [0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110],
    [0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110],
    [0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110],
    [0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111],
    [0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000],
    [0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01111],
    [0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001],
    [0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110],
    [0b00111, 0b00010, 0b00010, 0b00010, 0b00010, 0b10010, 0b01100],
    [0b10001, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b10001],
    [0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111],
    [0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001],
    [0b10001, 0b11001, 0b10101, 0b10011, 0b10001, 0b10001, 0b10001],
    [0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110],
    [0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000],
];
