//! STL, binary and as text. Normals aren't read, because they follow from the corners.

use glam::DVec3;

use super::obj::{Lines, vector};
use super::part::{Imported, LeftOut, Stretches};
use super::soup::{Soup, named_parts};
use crate::progress::Progress;
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::{MeshError, MeshFault};

/// The bytes before the triangles of a binary file: 80 of any use, and the number of triangles.
const HEADER: usize = 84;
/// The bytes of a triangle: its normal and three corners in single precision, and two of any use.
const TRIANGLE: usize = 50;

/// The solids of an STL file.
///
/// # Errors
/// [`MeshError::Line`], [`MeshError::Byte`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], progress: &Progress) -> Result<Imported, MeshError> {
    // Binary files may begin with "solid" as well, so their length decides.
    let triangles = bytes.get(80..HEADER).map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let (needed, found) = (HEADER as u64 + u64::from(triangles) * TRIANGLE as u64, bytes.len() as u64);
    let begin = Lines::new(bytes).rest.trim_ascii_start();
    let is_text = begin.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
        && !begin.iter().take(1024).any(|&byte| byte == 0);
    let (mut left_out, mut stretches) = (LeftOut::default(), Stretches::begin(progress, bytes));
    let solids = if found != needed && is_text {
        text(bytes, &mut stretches).await?
    } else if found >= needed {
        left_out.add("bytes", usize::try_from(found - needed).unwrap_or(usize::MAX));
        binary(&bytes[HEADER..], triangles as usize, &mut left_out, &mut stretches).await?
    } else {
        return Err(MeshError::Byte { byte: 80, fault: MeshFault::Length { triangles, needed, found } });
    };
    named_parts(solids, left_out, progress).await
}

async fn binary(
    bytes: &[u8],
    count: usize,
    left_out: &mut LeftOut,
    stretches: &mut Stretches<'_>,
) -> Result<Vec<(String, Soup)>, MeshError> {
    let mut soup = Soup::default();
    for (triangle, k) in bytes.chunks_exact(TRIANGLE).zip(0..count) {
        stretches.advance_to(k * TRIANGLE).await?;
        for (corner, at) in triangle[12..48].chunks_exact(12).zip((HEADER + k * TRIANGLE + 12..).step_by(12)) {
            let number =
                |k: usize| f64::from(f32::from_le_bytes([corner[k], corner[k + 1], corner[k + 2], corner[k + 3]]));
            let point = DVec3::new(number(0), number(4), number(8));
            if !point.is_finite() {
                return Err(MeshError::Byte { byte: at, fault: MeshFault::Number { found: point.to_string() } });
            }
            soup.corners.push(index_u32(soup.positions.len()));
            soup.positions.push(point);
        }
        left_out.add("attribute byte count", usize::from(triangle[48..] != [0, 0]));
    }
    Ok(vec![(String::new(), soup)])
}

async fn text(bytes: &[u8], stretches: &mut Stretches<'_>) -> Result<Vec<(String, Soup)>, MeshError> {
    let mut lines = Lines::new(bytes);
    let (mut solids, mut name, mut soup) = (Vec::new(), String::new(), Soup::default());
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
                word => {
                    let allowed = "solid, facet normal, outer loop, 3 × vertex, endloop, endfacet, endsolid".to_owned();
                    return Err(refused(MeshFault::Word { found: escaped(word), allowed }));
                }
            }
        }
    }
    if soup.corners.len() > ended {
        return Err(MeshError::Line { line: lines.number, fault: MeshFault::End });
    }
    solids.push((name, soup));
    Ok(solids)
}
