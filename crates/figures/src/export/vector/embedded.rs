//! Embeds the figure file in a page, and finds it there.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use xmlwriter::XmlWriter;

/// The element of an SVG file that holds a figure file, in Base64. Drawing programs keep it as it is.
const ELEMENT: &str = "camera-lab:figure";
/// The namespace of that element.
const NAMESPACE: &str = "urn:camera-lab:figure";
/// The kind of an attached figure file, as PDF writes it.
const SUBTYPE: &[u8] = b"application#2Ftoml";

pub(super) fn write_in_svg(xml: &mut XmlWriter, figure: &str) {
    xml.start_element("metadata");
    xml.start_element(ELEMENT);
    xml.write_attribute("xmlns:camera-lab", NAMESPACE);
    xml.set_preserve_whitespaces(true);
    xml.write_text(&STANDARD.encode(figure));
    xml.end_element();
    xml.set_preserve_whitespaces(false);
    xml.end_element();
}

/// True for bytes that begin like an SVG file.
fn is_svg(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(b"<svg")
        || (start.starts_with(b"<?xml") && find(&start[..start.len().min(4096)], b"<svg").is_some())
}

/// The figure file in an SVG file or a PDF, if the bytes are one of these; `Some(None)` if it has none that can be
/// read.
pub fn figure_in(bytes: &[u8]) -> Option<Option<Vec<u8>>> {
    if bytes.starts_with(b"%PDF-") { Some(figure_in_pdf(bytes)) } else { is_svg(bytes).then(|| figure_in_svg(bytes)) }
}

/// The figure file in an SVG file; `None` if there is none that can be read.
fn figure_in_svg(bytes: &[u8]) -> Option<Vec<u8>> {
    let after = &bytes[find(bytes, format!("<{ELEMENT}").as_bytes())?..];
    let text = &after[find(after, b">")? + 1..];
    let text = &text[..find(text, b"<")?];
    let packed: Vec<u8> = text.iter().copied().filter(|byte| !byte.is_ascii_whitespace()).collect();
    STANDARD.decode(packed).ok()
}

/// The figure file attached to a PDF of this program; `None` if there is none that can be read.
fn figure_in_pdf(bytes: &[u8]) -> Option<Vec<u8>> {
    let at = find(bytes, SUBTYPE)?;
    let start = rfind(&bytes[..at], b" obj")?;
    let object = &bytes[start..];
    let stream = find(object, b"stream\n")?;
    let dictionary = &object[..stream];
    let length = &dictionary[find(dictionary, b"/Length")? + b"/Length".len()..];
    let digits: String =
        length.iter().skip_while(|c| **c == b' ').take_while(|c| c.is_ascii_digit()).map(|c| char::from(*c)).collect();
    let from = stream + b"stream\n".len();
    object.get(from..from.checked_add(digits.parse().ok()?)?).map(<[u8]>::to_vec)
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

fn rfind(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).rposition(|window| window == wanted)
}
