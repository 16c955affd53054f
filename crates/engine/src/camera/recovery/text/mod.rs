//! A text or a file of another program → the cameras in it.
//!
//! Each real format has its reader: JSON, YAML, COLMAP, glTF, trajectories of `Open3D`, `ParaView`. A text of another
//! form is a list of numbers under names (`K =`, `R:`, `P2:`), as programs print them. The names and counts say which
//! is which.

#[cfg(feature = "import")]
mod gltf;
#[cfg(feature = "import")]
mod json;
mod lines;
pub(crate) mod numbers;
mod paraview;
mod words;
#[cfg(feature = "import")]
mod yaml;

use glam::{DMat3, DMat4, DVec3};

use crate::camera::ImageSize;
use crate::camera::recovery::entries::{MatrixEntries, Written, rigid};
use crate::camera::recovery::{Axes, MatrixKind, Order};
use numbers::Segment;
pub(crate) use words::Word;

/// A camera of a text: its numbers, and the parts of their reading that the format or the words state.
#[derive(Clone, Debug, PartialEq)]
pub struct Pasted {
    /// Its name in the file, such as that of its image. Empty if it has none.
    pub name: String,
    /// The matrix, or the three vectors; `None` if the file only has a lens.
    pub(crate) entries: Option<MatrixEntries>,
    /// The part of the reading that the text states.
    pub(crate) word: Option<Word>,
    /// The lens that goes with it.
    pub(crate) lens: Option<GivenLens>,
    /// The size of its image.
    pub image: Option<ImageSize>,
}

/// A lens beside a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GivenLens {
    /// K in pixels.
    Pixels { focal_lengths: [f64; 2], principal_point: [f64; 2] },
    /// The angle from left to right, in radians.
    #[cfg_attr(not(feature = "import"), expect(dead_code, reason = "only nerfstudio has it"))]
    AngleX(f64),
    /// The angle from bottom to top in degrees. Missing values stay.
    AngleY { degrees: f64, aspect: Option<f64>, near: Option<f64>, far: Option<f64> },
    /// A parallel projection: H, and A, F and B if they are there.
    Parallel { height: f64, aspect: Option<f64>, planes: Option<[f64; 2]> },
}

/// The reason why a text holds no camera.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixTextError {
    /// Another count of numbers.
    #[error("{0} numbers; a matrix has 16, four rows of four, or 12: K [R | t], or 9: K, or 7: a quaternion and t")]
    Count(usize),
    /// A part of it isn't a number.
    #[error("“{}” is not a number", crate::sanitize::escaped(.0))]
    Part(String),
    /// Numbers that the program left out when it printed them.
    #[error("“...” stands for numbers that were left out; print all of them")]
    Elided,
    /// A file of a known format without a camera.
    #[error("no camera in it; {0} has none of the keys of a camera")]
    NoCamera(&'static str),
    /// A file that isn't text.
    #[error("it is neither text nor GLB")]
    NotText,
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
        Self { name: name.to_owned(), entries: Some(entries), word: None, lens: None, image: None }
    }

    /// A lens without a pose.
    fn lens(name: &str, lens: GivenLens, image: Option<ImageSize>) -> Self {
        Self { name: name.to_owned(), entries: None, word: None, lens: Some(lens), image }
    }

    /// A pose that a format defines.
    fn pose(
        name: &str,
        entries: MatrixEntries,
        kind: MatrixKind,
        axes: Axes,
        (order, word): (Order, &'static str),
    ) -> Self {
        Self { word: Some(Word::full(word, kind, axes, order)), ..Self::new(name, entries) }
    }
}

impl GivenLens {
    const fn pixels(focal_lengths: [f64; 2], principal_point: [f64; 2]) -> Self {
        Self::Pixels { focal_lengths, principal_point }
    }

    /// The lens of K, nine numbers by rows.
    fn of_k(k: &[f64]) -> Self {
        Self::pixels([k[0], k[4]], [k[2], k[5]])
    }
}

