//! glTF 2.0 and GLB, through the crate `gltf`, which reads and checks the JSON. The bytes behind the accessors are read
//! here, with every address checked.

use std::array::from_fn;
use std::borrow::Cow;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;
use std::sync::Arc;

use ::gltf::accessor::{DataType, Dimensions};
use ::gltf::buffer::View;
use ::gltf::json::Root;
use ::gltf::json::validation::{Checked, Error as Rule};
use ::gltf::material::AlphaMode;
use ::gltf::mesh::Mode;
use ::gltf::{Accessor, Document, Gltf, Primitive, Semantic};
use base64::Engine as _;
use glam::{DMat4, DQuat, DVec3};
use serde_json::error::Category;
use serde_json::value::RawValue;

use super::part::{Imported, LeftOut, Part, PartTexture, byte};
use super::soup::Soup;
use crate::appearance::{Filter, Rgba, Sampler, Texture, Wrap};
use crate::limits::{MAX_OBJECTS, MAX_SCENE_BYTES, MAX_ZEROS};
use crate::progress::{Activity, Progress, pause};
use crate::sanitize::{self, escaped};
use crate::scene::mesh::polygon::Triangulator;
use crate::scene::read_error::Beside;
use crate::scene::texture::{Alpha, Textures};
use crate::scene::{GlbFault, GltfFault, JsonFault, MeshError, MeshNotice, TextureError};

/// The extensions that are read.
const EXTENSIONS: [&str; 2] = [QUANTIZED, "KHR_texture_transform"];
/// Attributes of whole numbers.
const QUANTIZED: &str = "KHR_mesh_quantization";

/// The objects of a glTF or GLB file: one part for each primitive of each node of its scene.
///
/// # Errors
/// [`MeshError::Json`], [`MeshError::Gltf`] and [`MeshError::Cancelled`].
pub(crate) async fn read(bytes: &[u8], read_file: &mut Beside<'_>, progress: &Progress) -> Result<Imported, MeshError> {
    progress.begin(Activity::Reading, 0);
    let Gltf { document, blob } = parse(bytes)?;
    let buffers = buffers(&document, blob, read_file)?;
    let reader = Reader {
        buffers,
        is_quantized: document.extensions_used().any(|name| name == QUANTIZED),
        left: Cell::new(MAX_SCENE_BYTES),
        zeros_left: Cell::new(MAX_ZEROS),
    };
    let mut left_out = unused(document.as_json());
    let mut meshes: BTreeMap<(usize, usize), Option<Part>> = BTreeMap::new();
    let mut materials = Materials { reader: &reader, textures: Textures::default(), notices: Vec::new() };
    let mut parts = Vec::new();
    for (node, world) in nodes(&document)? {
        let Some(mesh) = node.mesh() else { continue };
        let name = node.name().or(mesh.name()).unwrap_or_default();
        for primitive in mesh.primitives() {
            pause().await;
            if progress.is_cancelled() {
                return Err(MeshError::Cancelled);
            }
            let key = (mesh.index(), primitive.index());
            let part = match meshes.get(&key) {
                Some(known) => known.clone(),
                None => {
                    let made = reader.part(&primitive, &place("meshes", mesh.index()), &mut left_out)?;
                    meshes.entry(key).or_insert(made).clone()
                }
            };
            if parts.len() >= MAX_OBJECTS {
                return Err(MeshError::TooManyObjects);
            }
            if let Some(part) = part {
                let material = primitive.material();
                let texture = if part.uv.is_empty() { None } else { materials.texture(&material, read_file) };
                parts.push(Part {
                    name: name.to_owned(),
                    two_sided: material.double_sided() || part.two_sided,
                    file_from_part: world,
                    color: part.color.or_else(|| material.index().map(|_| color(&material, [1.0; 4]))),
                    texture,
                    ..part
                });
            }
        }
    }
    let notices = left_out.notice().into_iter().chain(materials.notices).collect();
    Ok(Imported { parts, notices })
}

