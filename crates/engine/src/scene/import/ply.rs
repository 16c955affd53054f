//! PLY, as text and binary in both byte orders: points with their normals, colours and texture coordinates, and the
//! corners and colours of faces and strips of triangles. Other elements and properties are left out.

use glam::DVec3;

use super::obj::Lines;
use super::part::{Imported, LeftOut, Stretches, vertex_colors};
use super::soup::{Soup, named_parts, strip};
use crate::progress::Progress;
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::{MeshError, MeshFault};

/// The kinds of numbers: their two names, their bytes, and the value that means 1 in a colour.
const KINDS: [(&str, &str, usize, f64); 8] = [
    ("char", "int8", 1, 127.0),
    ("uchar", "uint8", 1, 255.0),
    ("short", "int16", 2, 32_767.0),
    ("ushort", "uint16", 2, 65_535.0),
    ("int", "int32", 4, 2_147_483_647.0),
    ("uint", "uint32", 4, 4_294_967_295.0),
    ("float", "float32", 4, 1.0),
    ("double", "float64", 8, 1.0),
];

/// The properties that are read, each with its place in a [`Row`].
const PROPERTIES: [&[&str]; 12] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx"],
    &["ny"],
    &["nz"],
    &["red", "r", "diffuse_red"],
    &["green", "g", "diffuse_green"],
    &["blue", "b", "diffuse_blue"],
    &["alpha", "a"],
    &["s", "u", "texture_u"],
    &["t", "v", "texture_v"],
];

/// The values of one point or face: x, y, z, normal, red, green, blue, alpha, u, v.
type Row = [f64; PROPERTIES.len()];
const EMPTY: Row = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, f64::INFINITY, 0.0, 0.0];

/// The colour of faces without one, if others have one.
const UNSAID: [f32; 4] = [0.8, 0.8, 0.8, f32::INFINITY];

/// Ends a strip.
const END: u32 = u32::MAX;

#[derive(Clone, Copy, PartialEq)]
enum Form {
    Text,
    LittleEndian,
    BigEndian,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

struct Property {
    name: String,
    kind: usize,
    /// The kind of the number of values, if it's a list.
    list: Option<usize>,
    /// The place in a row, if it's read.
    place: Option<usize>,
}

impl Element {
    fn has(&self, mut places: std::ops::Range<usize>) -> bool {
        places.all(|place| self.properties.iter().any(|property| property.place == Some(place)))
    }

    /// The property that lists corners.
    fn corners(&self) -> Option<usize> {
        let is_list = |p: &Property| p.list.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
        self.properties.iter().position(is_list).filter(|_| matches!(self.name.as_str(), "face" | "tristrips"))
    }

