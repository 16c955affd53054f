//! Wavefront OBJ: points, normals, texture coordinates, faces, objects, and the colours and textures of their
//! materials. All other content is left out. Faults of other programs that don't harm the surface are left out with a
//! [`MeshNotice`].

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::{DMat4, DVec3};

use super::part::{Imported, Part, PartTexture, note};
use super::soup::Soup;
use crate::appearance::{Rgba, Sampler, Wrap};
use crate::limits::MAX_OBJECTS;
use crate::progress::{Activity, Progress, pause};
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::mesh::polygon::Triangulator;
use crate::scene::read_error::Beside;
use crate::scene::texture::{Alpha, Textures};
use crate::scene::{MeshError, MeshNotice, ObjFault};

/// Bytes read between two checks whether the work was cancelled.
const STRETCH: usize = 1 << 16;

/// The objects of an OBJ file. One that has several materials comes in several parts, one for each, however often the
/// file changes between them.
///
/// # Errors
/// [`MeshError::Obj`] with the line, and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], read_file: &mut Beside<'_>, progress: &Progress) -> Result<Imported, MeshError> {
    let mut file = ObjFile::default();
    let mut lines = Lines { rest: bytes, number: 0 };
    progress.begin(Activity::Reading, bytes.len());
    let mut told = bytes.len();
    while let Some(line) = lines.next() {
        if told - lines.rest.len() >= STRETCH {
            progress.advance_and_pause(told - lines.rest.len()).await;
            told = lines.rest.len();
            if progress.is_cancelled() {
                return Err(MeshError::Cancelled);
            }
        }
        let number = lines.number;
        file.read_line(&line, number, read_file).map_err(|fault| MeshError::Obj { line: number, fault })?;
        if file.parts.len() > MAX_OBJECTS {
            return Err(MeshError::TooManyObjects);
        }
    }
    if let Some((line, found)) = file.points_ahead.beyond(file.points.len()) {
        return Err(MeshError::Obj { line, fault: file.no_such_point(&found) });
    }
    file.end_part();
    let mut notices = file.notices();
    let mut textures = Textures::default();
    let mut parts = Vec::new();
    let mut triangulator = Triangulator::default();
    for part in std::mem::take(&mut file.parts) {
        pause().await;
        if progress.is_cancelled() {
            return Err(MeshError::Cancelled);
        }
        let (mesh, uv) = file.soup(&part).into_mesh(&mut triangulator)?;
        if mesh.triangles.is_empty() {
            continue;
        }
        let material = part.material.and_then(|index| file.materials.get(index));
        if let Some(invisible) = material.filter(|material| material.is_invisible()) {
            note(&mut notices, MeshNotice::Invisible { material: escaped(&invisible.name) });
        }
        let color = material.map(Material::color);
        let two_sided = !mesh.closed;
        let map = material.and_then(|material| material.map.as_ref()).filter(|_| !uv.is_empty());
        let texture = map.and_then(|map| {
            PartTexture::new(textures.get(&map.file, Alpha::Ignored, read_file), map.sampler(), &mut notices)
        });
        parts.push(Part {
            name: part.name,
            two_sided,
            mesh: Arc::new(mesh),
            file_from_part: DMat4::IDENTITY,
            color,
            uv: Arc::new(uv),
            texture,
        });
    }
    if triangulator.cut_as_convex > 0 {
        notices.push(MeshNotice::CutAsConvex { count: triangulator.cut_as_convex });
    }
    Ok(Imported { parts, notices })
}

/// The lines of a file. One that ends with `\` continues in the next.
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

/// The part of a file read so far.
#[derive(Default)]
struct ObjFile {
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// (0, 0) at the top left of the picture.
    texture_coordinates: Vec<[f32; 2]>,
    /// A corner came without a normal.
    normals_lack: bool,
    /// Corners that name points not yet read.
    points_ahead: Ahead,
    normals_ahead: Ahead,
    texture_coordinates_ahead: Ahead,
    /// The first corner whose normal or texture coordinate can't exist: line, corner.
    impossible: Option<(usize, String)>,
    /// The first face with fewer than three corners (its line and their number), and how many such faces there are.
    skipped: Option<(usize, usize)>,
    skipped_count: usize,
    materials: Vec<Material>,
    material_of: HashMap<String, usize>,
    /// The material libraries requested.
    libraries: HashSet<String>,
    parts: Vec<Faces>,
    /// Their places, by name and material.
    part_of: HashMap<(String, Option<usize>), usize>,
    /// The part that is being read.
    open: Faces,
}

/// The corner that looks farthest ahead, among those that name something later in the file.
#[derive(Default)]
struct Ahead(Option<(usize, usize, String)>);