/// The cameras of a file, or of a pasted text. At least one.
///
/// # Errors
/// [`MatrixTextError`] if there is none.
pub fn read_cameras(bytes: &[u8]) -> Result<Vec<Pasted>, MatrixTextError> {
    #[cfg(feature = "import")]
    if bytes.starts_with(b"glTF") {
        return gltf::of_glb(bytes);
    }
    let text = std::str::from_utf8(bytes).map_err(|_| MatrixTextError::NotText)?;
    let text = text.trim_start_matches('\u{feff}');
    if let Some(cameras) = lines::colmap(text) {
        return Ok(cameras);
    }
    if let Some(poses) = lines::trajectory(text) {
        return Ok(poses);
    }
    if let Some(camera) = paraview::camera(text) {
        return Ok(vec![camera]);
    }
    #[cfg(feature = "import")]
    if let Ok(value) = serde_json::from_str(text) {
        return json::cameras(&value, text);
    }
    #[cfg(feature = "import")]
    if let Some(cameras) = yaml::cameras(text) {
        return Ok(cameras);
    }
    let (segments, stray) = numbers::segments(text)?;
    of_segments(segments, text).map_err(|error| match (error, stray) {
        (MatrixTextError::Count(_), Some(stray)) => MatrixTextError::Part(stray),
        (error, _) => error,
    })
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

/// The cameras of numbers under names.
fn of_segments(segments: Vec<Segment>, text: &str) -> Result<Vec<Pasted>, MatrixTextError> {
    let word = words::find(&numbers::without_comments(text));
    let image = named_size(&segments);
    let total: usize = segments.iter().map(|segment| segment.numbers.len()).sum();
    let said = |camera: Pasted| Pasted { word: camera.word.or(word), image, ..camera };
    if let Some(entries) = whole(&segments) {
        return Ok(vec![said(Pasted::new("", entries))]);
    }
    if let Some(cameras) = of_lines(&segments) {
        return Ok(cameras.into_iter().map(said).collect());
    }
    if let Some(camera) = of_parts(&segments) {
        return Ok(vec![said(camera)]);
    }
    let matrices: Vec<Pasted> = segments
        .into_iter()
        .filter_map(|s| Some(Pasted::new(&s.name, MatrixEntries::new(s.numbers.clone(), s.in_line())?)))
        .map(|camera| {
            let word = words::find(&camera.name).or(word.filter(|word| word.kind != Some(MatrixKind::Intrinsics)));
            Pasted { word, image, ..camera }
        })
        .collect();
    // The matrix of a projection or a pose says more than K or a rectification beside it.
    let most = matrices.iter().filter_map(|m| Some(m.entries.as_ref()?.count())).max();
    let chosen: Vec<Pasted> =
        matrices.into_iter().filter(|m| m.entries.as_ref().map(MatrixEntries::count) == most).collect();
    if chosen.is_empty() { Err(MatrixTextError::Count(total)) } else { Ok(chosen) }
}

/// All numbers as one matrix, if their count is that of one and the names don't say that they are several things.
fn whole(segments: &[Segment]) -> Option<MatrixEntries> {
    let mut numbers: Vec<Written> = segments.iter().flat_map(|segment| segment.numbers.clone()).collect();
    let mut lines: Vec<usize> = segments.iter().flat_map(|segment| segment.lines.clone()).collect();
    let lengths: Vec<usize> = segments.iter().map(|segment| segment.numbers.len()).collect();
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
    let joined = Segment { name: String::new(), numbers, lines };
    let in_line = if lengths == [9, 3] { Some(3) } else { joined.in_line() };
    MatrixEntries::new(joined.numbers, in_line)
}

/// The count of numbers before a matrix that say how many it has.
fn counts_before(numbers: &[Written]) -> Option<usize> {
    let is = |count: usize, value: f64| (value - f64::from(u8::try_from(count).unwrap_or(0))).abs() < 0.5;
    [16, 12, 9].into_iter().find_map(|count| {
        let before = numbers.len().checked_sub(count).filter(|before| (1..=2).contains(before))?;
        numbers[..before].iter().all(|number| is(count, number.value)).then_some(before)
    })
}

/// One camera in each line: the trajectories of TUM and KITTI.
fn of_lines(segments: &[Segment]) -> Option<Vec<Pasted>> {
    let [Segment { numbers, lines, .. }] = segments else { return None };
    let in_line = *lines.first()?;
    if lines.len() < 2 || !matches!(in_line, 8 | 12 | 16) || lines.iter().any(|line| *line != in_line) {
        return None;
    }
    let camera = |(k, line): (usize, &[Written])| {
        let skipped = usize::from(in_line == 8);
        Some(Pasted::new(&format!("{}", k + 1), MatrixEntries::new(line[skipped..].to_vec(), None)?))
    };
    numbers.chunks(in_line).enumerate().map(camera).collect()
}

/// K with a pose, under names: R and t, rvec and t, or \[R | t\].
fn of_parts(segments: &[Segment]) -> Option<Pasted> {
    let named = |names: &[&str], count: usize| {
        let is_it = |s: &&Segment| s.numbers.len() == count && names.contains(&s.name.to_lowercase().as_str());
        segments.iter().find(is_it)
    };
    let nine = segments.iter().filter(|segment| segment.numbers.len() == 9);
    let (intrinsics, rotations): (Vec<&Segment>, Vec<&Segment>) = nine.partition(|s| is_intrinsics(&values(s)));
    let lens = intrinsics.first().map(|k| GivenLens::of_k(&values(k)));
    let t = named(&["t", "tvec", "translation", "tvecs", "tr"], 3);
    let rvec = named(&["rvec", "rvecs", "r"], 3);
    let r = rotations.first().map(|r| values(r)).or_else(|| rvec.map(|rvec| rotation_of(&values(rvec))));
    let matrix =
        segments.iter().find(|s| matches!(s.numbers.len(), 12 | 16) && !s.name.to_lowercase().starts_with('p'));
    let entries = match (r, t, matrix) {
        (Some(r), Some(t), _) => of_rotation(&r, &values(t)),
        (_, _, Some(matrix)) if lens.is_some() => MatrixEntries::new(matrix.numbers.clone(), matrix.in_line())?,
        _ => return None,
    };
    let open = Pasted { lens, ..Pasted::new("", entries) };
    // K, R and t have the axes of computer vision.
    let is_vision = lens.is_some() || rvec.is_some();
    Some(Pasted { word: (is_vision && matrix.is_none()).then_some(VISION), ..open })
}

/// K, R and t lead from the world to the camera, in the axes of `OpenCV`.
const VISION: Word = Word::full("K, R, t", MatrixKind::View, Axes::OPENCV, Order::Rows);

/// The pose of a rotation matrix by rows, and t.
fn of_rotation(r: &[f64], t: &[f64]) -> MatrixEntries {
    let line = |i: usize| DVec3::from_slice(&r[3 * i..]);
    MatrixEntries::of_matrix(rigid([line(0), line(1), line(2)], DVec3::from_slice(t)), 1e-6)
}

/// The rotation matrix of a vector of Rodrigues, by rows.
fn rotation_of(vector: &[f64]) -> Vec<f64> {
    let m = DMat3::from_quat(glam::DQuat::from_scaled_axis(DVec3::from_slice(vector)));
    m.transpose().to_cols_array().to_vec()
}

fn values(segment: &Segment) -> Vec<f64> {
    segment.numbers.iter().map(|number| number.value).collect()
}

/// True if nine numbers have the zeros and the one of K.
#[expect(clippy::float_cmp, reason = "K has 0 and 1 themselves")]
fn is_intrinsics(k: &[f64]) -> bool {
    k[3] == 0.0 && k[6] == 0.0 && k[7] == 0.0 && k[8] == 1.0 && k[0] > 0.0 && k[4] > 0.0 && k[2] != 0.0
}

/// The size of the image, under the names that programs give it.
fn named_size(segments: &[Segment]) -> Option<ImageSize> {
    let side = |names: [&str; 3]| {
        let segment =
            segments.iter().find(|s| s.numbers.len() == 1 && names.contains(&s.name.to_lowercase().as_str()))?;
        Some(segment.numbers[0].value)
    };
    image_size(side(["image_width", "width", "w"])?, side(["image_height", "height", "h"])?)
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

/// A pose of K's axes from a quaternion w x y z and t.
fn of_quaternion([w, x, y, z]: [f64; 4], t: DVec3) -> DMat4 {
    DMat4::from_rotation_translation(glam::DQuat::from_xyzw(x, y, z, w).normalize(), t)
}

/// A number of JSON; `null` is the NaN of JavaScript.
#[cfg(feature = "import")]
fn number(value: &serde_json::Value) -> Option<f64> {
    if value.is_null() { Some(f64::NAN) } else { value.as_f64() }
}

/// A list of numbers, of one level or more.
#[cfg(feature = "import")]
fn list(value: &serde_json::Value) -> Option<Vec<f64>> {
    let mut numbers = Vec::new();
    for item in value.as_array()? {
        match item {
            serde_json::Value::Array(_) => numbers.extend(list(item)?),
            _ => numbers.push(number(item)?),
        }
    }
    Some(numbers)
}
