//! glTF 2.0 and GLB, through the crate `gltf`: it reads and checks the JSON; the bytes behind the accessors are read here,
//! with every address checked.

use std::collections::BTreeMap;
use std::sync::Arc;

use ::gltf::accessor::{DataType, Dimensions};
use ::gltf::json::validation::{Checked, Error as Rule};
use ::gltf::material::AlphaMode;
use ::gltf::mesh::Mode;
use ::gltf::{Accessor, Document, Gltf, Primitive, Semantic};
use base64::Engine as _;
use glam::{DMat4, DQuat, DVec3};

use super::Mesh;
use super::ReadFile;
use super::part::Part;
use super::soup::Soup;
use super::{GltfFault, MeshError};
use crate::appearance::Rgba;

/// The objects of a glTF or GLB file: one part for each primitive of each node of its scene.
///
/// # Errors
/// [`MeshError::Json`] and [`MeshError::Gltf`].
pub(super) fn read(bytes: &[u8], read_file: &mut ReadFile<'_>) -> Result<Vec<Part>, MeshError> {
    let Gltf { document, blob } = parse(bytes)?;
    let reader = Reader { buffers: buffers(&document, blob, read_file)? };
    let mut meshes: BTreeMap<(usize, usize), Option<Arc<Mesh>>> = BTreeMap::new();
    let mut parts = Vec::new();
    for (node, world) in nodes(&document)? {
        let Some(mesh) = node.mesh() else { continue };
        let name = node.name().or(mesh.name()).unwrap_or_default();
        for primitive in mesh.primitives() {
            let key = (mesh.index(), primitive.index());
            let surface = match meshes.get(&key) {
                Some(known) => known.clone(),
                None => {
                    let made = reader.surface(&primitive, &place("meshes", mesh.index()))?.map(Arc::new);
                    meshes.entry(key).or_insert(made).clone()
                }
            };
            if let Some(mesh) = surface {
                let material = primitive.material();
                parts.push(Part {
                    name: name.to_owned(),
                    two_sided: material.double_sided() || !mesh.closed,
                    mesh,
                    file_from_part: world,
                    color: material.index().map(|_| color(&material)),
                });
            }
        }
    }
    Ok(parts)
}

fn fault(place: impl Into<String>, fault: GltfFault) -> MeshError {
    MeshError::Gltf { place: place.into(), fault }
}

fn place(list: &str, index: usize) -> String {
    format!("{list}[{index}]")
}

fn parse(bytes: &[u8]) -> Result<Gltf, MeshError> {
    let container = |detail: String| fault("GLB", GltfFault::Container { detail });
    if bytes.starts_with(b"glTF") {
        // The crate subtracts the header from this length without looking.
        let length = bytes.get(8..12).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        if length.is_none_or(|length| length < 12) {
            return Err(container("the header is cut off or its length is wrong".to_owned()));
        }
    }
    // The crate's check of positions indexes the list of accessors without looking.
    if let Ok(unchecked) = Gltf::from_slice_without_validation(bytes) {
        let root = unchecked.document.as_json();
        for (i, mesh) in root.meshes.iter().enumerate() {
            for (j, primitive) in mesh.primitives.iter().enumerate() {
                let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
                if positions.is_some_and(|accessor| accessor.value() >= root.accessors.len()) {
                    let place = format!("meshes[{i}].primitives[{j}].attributes[\"POSITION\"]");
                    return Err(fault(place, GltfFault::Reference));
                }
            }
        }
    }
    Gltf::from_slice(bytes).map_err(|error| match error {
        ::gltf::Error::Deserialize(e) => MeshError::Json { line: e.line(), column: e.column(), detail: e.to_string() },
        ::gltf::Error::Validation(all) => match all.into_iter().next() {
            Some((path, error)) => fault(path.to_string(), broken_rule(error)),
            None => fault("", GltfFault::Value),
        },
        other => container(other.to_string()),
    })
}

fn broken_rule(error: Rule) -> GltfFault {
    match error {
        Rule::IndexOutOfBounds => GltfFault::Reference,
        Rule::Missing => GltfFault::Missing,
        Rule::Unsupported => GltfFault::Unsupported { what: "extension".to_owned() },
        Rule::Invalid | Rule::Oversize => GltfFault::Value,
    }
}