impl Ahead {
    /// A corner on this line names number `from_one`, when there are `so_far`.
    fn note(&mut self, from_one: usize, so_far: usize, corner: &str, line: usize) {
        if from_one > so_far && self.0.as_ref().is_none_or(|(farthest, ..)| from_one > *farthest) {
            self.0 = Some((from_one, line, corner.to_owned()));
        }
    }

    /// Line and corner, if it names more than there are at the end.
    fn beyond(&self, there: usize) -> Option<(usize, String)> {
        let (_, line, corner) = self.0.as_ref().filter(|(farthest, ..)| *farthest > there)?;
        Some((*line, corner.clone()))
    }
}

/// The faces of an object that have one material.
#[derive(Clone, Default)]
struct Faces {
    name: String,
    material: Option<usize>,
    /// For each corner its point and, if it has them, its normal and its texture coordinate, from 0.
    corners: Vec<(usize, Option<usize>, Option<usize>)>,
    /// The number of corners of each face.
    arities: Vec<u32>,
}

/// The colour of a material and its opacity.
#[derive(Clone, Default)]
struct Material {
    name: String,
    diffuse: Option<[f64; 3]>,
    opacity: Option<f64>,
    map: Option<Map>,
}

/// The texture of a material.
#[derive(Clone)]
struct Map {
    file: String,
    /// `-clamp on`.
    clamps: bool,
}

impl Map {
    /// The value of `map_Kd`: options, then the name of a file, which may have spaces.
    fn read(values: &str) -> Option<Self> {
        let mut clamps = false;
        let mut rest = values.trim();
        while let Some(option) = rest.strip_prefix('-') {
            let (name, after) = option.split_once(char::is_whitespace)?;
            let numbers = match name {
                "blendu" | "blendv" | "cc" | "clamp" | "boost" | "texres" | "bm" | "imfchan" | "type" => 1..=1,
                "mm" => 2..=2,
                // One to three numbers.
                _ => 1..=3,
            };
            rest = after.trim_start();
            for k in 1..=*numbers.end() {
                let (word, after) = rest.split_once(char::is_whitespace)?;
                if k > *numbers.start() && word.parse::<f64>().is_err() {
                    break;
                }
                clamps |= name == "clamp" && word == "on";
                rest = after.trim_start();
            }
        }
        (!rest.is_empty()).then(|| Self { file: rest.to_owned(), clamps })
    }

    fn sampler(&self) -> Sampler {
        let wrap = if self.clamps { Wrap::Clamp } else { Wrap::Repeat };
        Sampler { wrap_u: wrap, wrap_v: wrap, ..Sampler::default() }
    }
}

impl Material {
    /// True if its objects would be invisible. Several programs write `Tr 1` for opaque materials.
    fn is_invisible(&self) -> bool {
        byte(self.opacity.unwrap_or(1.0)) == 0
    }

    fn color(&self) -> Rgba {
        // A picture shows its own colours if the material has none.
        let unsaid = if self.map.is_some() { 1.0 } else { 0.8 };
        let [r, g, b] = self.diffuse.unwrap_or([unsaid; 3]).map(byte);
        let alpha = if self.is_invisible() { 255 } else { byte(self.opacity.unwrap_or(1.0)) };
        Rgba::rgba(r, g, b, alpha)
    }
}

