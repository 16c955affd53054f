"""Draws assets/fonts/Clipboard.ttf: the one sign on egui's own buttons that DejaVu lacks, U+1F4CB. Needs fonttools."""

import pathlib

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen


def rectangle(pen, left, bottom, right, top, hole=False):
    corners = [(left, bottom), (left, top), (right, top), (right, bottom)]
    pen.moveTo(corners[0])
    for corner in (corners[:0:-1] if hole else corners[1:]):
        pen.lineTo(corner)
    pen.closePath()


def main():
    pen = TTGlyphPen(None)
    rectangle(pen, 100, -60, 740, 700)
    rectangle(pen, 170, 10, 670, 630, hole=True)
    rectangle(pen, 290, 560, 550, 780)
    for bottom in (420, 280, 140):
        rectangle(pen, 260, bottom, 580, bottom + 60)
    fonts = FontBuilder(1000, isTTF=True)
    fonts.setupGlyphOrder([".notdef", "clipboard"])
    fonts.setupCharacterMap({0x1F4CB: "clipboard"})
    fonts.setupGlyf({".notdef": TTGlyphPen(None).glyph(), "clipboard": pen.glyph()})
    fonts.setupHorizontalMetrics({".notdef": (840, 0), "clipboard": (840, 100)})
    fonts.setupHorizontalHeader(ascent=900, descent=-200)
    fonts.setupOS2(sTypoAscender=900, sTypoDescender=-200, usWinAscent=900, usWinDescent=200)
    fonts.setupPost(keepGlyphNames=False)
    # The same bytes each time.
    fonts.setupHead(unitsPerEm=1000, created=0, modified=0)
    fonts.save(pathlib.Path(__file__).parent.parent / "assets" / "fonts" / "Clipboard.ttf")


main()
