//! A text or a file of another program → the cameras in it.
//!
//! Every form becomes one tree of names and values ([`tree`]). Files that keep a camera in several places are put in
//! order first ([`files`]). Then one walker ([`walk`]) asks one table of names ([`names`]) for the meaning of each
//! entry, and each entry is used, or named as left out ([`account`]). Numbers without such names are a matrix, a
//! quaternion, K or three vectors by their count.

mod camera;
mod files;
mod lens;
mod names;
mod tokens;
mod tree;
mod walk;

use glam::DMat4;

use crate::camera::ImageSize;
use crate::camera::recovery::reading::{MatrixEntries, Written};
use crate::camera::recovery::{Axes, MatrixKind, MatrixTextError, Order, RecoveryError};
pub(crate) use camera::Side;
use camera::{Entry, in_line};
pub(crate) use names::Word;
use tree::Node;

/// A camera of a text: its numbers, and the parts of their reading that the format or the words state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pasted {
    /// Its name in the file, such as that of its image. Empty if it has none.
    pub name: String,
    /// The matrix, or the three vectors; `None` if the file only has a lens.
    pub(crate) entries: Option<MatrixEntries>,
    /// The part of the reading that the text states.
    pub(crate) word: Option<Word>,
    /// M_p beside its pose.
    pub(crate) projection: Option<Box<Self>>,
    /// The lens that goes with it.
    pub(crate) lens: Option<GivenLens>,
    /// The size of its image.
    pub image: Option<ImageSize>,
    /// The reason why it can't be read. It keeps its place in the list.
    pub(crate) refused: Option<RecoveryError>,
    /// Its pose is relative to the camera before.
    is_chained: bool,
    /// It has no pose, and the others of the file stand around it.
    pub(crate) is_origin: bool,
    /// A scale above it was left out.
    pub(crate) is_scaled: bool,
    /// The entries of the text that make it.
    pub used: Vec<Used>,
    /// The other entries, those that the image could show first.
    pub left_out: Vec<LeftOut>,
}

/// An entry of a text that is in the camera.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Used {
    /// As it stands in the text, with the names around it.
    pub name: String,
    /// Its numbers, or its word.
    pub value: String,
    /// The symbol of its meaning: C, `f_x`, theta.
    pub meaning: &'static str,
}

/// An entry of a text that isn't in the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// As it stands in the text, with the names around it.
    pub name: String,
    /// Its numbers, or its word.
    pub value: String,
    /// The reason.
    pub why: Why,
}

/// The reason why an entry is left out.
#[derive(Clone, Debug, PartialEq)]
pub enum Why {
    /// Its name has no known meaning.
    Unknown,
    /// It has a meaning, but the camera can't have it.
    NotUsed,
    /// The same entry came before.
    Repeated,
    /// A nearer or a fuller entry says it.
    Overridden,
    /// It says nothing of the image.
    SaysNothing,
    /// It's 0, so it changes nothing.
    Zero,
    /// It's of the image before rectification.
    BeforeRectification,
    /// Another sensor, or a map that is no camera.
    NotCamera,
    /// A lens that is no pinhole.
    Fisheye,
    /// Distortion, by its model, with the largest shift at a corner of the image in pixels if it's known.
    Distortion {
        /// The word of the file; empty if it has none.
        model: String,
        /// Pixels.
        pixels: Option<f64>,
    },
}

impl Why {
    /// True if the image would be another one with it; `None` if that isn't known.
    pub const fn changes_image(&self) -> Option<bool> {
        match self {
            Self::Unknown => None,
            Self::NotUsed | Self::Repeated | Self::Fisheye | Self::Distortion { .. } => Some(true),
            _ => Some(false),
        }
    }
}

/// A lens beside a pose, or alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct GivenLens {
    pub(crate) size: Size,
    pub(crate) is_parallel: bool,
    /// Its length is that over F.
    pub(crate) is_slope: bool,
    /// θ, if it is given.
    pub(crate) degrees: Option<f64>,
    pub(crate) aspect: Option<f64>,
    /// The middle of the window, in shares of its sides.
    pub(crate) shift: [f64; 2],
    /// Both shares are of the height.
    pub(crate) shift_of_height: bool,
    /// 0 and 1 are the same.
    pub(crate) zoom: f64,
    pub(crate) near: Option<f64>,
    pub(crate) far: Option<f64>,
    /// The part of a larger window: left, top, width and height in shares of it.
    pub(crate) crop: Option<[f64; 4]>,
}