    /// Keeps the places of properties that are used, and counts the others.
    fn choose(&mut self, is_used: impl Fn(usize) -> bool, left_out: &mut LeftOut) {
        let corners = self.corners();
        for (k, property) in self.properties.iter_mut().enumerate() {
            property.place = property.place.filter(|&place| is_used(place));
            if property.place.is_none() && corners != Some(k) {
                left_out.add(&format!("{}.{}", self.name, property.name), self.count);
            }
        }
    }
}

/// The mesh of a PLY file.
///
/// # Errors
/// [`MeshError::Line`], [`MeshError::Byte`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], progress: &Progress) -> Result<Imported, MeshError> {
    let mut stretches = Stretches::begin(progress, bytes);
    let mut lines = Lines::new(bytes);
    let mut left_out = LeftOut::default();
    let header =
        header(&mut lines, &mut left_out).and_then(|(form, elements)| Ok((form, points(&elements)?, elements)));
    let (form, (points, [has_normals, has_colors, has_uv]), mut elements) =
        header.map_err(|fault| MeshError::Line { line: lines.number, fault })?;
    let count = elements[points].count;
    for (k, element) in elements.iter_mut().enumerate() {
        let is_colored = !has_colors && element.corners().is_some() && element.has(6..9);
        let is_used = |place| match place {
            0..3 => k == points,
            3..6 => k == points && has_normals,
            6..10 => k == points && has_colors || is_colored,
            _ => k == points && has_uv,
        };
        element.choose(is_used, &mut left_out);
    }
    let mut values = Values { form, bytes, at: bytes.len() - lines.rest.len() };
    let mut soup = Soup::default();
    let (mut colors, mut uv, mut corners): (Vec<[f32; 4]>, Vec<[f32; 2]>, Vec<u32>) = Default::default();
    for (k, element) in elements.iter().enumerate().filter(|(_, element)| !element.properties.is_empty()) {
        for _ in 0..element.count {
            stretches.advance_to(values.at).await?;
            let row = values.row(element, count, &mut corners)?;
            #[expect(clippy::cast_possible_truncation, reason = "colours and texture coordinates are single precision")]
            let single = row.map(|value| value as f32);
            let [.., r, g, b, a, u, v] = single;
            if k == points {
                soup.positions.push(DVec3::from_slice(&row[..3]));
                soup.normals.extend(has_normals.then(|| DVec3::from_slice(&row[3..6])));
                colors.extend(has_colors.then_some([r, g, b, a]));
                uv.extend(has_uv.then(|| [u, 1.0 - v].map(|value| if value.is_finite() { value } else { 0.0 })));
                continue;
            }
            let before = soup.corners.len();
            if element.name == "tristrips" {
                soup.corners.extend(corners.split(|&corner| corner == END).flat_map(strip));
                soup.arities.resize(soup.arities.len() + (soup.corners.len() - before) / 3, 3);
            } else if corners.len() >= 3 {
                soup.corners.extend(&corners);
                soup.arities.push(index_u32(corners.len()));
            } else if element.corners().is_some() {
                left_out.add(&format!("{}[{}]", element.name, corners.len()), 1);
            }
            if element.has(6..9) {
                colors.resize(before, UNSAID);
                colors.resize(soup.corners.len(), [r, g, b, a]);
            }
        }
    }
    let rest = &bytes[values.at..];
    left_out.add("bytes", if form == Form::Text { rest.trim_ascii().len() } else { rest.len() });
    if has_uv {
        soup.corner_uv = soup.corners.iter().map(|&i| uv[i as usize]).collect();
    }
    if !has_colors && !colors.is_empty() {
        colors.resize(soup.corners.len(), UNSAID);
    }
    let colors = vertex_colors(&colors);
    soup.corner_colors = if has_colors { soup.corners.iter().map(|&i| colors[i as usize]).collect() } else { colors };
    named_parts(vec![(String::new(), soup)], left_out, progress).await
}

/// The element of the points, and whether they have normals, colours and texture coordinates.
fn points(elements: &[Element]) -> Result<(usize, [bool; 3]), MeshFault> {
    let missing = |word: &str| MeshFault::Missing { word: word.to_owned() };
    let place = elements.iter().position(|e| e.name == "vertex").ok_or_else(|| missing("element vertex"))?;
    let has = |places| elements[place].has(places);
    match (0..3).find(|&k| !has(k..k + 1)) {
        Some(lacking) => Err(missing(&format!("property {}", PROPERTIES[lacking][0]))),
        None => Ok((place, [has(3..6), has(6..9), has(10..12)])),
    }
}

fn header(lines: &mut Lines<'_>, left_out: &mut LeftOut) -> Result<(Form, Vec<Element>), MeshFault> {
    let unknown = |found: &str, allowed: &str| MeshFault::Word { found: escaped(found), allowed: allowed.to_owned() };
    let missing = |word: &str| MeshFault::Missing { word: word.to_owned() };
    let kind = |name: &str| {
        let names = || KINDS.iter().flat_map(|(one, other, ..)| [*one, *other]);
        let kind = KINDS.iter().position(|(one, other, ..)| name == *one || name == *other);
        kind.ok_or_else(|| unknown(name, &names().collect::<Vec<_>>().join(", ")))
    };
    let (mut form, mut elements) = (None, Vec::<Element>::new());
    let mut is_first = true;
    loop {
        let line = String::from_utf8_lossy(lines.line().ok_or(MeshFault::End)?).into_owned();
        let words: Vec<&str> = line.split_whitespace().collect();
        let (name, list, value) = match words[..] {
            ["ply"] if is_first => {
                is_first = false;
                continue;
            }
            [found, ..] if is_first => return Err(unknown(found, "ply")),
            ["comment", "TextureFile", ..] => {
                left_out.add("TextureFile", 1);
                continue;
            }
            [] | ["comment" | "obj_info", ..] => continue,
            ["format", name, ..] => {
                form = Some(match name {
                    "ascii" => Form::Text,
                    "binary_little_endian" => Form::LittleEndian,
                    "binary_big_endian" => Form::BigEndian,
                    _ => return Err(unknown(name, "ascii, binary_little_endian, binary_big_endian")),
                });
                continue;
            }
            ["element", name, count] => {
                let count = count.parse().map_err(|_| MeshFault::Number { found: escaped(count) })?;
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
                continue;
            }
            ["property", "list", count, value, name] => (name, Some(kind(count)?), kind(value)?),
            ["property", value, name] => (name, None, kind(value)?),
            ["end_header"] => return Ok((form.ok_or_else(|| missing("format"))?, elements)),
            [found, ..] => return Err(unknown(found, "format, comment, obj_info, element, property, end_header")),
        };
        let place = PROPERTIES.iter().position(|names| names.contains(&name)).filter(|_| list.is_none());
        let properties = &mut elements.last_mut().ok_or_else(|| missing("element"))?.properties;
        properties.push(Property { name: name.to_owned(), kind: value, list, place });
    }
}

