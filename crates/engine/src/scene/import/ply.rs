//! PLY, as text and binary in both byte orders: points with their normals and colours, and faces. Other elements and
//! properties are left out.

use glam::DVec3;

use super::obj::Lines;
use super::part::{Imported, LeftOut, Stretches, vertex_colors};
use super::soup::{Soup, named_parts};
use crate::progress::Progress;
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::{MeshError, MeshFault};

const FORMS: &str = "ascii binary_little_endian binary_big_endian";
/// The kinds of numbers by both of their names. Those of the same kind are eight apart.
const KINDS: &str =
    "char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 float32 float64";
const WIDTHS: [usize; 8] = [1, 1, 2, 2, 4, 4, 4, 8];
const FLOAT: usize = 6;
const LINES: &str =
    "format, comment, obj_info, element NAME COUNT, property KIND NAME, property list KIND KIND NAME, end_header";
/// The properties of points that are read, each in its place of a row.
const PROPERTIES: &str = "x y z nx ny nz red green blue alpha";
type Row = [f64; 10];

#[derive(Default)]
struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

struct Property {
    name: String,
    /// The kind of its values, and before it that of their number if it's a list.
    kinds: Vec<usize>,
    /// The place in a row.
    place: Option<usize>,
    /// It lists the corners of a face.
    is_corners: bool,
}

impl Element {
    fn has(&self, mut places: std::ops::Range<usize>) -> bool {
        places.all(|place| self.properties.iter().any(|property| property.place == Some(place)))
    }
}

/// The mesh of a PLY file.
///
/// # Errors
/// [`MeshError::Line`], [`MeshError::Byte`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], progress: &Progress) -> Result<Imported, MeshError> {
    let mut stretches = Stretches::begin(progress, bytes);
    let mut lines = Lines::new(bytes);
    let header = header(&mut lines).map_err(|fault| MeshError::Line { line: lines.number, fault });
    let (form, elements) = header?;
    let none = Element::default();
    let points = elements.iter().find(|element| element.name == "vertex").unwrap_or(&none);
    if !points.has(0..3) {
        let fault = MeshFault::Missing { word: "element vertex: x, y, z".to_owned() };
        return Err(MeshError::Line { line: lines.number, fault });
    }
    let (mut soup, mut colors, mut left_out) = (Soup::default(), Vec::new(), LeftOut::default());
    let mut values = Values { form, bytes, start: 0, at: bytes.len() - lines.rest.len() };
    for element in elements.iter().filter(|element| !element.properties.is_empty()) {
        for property in element.properties.iter().filter(|property| property.place.is_none() && !property.is_corners) {
            left_out.add(&format!("{}.{}", element.name, property.name), element.count);
        }
        for _ in 0..element.count {
            stretches.advance_to(values.at).await?;
            let before = soup.corners.len();
            let row = values.row(element, points.count, &mut soup.corners).map_err(|fault| values.refused(fault))?;
            if std::ptr::eq(element, points) {
                soup.positions.push(DVec3::from_slice(&row[..3]));
                soup.normals.extend(points.has(3..6).then(|| DVec3::from_slice(&row[3..6])));
                #[expect(clippy::cast_possible_truncation, reason = "colours are single precision")]
                colors.extend(points.has(6..9).then(|| [row[6], row[7], row[8], row[9]].map(|channel| channel as f32)));
            } else if element.name == "face" {
                // The few corners of others are left out when it becomes a mesh.
                let corners = soup.corners.len() - before;
                soup.arities.push(index_u32(corners));
                left_out.add(&format!("face[{corners}]"), usize::from(corners < 3));
            }
        }
    }
    let rest = &bytes[values.at..];
    left_out.add("bytes", if form == 0 { rest.trim_ascii().len() } else { rest.len() });
    let colors = vertex_colors(&colors);
    soup.corner_colors = soup.corners.iter().filter_map(|&corner| colors.get(corner as usize).copied()).collect();
    named_parts(vec![(String::new(), soup)], left_out, progress).await
}

/// The place of a word in a list.
fn choose(found: &str, allowed: &str) -> Result<usize, MeshFault> {
    let place = allowed.split(' ').position(|word| word == found);
    place.ok_or_else(|| MeshFault::Word { found: escaped(found), allowed: allowed.replace(' ', ", ") })
}

