//! A page as SVG.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use xmlwriter::{Indent, Options, XmlWriter};

use super::embedded::write_in_svg;
use super::font::Glyphs;
use super::{Item, Letters, Page, PageText, number, straight};
use crate::appearance::Rgba;
use crate::text::{self, Element, Face};

/// The page as an SVG file, with a figure file in it. An empty `figure` is left out.
///
/// *Guarantees*: the same page and figure give the same bytes.
pub(super) fn svg(page: &Page, letters: Letters, figure: &str) -> String {
    let options = Options { use_single_quote: false, indent: Indent::Spaces(1), attributes_indent: Indent::None };
    let mut writer = Writer { xml: XmlWriter::new(options), letters, clips: 0, glyphs: Face::ALL.map(Glyphs::of) };
    let [width, height] = page.size;
    let xml = &mut writer.xml;
    xml.start_element("svg");
    xml.write_attribute("xmlns", "http://www.w3.org/2000/svg");
    xml.write_attribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
    for (name, side) in [("width", width), ("height", height)] {
        xml.write_attribute_fmt(name, format_args!("{}pt", number(side * page.points)));
    }
    xml.write_attribute_fmt("viewBox", format_args!("0 0 {} {}", number(width), number(height)));
    xml.write_attribute("xml:lang", page.language);
    xml.write_attribute("role", "img");
    for (name, text) in [("title", &page.title), ("desc", &page.description)] {
        if !text.is_empty() {
            xml.start_element(name);
            xml.set_preserve_whitespaces(true);
            xml.write_text(&escaped(text));
            xml.end_element();
            xml.set_preserve_whitespaces(false);
        }
    }
    if !figure.is_empty() {
        write_in_svg(xml, figure);
    }
    writer.items(&page.items);
    writer.fonts();
    writer.xml.end_document()
}

struct Writer {
    xml: XmlWriter,
    letters: Letters,
    clips: usize,
    /// The letters of the texts, for each face.
    glyphs: [Glyphs; 4],
}

