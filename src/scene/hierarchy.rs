//! From what a figure says of its scene to the scene: names resolved, transforms multiplied out, meshes made, `[3]`
//! "Descrição da cena".

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3};

use super::palette::{PALETTE, SceneColors};
use super::{
    Light, LightSpec, Line, Mesh, MeshError, MeshFiles, Object, ObjectPaint, ObjectSpec, PointMark, Scene, SceneSpec,
    Shape, Text, presets, primitives,
};
use crate::appearance::{LineStyle, MarkShape, Rgba, Style, Theme};
use crate::geometry::{Angle, try_unit};

/// Where the default light goes: it comes from above, behind the usual viewer at (3, 4, 5) and a little to his left, so that
/// the three sides that he sees of a box differ and none is black.
pub const DEFAULT_LIGHT: DVec3 = DVec3::new(-0.33, -0.755, -0.6);

/// Half the width of a point's mark, in pixels at scale 1.
const MARK_RADIUS: f32 = 4.0;
/// Height of a point's name, in pixels at scale 1.
const NAME_SIZE: f32 = 14.0;

/// Why a specification is no scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// Two objects have one name.
    #[error("two objects are named \"{name}\"; each name must be used once")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// An object's parent does not exist.
    #[error("object \"{name}\": there is no object \"{parent}\" that could be its parent")]
    UnknownParent {
        /// The object.
        name: String,
        /// The name that was not found.
        parent: String,
    },
    /// An object is its own ancestor.
    #[error("object \"{}\" is its own ancestor: {}", chain.first().map_or("", String::as_str), chain.join(" → "))]
    Cycle {
        /// From the object over its ancestors back to itself.
        chain: Vec<String>,
    },
    /// A number is infinite or not a number.
    #[error("object \"{name}\": {key} has a value that is not finite")]
    NotFinite {
        /// The object.
        name: String,
        /// `translate`, `rotate`, `scale`, `points`, `segments`, or `parent` when only the product with the ancestors'
        /// transforms overflows.
        key: &'static str,
    },
    /// A scale of zero makes a solid flat.
    #[error("object \"{name}\": scale must not be 0 along any axis")]
    ZeroScale {
        /// The object.
        name: String,
    },
    /// `segments` is out of its range.
    #[error(
        "object \"{name}\": segments is {found}; allowed: {} to {}",
        primitives::MIN_SEGMENTS,
        primitives::MAX_SEGMENTS
    )]
    Segments {
        /// The object.
        name: String,
        /// What was found.
        found: u32,
    },
    /// A mesh file cannot be used.
    #[error("object \"{name}\": mesh file \"{path}\": {error}")]
    Mesh {
        /// The object.
        name: String,
        /// As the figure names it.
        path: String,
        /// Why.
        error: MeshError,
    },
    /// A light has no direction, or a number that is not finite.
    #[error("light {}: {key} must be finite{}", index + 1, if *key == "direction" { " and not zero" } else { "" })]
    Light {
        /// Its place in the list, from 0.
        index: usize,
        /// `direction` or `position`.
        key: &'static str,
    },
}

impl SceneError {
    /// The name of the object that is at fault, where it is one.
    #[must_use]
    pub fn object(&self) -> Option<&str> {
        match self {
            Self::DuplicateName { name }
            | Self::UnknownParent { name, .. }
            | Self::NotFinite { name, .. }
            | Self::ZeroScale { name }
            | Self::Segments { name, .. }
            | Self::Mesh { name, .. } => Some(name),
            Self::Cycle { chain } => chain.first().map(String::as_str),
            Self::Light { .. } => None,
        }
    }

    /// The key that is at fault.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        match self {
            Self::DuplicateName { .. } => "name",
            Self::UnknownParent { .. } | Self::Cycle { .. } => "parent",
            Self::ZeroScale { .. } => "scale",
            Self::Segments { .. } => "segments",
            Self::Mesh { .. } => "path",
            Self::NotFinite { key, .. } | Self::Light { key, .. } => key,
        }
    }
}