/// The form of the values, and the elements.
fn header(lines: &mut Lines<'_>) -> Result<(usize, Vec<Element>), MeshFault> {
    let mut next = || Ok(String::from_utf8_lossy(lines.line().ok_or(MeshFault::End)?).into_owned());
    choose(&next()?, "ply")?;
    let (mut form, mut elements) = (None, Vec::<Element>::new());
    loop {
        let line = next()?;
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            [] | ["comment" | "obj_info", ..] => {}
            ["format", name, ..] => form = Some(choose(name, FORMS)?),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| MeshFault::Number { found: escaped(count) })?;
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
            }
            ["property", ref kinds @ .., name] if let (1 | 3, Some(element)) = (kinds.len(), elements.last_mut()) => {
                let kinds = kinds.iter().skip(usize::from(kinds.len() == 3));
                let kinds = kinds.map(|kind| Ok(choose(kind, KINDS)? % 8)).collect::<Result<Vec<_>, _>>()?;
                let (of_points, of_faces) = (element.name == "vertex", element.name == "face" && kinds.len() == 2);
                let place = choose(name, PROPERTIES).ok().filter(|_| of_points && kinds.len() == 1);
                let is_corners = of_faces && matches!(name, "vertex_indices" | "vertex_index");
                element.properties.push(Property { name: name.to_owned(), kinds, place, is_corners });
            }
            ["end_header"] => {
                let form = form.ok_or_else(|| MeshFault::Missing { word: "format".to_owned() })?;
                return Ok((form, elements));
            }
            _ => return Err(MeshFault::Word { found: escaped(&line), allowed: LINES.to_owned() }),
        }
    }
}

/// The values behind the header, one after the other.
struct Values<'a> {
    form: usize,
    bytes: &'a [u8],
    /// Where the last value began.
    start: usize,
    at: usize,
}

impl Values<'_> {
    /// A fault of the last value.
    fn refused(&self, fault: MeshFault) -> MeshError {
        if self.form > 0 {
            return MeshError::Byte { byte: self.start, fault };
        }
        let mut lines = Lines::new(&self.bytes[..self.bytes.len().min(self.start + 1)]);
        while lines.line().is_some() {}
        MeshError::Line { line: lines.number, fault }
    }

    /// One row of an element. Its corners, each one of so many `points`, are added.
    fn row(&mut self, element: &Element, points: usize, corners: &mut Vec<u32>) -> Result<Row, MeshFault> {
        let mut row = [0.0; 10];
        row[9] = f64::INFINITY;
        for property in &element.properties {
            let (kind, mut left) = match property.kinds[..] {
                [count, kind] => (kind, self.next(count)?),
                [kind] | [.., kind] => (kind, 1.0),
                [] => continue,
            };
            if left < 0.0 || left.fract() != 0.0 {
                return Err(MeshFault::Word { found: left.to_string(), allowed: "0, 1, 2, …".to_owned() });
            }
            while left >= 1.0 {
                left -= 1.0;
                let value = self.next(kind)?;
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates")]
                let index = value as u32;
                match property.place {
                    Some(0..3) if !value.is_finite() => return Err(MeshFault::Number { found: value.to_string() }),
                    Some(place @ 6..) if kind < FLOAT => row[place] = value / 255.0,
                    Some(place) => row[place] = value,
                    None if !property.is_corners => {}
                    None if f64::from(index) == value && (index as usize) < points => corners.push(index),
                    None => return Err(MeshFault::Index { found: value.to_string(), points }),
                }
            }
        }
        let more = self.bytes[self.at..].split(|byte| matches!(byte, b'\r' | b'\n')).next().unwrap_or_default();
        match more.trim_ascii() {
            [_, ..] if self.form == 0 => {
                self.start = self.at;
                let names: Vec<&str> = element.properties.iter().map(|property| property.name.as_str()).collect();
                let found = escaped(&String::from_utf8_lossy(more.trim_ascii()));
                Err(MeshFault::Word { found, allowed: names.join(", ") })
            }
            _ => Ok(row),
        }
    }

    fn next(&mut self, kind: usize) -> Result<f64, MeshFault> {
        self.start = self.at;
        if self.form == 0 {
            let rest = &self.bytes[self.at..];
            self.start += rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
            let word = self.bytes[self.start..].split(u8::is_ascii_whitespace).next().unwrap_or_default();
            self.at = self.start + word.len();
            let word = String::from_utf8_lossy(word);
            let number = word.parse().map_err(|_| MeshFault::Number { found: escaped(&word) });
            return if word.is_empty() { Err(MeshFault::End) } else { number };
        }
        let own = self.bytes.get(self.at..self.at + WIDTHS[kind]).ok_or(MeshFault::End)?;
        self.at += own.len();
        let mut b = [0; 8];
        b[..own.len()].copy_from_slice(own);
        if self.form == 2 {
            b[..own.len()].reverse();
        }
        let whole = f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let values = 256_f64.powi(if own.len() < 4 { i32::from(own.len() == 2) + 1 } else { 4 });
        Ok(match kind {
            FLOAT => f32::from_le_bytes([b[0], b[1], b[2], b[3]]).into(),
            7.. => f64::from_le_bytes(b),
            // Those of even places are signed.
            _ if kind.is_multiple_of(2) && whole >= values / 2.0 => whole - values,
            _ => whole,
        })
    }
}