/// The size of a window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Size {
    /// That of the figure.
    #[default]
    Open,
    /// K in pixels. Without a principal point it's the middle of the image.
    Pixels { focal_lengths: [f64; 2], principal_point: Option<[f64; 2]>, skew: f64 },
    /// The length of a side.
    Length(Side, f64),
    /// l, r, b and t.
    Sides([f64; 4]),
}

/// The names of several cameras, none for a single one. A number from 1 stands for a missing name.
pub fn camera_names(cameras: &[Pasted]) -> Vec<String> {
    if cameras.len() < 2 {
        return Vec::new();
    }
    let name = |(k, camera): (usize, &Pasted)| {
        if camera.name.is_empty() { (k + 1).to_string() } else { camera.name.clone() }
    };
    cameras.iter().enumerate().map(name).collect()
}

impl Pasted {
    fn new(name: &str, entries: MatrixEntries) -> Self {
        Self { name: name.to_owned(), entries: Some(entries), ..Self::default() }
    }

    /// From the file's world to the camera, in the axes of computer vision, if it has such a pose.
    fn view(&self) -> Option<DMat4> {
        let m = self.entries.as_ref().filter(|entries| entries.count() == 16)?.matrix(false);
        match self.word?.kind? {
            MatrixKind::View => Some(m),
            MatrixKind::CameraToWorld => Some(m.inverse()),
            _ => None,
        }
    }

    fn set_view(&mut self, view: DMat4) {
        self.entries = Some(MatrixEntries::of_matrix(view, 0.0));
        self.word = Some(Word::full("R, t", MatrixKind::View, Axes::OPENCV, Order::Rows));
    }

    /// The largest shift of a corner of the image by coefficients of distortion, in pixels.
    fn shift_at_corner(&self, coefficients: &[&Entry]) -> Option<f64> {
        let ImageSize { width, height } = self.image?;
        let Size::Pixels { focal_lengths: f, principal_point, .. } = self.lens?.size else { return None };
        let [m, n] = [width, height].map(f64::from);
        let middle = principal_point.unwrap_or([m / 2.0, n / 2.0]);
        let mut k = [0.0; 8];
        for entry in coefficients {
            let names = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"];
            let at = names.iter().position(|own| names::plain(&entry.name).ends_with(own));
            match (at, entry.numbers.as_slice()) {
                (Some(at), [own]) => k[at] = own.value,
                (_, own) => k.iter_mut().zip(own).for_each(|(k, own)| *k = own.value),
            }
        }
        let shift = |[i, j]: [f64; 2]| {
            let [x, y] = [(i - middle[0]) / f[0], (j - middle[1]) / f[1]];
            let r = x * x + y * y;
            let radial = (1.0 + r * (k[0] + r * (k[1] + r * k[4]))) / (1.0 + r * (k[5] + r * (k[6] + r * k[7]))) - 1.0;
            let across = x * radial + 2.0 * k[2] * x * y + k[3] * (r + 2.0 * x * x);
            let down = y * radial + k[2] * (r + 2.0 * y * y) + 2.0 * k[3] * x * y;
            (f[0] * across).hypot(f[1] * down)
        };
        Some([[0.0, 0.0], [m, 0.0], [0.0, n], [m, n]].into_iter().map(shift).fold(0.0, f64::max))
    }
}