/// What the shells do when a mesh file is asked for: gives the bytes of the file with this path (as the figure names it), or a
/// sentence why not.
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// Makes the scene that `spec` describes: the preset's objects, then its own; in the colours of the style's theme, with hidden
/// edges as it wants them.
///
/// Each object's model matrix is its ancestors' times T · R · S, with R = Rz · Ry · Rx, `[3]`; an object without a colour
/// has its nearest ancestor's, else the next one of [`PALETTE`]. A single point carries its object's name
/// as a label. Without lights there is one, [`DEFAULT_LIGHT`].
///
/// *Guarantees*: all matrices are finite and, up to rounding, invertible.
///
/// # Errors
/// [`SceneError`] names the object and what is wrong with it.
pub fn build(spec: &SceneSpec, style: &Style, read_file: &mut ReadFile<'_>) -> Result<Scene, SceneError> {
    build_with(spec, style, read_file, &mut MeshFiles::default())
}

/// As [`build`], for scenes that are built again and again: `files` keeps the mesh files that `spec` uses.
///
/// # Errors
/// [`SceneError`] names the object and what is wrong with it.
pub fn build_with(
    spec: &SceneSpec,
    style: &Style,
    read_file: &mut ReadFile<'_>,
    files: &mut MeshFiles,
) -> Result<Scene, SceneError> {
    let colors = SceneColors { hidden: style.hidden_lines, ..SceneColors::of(style.theme) };
    let preset = presets::objects(spec.preset, &colors);
    let placed_preset = place(&preset, &[])?;
    let placed_own = place(&spec.objects, &placed_preset)?;

    let mut scene = Scene::default();
    let is_used =
        |path: &str| spec.objects.iter().any(|o| matches!(&o.shape, Some(Shape::Mesh { path: p }) if p == path));
    files.retain(is_used);
    let mut maker = Maker { colors, before: std::mem::take(&mut files.primitives), read_file, files };
    let mut turns = PALETTE.into_iter().cycle();
    let mut next_color = || turns.next().unwrap_or(PALETTE[0]);
    for placed in &placed_preset {
        maker.add(&mut scene, placed, placed.color.unwrap_or_else(&mut next_color))?;
    }
    presets::finish(spec.preset, &colors, &mut scene);
    for placed in &placed_own {
        maker.add(&mut scene, placed, placed.color.unwrap_or_else(&mut next_color))?;
    }
    scene.lights = lights(&spec.lights)?;
    Ok(scene)
}

/// Whether a scene can be built of this, but for its mesh files.
///
/// # Errors
/// [`SceneError`] names the object and what is wrong with it.
pub fn check(spec: &SceneSpec) -> Result<(), SceneError> {
    let preset = presets::objects(spec.preset, &SceneColors::of(Theme::Light));
    let placed_preset = place(&preset, &[])?;
    place(&spec.objects, &placed_preset)?;
    for object in spec.objects.iter().filter(|o| o.shape.as_ref().is_some_and(Shape::has_segments)) {
        allowed_segments(object)?;
    }
    lights(&spec.lights).map(|_| ())
}

/// The number of segments of an object, where it is allowed.
fn allowed_segments(spec: &ObjectSpec) -> Result<u32, SceneError> {
    if (primitives::MIN_SEGMENTS..=primitives::MAX_SEGMENTS).contains(&spec.segments) {
        Ok(spec.segments)
    } else {
        Err(SceneError::Segments { name: spec.name.clone(), found: spec.segments })
    }
}

/// An object whose ancestors have been found.
pub(super) struct Placed<'a> {
    pub(super) spec: &'a ObjectSpec,
    pub(super) world_from_object: DMat4,
    color: Option<Rgba>,
}

/// T · R · S of one object.
///
/// # Errors
/// A value that is not finite, or a scale of 0.
pub(super) fn parent_from_object(spec: &ObjectSpec) -> Result<DMat4, SceneError> {
    for (key, v) in [("translate", spec.translate), ("rotate", spec.rotate), ("scale", spec.scale)] {
        if !v.is_finite() {
            return Err(SceneError::NotFinite { name: spec.name.clone(), key });
        }
    }
    if spec.scale.cmpeq(DVec3::ZERO).any() {
        return Err(SceneError::ZeroScale { name: spec.name.clone() });
    }
    let m = rotation(spec.rotate) * DMat3::from_diagonal(spec.scale);
    Ok(DMat4::from_cols(m.x_axis.extend(0.0), m.y_axis.extend(0.0), m.z_axis.extend(0.0), spec.translate.extend(1.0)))
}