/// The lists of a file that aren't drawn.
fn unused(root: &Root) -> LeftOut {
    let mut left_out = LeftOut::default();
    left_out.add("animations", root.animations.len());
    left_out.add("skins", root.skins.len());
    left_out.add("cameras", root.cameras.len());
    left_out.add("scenes", root.scenes.len().saturating_sub(1));
    let base = |material: &::gltf::json::Material| {
        Some(material.pbr_metallic_roughness.base_color_texture.as_ref()?.index.value())
    };
    let used: BTreeSet<usize> = root.materials.iter().filter_map(base).collect();
    left_out.add("textures", root.textures.len().saturating_sub(used.len()));
    for extension in root.extensions_used.iter().filter(|name| !EXTENSIONS.contains(&name.as_str())) {
        left_out.add(extension, 1);
    }
    left_out
}

/// The textures of materials.
struct Materials<'a> {
    reader: &'a Reader,
    textures: Textures,
    notices: Vec<MeshNotice>,
}

impl Materials<'_> {
    /// The texture of a material's base colour. If it can't be used, a notice says so.
    fn texture(&mut self, material: &::gltf::Material<'_>, read_file: &mut Beside<'_>) -> Option<PartTexture> {
        let texture = material.pbr_metallic_roughness().base_color_texture()?.texture();
        let alpha = match material.alpha_mode() {
            AlphaMode::Opaque => Alpha::Ignored,
            AlphaMode::Mask => Alpha::Mask(material.alpha_cutoff().unwrap_or(0.5)),
            AlphaMode::Blend => Alpha::Kept,
        };
        let image = self.image(&texture, alpha, read_file);
        PartTexture::new(image, sampler(&texture.sampler()), &mut self.notices)
    }

    fn image(
        &mut self,
        texture: &::gltf::Texture<'_>,
        alpha: Alpha,
        read_file: &mut Beside<'_>,
    ) -> Result<Arc<Texture>, TextureError> {
        let image = texture.source();
        let name = place("images", image.index());
        match image.source() {
            ::gltf::image::Source::View { view, .. } => {
                self.textures.of_bytes(&name, alpha, self.reader.viewed(&view).unwrap_or_default())
            }
            ::gltf::image::Source::Uri { uri, .. } => match uri.strip_prefix("data:") {
                Some(data) => self.textures.of_bytes(&name, alpha, &decoded(data).unwrap_or_default()),
                None => {
                    let file = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
                    self.textures.get(&file, alpha, read_file)
                }
            },
        }
    }
}

/// Wrapping and filter: glTF's filter for smaller pictures that asks for levels of detail is ours with levels.
fn sampler(sampler: &::gltf::texture::Sampler<'_>) -> Sampler {
    use ::gltf::texture::{MagFilter, MinFilter, WrappingMode};
    let wrap = |mode| match mode {
        WrappingMode::ClampToEdge => Wrap::Clamp,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::Repeat => Wrap::Repeat,
    };
    let filter = match (sampler.min_filter(), sampler.mag_filter()) {
        (Some(MinFilter::Nearest), _) | (None, Some(MagFilter::Nearest)) => Filter::Nearest,
        (Some(MinFilter::Linear), _) => Filter::Bilinear,
        _ => Filter::Trilinear,
    };
    Sampler { wrap_u: wrap(sampler.wrap_s()), wrap_v: wrap(sampler.wrap_t()), filter, reveal: None }
}

fn fault(place: impl Into<String>, fault: GltfFault) -> MeshError {
    MeshError::Gltf { place: place.into(), fault }
}

fn of_accessor(accessor: &Accessor<'_>, found: GltfFault) -> MeshError {
    fault(place("accessors", accessor.index()), found)
}

fn unsupported(accessor: &Accessor<'_>) -> MeshError {
    let what = format!("{:?} {:?}", accessor.dimensions(), accessor.data_type());
    of_accessor(accessor, GltfFault::Unsupported { what })
}

