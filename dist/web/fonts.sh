#!/usr/bin/env bash
# Makes the fonts of the page, crates/engine/fonts/page and assets/fonts/page: the characters that a figure or a text of this program is
# likely to hold, of the fonts in the folder above, with the same outlines. The browser writes other characters in the window. Images leave them out. There are no instructions
# for hinting either, 25 kB packed: images don't use them, and the window hints letters without instructions by itself.
# Needs fonttools (pip install fonttools). Run it when the fonts or the lists below change.
set -euo pipefail
cd "$(dirname "$0")/../.."
window=assets/fonts
pictures=crates/engine/fonts

# Letters of Western Europe, Greek ones, and the signs, arrows and symbols that this program's own texts have.
letters=U+0020-007E,U+00A0-017F,U+02C6-02DC,U+0301-0304,U+0391-03C9,U+03D1,U+03D5,U+03F5
letters+=,U+1D40,U+1D4F,U+1D63,U+2009-2014,U+2016-201D,U+2022,U+2026,U+202F,U+2032-2033,U+2070-2089,U+2099,U+209B-209C,U+20AC,U+2102,U+210E
letters+=,U+2113,U+211D,U+2124,U+2153-2154,U+2190-2195,U+21A6,U+21B6-21B7,U+21BA-21BB,U+21D2,U+21D4,U+2202,U+2207-2208,U+2211-2213,U+2217-221A
letters+=,U+221D-221E,U+2220,U+2225,U+2227-222B,U+223C,U+2248,U+2260-2261,U+2264-2265,U+2282,U+2295,U+2297,U+22A5,U+22C5,U+22EF,U+2308-230B,U+2500,U+2502,U+250C
letters+=,U+2510,U+2514,U+2518,U+25A0-25A1,U+25B2-25B3,U+25B6,U+25B8,U+25BC,U+25BE,U+25C0,U+25C2,U+25CB,U+25CF-25D1,U+25E7-25E8,U+2605,U+2610,U+2630,U+26A0
letters+=,U+270E,U+2713-2718,U+27E8-27E9,U+2B12-2B13,U+FFFD
# In code and in columns of numbers. The window takes other characters from the font above.
columns=U+0020-007E,U+00A0,U+00B0,U+00B7,U+00D7,U+00E7,U+00E3,U+00E9,U+00ED,U+00F3,U+2026,U+2190-2193,U+2212,U+221E,U+FFFD
# In titles and bold words.
titles=U+0020-007E,U+00A0,U+00B0,U+00B7,U+00BA,U+00C0-00C3,U+00C7,U+00C9-00CA,U+00CD,U+00D3-00D5,U+00D7,U+00DA,U+00E0-00E3,U+00E7,U+00E9-00EA,U+00ED
titles+=,U+00F3-00F5,U+00FA,U+03B1-03C9,U+2013-2014,U+2018-201D,U+2026,U+2080-2082,U+2190-2193,U+2212

subset() {
    mkdir -p "$1/page"
    pyftsubset "$1/$2.ttf" --output-file="$1/page/$2.ttf" --unicodes="$3" --layout-features=kern,mark,mkmk --no-glyph-names --notdef-outline \
        --no-hinting --name-IDs='' --drop-tables+=FFTM,MATH
}
# For titles and the heads of sections, in the window and in the page alike. Debian's package fonts-dejavu-core has the whole font.
heads=U+0020-017F,U+0370-03CF,U+2010-2027,U+2030-203A,U+2070-209F,U+2190-2199,U+2200-2265
pyftsubset /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf --output-file="$window/DejaVuSans-Bold.ttf" --unicodes="$heads" \
    --layout-features=kern,mark,mkmk --no-glyph-names --notdef-outline --name-IDs='' --drop-tables+=FFTM,MATH

# Those of mathematics are whole but for the instructions, 19 kB packed. Bold letters are vectors and matrices.
subset_of_katex() {
    mkdir -p "$1/page"
    pyftsubset "$1/$2.ttf" --output-file="$1/page/$2.ttf" --unicodes="$3" --layout-features='' --no-glyph-names --notdef-outline \
        --no-hinting --name-IDs=''
}
subset_of_katex "$pictures" KaTeX_Math-Italic '*'
# But for cards, notes of music, accented capitals and rare relations.
roman=U+0020-007E,U+00A0,U+00AC,U+00B0,U+00B1,U+00B7,U+00D7,U+00F7,U+0131,U+0237,U+02C6-02DD,U+0300-0338,U+0391-03F6,U+2010-2027,U+2032
roman+=,U+2033,U+2057,U+20D7,U+210E,U+210F,U+2111,U+2113,U+2118,U+211C,U+2135,U+2190-2199,U+21A6,U+21CC,U+21D0-21D4,U+2200-226B,U+2282
roman+=,U+2283,U+2286,U+2287,U+2295-2297,U+2299,U+22A4,U+22A5,U+22C5,U+22EE-22F1,U+2308-230B,U+25B3,U+25EF,U+27E8,U+27E9,U+27F5,U+27F6
subset_of_katex "$pictures" KaTeX_Main-Regular "$roman"
for size in 1 2 3 4; do subset_of_katex "$window" "KaTeX_Size$size-Regular" '*'; done
subset_of_katex "$pictures" KaTeX_Main-Bold U+0020-007E,U+0391-03C9,U+2212,U+00B7,U+00D7

subset "$pictures" DejaVuSans "$letters"
subset "$window" DejaVuSansMono "$columns"
subset "$window" DejaVuSans-Bold "$titles"
ls -l "$pictures/page" "$window/page"