/// The cameras of a file, or of a pasted text. At least one.
///
/// # Errors
/// [`MatrixTextError`] if there is none.
pub fn read_cameras(bytes: &[u8]) -> Result<Vec<Pasted>, MatrixTextError> {
    let bytes = if bytes.starts_with(b"glTF") { chunk(bytes).ok_or(MatrixTextError::NoCamera("GLB"))? } else { bytes };
    let text = std::str::from_utf8(bytes).map_err(|_| MatrixTextError::NotText)?;
    let text = text.trim_start_matches('\u{feff}');
    let sign = camera::sign_of(text);
    let by_lines = [files::colmap, files::trajectory, files::middlebury, files::table];
    if let Some(tree) = by_lines.into_iter().find_map(|read| read(text)) {
        return walk::cameras(&tree, sign);
    }
    if text.matches("\\begin{").count() > 1 {
        return Err(MatrixTextError::Latex);
    }
    let plain = tokens::without_comments(text);
    let plain = if sign.is_pov() { tokens::pov(&plain) } else { plain };
    let start = plain.trim_start();
    let is_xml = start.starts_with('<') && (start.contains("</") || start.contains("/>"));
    let tree = if is_xml { files::xml_tree(start) } else { tree::read(&plain)? };
    let by_parts =
        [files::gltf, files::open_mvg, files::metashape, files::three_js, files::usd, files::collada, files::pbrt];
    if let Some(tree) = by_parts.into_iter().find_map(|read| read(&tree)) {
        return walk::cameras(&tree, sign);
    }
    let found = walk::cameras(&tree, sign)?;
    if !found.is_empty() {
        return Ok(found);
    }
    if tree.child("asset").is_some() {
        return Err(MatrixTextError::NoCamera("glTF"));
    }
    of_numbers(&tree, &plain)
}

/// The first chunk of a GLB file: behind a header of 12 bytes its length, its kind, its JSON.
fn chunk(bytes: &[u8]) -> Option<&[u8]> {
    let length = u32::from_le_bytes(bytes.get(12..16)?.try_into().ok()?);
    bytes.get(16..)?.strip_prefix(b"JSON")?.get(..usize::try_from(length).ok()?)
}

impl MatrixEntries {
    /// Reads a single matrix of seven (a quaternion and t), nine (K, or C, PF and VUP), twelve or sixteen numbers, as
    /// any program prints it.
    ///
    /// ```
    /// # use camera_lab_engine::camera::MatrixEntries;
    /// let blender = "<Matrix 4x4 (1.0, 0.0, 0.0, 7.0)\n(0.0, 1.0, 0.0, 8.0)\n(0.0, 0.0, 1.0, 9.0)\n(0.0, 0.0, 0.0, 1.0)>";
    /// assert_eq!(MatrixEntries::read(blender)?.matrix(false).w_axis.z, 9.0);
    /// # Ok::<(), camera_lab_engine::camera::MatrixTextError>(())
    /// ```
    ///
    /// # Errors
    /// [`MatrixTextError`] names the part that isn't a number, or the count of numbers.
    pub fn read(text: &str) -> Result<Self, MatrixTextError> {
        let first = read_cameras(text.as_bytes())?.into_iter().next();
        first.and_then(|camera| camera.entries).ok_or(MatrixTextError::Count(0))
    }
}

/// The camera of numbers that no name explains.
fn of_numbers(tree: &Node, text: &str) -> Result<Vec<Pasted>, MatrixTextError> {
    let mut leaves = Vec::new();
    tree.leaves(&mut leaves);
    let word = names::find(text);
    let is_size = |leaf: &Node, field| names::meaning(&names::plain(&leaf.name), 1, false) == Some(&[field]);
    let side = |field| leaves.iter().find(|leaf| leaf.numbers().0.len() == 1 && is_size(leaf, field));
    let image = side(names::Field::ImageWidth).zip(side(names::Field::ImageHeight));
    let image = image.and_then(|(width, height)| image_size(*width.values().first()?, *height.values().first()?));
    let total: usize = leaves.iter().map(|leaf| leaf.numbers().0.len()).sum();
    let of = |name: &str, numbers: Vec<Written>, in_line: Option<usize>, word: Option<Word>| {
        let used = Used { name: name.to_owned(), value: format!("{} numbers", numbers.len()), meaning: "matrix" };
        let entries = MatrixEntries::new(numbers, in_line)?;
        Some(Pasted { word, image, used: vec![used], ..Pasted::new(name, entries) })
    };
    if let Some(poses) = of_lines(&leaves) {
        let cameras = poses.into_iter().enumerate();
        return Ok(cameras.filter_map(|(k, pose)| of(&(k + 1).to_string(), pose, None, word)).collect());
    }
    if let Some((numbers, in_line)) = whole(&leaves)
        && let Some(camera) = of("", numbers, in_line, word)
    {
        return Ok(vec![camera]);
    }
    let counts = leaves.iter().map(|leaf| leaf.numbers().0.len()).filter(|count| matches!(count, 7 | 9 | 12 | 16));
    // The matrix of a projection or a pose says more than K or a rectification beside it.
    let most = counts.max();
    let (chosen, others): (Vec<&Node>, Vec<&Node>) =
        leaves.iter().partition(|leaf| Some(leaf.numbers().0.len()) == most);
    let left_out = |leaf: &&Node| {
        let value = leaf.values().iter().take(16).map(f64::to_string).collect::<Vec<_>>().join(" ");
        LeftOut { name: leaf.name.clone(), value, why: Why::Unknown }
    };
    let cameras = chosen.into_iter().filter_map(|leaf| {
        let (numbers, lines) = leaf.numbers();
        let own = names::find(&leaf.name).or(word.filter(|word| word.kind != Some(MatrixKind::Intrinsics)));
        let camera = of(&leaf.name, numbers, in_line(&lines), own)?;
        Some(Pasted { left_out: others.iter().map(left_out).collect(), ..camera })
    });
    let cameras: Vec<Pasted> = cameras.collect();
    if !cameras.is_empty() {
        return Ok(cameras);
    }
    Err(MatrixTextError::Count(total))
}

