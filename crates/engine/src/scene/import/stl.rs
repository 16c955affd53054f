//! STL, binary and as text: triangles, and in binary files their colours in the form of `VisCAM` or of Magics. Normals
//! aren't read, because they follow from the corners.

use glam::DVec3;

use super::obj::{Lines, vector};
use super::part::{Imported, LeftOut, Stretches};
use super::soup::{Soup, named_parts};
use crate::appearance::Rgba;
use crate::progress::Progress;
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::{MeshError, MeshFault};

/// The bytes before the triangles of a binary file: 80 of any use, and the number of triangles.
const HEADER: usize = 84;
/// The bytes of a triangle: its normal and three corners in single precision, and two of any use.
const TRIANGLE: usize = 50;
/// The words of a text file.
const WORDS: &str = "solid, facet, normal, outer, loop, vertex, endloop, endfacet, endsolid";
/// The colour of triangles without one, if others have one.
const UNSAID: Rgba = Rgba::rgb(204, 204, 204);

/// The solids of an STL file.
///
/// # Errors
/// [`MeshError::Line`], [`MeshError::Byte`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], progress: &Progress) -> Result<Imported, MeshError> {
    // Binary files may begin with "solid" as well, so their length decides.
    let triangles = bytes.get(80..HEADER).map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let needed = HEADER as u64 + u64::from(triangles) * TRIANGLE as u64;
    let begin = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    let is_text = begin.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
        && !begin.iter().take(1024).any(|&byte| byte == 0);
    let mut left_out = LeftOut::default();
    let solids = match bytes.len() as u64 {
        found if found == needed || (found > needed && !is_text) => binary(bytes, &mut left_out, progress).await?,
        _ if is_text => text(bytes, progress).await?,
        _ => {
            let fault = MeshFault::Length { triangles, needed, found: bytes.len() };
            return Err(MeshError::Byte { byte: 80, fault });
        }
    };
    named_parts(solids, left_out, progress).await
}

async fn binary(bytes: &[u8], left_out: &mut LeftOut, progress: &Progress) -> Result<Vec<(String, Soup)>, MeshError> {
    let mut stretches = Stretches::begin(progress, bytes);
    let (header, rest) = bytes.split_at(HEADER);
    let count = u32::from_le_bytes([header[80], header[81], header[82], header[83]]) as usize;
    // Magics gives the solid a colour, and stores red first.
    let solid = header.windows(10).find(|window| window.starts_with(b"COLOR="));
    let solid = solid.map(|window| Rgba::rgb(window[6], window[7], window[8]));
    let mut soup = Soup::default();
    let mut colors = Vec::new();
    let (mut colored, mut unknown) = (solid.is_some(), 0);
    for (k, triangle) in rest.chunks_exact(TRIANGLE).take(count).enumerate() {
        let at = HEADER + k * TRIANGLE;
        stretches.advance_to(at).await?;
        let numbers = triangle[12..48].chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let numbers: Vec<f64> = numbers.map(f64::from).collect();
        if let Some(wrong) = numbers.iter().position(|number| !number.is_finite()) {
            let fault = MeshFault::Number { found: numbers[wrong].to_string() };
            return Err(MeshError::Byte { byte: at + 12 + 4 * wrong, fault });
        }
        for point in numbers.chunks_exact(3) {
            soup.corners.push(index_u32(soup.positions.len()));
            soup.positions.push(DVec3::from_slice(point));
        }
        let word = u16::from_le_bytes([triangle[48], triangle[49]]);
        let five = |shift: u32| u8::try_from((u32::from(word >> shift & 31) * 255 + 15) / 31).unwrap_or(255);
        let own = match solid {
            Some(_) => (word != 0 && word >> 15 == 0).then(|| Rgba::rgb(five(0), five(5), five(10))),
            None => (word >> 15 == 1).then(|| Rgba::rgb(five(10), five(5), five(0))),
        };
        colored |= own.is_some();
        unknown += usize::from(word != 0 && own.is_none() && solid.is_none());
        colors.extend([own.or(solid).unwrap_or(UNSAID); 3]);
    }
    if colored {
        soup.corner_colors = colors;
    }
    left_out.add("attribute byte count", unknown);
    left_out.add("bytes", rest.len() - count * TRIANGLE);
    Ok(vec![(String::new(), soup)])
}

async fn text(bytes: &[u8], progress: &Progress) -> Result<Vec<(String, Soup)>, MeshError> {
    let mut stretches = Stretches::begin(progress, bytes);
    let mut lines = Lines::new(bytes);
    let mut solids = Vec::new();
    let (mut name, mut soup) = (String::new(), Soup::default());
    // Corners of the loops that have ended.
    let mut ended = 0;
    while let Some(line) = lines.line() {
        stretches.advance_to(bytes.len() - lines.rest.len()).await?;
        let refused = |fault| MeshError::Line { line: lines.number, fault };
        let line = String::from_utf8_lossy(line);
        let mut words = line.split_whitespace();
        while let Some(word) = words.next() {
            match word.to_ascii_lowercase().as_str() {
                "solid" => {
                    let next = words.by_ref().collect::<Vec<_>>().join(" ");
                    solids.push((std::mem::replace(&mut name, next), std::mem::take(&mut soup)));
                    ended = 0;
                }
                "endsolid" => break,
                "normal" => words.by_ref().take(3).for_each(drop),
                "facet" | "outer" | "loop" | "endfacet" => {}
                "vertex" => {
                    soup.corners.push(index_u32(soup.positions.len()));
                    soup.positions.push(vector(words.by_ref()).map_err(refused)?);
                }
                "endloop" if soup.corners.len() >= ended + 3 => {
                    soup.arities.push(index_u32(soup.corners.len() - ended));
                    ended = soup.corners.len();
                }
                "endloop" => {
                    return Err(refused(MeshFault::Word { found: word.to_owned(), allowed: "vertex".to_owned() }));
                }
                _ => return Err(refused(MeshFault::Word { found: escaped(word), allowed: WORDS.to_owned() })),
            }
        }
    }
    if soup.corners.len() > ended {
        return Err(MeshError::Line { line: lines.number, fault: MeshFault::End });
    }
    solids.push((name, soup));
    Ok(solids)
}
