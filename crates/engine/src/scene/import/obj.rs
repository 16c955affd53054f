//! Wavefront OBJ: points with their colours, normals, texture coordinates, faces, objects, and the colours and textures
//! of their materials. All other entries, and faults of other programs that don't harm the surface, are left out with a
//! [`MeshNotice`]. How a material shines isn't read.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

use glam::DVec3;

use super::part::{Imported, LeftOut, Part, PartTexture, Stretches, byte, note, vertex_colors};
use super::soup::Soup;
use crate::appearance::{Rgba, Sampler, Wrap};
use crate::limits::MAX_OBJECTS;
use crate::progress::{Progress, pause};
use crate::sanitize::escaped;
use crate::scene::mesh::index_u32;
use crate::scene::mesh::polygon::Triangulator;
use crate::scene::read_error::Beside;
use crate::scene::texture::{Alpha, Textures};
use crate::scene::{MeshError, MeshFault, MeshNotice};

/// The objects of an OBJ file. One that has several materials comes in several parts, one for each, however often the
/// file changes between them.
///
/// # Errors
/// [`MeshError::Line`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], read_file: &mut Beside<'_>, progress: &Progress) -> Result<Imported, MeshError> {
    let mut file = ObjFile::default();
    let mut lines = Lines::new(bytes);
    let mut stretches = Stretches::begin(progress, bytes);
    while let Some(line) = lines.whole() {
        stretches.advance_to(bytes.len() - lines.rest.len()).await?;
        let number = lines.number;
        file.read_line(&line, number, read_file).map_err(|fault| MeshError::Line { line: number, fault })?;
        if file.parts.len() > MAX_OBJECTS {
            return Err(MeshError::TooManyObjects);
        }
    }
    if let Some((line, found)) = file.points_ahead.beyond(file.points.len()) {
        return Err(MeshError::Line { line, fault: file.no_such_point(&found) });
    }
    file.end_part();
    let mut notices = file.notices();
    let mut textures = Textures::default();
    let mut parts = Vec::new();
    let mut triangulator = Triangulator::default();
    let colors = vertex_colors(&file.colors);
    for faces in std::mem::take(&mut file.parts) {
        pause().await;
        if progress.is_cancelled() {
            return Err(MeshError::Cancelled);
        }
        let material = faces.material.and_then(|index| file.materials.get(index)).filter(|material| material.is_known);
        let part = file.soup(&faces, &colors, material).into_part(&mut triangulator)?;
        if part.mesh.triangles.is_empty() {
            continue;
        }
        if let Some(invisible) = material.filter(|material| material.is_invisible()) {
            note(&mut notices, MeshNotice::Invisible { material: escaped(&invisible.name) });
        }
        let map = material.and_then(|material| material.map.as_ref()).filter(|_| !part.uv.is_empty());
        let texture = map.and_then(|map| {
            PartTexture::new(textures.get(&map.file, Alpha::Ignored, read_file), map.sampler(), &mut notices)
        });
        parts.push(Part {
            name: faces.name,
            color: part.color.or_else(|| material.map(Material::color)),
            texture,
            ..part
        });
    }
    notices.extend(triangulator.notice());
    Ok(Imported { parts, notices })
}