fn place(list: &str, index: usize) -> String {
    format!("{list}[{index}]")
}

fn parse(bytes: &[u8]) -> Result<Gltf, MeshError> {
    let container = |broken: GlbFault| fault("", GltfFault::Container { fault: broken });
    let version = |found: String| fault("asset", GltfFault::Version { found });
    let mut json = Cow::Borrowed(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes));
    let mut blob = None;
    if bytes.starts_with(b"glTF") {
        let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        if let Some(other) = word(4).filter(|&number| number != 2) {
            return Err(version(other.to_string()));
        }
        // The crate subtracts the header from this length without looking.
        if word(8).is_none_or(|length| length < 12) {
            return Err(container(GlbFault::Header));
        }
        let glb = ::gltf::Glb::from_slice(bytes).map_err(|error| match error {
            ::gltf::Error::Binary(::gltf::binary::Error::ChunkType(_) | ::gltf::binary::Error::UnknownChunkType(_)) => {
                container(GlbFault::Parts)
            }
            _ => container(GlbFault::End),
        })?;
        (json, blob) = (glb.json, glb.bin.map(Cow::into_owned));
    }
    let mut root: Root = serde_json::from_slice(&json).map_err(|error| match old_version(&json) {
        // Version 1 has objects in place of lists.
        Some(old) => version(old),
        None => MeshError::Json { line: error.line(), column: error.column(), fault: json_fault(&error) },
    })?;
    let versions = [Some(&root.asset.version), root.asset.min_version.as_ref()];
    if let Some(other) = versions.into_iter().flatten().find(|version| !is_second(version)) {
        return Err(version(escaped(other)));
    }
    if let Some(other) = root.extensions_required.iter().find(|name| !EXTENSIONS.contains(&name.as_str())) {
        return Err(fault("extensionsRequired", GltfFault::Extension { found: escaped(other) }));
    }
    // The crate doesn't know it. Nothing else of it needs a check.
    root.extensions_required.retain(|name| name != QUANTIZED);
    // The crate's check of positions indexes the list of accessors without looking.
    for (i, mesh) in root.meshes.iter().enumerate() {
        for (j, primitive) in mesh.primitives.iter().enumerate() {
            let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
            if positions.is_some_and(|accessor| accessor.value() >= root.accessors.len()) {
                let place = format!("meshes[{i}].primitives[{j}].attributes[\"POSITION\"]");
                return Err(fault(place, GltfFault::Reference));
            }
        }
    }
    let document = Document::from_json(root).map_err(|error| match error {
        ::gltf::Error::Validation(all) => match all.into_iter().next() {
            Some((path, error)) => fault(sanitize::within(&path.to_string(), 80), broken_rule(error)),
            None => fault("", GltfFault::Value),
        },
        _ => fault("", GltfFault::Value),
    })?;
    Ok(Gltf { document, blob })
}

fn is_second(version: &str) -> bool {
    version == "2" || version.starts_with("2.")
}

/// The version of a file that isn't of version 2.
fn old_version(json: &[u8]) -> Option<String> {
    let keys: BTreeMap<String, &RawValue> = serde_json::from_slice(json).ok()?;
    let asset: serde_json::Value = serde_json::from_str(keys.get("asset")?.get()).ok()?;
    let version = asset.get("version")?;
    let version = version.as_str().map_or_else(|| version.to_string(), str::to_owned);
    (!is_second(&version)).then(|| escaped(&version))
}

/// The fault found by the JSON parser, without its words, which repeat the place and the contents of the file at any
/// length.
fn json_fault(error: &serde_json::Error) -> JsonFault {
    match error.classify() {
        Category::Eof => JsonFault::End,
        Category::Syntax | Category::Io => JsonFault::Syntax,
        Category::Data => {
            let words = error.to_string();
            let key = words.strip_prefix("missing field `").and_then(|rest| rest.split('`').next());
            key.map_or(JsonFault::Value, |key| JsonFault::MissingKey { key: escaped(key) })
        }
    }
}