/// The bytes of every buffer.
fn buffers(
    document: &Document,
    blob: Option<Vec<u8>>,
    read_file: &mut ReadFile<'_>,
) -> Result<Vec<Vec<u8>>, MeshError> {
    let mut blob = blob;
    let mut all = Vec::new();
    for buffer in document.buffers() {
        let fault = |f| fault(place("buffers", buffer.index()), f);
        let bytes = match buffer.source() {
            ::gltf::buffer::Source::Bin => blob.take().ok_or_else(|| fault(GltfFault::NoBytes))?,
            ::gltf::buffer::Source::Uri(uri) => match uri.strip_prefix("data:") {
                Some(data) => {
                    let text = data.split_once(";base64,").map(|(_, text)| text);
                    let decoded = text.and_then(|t| base64::engine::general_purpose::STANDARD.decode(t).ok());
                    decoded.ok_or_else(|| fault(GltfFault::DataUri))?
                }
                None => {
                    let name = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
                    read_file(&name)
                        .map_err(|error| fault(GltfFault::File { uri: uri.to_owned(), error: Box::new(error) }))?
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

/// The nodes of the scene (the default one, else the first, else every node), with their matrices multiplied out. Nodes that
/// are scaled to nothing are hidden, and so is what is below them.
fn nodes(document: &Document) -> Result<Vec<(::gltf::Node<'_>, DMat4)>, MeshError> {
    let roots: Vec<_> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().collect(),
        None => {
            let children: Vec<usize> = document.nodes().flat_map(|n| n.children().map(|c| c.index())).collect();
            document.nodes().filter(|n| !children.contains(&n.index())).collect()
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

/// The base colour; glTF's factors are linear light.
fn color(material: &::gltf::Material<'_>) -> Rgba {
    let [r, g, b, a] = material.pbr_metallic_roughness().base_color_factor().map(|c| f64::from(c).clamp(0.0, 1.0));
    let byte = |share: f64| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
        let byte = (share * 255.0).round() as u8;
        byte
    };
    let [r, g, b] =
        [r, g, b].map(|c| byte(if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }));
    Rgba::rgba(r, g, b, if material.alpha_mode() == AlphaMode::Opaque { 255 } else { byte(a) })
}

struct Reader {
    buffers: Vec<Vec<u8>>,
}

impl Reader {
    /// The triangles of a primitive; `None` for points and lines.
    fn surface(&self, primitive: &Primitive<'_>, mesh: &str) -> Result<Option<Mesh>, MeshError> {
        let mesh = format!("{mesh}.primitives[{}]", primitive.index());
        if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            return Ok(None);
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(None) };
        let positions = self.vectors(&positions)?;
        let normals = match primitive.get(&Semantic::Normals) {
            Some(accessor) if accessor.count() == positions.len() => self.vectors(&accessor)?,
            _ => Vec::new(),
        };
        let order = match primitive.indices() {
            Some(accessor) => self.indices(&accessor)?,
            None => (0..u32::try_from(positions.len()).map_err(|_| MeshError::TooLarge)?).collect(),
        };
        if let Some(&found) = order.iter().find(|&&i| i as usize >= positions.len()) {
            return Err(fault(mesh, GltfFault::Index { found, vertices: positions.len() }));
        }
        let corners = match primitive.mode() {
            Mode::TriangleStrip => strip(&order),
            Mode::TriangleFan => order.windows(2).skip(1).flat_map(|w| [order[0], w[0], w[1]]).collect(),
            _ => order,
        };
        let mut soup = Soup { positions, normals, corners, ..Soup::default() };
        soup.weld();
        Ok(Some(soup.into_mesh()?))
    }

    /// The bytes of each item of an accessor with `N` components.
    fn items<const N: usize>(&self, accessor: &Accessor<'_>) -> Result<impl Iterator<Item = &[u8]>, MeshError> {
        let fault = |f| fault(place("accessors", accessor.index()), f);
        if accessor.sparse().is_some() {
            return Err(fault(GltfFault::Unsupported { what: "sparse accessor".to_owned() }));
        }
        let Some(view) = accessor.view() else { return Err(fault(GltfFault::NoBytes)) };
        let item = N * accessor.data_type().size();
        let stride = view.stride().unwrap_or(item).max(item);
        let data = self.buffers.get(view.buffer().index()).and_then(|bytes| {
            let end = view.offset().checked_add(view.length())?;
            let data = bytes.get(view.offset()..end)?.get(accessor.offset()..)?;
            // The last item need not be padded to the stride.
            let before_last = accessor.count().saturating_sub(1).checked_mul(stride)?;
            data.get(..if accessor.count() == 0 { 0 } else { before_last.checked_add(item)? })
        });
        let data = data.ok_or_else(|| fault(GltfFault::OutOfBuffer))?;
        Ok(data.chunks(stride).map(move |padded| &padded[..item]))
    }

    /// Points or normals.
    fn vectors(&self, accessor: &Accessor<'_>) -> Result<Vec<DVec3>, MeshError> {
        let fault = |f| fault(place("accessors", accessor.index()), f);
        if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
            let what = format!("{:?} {:?}", accessor.dimensions(), accessor.data_type());
            return Err(fault(GltfFault::Unsupported { what }));
        }
        let number = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let vector = |b: &[u8]| DVec3::new(number(&b[..4]), number(&b[4..8]), number(&b[8..]));
        let vectors: Vec<DVec3> = self.items::<3>(accessor)?.map(vector).collect();
        if vectors.iter().all(|v| v.is_finite()) { Ok(vectors) } else { Err(fault(GltfFault::NotFinite)) }
    }

    fn indices(&self, accessor: &Accessor<'_>) -> Result<Vec<u32>, MeshError> {
        let read: fn(&[u8]) -> u32 = match (accessor.data_type(), accessor.dimensions()) {
            (DataType::U8, Dimensions::Scalar) => |b| u32::from(b[0]),
            (DataType::U16, Dimensions::Scalar) => |b| u32::from(u16::from_le_bytes([b[0], b[1]])),
            (DataType::U32, Dimensions::Scalar) => |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]),
            (data_type, dimensions) => {
                let what = format!("{dimensions:?} {data_type:?}");
                return Err(fault(place("accessors", accessor.index()), GltfFault::Unsupported { what }));
            }
        };
        Ok(self.items::<1>(accessor)?.map(read).collect())
    }
}

/// The triangles of a strip, all turned the same way.
fn strip(order: &[u32]) -> Vec<u32> {
    let turned = |(k, w): (usize, &[u32])| if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
    order.windows(3).enumerate().flat_map(turned).collect()
}