impl Writer {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            self.item(item);
        }
    }

    fn item(&mut self, item: &Item) {
        match item {
            Item::Group { corner, scale, clip, items } => self.group((*corner, *scale), *clip, items),
            Item::Fill { path, color } => {
                self.path(path);
                self.color("fill", *color);
                self.xml.end_element();
            }
            Item::Stroke { path, color, width, dashes, phase, round } => {
                self.path(path);
                self.xml.write_attribute("fill", "none");
                self.color("stroke", *color);
                self.xml.write_attribute("stroke-width", &number(*width));
                if *round {
                    self.xml.write_attribute("stroke-linecap", "round");
                    self.xml.write_attribute("stroke-linejoin", "round");
                }
                if !dashes.is_empty() {
                    let lengths: Vec<String> = dashes.iter().map(|length| number(*length)).collect();
                    self.xml.write_attribute("stroke-dasharray", &lengths.join(" "));
                    self.xml.write_attribute("stroke-dashoffset", &number(*phase));
                }
                self.xml.end_element();
            }
            Item::Text(text) => match self.letters {
                Letters::Text => self.text(text),
                Letters::Outlines => self.outlines(text),
            },
            Item::Picture { corner, size, pixels } => {
                let Some(png) = png_of(pixels) else { return };
                let xml = &mut self.xml;
                xml.start_element("image");
                place(xml, [corner[0], corner[1], size[0], size[1]]);
                xml.write_attribute("preserveAspectRatio", "none");
                let href = format!("data:image/png;base64,{}", STANDARD.encode(png));
                // The older name, because every program knows it.
                xml.write_attribute("xlink:href", &href);
                xml.end_element();
            }
        }
    }

    fn group(&mut self, (corner, scale): ([f32; 2], f32), [left, top, right, bottom]: [f32; 4], items: &[Item]) {
        self.clips += 1;
        let id = format!("clip{}", self.clips);
        let xml = &mut self.xml;
        xml.start_element("clipPath");
        xml.write_attribute("id", &id);
        xml.start_element("rect");
        place(xml, [left, top, right - left, bottom - top]);
        xml.end_element();
        xml.end_element();
        xml.start_element("g");
        let [x, y] = corner.map(number);
        if scale != 1.0 {
            xml.write_attribute_fmt("transform", format_args!("translate({x} {y}) scale({scale})"));
        } else if corner != [0.0; 2] {
            xml.write_attribute_fmt("transform", format_args!("translate({x} {y})"));
        }
        xml.write_attribute_fmt("clip-path", format_args!("url(#{id})"));
        self.items(items);
        self.xml.end_element();
    }

    fn path(&mut self, path: &[Element]) {
        self.xml.start_element("path");
        self.xml.write_attribute("d", &data(path));
    }

    fn color(&mut self, name: &str, color: Rgba) {
        let Rgba { r, g, b, a } = color;
        self.xml.write_attribute_fmt(name, format_args!("#{r:02x}{g:02x}{b:02x}"));
        if a < 255 {
            let opacity = number(f32::from(a) / 255.0);
            self.xml.write_attribute_fmt(&format!("{name}-opacity"), format_args!("{opacity}"));
        }
    }

    /// One element with its halo painted first, so that each text is there once. If there are several parts, the halo
    /// of one would cover the letters of the part before, so the halo is that of the outlines, below the text.
    fn text(&mut self, of: &PageText) {
        let PageText { at: [x, y], size, halo, .. } = *of;
        let runs = text::set_runs(&of.text, size, of.mathematical);
        if runs.len() > 1 && halo.a > 0 {
            self.halo(&of.outline(), of);
        }
        self.xml.start_element("text");
        if runs.iter().skip(1).any(|run| run.text.starts_with(' ')) {
            // Inkscape and librsvg drop a space if a run has its own position.
            self.xml.write_attribute("xml:space", "preserve");
        }
        self.xml.write_attribute("x", &number(x));
        self.xml.write_attribute("y", &number(y));
        self.xml.write_attribute_fmt("font-family", format_args!("{}, Verdana, sans-serif", family(Face::Plain)));
        self.xml.write_attribute("font-size", &number(size));
        self.color("fill", of.color);
        if runs.len() <= 1 && halo.a > 0 {
            self.xml.write_attribute("paint-order", "stroke");
            self.color("stroke", halo);
            self.xml.write_attribute("stroke-width", &number(of.halo_width));
            self.xml.write_attribute("stroke-linejoin", "round");
        }
        for run in &runs {
            self.glyphs[run.face as usize].take(&run.text);
        }
        self.xml.set_preserve_whitespaces(true);
        if let [run] = runs.as_slice()
            && run.size == size
            && run.face == Face::Plain
        {
            self.xml.write_text(&escaped(&run.text));
        } else {
            for run in runs {
                self.xml.start_element("tspan");
                // The positions of the intended font, which letters of another font follow.
                self.xml.write_attribute("x", &number(x + run.at[0]));
                self.xml.write_attribute("y", &number(y + run.at[1]));
                self.font(run.face);
                if run.size != size {
                    self.xml.write_attribute("font-size", &number(run.size));
                }
                self.xml.write_text(&escaped(&run.text));
                self.xml.end_element();
            }
        }
        self.xml.end_element();
        self.xml.set_preserve_whitespaces(false);
    }

    /// The font of a run, if it isn't that of the text.
    fn font(&mut self, face: Face) {
        if face == Face::Plain {
            return;
        }
        let families = format!("{}, Latin Modern Roman, CMU Serif, serif", family(face));
        self.xml.write_attribute("font-family", &families);
        for (name, value) in look(face) {
            self.xml.write_attribute(name, value);
        }
    }

    /// The letters of the texts as fonts. Browsers use them, while other programs use the fonts of the machine.
    fn fonts(&mut self) {
        let mut rules = String::new();
        for (face, glyphs) in Face::ALL.into_iter().zip(&self.glyphs) {
            let Some(font) = (!glyphs.is_empty()).then(|| glyphs.web_font()).flatten() else { continue };
            let look: String = look(face).iter().map(|(name, value)| format!("{name}:{value};")).collect();
            // Other figures on a web page have other letters of the same font.
            let range: Vec<String> = glyphs.characters().map(|c| format!("U+{:X}", u32::from(c))).collect();
            let (family, range, font) = (family(face), range.join(","), STANDARD.encode(font));
            rules.push_str(&format!(
                "@font-face{{font-family:\"{family}\";{look}unicode-range:{range};src:url(data:font/ttf;base64,{font})}}"
            ));
        }
        if !rules.is_empty() {
            self.xml.start_element("style");
            self.xml.write_text(&rules);
            self.xml.end_element();
        }
    }

    /// A stroke around letters.
    fn halo(&mut self, outline: &[Element], of: &PageText) {
        self.path(outline);
        self.xml.write_attribute("fill", "none");
        self.color("stroke", of.halo);
        self.xml.write_attribute("stroke-width", &number(of.halo_width));
        self.xml.write_attribute("stroke-linejoin", "round");
        self.xml.end_element();
    }

    fn outlines(&mut self, of: &PageText) {
        let path = of.outline();
        self.xml.start_element("g");
        self.xml.write_attribute("aria-label", &escaped(&of.text));
        if of.halo.a > 0 {
            self.halo(&path, of);
        }
        self.path(&path);
        self.color("fill", of.color);
        self.xml.end_element();
        self.xml.end_element();
    }
}