fn broken_rule(error: Rule) -> GltfFault {
    match error {
        Rule::IndexOutOfBounds => GltfFault::Reference,
        Rule::Missing => GltfFault::Missing,
        Rule::Unsupported => GltfFault::Unsupported { what: "extension".to_owned() },
        Rule::Invalid | Rule::Oversize => GltfFault::Value,
    }
}

/// The bytes of a data URI.
fn decoded(data: &str) -> Option<Vec<u8>> {
    base64::engine::general_purpose::STANDARD.decode(data.split_once(";base64,")?.1).ok()
}

/// The bytes of every buffer.
fn buffers(
    document: &Document,
    blob: Option<Vec<u8>>,
    read_file: &mut Beside<'_>,
) -> Result<Vec<Rc<Vec<u8>>>, MeshError> {
    let mut blob = blob;
    let mut all = Vec::new();
    let mut files: HashMap<String, Rc<Vec<u8>>> = HashMap::new();
    for buffer in document.buffers() {
        let fault = |f| fault(place("buffers", buffer.index()), f);
        let bytes = match buffer.source() {
            ::gltf::buffer::Source::Bin => Rc::new(blob.take().ok_or_else(|| fault(GltfFault::NoBytes))?),
            ::gltf::buffer::Source::Uri(uri) => match uri.strip_prefix("data:") {
                Some(data) => Rc::new(decoded(data).ok_or_else(|| fault(GltfFault::DataUri))?),
                None => {
                    let name = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
                    let failed = |error| fault(GltfFault::File { uri: escaped(uri), error: Box::new(error) });
                    match files.get(&*name) {
                        Some(known) => Rc::clone(known),
                        None => {
                            let read = Rc::new(read_file(&name).map_err(failed)?);
                            Rc::clone(files.entry(name.into_owned()).or_insert(read))
                        }
                    }
                }
            },
        };
        if bytes.len() < buffer.length() {
            return Err(fault(GltfFault::NoBytes));
        }
        all.push(bytes);
    }
    Ok(all)
}

/// The nodes of the scene (the default one, else the first, else every node), with their matrices multiplied out. Nodes
/// scaled to nothing are hidden, together with their descendants.
fn nodes(document: &Document) -> Result<Vec<(::gltf::Node<'_>, DMat4)>, MeshError> {
    let roots: Vec<_> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().collect(),
        None => {
            let mut has_parent = vec![false; document.nodes().len()];
            document.nodes().flat_map(|n| n.children()).for_each(|child| has_parent[child.index()] = true);
            document.nodes().filter(|n| !has_parent[n.index()]).collect()
        }
    };
    let mut seen = vec![false; document.nodes().len()];
    let mut stack: Vec<_> = roots.into_iter().rev().map(|n| (n, DMat4::IDENTITY)).collect();
    let mut all = Vec::new();
    while let Some((node, parent)) = stack.pop() {
        let index = node.index();
        if std::mem::replace(&mut seen[index], true) {
            return Err(fault(place("nodes", index), GltfFault::Tree));
        }
        let world = parent * matrix(&node);
        if !world.is_finite() {
            return Err(fault(place("nodes", index), GltfFault::NotFinite));
        }
        if world.determinant() == 0.0 {
            continue;
        }
        let children: Vec<_> = node.children().collect();
        stack.extend(children.into_iter().rev().map(|child| (child, world)));
        all.push((node, world));
    }
    Ok(all)
}

/// A node's matrix in double precision.
fn matrix(node: &::gltf::Node<'_>) -> DMat4 {
    match node.transform() {
        ::gltf::scene::Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        ::gltf::scene::Transform::Decomposed { translation, rotation, scale } => {
            let [x, y, z, w] = rotation.map(f64::from);
            let turn = DQuat::from_xyzw(x, y, z, w);
            let turn = if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
            DMat4::from_scale_rotation_translation(
                DVec3::from(scale.map(f64::from)),
                turn,
                DVec3::from(translation.map(f64::from)),
            )
        }
    }
}

