//! Wavefront OBJ: points, normals, faces, objects, and the colours of their materials. Texture coordinates are checked and left
//! out, as is all that is neither point, normal, face, name nor material.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::{DMat4, DVec3};

use super::mesh::index_u32;
use super::part::Part;
use super::read_error::Beside;
use super::soup::Soup;
use super::{MeshError, ObjFault};
use crate::appearance::Rgba;
use crate::foreign::shown;
use crate::progress::{Doing, Progress};

/// So many bytes are read before the work is asked whether it is still wanted.
const STRETCH: usize = 1 << 16;

/// The objects of an OBJ file; one that has several materials comes in several parts.
///
/// # Errors
/// [`MeshError::Obj`] with the line, and [`MeshError::Cancelled`].
pub(super) fn read(bytes: &[u8], read_file: &mut Beside<'_>, progress: &Progress) -> Result<Vec<Part>, MeshError> {
    let mut file = ObjFile::default();
    let mut lines = Lines { rest: bytes, number: 0 };
    progress.begin(Doing::Reading, bytes.len());
    let mut told = bytes.len();
    while let Some(line) = lines.next() {
        if told - lines.rest.len() >= STRETCH {
            progress.advance(told - lines.rest.len());
            told = lines.rest.len();
            if progress.is_cancelled() {
                return Err(MeshError::Cancelled);
            }
        }
        let number = lines.number;
        file.read_line(&line, number, read_file).map_err(|fault| MeshError::Obj { line: number, fault })?;
    }
    if let Some((line, fault)) = file.missing() {
        return Err(MeshError::Obj { line, fault });
    }
    file.end_part();
    let parts = std::mem::take(&mut file.parts);
    let parts = parts.into_iter().map(|part| {
        if progress.is_cancelled() {
            return Err(MeshError::Cancelled);
        }
        let color = part.material.and_then(|index| file.materials.get(index)).map(|material| material.color());
        let mesh = file.soup(&part).into_mesh()?;
        let two_sided = !mesh.closed;
        Ok(Part { name: part.name, two_sided, mesh: Arc::new(mesh), file_from_part: DMat4::IDENTITY, color })
    });
    parts.filter(|part| !matches!(part, Ok(part) if part.mesh.triangles.is_empty())).collect()
}

/// The lines of a file; one that ends with `\` goes on in the next.
struct Lines<'a> {
    rest: &'a [u8],
    /// The number of the last line that was read, from 1.
    number: usize,
}

impl Lines<'_> {
    fn next(&mut self) -> Option<String> {
        let mut whole = Vec::new();
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|&b| b == b'\n').map_or(self.rest.len(), |n| n + 1);
            let (line, rest) = self.rest.split_at(end);
            self.rest = rest;
            self.number += 1;
            let line = line.trim_ascii_end();
            match line.strip_suffix(b"\\") {
                Some(begun) if !rest.is_empty() => {
                    whole.extend_from_slice(begun);
                    whole.push(b' ');
                }
                begun => {
                    whole.extend_from_slice(begun.unwrap_or(line));
                    return Some(String::from_utf8_lossy(&whole).into_owned());
                }
            }
        }
        None
    }
}

/// What has been read of a file.
#[derive(Default)]
struct ObjFile {
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// A corner came without a normal.
    normals_lack: bool,
    /// The corner that names the point or normal farthest behind what was there: index (from 1), line, corner.
    ahead: [Option<(usize, usize, String)>; 2],
    materials: Vec<Material>,
    material_of: HashMap<String, usize>,
    /// The material libraries that have been asked for.
    libraries: HashSet<String>,
    parts: Vec<Faces>,
    /// The part that is being read.
    open: Faces,
}

/// The faces of an object that have one material.
#[derive(Clone, Default)]
struct Faces {
    name: String,
    material: Option<usize>,
    /// For each corner its point and, where it has one, its normal, from 0.
    corners: Vec<(usize, Option<usize>)>,
    /// The number of corners of each face.
    arities: Vec<u32>,
}

/// The colour of a material and its opacity.
#[derive(Clone, Copy, Default)]
struct Material {
    diffuse: Option<[f64; 3]>,
    opacity: Option<f64>,
}

impl Material {
    fn color(self) -> Rgba {
        let byte = |share: f64| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
            let byte = (share.clamp(0.0, 1.0) * 255.0).round() as u8;
            byte
        };
        let [r, g, b] = self.diffuse.unwrap_or([0.8; 3]).map(byte);
        Rgba::rgba(r, g, b, byte(self.opacity.unwrap_or(1.0)))
    }
}

impl ObjFile {
    fn read_line(&mut self, line: &str, number: usize, read_file: &mut Beside<'_>) -> Result<(), ObjFault> {
        let line = line.trim_start();
        let (keyword, values) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        // Names may hold a #, numbers are followed by comments.
        let name = values.trim();
        let numbers = values.split('#').next().unwrap_or_default();
        match keyword {
            "v" => self.points.push(point(numbers)?),
            "vn" => self.normals.push(vector(numbers)?),
            "f" => self.face(numbers, number)?,
            "o" | "g" if !name.is_empty() => {
                self.end_part();
                name.clone_into(&mut self.open.name);
            }
            "usemtl" if !name.is_empty() => {
                let material = self.material_of.get(name).copied();
                if material != self.open.material {
                    self.end_part();
                }
                self.open.material = material;
            }
            "mtllib" if !name.is_empty() => self.library(name, read_file),
            _ => {}
        }
        Ok(())
    }

    /// What comes next belongs to another part, of the same name and material unless they change.
    fn end_part(&mut self) {
        if self.open.arities.is_empty() {
            return;
        }
        let next = Faces { name: self.open.name.clone(), material: self.open.material, ..Faces::default() };
        self.parts.push(std::mem::replace(&mut self.open, next));
    }