/// The lines of a text, which ends them with LF, CR LF or CR, and may begin with a byte order mark.
pub(super) struct Lines<'a> {
    pub(super) rest: &'a [u8],
    /// The number of the last line that was read, from 1.
    pub(super) number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes), number: 0 }
    }

    /// The next line, without its end and blanks before that.
    pub(super) fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let length = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
        let (line, end) = self.rest.split_at(length);
        self.rest = end.strip_prefix(b"\r\n").or(end.get(1..)).unwrap_or_default();
        self.number += 1;
        Some(line.trim_ascii_end())
    }

    /// The next line. One that ends with `\` continues in the next.
    fn whole(&mut self) -> Option<String> {
        let mut whole = Vec::new();
        while let Some(line) = self.line() {
            match line.strip_suffix(b"\\") {
                Some(begun) if !self.rest.is_empty() => {
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
    /// The colours behind the coordinates of points, up to the last one that has any. NaN if a point has none.
    colors: Vec<[f32; 4]>,
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
    left_out: LeftOut,
    smoothing_groups: usize,
    materials: Vec<Material>,
    material_of: HashMap<String, usize>,
    /// The material libraries requested.
    libraries: HashSet<String>,
    /// One of them can't be read.
    library_lacks: bool,
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
    /// A library has it.
    is_known: bool,
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

impl ObjFile {
    fn read_line(&mut self, line: &str, number: usize, read_file: &mut Beside<'_>) -> Result<(), MeshFault> {
        let line = line.trim_start();
        let (keyword, values) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        // Names may hold a #, numbers are followed by comments.
        let name = values.trim();
        let numbers = values.split('#').next().unwrap_or_default();
        match keyword {
            "v" => self.point(numbers)?,
            "vn" => self.normals.push(vector(numbers.split_whitespace())?),
            "vt" => self.texture_coordinates.push(texture_coordinate(numbers)),
            "f" | "fo" => self.face(numbers, number)?,
            "o" | "g" if !name.is_empty() => {
                self.end_part();
                name.clone_into(&mut self.open.name);
            }
            "usemtl" if !name.is_empty() => {
                // Its library may come later.
                let material = Some(self.material(name));
                if material != self.open.material {
                    self.end_part();
                }
                self.open.material = material;
            }
            "mtllib" => file_names(name).for_each(|name| self.library(name, read_file)),
            "s" => self.smoothing_groups += 1,
            "o" | "g" | "usemtl" | "" => {}
            _ if keyword.starts_with('#') => {}
            _ => self.left_out.add(keyword, 1),
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

    /// A point: three coordinates. A fourth number is its weight, and three more are its colour.
    fn point(&mut self, values: &str) -> Result<(), MeshFault> {
        let point = vector(values.split_whitespace())?;
        let more = || values.split_whitespace().skip(3);
        let count = more().count();
        let weight = if count == 1 { more().next() } else { None };
        let divided = weight.map_or(Ok(point), |weight| Ok(point / number(weight)?))?;
        if !divided.is_finite() {
            return Err(MeshFault::Number { found: escaped(weight.unwrap_or_default()) });
        }
        self.points.push(divided);
        let channels: Vec<f32> = more().take(3).map_while(|word| word.parse().ok()).collect();
        if let [r, g, b] = channels[..] {
            self.colors.resize(self.points.len() - 1, [f32::NAN; 4]);
            self.colors.push([r, g, b, f32::INFINITY]);
        }
        self.left_out.add("v x y z …", usize::from(!matches!((count, channels.len()), (0 | 1, _) | (3, 3))));
        Ok(())
    }

    /// The index of the material with this name.
    fn material(&mut self, name: &str) -> usize {
        if let Some(&known) = self.material_of.get(name) {
            return known;
        }
        self.material_of.insert(name.to_owned(), self.materials.len());
        self.materials.push(Material { name: name.to_owned(), ..Material::default() });
        self.materials.len() - 1
    }

    /// Reads a material library. If it can't be read, its materials have no colour.
    fn library(&mut self, name: &str, read_file: &mut Beside<'_>) {
        if !self.libraries.insert(name.to_owned()) {
            return;
        }
        let Ok(bytes) = read_file(name) else { return self.library_lacks = true };
        let mut lines = Lines::new(&bytes);
        let mut material = None;
        while let Some(line) = lines.whole() {
            let line = line.trim();
            let (keyword, values) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let numbers: Vec<f64> = values.split_whitespace().map_while(|word| word.parse().ok()).collect();
            if keyword == "newmtl" && !values.trim().is_empty() {
                let index = self.material(values.trim());
                self.materials[index] =
                    Material { name: values.trim().to_owned(), is_known: true, ..Material::default() };
                material = Some(index);
            }
            let Some(material) = material.and_then(|index| self.materials.get_mut(index)) else { continue };
            match (keyword, &numbers[..]) {
                ("map_Kd", _) => material.map = Map::read(values),
                ("Kd", &[r, g, b, ..]) => material.diffuse = Some([r, g, b]),
                ("d", &[opacity, ..]) => material.opacity = Some(opacity),
                ("Tr", &[transparency, ..]) => material.opacity = Some(1.0 - transparency),
                ("bump" | "disp" | "decal" | "norm" | "refl", _) => self.left_out.add(keyword, 1),
                _ if keyword.starts_with("map_") => self.left_out.add(keyword, 1),
                _ => {}
            }
        }
    }

    fn face(&mut self, values: &str, line: usize) -> Result<(), MeshFault> {
        let found = values.split_whitespace().count();
        if found < 3 {
            self.skipped.get_or_insert((line, found));
            self.skipped_count += 1;
            return Ok(());
        }
        for word in values.split_whitespace() {
            let corner = ObjCorner::read(word).ok_or_else(|| MeshFault::Corner { found: escaped(word) })?;
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

    fn no_such_point(&self, corner: &str) -> MeshFault {
        MeshFault::Index { found: escaped(corner), points: self.points.len() }
    }

    /// The parts of the file that were left out. Collected at its end. A face may come before the points it names.
    fn notices(&mut self) -> Vec<MeshNotice> {
        let no_normal = self.normals_ahead.beyond(self.normals.len());
        self.normals_lack |= no_normal.is_some();
        let lost = self.impossible.take().into_iter().chain(no_normal);
        let lost = lost.chain(self.texture_coordinates_ahead.beyond(self.texture_coordinates.len()));
        let lost = lost.min().map(|(line, found)| MeshNotice::IndexIgnored { line, found: escaped(&found) });
        if self.normals_lack {
            // All are found from the faces.
            self.left_out.add("s", self.smoothing_groups);
            self.left_out.add("vn", if lost.is_none() { self.normals.len() } else { 0 });
        }
        let count = self.skipped_count;
        let skipped = self.skipped.map(|(line, found)| MeshNotice::FacesSkipped { line, found, count });
        let left_out = std::mem::take(&mut self.left_out).notice();
        let mut unknown = self.materials.iter().filter(|material| !material.is_known && !self.library_lacks);
        let first = unknown.next().map(|first| escaped(&first.name));
        let unknown = first.map(|material| MeshNotice::NoMaterial { material, count: 1 + unknown.count() });
        lost.into_iter().chain(skipped).chain(left_out).chain(unknown).collect()
    }

    /// A part with only those points and normals that it uses, in the order in which it does.
    fn soup(&self, part: &Faces, colors: &[Rgba], material: Option<&Material>) -> Soup {
        let mut soup = Soup { arities: part.arities.clone(), ..Soup::default() };
        let (mut point_of, mut normal_of) = (HashMap::new(), HashMap::new());
        let has_uv = part.corners.iter().any(|(_, _, uv)| uv.is_some());
        // In place of the colour of the material, with its opacity.
        let color = |point: usize| {
            let is_there = self.colors.get(point).is_some_and(|[r, ..]| !r.is_nan());
            let color = colors.get(point).filter(|_| is_there)?;
            Some(Rgba { a: material.map_or(255, |material| material.color().a), ..*color })
        };
        let has_colors = part.corners.iter().any(|(point, ..)| color(*point).is_some());
        let unsaid = material.unwrap_or(&Material::default()).color();
        for &(point, normal, uv) in &part.corners {
            if has_colors {
                soup.corner_colors.push(color(point).unwrap_or(unsaid));
            }
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

/// The names of libraries, which may have spaces. Each but the last ends with `.mtl`.
fn file_names(names: &str) -> impl Iterator<Item = &str> {
    let is_end =
        |at: usize| names[..at].get(at.saturating_sub(4)..).is_some_and(|end| end.eq_ignore_ascii_case(".mtl"));
    let mut first = 0;
    let spaces = names.match_indices(char::is_whitespace).map(|(at, _)| at).chain([names.len()]);
    let ends = spaces.filter(move |&at| at == names.len() || is_end(at));
    ends.map(move |at| names[std::mem::replace(&mut first, at)..at].trim()).filter(|name| !name.is_empty())
}

/// The first two numbers, v downwards. Anything else counts as 0, which leaves the surface the same.
fn texture_coordinate(values: &str) -> [f32; 2] {
    let mut numbers = values.split_whitespace().map(|word| word.parse().ok().filter(|v: &f32| v.is_finite()));
    let mut next = || numbers.next().flatten().unwrap_or(0.0);
    let (u, v) = (next(), next());
    [u, 1.0 - v]
}

/// The first three numbers.
pub(super) fn vector<'a>(words: impl Iterator<Item = &'a str>) -> Result<DVec3, MeshFault> {
    let mut found = [0.0; 3];
    let mut count = 0;
    for (coordinate, word) in found.iter_mut().zip(words) {
        *coordinate = number(word)?;
        count += 1;
    }
    if count == 3 { Ok(found.into()) } else { Err(MeshFault::Coordinates { found: count }) }
}

pub(super) fn number(word: &str) -> Result<f64, MeshFault> {
    word.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| MeshFault::Number { found: escaped(word) })
}