/// The values behind the header, one after the other.
struct Values<'a> {
    form: Form,
    bytes: &'a [u8],
    at: usize,
}

impl Values<'_> {
    fn refused(&self, at: usize, fault: MeshFault) -> MeshError {
        if self.form != Form::Text {
            return MeshError::Byte { byte: at, fault };
        }
        let blanks = self.bytes[at..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        let mut lines = Lines::new(&self.bytes[..self.bytes.len().min(at + blanks + 1)]);
        while lines.line().is_some() {}
        MeshError::Line { line: lines.number, fault }
    }

    /// One row of an element. Its corners, which name one of so many `points`, go to `corners`.
    fn row(&mut self, element: &Element, points: usize, corners: &mut Vec<u32>) -> Result<Row, MeshError> {
        let mut row = EMPTY;
        let corners_at = element.corners();
        corners.clear();
        for (k, property) in element.properties.iter().enumerate() {
            let Some(list) = property.list else {
                let start = self.at;
                let value = self.next(property.kind)?;
                let Some(place) = property.place else { continue };
                if place < 3 && !value.is_finite() {
                    return Err(self.refused(start, MeshFault::Number { found: value.to_string() }));
                }
                row[place] = if (6..10).contains(&place) { value / KINDS[property.kind].3 } else { value };
                continue;
            };
            let start = self.at;
            let mut left = self.next(list)?;
            if left < 0.0 || left.fract() != 0.0 {
                let (found, allowed) = (left.to_string(), "0, 1, 2, …".to_owned());
                return Err(self.refused(start, MeshFault::Word { found, allowed }));
            }
            while left >= 1.0 {
                left -= 1.0;
                let start = self.at;
                let value = self.next(property.kind)?;
                if corners_at != Some(k) {
                    continue;
                }
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates")]
                let index = value as u32;
                let is_end = value == -1.0 && element.name == "tristrips";
                if !is_end && (f64::from(index) != value || index as usize >= points) {
                    return Err(self.refused(start, MeshFault::Index { found: value.to_string(), points }));
                }
                corners.push(if is_end { END } else { index });
            }
        }
        let rest = &self.bytes[self.at..];
        let more = rest.iter().position(|b| !matches!(b, b' ' | b'\t')).filter(|_| self.form == Form::Text);
        match more {
            Some(k) if !matches!(rest[k], b'\r' | b'\n') => {
                let names: Vec<&str> = element.properties.iter().map(|property| property.name.as_str()).collect();
                let found = String::from_utf8_lossy(&rest[k..]);
                let found = escaped(found.split_whitespace().next().unwrap_or_default());
                Err(self.refused(self.at, MeshFault::Word { found, allowed: names.join(", ") }))
            }
            _ => Ok(row),
        }
    }

    fn next(&mut self, kind: usize) -> Result<f64, MeshError> {
        let rest = &self.bytes[self.at..];
        if self.form == Form::Text {
            let start = rest.iter().position(|b| !b.is_ascii_whitespace());
            let start = start.ok_or_else(|| self.refused(self.bytes.len(), MeshFault::End))?;
            let length = rest[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - start);
            let word = String::from_utf8_lossy(&rest[start..start + length]);
            let number = word.parse();
            let at = self.at + start;
            let number = number.map_err(|_| self.refused(at, MeshFault::Number { found: escaped(&word) }))?;
            self.at = at + length;
            return Ok(number);
        }
        let width = KINDS[kind].2;
        let own = rest.get(..width).ok_or_else(|| self.refused(self.at, MeshFault::End))?;
        let mut b = [0; 8];
        b[..width].copy_from_slice(own);
        if self.form == Form::BigEndian {
            b[..width].reverse();
        }
        self.at += width;
        Ok(match kind {
            0 => f64::from(i8::from_le_bytes([b[0]])),
            1 => f64::from(b[0]),
            2 => f64::from(i16::from_le_bytes([b[0], b[1]])),
            3 => f64::from(u16::from_le_bytes([b[0], b[1]])),
            4 => f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            5 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            6 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            _ => f64::from_le_bytes(b),
        })
    }
}