/// All numbers as one matrix, if their count is that of one and the names don't say that they are several things.
fn whole(leaves: &[Node]) -> Option<(Vec<Written>, Option<usize>)> {
    let parts: Vec<(Vec<Written>, Vec<usize>)> = leaves.iter().map(Node::numbers).collect();
    let lengths: Vec<usize> = parts.iter().map(|part| part.0.len()).collect();
    let mut numbers: Vec<Written> = parts.iter().flat_map(|part| part.0.clone()).collect();
    let mut lines: Vec<usize> = parts.iter().flat_map(|part| part.1.clone()).collect();
    if let Some(counts) = counts_before(&numbers) {
        // `Float32Array(16)` and `elements: (16)` of consoles of browsers.
        numbers.drain(..counts);
        lines.clear();
    } else if !matches!(lengths.as_slice(), [9, 3] | [4, 3] | [3, 4])
        && lengths.iter().any(|length| *length != lengths[0])
    {
        return None;
    }
    // A line of TUM begins with a time, a line of COLMAP with a number of the image.
    if numbers.len() == 8 {
        numbers.remove(0);
        lines.clear();
    }
    let in_line = if lengths == [9, 3] { Some(3) } else { in_line(&lines) };
    Some((numbers, in_line))
}

/// The count of numbers before a matrix that say how many it has.
fn counts_before(numbers: &[Written]) -> Option<usize> {
    let is = |count: usize, value: f64| (value - f64::from(u8::try_from(count).unwrap_or(0))).abs() < 0.5;
    [16, 12, 9].into_iter().find_map(|count| {
        let before = numbers.len().checked_sub(count).filter(|before| (1..=2).contains(before))?;
        numbers[..before].iter().all(|number| is(count, number.value)).then_some(before)
    })
}

/// One camera in each line: the trajectories of TUM and KITTI. Two lines of eight numbers are two poses only if each
/// has a unit quaternion behind its time.
fn of_lines(leaves: &[Node]) -> Option<Vec<Vec<Written>>> {
    let [leaf] = leaves else { return None };
    let (numbers, lines) = leaf.numbers();
    let in_line = in_line(&lines).filter(|in_line| matches!(in_line, 8 | 12 | 16))?;
    let is_unit = |q: &[Written]| (q.iter().map(|x| x.value * x.value).sum::<f64>() - 1.0).abs() < 1e-2;
    let is_pose = |line: &[Written]| in_line != 8 || is_unit(&line[1..5]) || is_unit(&line[4..8]);
    if numbers.len() == 16 && !numbers.chunks(in_line).all(is_pose) {
        return None;
    }
    Some(numbers.chunks(in_line).map(|line| line[usize::from(in_line == 8)..].to_vec()).collect())
}

/// The size of an image, if two numbers can be one.
fn image_size(width: f64, height: f64) -> Option<ImageSize> {
    Some(ImageSize { width: side(width)?, height: side(height)? })
}

/// A side of an image in pixels, if a number can be one.
fn side(value: f64) -> Option<u32> {
    let is_side = value >= 1.0 && value <= f64::from(crate::limits::MAX_SIDE) && value.fract() == 0.0;
    #[expect(clippy::cast_possible_truncation, reason = "it is a whole number in this range")]
    is_side.then_some(value as u32)
}
