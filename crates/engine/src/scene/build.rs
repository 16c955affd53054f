//! Builds a scene from its specification in a figure: objects with their meshes, lines, marks, texts and lights.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::import::PartTexture;
use super::palette::{PALETTE, SceneColors};
use super::texture::{Alpha, UvMesh, builtin, mapped};
use super::tree::presets;
use super::tree::resolve::{Placed, allowed_segments, lights, place};
use super::{
    Adjacency, Line, Mesh, MeshFiles, MeshNotice, Object, ObjectPaint, ObjectSpec, Pictured, ReadFile, Scene,
    SceneError, SceneSpec, Shape, TextureError, TextureSource, Wanted, object_name, point_mark, primitives,
};
use crate::appearance::{LineStyle, MarkShape, Rgba, Sampler, Style, Texture};
use crate::limits::MAX_OBJECTS;
use crate::sanitize::escaped;

/// Makes the scene that `spec` describes, the preset's objects and then its own, in the colours of the style's theme.
///
/// Each object's model matrix is its ancestors' times T · R · S, with R = Rz · Ry · Rx, `[3]`. An object without a
/// colour has its nearest ancestor's, else the next one of [`PALETTE`]. A single point carries its object's name as a
/// label. Without lights there is one, [`DEFAULT_LIGHT`](super::DEFAULT_LIGHT).
///
/// *Guarantees*: all matrices are finite and, up to rounding, invertible.
///
/// # Errors
/// [`SceneError`] names the object and its fault.
pub fn build(spec: &SceneSpec, style: &Style, read_file: &mut ReadFile<'_>) -> Result<Scene, SceneError> {
    build_with(spec, style, read_file, &mut MeshFiles::default())
}

/// Like [`build`], for scenes that are built again and again. `files` caches the mesh files that `spec` uses.
///
/// # Errors
/// [`SceneError`] names the object and its fault.
pub fn build_with(
    spec: &SceneSpec,
    style: &Style,
    read_file: &mut ReadFile<'_>,
    files: &mut MeshFiles,
) -> Result<Scene, SceneError> {
    let colors = SceneColors::of(style.theme);
    let preset = presets::objects(spec.preset, &colors);
    let placed_preset = place(&preset, &[])?;
    let placed_own = place(&spec.objects, &placed_preset)?;

    let mut scene = Scene::default();
    let is_used =
        |path: &str| spec.objects.iter().any(|o| matches!(&o.shape, Some(Shape::Mesh { path: p }) if p == path));
    files.retain(is_used);
    let photograph = files.photograph.clone();
    files.textures.retain(|path| {
        let is_on_object = |o: &ObjectSpec| o.texture.as_ref().and_then(TextureSource::file) == Some(path);
        photograph.as_deref() == Some(path) || spec.objects.iter().any(is_on_object)
    });
    let before = std::mem::take(&mut files.primitives);
    let mapped_before = std::mem::take(&mut files.mapped);
    let mut maker = MeshMaker { colors, before, mapped_before, read_file, files };
    let mut turns = PALETTE.into_iter().cycle();
    let mut next_color = || turns.next().unwrap_or(PALETTE[0]);
    for placed in &placed_preset {
        maker.add(&mut scene, placed, placed.color.unwrap_or_else(&mut next_color))?;
    }
    presets::finish(spec.preset, &colors, &mut scene);
    for placed in &placed_own {
        maker.add(&mut scene, placed, placed.color.unwrap_or_else(&mut next_color))?;
        if scene.objects.len() > MAX_OBJECTS {
            return Err(SceneError::TooManyObjects);
        }
    }
    // After the textures, which come first if there's too much.
    maker.photograph(&mut scene, photograph.as_deref());
    scene.lights = lights(&spec.lights)?;
    Ok(scene)
}