fn byte(share: f64) -> u8 {
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let byte = (share.clamp(0.0, 1.0) * 255.0).round() as u8;
    byte
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
            "vt" => self.texture_coordinates.push(texture_coordinate(numbers)),
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

    /// Ends a part: the following faces belong to another one, perhaps to an earlier one of the same name and material.
    fn end_part(&mut self) {
        if self.open.arities.is_empty() {
            return;
        }
        let next = Faces { name: self.open.name.clone(), material: self.open.material, ..Faces::default() };
        let part = std::mem::replace(&mut self.open, next);
        match self.part_of.entry((part.name.clone(), part.material)) {
            Entry::Occupied(there) => {
                let there = &mut self.parts[*there.get()];
                there.corners.extend(part.corners);
                there.arities.extend(part.arities);
            }
            Entry::Vacant(place) => {
                place.insert(self.parts.len());
                self.parts.push(part);
            }
        }
    }

    /// Reads a material library. If it can't be read, its materials have no colour.
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
                self.materials.push(Material { name: values.trim().to_owned(), ..Material::default() });
                material = self.materials.len().checked_sub(1);
            }
            let Some(material) = material.and_then(|index| self.materials.get_mut(index)) else { continue };
            if keyword == "map_Kd" {
                material.map = Map::read(values);
            }
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
            self.skipped.get_or_insert((line, found));
            self.skipped_count += 1;
            return Ok(());
        }
        for word in values.split_whitespace() {
            let corner = ObjCorner::read(word).ok_or_else(|| ObjFault::Corner { found: escaped(word) })?;
            let point = from_one(corner.point, self.points.len()).ok_or_else(|| self.no_such_point(word))?;
            self.points_ahead.note(point, self.points.len(), word, line);
            let mut beside = |index: Option<i64>, so_far: usize, ahead: &mut Ahead| {
                let place = from_one(index?, so_far);
                match place {
                    Some(i) => ahead.note(i, so_far, word, line),
                    None => drop(self.impossible.get_or_insert_with(|| (line, word.to_owned()))),
                }
                place
            };
            let (uvs, normals) = (self.texture_coordinates.len(), self.normals.len());
            let texture_coordinate = beside(corner.texture_coordinate, uvs, &mut self.texture_coordinates_ahead);
            let normal = beside(corner.normal, normals, &mut self.normals_ahead);
            self.normals_lack |= normal.is_none();
            let uv = texture_coordinate.map(|i| i - 1);
            self.open.corners.push((point - 1, normal.map(|i| i - 1), uv));
        }
        self.open.arities.push(index_u32(found));
        Ok(())
    }

    fn no_such_point(&self, corner: &str) -> ObjFault {
        ObjFault::Index { found: escaped(corner), points: self.points.len() }
    }

    /// The parts of the file that were left out. Collected at its end. A face may come before the points it names.
    fn notices(&mut self) -> Vec<MeshNotice> {
        let no_normal = self.normals_ahead.beyond(self.normals.len());
        self.normals_lack |= no_normal.is_some();
        let lost = self.impossible.take().into_iter().chain(no_normal);
        let lost = lost.chain(self.texture_coordinates_ahead.beyond(self.texture_coordinates.len()));
        let lost = lost.min().map(|(line, found)| MeshNotice::IndexIgnored { line, found: escaped(&found) });
        let count = self.skipped_count;
        let skipped = self.skipped.map(|(line, found)| MeshNotice::FacesSkipped { line, found, count });
        lost.into_iter().chain(skipped).collect()
    }

    /// A part with only those points and normals that it uses, in the order in which it does.
    fn soup(&self, part: &Faces) -> Soup {
        let mut soup = Soup { arities: part.arities.clone(), ..Soup::default() };
        let (mut point_of, mut normal_of) = (HashMap::new(), HashMap::new());
        let has_uv = part.corners.iter().any(|(_, _, uv)| uv.is_some());
        for &(point, normal, uv) in &part.corners {
            if has_uv {
                let own = uv.and_then(|uv| self.texture_coordinates.get(uv).copied());
                soup.corner_uv.push(own.unwrap_or_default());
            }
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

/// An index of the file. Indices begin with 1, and negative ones count back from the last one so far. `None` for
/// indices that can never exist.
fn from_one(index: i64, so_far: usize) -> Option<usize> {
    let index = if index < 0 {
        usize::try_from(index.unsigned_abs()).ok().and_then(|back| (so_far + 1).checked_sub(back))
    } else {
        usize::try_from(index).ok()
    };
    index.filter(|&i| i > 0)
}

/// The indices of a corner as written: `v`, `v/vt`, `v//vn` or `v/vt/vn`; the number after a `/` may be missing.
struct ObjCorner {
    point: i64,
    texture_coordinate: Option<i64>,
    normal: Option<i64>,
}

impl ObjCorner {
    fn read(word: &str) -> Option<Self> {
        let mut fields = word.split('/');
        let point = fields.next()?.parse().ok()?;
        let mut beside = || match fields.next() {
            None | Some("") => Some(None),
            Some(field) => field.parse().ok().map(Some),
        };
        let (texture_coordinate, normal) = (beside()?, beside()?);
        fields.next().is_none().then_some(Self { point, texture_coordinate, normal })
    }
}

/// A point: three coordinates. A fourth number is its weight, and more numbers are the colour of the vertex.
fn point(values: &str) -> Result<DVec3, ObjFault> {
    let words: Vec<&str> = values.split_whitespace().collect();
    let point = vector(values)?;
    let [_, _, _, weight] = words[..] else { return Ok(point) };
    let divided = point / number(weight)?;
    if divided.is_finite() { Ok(divided) } else { Err(ObjFault::Number { found: escaped(weight) }) }
}

/// The first two numbers, v downwards. Anything else counts as 0, which leaves the surface the same.
fn texture_coordinate(values: &str) -> [f32; 2] {
    let mut numbers = values.split_whitespace().map(|word| word.parse().ok().filter(|v: &f32| v.is_finite()));
    let mut next = || numbers.next().flatten().unwrap_or(0.0);
    let (u, v) = (next(), next());
    [u, 1.0 - v]
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
    word.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| ObjFault::Number { found: escaped(word) })
}