/// Rz · Ry · Rx for angles in degrees.
fn rotation(degrees: DVec3) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(|d| Angle::from_degrees(d).sin_cos());
    let rx = DMat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, cx, sx, 0.0, -sx, cx]);
    let ry = DMat3::from_cols_array(&[cy, 0.0, -sy, 0.0, 1.0, 0.0, sy, 0.0, cy]);
    let rz = DMat3::from_cols_array(&[cz, sz, 0.0, -sz, cz, 0.0, 0.0, 0.0, 1.0]);
    rz * ry * rx
}

/// Multiplies out the tree of `specs`; parents are looked for among them, then among `others`.
pub(super) fn place<'a>(specs: &'a [ObjectSpec], others: &[Placed<'_>]) -> Result<Vec<Placed<'a>>, SceneError> {
    let mut by_name = BTreeMap::new();
    for (i, spec) in specs.iter().enumerate() {
        if by_name.insert(spec.name.as_str(), i).is_some() {
            return Err(SceneError::DuplicateName { name: spec.name.clone() });
        }
    }
    let mut done: Vec<Option<(DMat4, Option<Rgba>)>> = vec![None; specs.len()];
    for start in 0..specs.len() {
        // Up to the first ancestor that is done (or to a root), then down again.
        let mut path = Vec::new();
        let mut on_path = BTreeSet::new();
        let mut above = (DMat4::IDENTITY, None);
        let mut next = Some(start);
        while let Some(i) = next {
            if let Some(known) = done[i] {
                above = known;
                break;
            }
            path.push(i);
            if !on_path.insert(i) {
                let from = path.iter().position(|&k| k == i).unwrap_or(0);
                return Err(SceneError::Cycle { chain: path[from..].iter().map(|&k| specs[k].name.clone()).collect() });
            }
            next = None;
            if let Some(parent) = &specs[i].parent {
                if let Some(&p) = by_name.get(parent.as_str()) {
                    next = Some(p);
                } else if let Some(other) = others.iter().find(|o| &o.spec.name == parent) {
                    above = (other.world_from_object, other.color);
                } else {
                    return Err(SceneError::UnknownParent { name: specs[i].name.clone(), parent: parent.clone() });
                }
            }
        }
        for &i in path.iter().rev() {
            let matrix = above.0 * parent_from_object(&specs[i])?;
            if !matrix.is_finite() {
                return Err(SceneError::NotFinite { name: specs[i].name.clone(), key: "parent" });
            }
            above = (matrix, specs[i].color.or(above.1));
            done[i] = Some(above);
        }
    }
    Ok(specs
        .iter()
        .zip(done)
        .filter_map(|(spec, d)| d.map(|(world_from_object, color)| Placed { spec, world_from_object, color }))
        .collect())
}

/// Makes meshes; equal ones are made once.
struct Maker<'a, 'b> {
    colors: SceneColors,
    /// The primitives of the last time; those that are used again go back to `files`.
    before: BTreeMap<(&'static str, u32), Arc<Mesh>>,
    read_file: &'a mut ReadFile<'b>,
    files: &'a mut MeshFiles,
}

impl Maker<'_, '_> {
    fn add(&mut self, scene: &mut Scene, placed: &Placed<'_>, color: Rgba) -> Result<(), SceneError> {
        let Some(shape) = &placed.spec.shape else { return Ok(()) };
        let name = &placed.spec.name;
        let not_finite = |key| SceneError::NotFinite { name: name.clone(), key };
        let to_world = |p: DVec3| placed.world_from_object.transform_point3(p);
        match shape {
            Shape::Grid => {
                let style = self.colors.grid_style(placed.color.unwrap_or(self.colors.grid));
                let lines = primitives::grid_lines(allowed_segments(placed.spec)?);
                scene.lines.extend(lines.iter().map(|l| Line { points: l.map(to_world).to_vec(), style }));
            }
            Shape::Points(points) => {
                if !points.iter().all(|p| to_world(*p).is_finite()) {
                    return Err(not_finite("points"));
                }
                for p in points {
                    scene.marks.push(point_mark(to_world(*p), MarkShape::Disc, color));
                }
                if let [p] = points[..] {
                    scene.texts.push(point_name(to_world(p), name, self.colors.ink));
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
            solid => {
                let mesh = self.solid(solid, placed)?;
                let faceted = matches!(solid, Shape::Box | Shape::Prism | Shape::Pyramid);
                scene.objects.push(Object {
                    name: name.clone(),
                    mesh,
                    world_from_object: placed.world_from_object,
                    paint: ObjectPaint::Solid(color),
                    lit: true,
                    two_sided: false,
                    faces: true,
                    edges: faceted.then(|| self.colors.edge_style()),
                });
            }
        }
        Ok(())
    }

    /// The parts of a mesh file: named after the object, and after themselves where there are several. A colour that the figure
    /// gives wins over those of the file's materials.
    fn mesh_file(&mut self, scene: &mut Scene, placed: &Placed<'_>, path: &str, color: Rgba) -> Result<(), SceneError> {
        let name = &placed.spec.name;
        let failed = |error| SceneError::Mesh { name: name.clone(), path: path.to_owned(), error };
        let parts = self.files.get(path, self.read_file).map_err(failed)?;
        for (k, part) in parts.iter().enumerate() {
            let world_from_object = placed.world_from_object * part.file_from_part;
            if !world_from_object.is_finite() {
                return Err(SceneError::NotFinite { name: name.clone(), key: "scale" });
            }
            let part_name = if part.name.is_empty() { (k + 1).to_string() } else { part.name.clone() };
            scene.objects.push(Object {
                name: if parts.len() == 1 { name.clone() } else { format!("{name}/{part_name}") },
                mesh: Arc::clone(&part.mesh),
                world_from_object,
                paint: ObjectPaint::Solid(placed.color.or(part.color).unwrap_or(color)),
                lit: true,
                two_sided: part.two_sided,
                faces: true,
                edges: None,
            });
        }
        Ok(())
    }

    /// The mesh of a solid.
    fn solid(&mut self, shape: &Shape, placed: &Placed<'_>) -> Result<Arc<Mesh>, SceneError> {
        let segments = if shape.has_segments() { allowed_segments(placed.spec)? } else { 0 };
        let key = (shape.name(), segments);
        let before = self.before.remove(&key);
        let mesh = self.files.primitives.entry(key).or_insert_with(|| {
            before.unwrap_or_else(|| {
                Arc::new(match shape {
                    Shape::Prism => primitives::prism(segments),
                    Shape::Pyramid => primitives::pyramid(),
                    Shape::Sphere => primitives::sphere(segments),
                    Shape::Ellipsoid => primitives::ellipsoid(primitives::ELLIPSOID_HALF_AXES, segments),
                    Shape::Cylinder => primitives::cylinder(segments),
                    Shape::Cone => primitives::cone(segments),
                    Shape::Torus => primitives::torus(segments),
                    _ => primitives::cube(),
                })
            })
        });
        Ok(Arc::clone(mesh))
    }
}

/// An object without faces.
fn bare(name: &str, mesh: Mesh, placed: &Placed<'_>, color: Rgba, edges: Option<LineStyle>) -> Object {
    Object {
        name: name.to_owned(),
        mesh: Arc::new(mesh),
        world_from_object: placed.world_from_object,
        paint: ObjectPaint::Solid(color),
        lit: false,
        two_sided: true,
        faces: false,
        edges,
    }
}

/// The mark of a point.
pub(super) fn point_mark(position: DVec3, shape: MarkShape, color: Rgba) -> PointMark {
    PointMark { position, shape, radius: MARK_RADIUS, color, fade_if_hidden: true }
}

/// The name beside a point.
pub(super) fn point_name(position: DVec3, text: &str, color: Rgba) -> Text {
    Text { position, text: text.to_owned(), offset: [8.0, -8.0], size: NAME_SIZE, color, fade_if_hidden: true }
}

fn lights(specs: &[LightSpec]) -> Result<Vec<Light>, SceneError> {
    if specs.is_empty() {
        return Ok(vec![Light::Directional { direction: DEFAULT_LIGHT }]);
    }
    specs
        .iter()
        .enumerate()
        .map(|(index, spec)| match *spec {
            LightSpec::Directional(direction) if try_unit(direction).is_some() => Ok(Light::Directional { direction }),
            LightSpec::Directional(_) => Err(SceneError::Light { index, key: "direction" }),
            LightSpec::Point(position) if position.is_finite() => Ok(Light::Point { position }),
            LightSpec::Point(_) => Err(SceneError::Light { index, key: "position" }),
        })
        .collect()
}