    /// Reads a material library; without one that can be read, its materials have no colour.
    fn library(&mut self, name: &str, read_file: &mut Beside<'_>) {
        if !self.libraries.insert(name.to_owned()) {
            return;
        }
        let Ok(bytes) = read_file(name) else { return };
        let mut material = None;
        for line in String::from_utf8_lossy(&bytes).lines() {
            let line = line.trim();
            let (keyword, values) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let numbers: Vec<f64> = values.split_whitespace().map_while(|word| word.parse().ok()).collect();
            if keyword == "newmtl" && !values.trim().is_empty() {
                self.material_of.insert(values.trim().to_owned(), self.materials.len());
                self.materials.push(Material::default());
                material = self.materials.len().checked_sub(1);
            }
            let Some(material) = material.and_then(|index| self.materials.get_mut(index)) else { continue };
            match (keyword, &numbers[..]) {
                ("Kd", &[r, g, b, ..]) => material.diffuse = Some([r, g, b]),
                ("d", &[opacity, ..]) => material.opacity = Some(opacity),
                ("Tr", &[transparency, ..]) => material.opacity = Some(1.0 - transparency),
                _ => {}
            }
        }
    }

    fn face(&mut self, values: &str, line: usize) -> Result<(), ObjFault> {
        let found = values.split_whitespace().count();
        if found < 3 {
            return Err(ObjFault::Corners { found });
        }
        for corner in values.split_whitespace() {
            let (point, normal) = indices(corner).ok_or_else(|| ObjFault::Corner { found: shown(corner) })?;
            let point = self.resolve(0, point, corner, line)?;
            let normal = normal.map(|index| self.resolve(1, index, corner, line)).transpose()?;
            self.normals_lack |= normal.is_none();
            self.open.corners.push((point, normal));
        }
        self.open.arities.push(index_u32(found));
        Ok(())
    }

    /// The index of a point (`which` = 0) or normal (1), from 0; in the file they count from 1, and negative ones count back
    /// from the last one so far.
    fn resolve(&mut self, which: usize, index: i64, corner: &str, line: usize) -> Result<usize, ObjFault> {
        let so_far = [self.points.len(), self.normals.len()][which];
        let from_one = if index < 0 {
            usize::try_from(index.unsigned_abs()).ok().and_then(|back| (so_far + 1).checked_sub(back))
        } else {
            usize::try_from(index).ok()
        };
        let from_one = from_one.filter(|&i| i > 0).ok_or_else(|| self.no_such_index(corner))?;
        if from_one > so_far && self.ahead[which].as_ref().is_none_or(|ahead| from_one > ahead.0) {
            self.ahead[which] = Some((from_one, line, corner.to_owned()));
        }
        Ok(from_one - 1)
    }

    fn no_such_index(&self, corner: &str) -> ObjFault {
        ObjFault::Index { found: shown(corner), points: self.points.len(), normals: self.normals.len() }
    }

    /// A corner that names what did not come until the end of the file.
    fn missing(&self) -> Option<(usize, ObjFault)> {
        let there = [self.points.len(), self.normals.len()];
        self.ahead.iter().zip(there).find_map(|(ahead, there)| {
            let (_, line, corner) = ahead.as_ref().filter(|ahead| ahead.0 > there)?;
            Some((*line, self.no_such_index(corner)))
        })
    }

    /// A part with only those points and normals that it uses, in the order in which it does.
    fn soup(&self, part: &Faces) -> Soup {
        let mut soup = Soup { arities: part.arities.clone(), ..Soup::default() };
        let (mut point_of, mut normal_of) = (HashMap::new(), HashMap::new());
        for &(point, normal) in &part.corners {
            soup.corners.push(*point_of.entry(point).or_insert_with(|| {
                soup.positions.push(self.points[point]);
                index_u32(soup.positions.len() - 1)
            }));
            // A file that gives only some normals gives none.
            let Some(normal) = normal.filter(|_| !self.normals_lack) else { continue };
            soup.corner_normals.push(*normal_of.entry(normal).or_insert_with(|| {
                soup.normals.push(self.normals[normal]);
                index_u32(soup.normals.len() - 1)
            }));
        }
        soup
    }
}

/// Point and normal of a corner as they are written: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
fn indices(corner: &str) -> Option<(i64, Option<i64>)> {
    let fields: Vec<&str> = corner.split('/').collect();
    let index = |field: &str| field.parse::<i64>().ok();
    match fields[..] {
        [v] => Some((index(v)?, None)),
        [v, vt] => index(vt).and(Some((index(v)?, None))),
        [v, "", vn] => Some((index(v)?, Some(index(vn)?))),
        [v, vt, vn] => index(vt).and(Some((index(v)?, Some(index(vn)?)))),
        _ => None,
    }
}

/// A point: three coordinates, and where there are four numbers its weight. More are the colour of the vertex.
fn point(values: &str) -> Result<DVec3, ObjFault> {
    let words: Vec<&str> = values.split_whitespace().collect();
    let point = vector(values)?;
    let [_, _, _, weight] = words[..] else { return Ok(point) };
    let divided = point / number(weight)?;
    if divided.is_finite() { Ok(divided) } else { Err(ObjFault::Number { found: shown(weight) }) }
}

/// The first three numbers.
fn vector(values: &str) -> Result<DVec3, ObjFault> {
    let numbers: Vec<f64> = values.split_whitespace().take(3).map(number).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] => Ok(DVec3::new(x, y, z)),
        _ => Err(ObjFault::Coordinates { found: numbers.len() }),
    }
}

fn number(word: &str) -> Result<f64, ObjFault> {
    word.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| ObjFault::Number { found: shown(word) })
}