/// The place of an element: its upper left corner, its width and its height.
fn place(xml: &mut XmlWriter, numbers: [f32; 4]) {
    for (name, value) in ["x", "y", "width", "height"].into_iter().zip(numbers) {
        xml.write_attribute(name, &number(value));
    }
}

/// The name of a face's font.
fn family(face: Face) -> &'static str {
    match face {
        Face::Plain => "DejaVu Sans",
        Face::Roman | Face::Bold => "KaTeX_Main",
        Face::Italic => "KaTeX_Math",
    }
}

/// The properties that distinguish a face among those of its font.
fn look(face: Face) -> &'static [(&'static str, &'static str)] {
    match face {
        Face::Plain | Face::Roman => &[],
        Face::Bold => &[("font-weight", "bold")],
        Face::Italic => &[("font-style", "italic")],
    }
}

/// A text in a form that XML can hold, in elements and in attributes, where the writer only escapes quotes. `>` must
/// not follow `]]`. Two characters that XML excludes become U+FFFD. The others that it excludes are controls.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars().filter(|c| !c.is_control()) {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push(char::REPLACEMENT_CHARACTER),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// The commands of a path.
fn data(path: &[Element]) -> String {
    let mut data = String::new();
    let point = |[x, y]: [f32; 2]| format!("{} {}", number(x), number(y));
    for element in path {
        data.push_str(&match *element {
            Element::Move(p) => format!("M{}", point(p)),
            Element::Line(p) => format!("L{}", point(p)),
            Element::Quad(c, p) => format!("Q{} {}", point(c), point(p)),
            Element::Cubic(a, b, p) => format!("C{} {} {}", point(a), point(b), point(p)),
            Element::Close => "Z".to_owned(),
        });
    }
    data
}

fn png_of(pixels: &tiny_skia::Pixmap) -> Option<Vec<u8>> {
    let (colors, opacities) = straight(pixels);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_depth(png::BitDepth::Eight);
    let data = match opacities {
        None => {
            encoder.set_color(png::ColorType::Rgb);
            colors
        }
        Some(opacities) => {
            encoder.set_color(png::ColorType::Rgba);
            let pixel = |(color, opacity): (&[u8; 3], u8)| [color[0], color[1], color[2], opacity];
            colors.as_chunks::<3>().0.iter().zip(opacities).flat_map(pixel).collect()
        }
    };
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&data)).ok()?;
    Some(bytes)
}