/// The base colour times a factor. glTF's numbers are linear light.
fn color(material: &::gltf::Material<'_>, times: [f32; 4]) -> Rgba {
    let factor = material.pbr_metallic_roughness().base_color_factor();
    let [r, g, b, a] = from_fn(|k| f64::from(factor[k] * times[k]).clamp(0.0, 1.0));
    let [r, g, b] =
        [r, g, b].map(|c| byte(if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }));
    Rgba::rgba(r, g, b, if material.alpha_mode() == AlphaMode::Opaque { 255 } else { byte(a) })
}

struct Reader {
    buffers: Vec<Rc<Vec<u8>>>,
    /// Points and normals may be whole numbers, and whole numbers may be no shares.
    is_quantized: bool,
    /// Bytes that accessors may still hold in all. Many can name the same bytes.
    left: Cell<usize>,
    /// Items that may still be 0 because no bytes are behind them.
    zeros_left: Cell<usize>,
}

/// Items of equal length.
struct Items<'a> {
    bytes: Cow<'a, [u8]>,
    /// From the start of one to the start of the next.
    stride: usize,
    item: usize,
}

impl Items<'_> {
    fn iter(&self) -> impl Iterator<Item = &[u8]> {
        self.bytes.chunks(self.stride).map(|padded| &padded[..self.item])
    }
}