/// Makes meshes. Equal ones are made once.
struct MeshMaker<'a, 'b> {
    colors: SceneColors,
    /// The primitives of the last time. Those that are used again go back to `files`.
    before: BTreeMap<(&'static str, u32), Arc<Mesh>>,
    mapped_before: BTreeMap<(&'static str, u32), UvMesh>,
    read_file: &'a mut ReadFile<'b>,
    files: &'a mut MeshFiles,
}

impl MeshMaker<'_, '_> {
    fn add(&mut self, scene: &mut Scene, placed: &Placed<'_>, color: Rgba) -> Result<(), SceneError> {
        let Some(shape) = &placed.spec.shape else { return Ok(()) };
        let name = &placed.spec.name;
        let not_finite = |key| SceneError::NotFinite { name: name.clone(), key };
        let to_world = |p: DVec3| placed.world_from_object.transform_point3(p);
        match shape {
            Shape::Grid => {
                let style = self.colors.grid_style(placed.color.unwrap_or(self.colors.grid));
                let lines = primitives::grid_lines(allowed_segments(placed.spec)?);
                let first = scene.lines.len();
                scene.lines.extend(lines.iter().map(|l| Line::new(l.map(to_world).to_vec(), style)));
                scene.grids.push((name.clone(), first..scene.lines.len()));
            }
            Shape::Points(points) => {
                if !points.iter().all(|p| to_world(*p).is_finite()) {
                    return Err(not_finite("points"));
                }
                for p in points {
                    scene.marks.push(point_mark(to_world(*p), MarkShape::Disc, color));
                }
                if let [p] = points[..] {
                    scene.texts.push(object_name(to_world(p), &escaped(name), self.colors.ink));
                }
                scene.objects.push(bare(name, Mesh::point_cloud(points.iter().copied()), placed, color, None));
            }
            Shape::Segments(segments) => {
                if !segments.iter().flatten().all(|p| to_world(*p).is_finite()) {
                    return Err(not_finite("segments"));
                }
                let style = self.colors.segment_style(color);
                let mesh = Mesh::segments(segments.iter().copied());
                scene.objects.push(bare(name, mesh, placed, color, Some(style)));
            }
            Shape::Mesh { path } => self.mesh_file(scene, placed, path, color)?,
            Shape::Box => self.solid(scene, placed, color, true, |_| primitives::cube())?,
            Shape::Prism => self.solid(scene, placed, color, true, primitives::prism)?,
            Shape::Pyramid => self.solid(scene, placed, color, true, |_| primitives::pyramid())?,
            Shape::Sphere => self.solid(scene, placed, color, false, primitives::sphere)?,
            Shape::Ellipsoid => self.solid(scene, placed, color, false, ellipsoid)?,
            Shape::Cylinder => self.solid(scene, placed, color, false, primitives::cylinder)?,
            Shape::Cone => self.solid(scene, placed, color, false, primitives::cone)?,
            Shape::Torus => self.solid(scene, placed, color, false, primitives::torus)?,
        }
        Ok(())
    }

    /// The parts of a mesh file: named after the object, and after themselves if there are several. A colour that
    /// the figure gives wins over those of the file.
    fn mesh_file(&mut self, scene: &mut Scene, placed: &Placed<'_>, path: &str, color: Rgba) -> Result<(), SceneError> {
        let name = &placed.spec.name;
        let failed = |error| SceneError::Mesh { name: name.clone(), path: path.to_owned(), error };
        let imported = self.files.get(path, self.read_file).map_err(failed)?;
        scene.notices.extend(imported.notices.iter().map(|notice| (name.clone(), notice.clone())));
        let parts = &imported.parts;
        for (k, part) in parts.iter().enumerate() {
            let world_from_object = placed.world_from_object * part.file_from_part;
            if !world_from_object.is_finite() {
                return Err(SceneError::NotFinite { name: name.clone(), key: "scale" });
            }
            let own = part.texture.as_ref();
            let texture = self.texture(scene, placed, own);
            let part_color = placed.color.or(part.color).unwrap_or(color);
            let (mesh, paint) = match texture {
                Some(_) if part.uv.is_empty() => {
                    scene.notices.push((name.clone(), MeshNotice::NoCoordinates));
                    (Arc::clone(&part.mesh), ObjectPaint::Solid(part_color))
                }
                Some((image, sampler)) => {
                    let made = || UvMesh::new(&part.mesh, &part.uv, &part.colors);
                    let textured = self.files.textured.entry((path.to_owned(), k)).or_insert_with(made);
                    // The factor of the file's material belongs to its own texture.
                    let is_own = placed.spec.texture.is_none();
                    let tint = placed.color.or(part.color.filter(|_| is_own)).unwrap_or(WHITE);
                    let has_colors = placed.color.is_none() && is_own;
                    let tints = if has_colors { Arc::clone(&textured.colors) } else { Arc::default() };
                    (Arc::clone(&textured.mesh), painted(image, sampler, &textured.uv, placed, (tint, tints)))
                }
                None if placed.color.is_none() && !part.colors.is_empty() => {
                    (Arc::clone(&part.mesh), ObjectPaint::Vertices(Arc::clone(&part.colors)))
                }
                None => (Arc::clone(&part.mesh), ObjectPaint::Solid(part_color)),
            };
            let mesh = if placed.spec.outline { self.outlined(path, k, mesh) } else { mesh };
            let part_name = if part.name.is_empty() { (k + 1).to_string() } else { part.name.clone() };
            scene.objects.push(Object {
                part_of: (parts.len() > 1).then(|| Arc::from(name.as_str())),
                two_sided: part.two_sided,
                outline: placed.spec.outline.then(|| self.colors.edge_style()),
                ..Object::new(
                    if parts.len() == 1 { name.clone() } else { format!("{name}/{part_name}") },
                    mesh,
                    world_from_object,
                    paint,
                )
            });
        }
        Ok(())
    }

    /// A part of a mesh file, with the adjacency for its outline. The corners of a texture double vertices too, so
    /// faces only meet in a crease if they aren't in one plane.
    fn outlined(&mut self, path: &str, part: usize, mesh: Arc<Mesh>) -> Arc<Mesh> {
        /// cos 20°.
        const FLAT: f64 = 0.94;
        let known = self.files.outlined.get(&(path.to_owned(), part));
        if let Some((_, outlined)) = known.filter(|(plain, _)| Arc::ptr_eq(plain, &mesh)) {
            return Arc::clone(outlined);
        }
        let mut adjacency = Adjacency::of(&mesh.positions, &mesh.triangles);
        let Adjacency { planes, edges } = &mut adjacency;
        for edge in edges {
            let [a, b] = edge.faces.map(|face| planes[face as usize].truncate());
            edge.crease &= a.dot(b) < FLAT * a.length() * b.length();
        }
        let outlined = Arc::new(Mesh { adjacency, ..Mesh::clone(&mesh) });
        self.files.outlined.insert((path.to_owned(), part), (mesh, Arc::clone(&outlined)));
        outlined
    }

    /// The texture of an object, and how it's sampled: that of the figure, else its own. If it can't be
    /// used, a notice says so.
    fn texture(
        &mut self,
        scene: &mut Scene,
        placed: &Placed<'_>,
        own: Option<&PartTexture>,
    ) -> Option<(Arc<Texture>, Sampler)> {
        let spec = placed.spec;
        let (image, sampler) = match (&spec.texture, own) {
            (None, own) => own.map(|own| (Arc::clone(&own.image), own.sampler))?,
            (Some(TextureSource::File(path)), _) => match self.picture(path) {
                Ok(image) => (image, Sampler::default()),
                Err(error) => {
                    scene.notices.push((spec.name.clone(), MeshNotice::Texture(error)));
                    return None;
                }
            },
            (Some(source), _) => (builtin(source)?, Sampler::default()),
        };
        let sampler = Sampler {
            wrap_u: spec.wrap.unwrap_or(sampler.wrap_u),
            wrap_v: spec.wrap.unwrap_or(sampler.wrap_v),
            filter: spec.filter.unwrap_or(sampler.filter),
            reveal: None,
        };
        Some((image, sampler))
    }

    /// The picture in a file that the figure names.
    fn picture(&mut self, path: &str) -> Result<Arc<Texture>, TextureError> {
        let read_file = &mut *self.read_file;
        let mut beside = |path: &str| read_file(Wanted { path, named_by: None });
        self.files.textures.get(path, Alpha::Kept, &mut beside)
    }

    /// The photograph in a file. If it can't be used, a notice says so.
    fn photograph(&mut self, scene: &mut Scene, path: Option<&str>) {
        match path.map(|path| self.picture(path)) {
            Some(Err(error)) => scene.notices.push(("[image]".to_owned(), MeshNotice::Photograph(error))),
            read => scene.photograph = read.and_then(Result::ok),
        }
    }

    /// A solid, whose mesh is made once for each number of segments; faceted ones show their edges, curved ones their
    /// outline.
    fn solid(
        &mut self,
        scene: &mut Scene,
        placed: &Placed<'_>,
        color: Rgba,
        faceted: bool,
        make: impl FnOnce(u32) -> Mesh,
    ) -> Result<(), SceneError> {
        let Some(shape) = &placed.spec.shape else { return Ok(()) };
        let segments = if shape.has_segments() { allowed_segments(placed.spec)? } else { 0 };
        let key = (shape.name(), segments);
        let before = self.before.remove(&key);
        let made = || {
            before.unwrap_or_else(|| {
                let mesh = make(segments);
                let adjacency =
                    if faceted { Adjacency::default() } else { Adjacency::of(&mesh.positions, &mesh.triangles) };
                Arc::new(Mesh { adjacency, ..mesh })
            })
        };
        let mesh = Arc::clone(self.files.primitives.entry(key).or_insert_with(made));
        let (mesh, paint) = match self.texture(scene, placed, None) {
            None => (mesh, ObjectPaint::Solid(color)),
            Some((image, sampler)) => {
                let before = self.mapped_before.remove(&key);
                let made = || before.unwrap_or_else(|| mapped(shape, &mesh));
                let mapped = self.files.mapped.entry(key).or_insert_with(made);
                let tint = placed.color.unwrap_or(WHITE);
                (Arc::clone(&mapped.mesh), painted(image, sampler, &mapped.uv, placed, (tint, Arc::default())))
            }
        };
        scene.objects.push(Object {
            edges: faceted.then(|| self.colors.edge_style()),
            outline: (!faceted).then(|| self.colors.edge_style()),
            ..Object::new(placed.spec.name.clone(), mesh, placed.world_from_object, paint)
        });
        Ok(())
    }
}

/// The tint of an untinted texture.
const WHITE: Rgba = Rgba::rgb(255, 255, 255);

/// A texture on an object, as often as the figure wants it.
fn painted(
    image: Arc<Texture>,
    sampler: Sampler,
    uv: &Arc<Vec<[f32; 2]>>,
    placed: &Placed<'_>,
    (tint, tints): (Rgba, Arc<Vec<Rgba>>),
) -> ObjectPaint {
    let scale = placed.spec.texture_scale;
    let uv = if scale == DVec2::ONE {
        Arc::clone(uv)
    } else {
        let [wide, high] = scale.as_vec2().to_array();
        // v is counted from below, where the first repetition begins.
        Arc::new(uv.iter().map(|[u, v]| [u * wide, 1.0 - (1.0 - v) * high]).collect())
    };
    let translucent = tints.iter().chain([&tint]).any(|tint| !tint.is_opaque()) || !image.is_opaque();
    ObjectPaint::Texture(Pictured { image, sampler, uv, tint, tints, translucent })
}

fn ellipsoid(segments: u32) -> Mesh {
    primitives::ellipsoid(primitives::ELLIPSOID_HALF_AXES, segments)
}

/// An object without faces.
fn bare(name: &str, mesh: Mesh, placed: &Placed<'_>, color: Rgba, edges: Option<LineStyle>) -> Object {
    Object {
        lit: false,
        two_sided: true,
        faces: false,
        edges,
        ..Object::new(name, Arc::new(mesh), placed.world_from_object, ObjectPaint::Solid(color))
    }
}