impl Reader {
    /// The triangles of a primitive. `None` for points and lines.
    fn part(&self, primitive: &Primitive<'_>, mesh: &str, left_out: &mut LeftOut) -> Result<Option<Part>, MeshError> {
        let mesh = format!("{mesh}.primitives[{}]", primitive.index());
        if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            left_out.add(&format!("{:?}", primitive.mode()), 1);
            return Ok(None);
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(None) };
        let positions = self.vectors(&positions)?;
        let count = positions.len();
        let normals = match primitive.get(&Semantic::Normals) {
            Some(accessor) if accessor.count() == count => self.vectors(&accessor)?,
            _ => Vec::new(),
        };
        let uv = self.texture_coordinates(primitive, count)?;
        let colors = self.colors(primitive, count)?;
        for (semantic, _) in primitive.attributes() {
            use Semantic::{Colors, Normals, Positions, TexCoords};
            let is_used = matches!(semantic, Positions | Normals | TexCoords(_) | Colors(0));
            left_out.add(&semantic.to_string(), usize::from(!is_used));
        }
        left_out.add("targets", primitive.morph_targets().count());
        let order = match primitive.indices() {
            Some(accessor) => self.indices(&accessor)?,
            None => (0..u32::try_from(count).map_err(|_| MeshError::TooLarge)?).collect(),
        };
        if let Some(&found) = order.iter().find(|&&i| i as usize >= count) {
            return Err(fault(mesh, GltfFault::Index { found, vertices: count }));
        }
        let corners = match primitive.mode() {
            Mode::TriangleStrip => strip(&order),
            Mode::TriangleFan => order.windows(2).skip(1).flat_map(|w| [order[0], w[0], w[1]]).collect(),
            _ => order,
        };
        let corner_uv = corners.iter().filter_map(|&i| uv.get(i as usize).copied()).collect();
        let corner_colors = corners.iter().filter_map(|&i| colors.get(i as usize).copied()).collect();
        let mut soup = Soup { positions, normals, corners, corner_uv, corner_colors, ..Soup::default() };
        soup.weld();
        Ok(Some(soup.into_part(&mut Triangulator::default())?))
    }

    /// The colours of the vertices, that of the material in them. None if it has none.
    fn colors(&self, primitive: &Primitive<'_>, count: usize) -> Result<Vec<Rgba>, MeshError> {
        let Some(accessor) = primitive.get(&Semantic::Colors(0)).filter(|accessor| accessor.count() == count) else {
            return Ok(Vec::new());
        };
        let material = primitive.material();
        Ok(match accessor.dimensions() {
            Dimensions::Vec3 => {
                let colors = self.numbers::<3>(&accessor, Dimensions::Vec3)?;
                colors.map(|[r, g, b]| color(&material, [r, g, b, 1.0])).collect()
            }
            _ => self.numbers::<4>(&accessor, Dimensions::Vec4)?.map(|times| color(&material, times)).collect(),
        })
    }

    /// The texture coordinates of the vertices, as the material's texture turns and moves them. None if it has none.
    fn texture_coordinates(&self, primitive: &Primitive<'_>, count: usize) -> Result<Vec<[f32; 2]>, MeshError> {
        let info = primitive.material().pbr_metallic_roughness().base_color_texture();
        let transform = info.as_ref().and_then(::gltf::texture::Info::texture_transform);
        let own = info.as_ref().map_or(0, ::gltf::texture::Info::tex_coord);
        let set = transform.as_ref().and_then(::gltf::texture::TextureTransform::tex_coord).unwrap_or(own);
        let Some(accessor) = primitive.get(&Semantic::TexCoords(set)).filter(|accessor| accessor.count() == count)
        else {
            return Ok(Vec::new());
        };
        let mut uv: Vec<[f32; 2]> = self.numbers(&accessor, Dimensions::Vec2)?.collect();
        if let Some(transform) = transform {
            // Offset · rotation · scale, as the extension defines them.
            let ([x, y], [wide, high]) = (transform.offset(), transform.scale());
            let (sin, cos) = f64::from(transform.rotation()).sin_cos();
            #[expect(clippy::cast_possible_truncation, reason = "texture coordinates are single precision")]
            let (sin, cos) = (sin as f32, cos as f32);
            for [u, v] in &mut uv {
                let (s, t) = (*u * wide, *v * high);
                (*u, *v) = (cos * s + sin * t + x, cos * t - sin * s + y);
            }
        }
        uv.iter_mut().flatten().filter(|v| !v.is_finite()).for_each(|v| *v = 0.0);
        Ok(uv)
    }

    /// Items of `N` numbers. Whole ones are shares of the greatest, unless a quantized file says otherwise.
    fn numbers<const N: usize>(
        &self,
        accessor: &Accessor<'_>,
        dimensions: Dimensions,
    ) -> Result<impl Iterator<Item = [f32; N]>, MeshError> {
        let (read, most): (fn(&[u8]) -> f32, f32) = match accessor.data_type() {
            DataType::F32 => (|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]), 1.0),
            DataType::U8 => (|b| f32::from(b[0]), 255.0),
            DataType::I8 => (|b| f32::from(i8::from_le_bytes([b[0]])), 127.0),
            DataType::U16 => (|b| f32::from(u16::from_le_bytes([b[0], b[1]])), 65_535.0),
            DataType::I16 => (|b| f32::from(i16::from_le_bytes([b[0], b[1]])), 32_767.0),
            DataType::U32 => return Err(unsupported(accessor)),
        };
        if accessor.dimensions() != dimensions {
            return Err(unsupported(accessor));
        }
        let width = accessor.data_type().size();
        let is_share = most > 1.0 && (accessor.normalized() || !self.is_quantized);
        let number = |b: &[u8]| if is_share { (read(b) / most).max(-1.0) } else { read(b) };
        let items = self.items::<N>(accessor)?;
        Ok(items.iter().map(|b| from_fn(|k| number(&b[k * width..][..width]))).collect::<Vec<_>>().into_iter())
    }

    /// The bytes of the items of an accessor with `N` components, all of equal length.
    fn items<const N: usize>(&self, accessor: &Accessor<'_>) -> Result<Items<'_>, MeshError> {
        let fault = |f| of_accessor(accessor, f);
        let item = N * accessor.data_type().size();
        let held = accessor.count().checked_mul(item).and_then(|bytes| self.left.get().checked_sub(bytes));
        self.left.set(held.ok_or_else(|| fault(GltfFault::OverBudget))?);
        let base = match accessor.view() {
            Some(view) => Some(self.strided(&view, accessor.offset(), accessor.count(), item).map_err(fault)?),
            None => None,
        };
        let Some(sparse) = accessor.sparse() else { return base.ok_or_else(|| fault(GltfFault::NoBytes)) };
        let mut bytes = match base {
            Some(base) => base.iter().flatten().copied().collect(),
            None => {
                let left = self.zeros_left.get().checked_sub(accessor.count());
                self.zeros_left.set(left.ok_or_else(|| fault(GltfFault::OverBudget))?);
                vec![0; accessor.count() * item]
            }
        };
        let (indices, values) = (sparse.indices(), sparse.values());
        let width = indices.index_type().size();
        let places = self.strided(&indices.view(), indices.offset(), sparse.count(), width).map_err(fault)?;
        let values = self.strided(&values.view(), values.offset(), sparse.count(), item).map_err(fault)?;
        let mut next = 0;
        for (place, value) in places.iter().zip(values.iter()) {
            let index = place.iter().rev().fold(0_u32, |index, byte| index << 8 | u32::from(*byte));
            let at = index as usize;
            if at < next || at >= accessor.count() {
                return Err(fault(GltfFault::SparseIndex { found: index, count: accessor.count() }));
            }
            bytes[at * item..][..item].copy_from_slice(value);
            next = at + 1;
        }
        Ok(Items { bytes: Cow::Owned(bytes), stride: item, item })
    }

    fn viewed(&self, view: &View<'_>) -> Option<&[u8]> {
        self.buffers.get(view.buffer().index())?.get(view.offset()..view.offset().checked_add(view.length())?)
    }

    /// The bytes of `count` items of `item` bytes in a view, from `offset` on.
    fn strided(&self, view: &View<'_>, offset: usize, count: usize, item: usize) -> Result<Items<'_>, GltfFault> {
        let stride = view.stride().unwrap_or(item).max(item);
        let data = self.viewed(view).and_then(|bytes| {
            let data = bytes.get(offset..)?;
            // The last item needn't be padded to the stride.
            let before_last = count.saturating_sub(1).checked_mul(stride)?;
            data.get(..if count == 0 { 0 } else { before_last.checked_add(item)? })
        });
        let bytes = Cow::Borrowed(data.ok_or(GltfFault::OutOfBuffer)?);
        Ok(Items { bytes, stride, item })
    }

    /// Points or normals.
    fn vectors(&self, accessor: &Accessor<'_>) -> Result<Vec<DVec3>, MeshError> {
        if accessor.data_type() != DataType::F32 && !self.is_quantized {
            return Err(unsupported(accessor));
        }
        let vectors = self.numbers::<3>(accessor, Dimensions::Vec3)?;
        let vectors: Vec<DVec3> = vectors.map(|vector| DVec3::from(vector.map(f64::from))).collect();
        let is_finite = vectors.iter().all(|v| v.is_finite());
        if is_finite { Ok(vectors) } else { Err(of_accessor(accessor, GltfFault::NotFinite)) }
    }

    fn indices(&self, accessor: &Accessor<'_>) -> Result<Vec<u32>, MeshError> {
        let read: fn(&[u8]) -> u32 = match (accessor.data_type(), accessor.dimensions()) {
            (DataType::U8, Dimensions::Scalar) => |b| u32::from(b[0]),
            (DataType::U16, Dimensions::Scalar) => |b| u32::from(u16::from_le_bytes([b[0], b[1]])),
            (DataType::U32, Dimensions::Scalar) => |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]),
            _ => return Err(unsupported(accessor)),
        };
        Ok(self.items::<1>(accessor)?.iter().map(read).collect())
    }
}

/// The triangles of a strip, all turned the same way.
fn strip(order: &[u32]) -> Vec<u32> {
    let turned = |(k, w): (usize, &[u32])| if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
    order.windows(3).enumerate().flat_map(turned).collect()
}
