//! A tree → the entries of each of its cameras.

use super::camera::{Entry, Sign};
use super::lens::assemble;
use super::names::{Field, is_known, meaning, plain};
use super::tree::{Node, Value};
use super::{LeftOut, MatrixTextError, Pasted, Why, names};
use crate::camera::recovery::MatrixKind;
use crate::camera::recovery::reading::Written;
use Field as F;

/// A part of a tree: its own entries, and the parts inside.
#[derive(Default)]
struct Scope {
    name: String,
    /// An item of a list, or one of several that are numbered.
    is_item: bool,
    entries: Vec<Entry>,
    inner: Vec<Self>,
}

/// The cameras of a tree, in its order; none if no name says what its numbers are.
///
/// # Errors
/// [`MatrixTextError::NotCamera`] for a matrix that is none by its name.
pub(crate) fn cameras(tree: &Node, sign: Sign) -> Result<Vec<Pasted>, MatrixTextError> {
    let mut scope = Scope::default();
    for node in tree.children() {
        walk(node, "", "", &mut scope);
    }
    if let (true, Value::Numbers(..) | Value::Word(_)) = (tree.children().is_empty(), &tree.value) {
        return Ok(Vec::new());
    }
    if !scope.has_camera() {
        let other = scope.entries.iter().find(|entry| entry.has(|field| field.is_left_out()));
        return other.map_or(Ok(Vec::new()), |entry| Err(MatrixTextError::NotCamera(entry.name.clone())));
    }
    let mut found = Vec::new();
    split(scope, Vec::new(), &mut found);
    let mut cameras: Vec<Pasted> = found.iter().map(|(name, entries)| assemble(name, entries, sign)).collect();
    rig(&mut cameras, &found);
    Ok(cameras)
}

impl Scope {
    fn any(&self, is: &impl Fn(Field) -> bool) -> bool {
        let own = self.entries.iter().any(|entry| entry.has(is));
        own || !self.is_sensor() && self.inner.iter().any(|inner| inner.any(is))
    }

    fn has_pose(&self) -> bool {
        !self.is_sensor() && self.any(&|field| field.is_pose())
    }

    fn has_lens(&self) -> bool {
        !self.is_sensor() && self.any(&|field| field.is_lens())
    }

    fn has_camera(&self) -> bool {
        self.has_pose() || self.has_lens()
    }

    /// A sensor that is no camera.
    fn is_sensor(&self) -> bool {
        is_sensor(&self.name)
    }

    fn all(self, into: &mut Vec<Entry>) {
        let is_sensor = self.is_sensor();
        let at = into.len();
        into.extend(self.entries);
        self.inner.into_iter().for_each(|inner| inner.all(into));
        if is_sensor {
            into[at..].iter_mut().for_each(|entry| entry.fields = &[F::NotCamera]);
        }
    }
}

fn is_sensor(name: &str) -> bool {
    let name = name.to_lowercase();
    ["lidar", "gps", "gyro", "accel", "inertial"].iter().any(|sensor| name.contains(sensor))
        || name.split(['_', '.', '2']).any(|part| matches!(part, "imu" | "imu0") || part.starts_with("velo"))
}

/// Adds the entries of a node to a scope. `shown` is the path as it's written, `path` in plain names.
fn walk(node: &Node, shown: &str, path: &str, scope: &mut Scope) {
    let join = |before: &str, own: &str| match (before, own) {
        (before, "") => before.to_owned(),
        ("", own) => own.to_owned(),
        (before, own) => format!("{before}.{own}"),
    };
    let (shown, path) = (join(shown, &node.name), join(path, &plain(&node.name)));
    let is_inner = has_names(node);
    let call = join(&path, &plain(&node.call));
    let entry = |fields, index: &str, word, (numbers, lines)| Entry {
        name: shown.clone(),
        index: index.to_owned(),
        fields,
        numbers,
        lines,
        text: node.word().unwrap_or_default().to_owned(),
        word,
        is_inherited: false,
    };
    let is_word = matches!(node.value, Value::Word(_));
    let count = node.count();
    let is_empty = count == 0 && !is_word && node.children().is_empty();
    let is_bare = is_word && node.word() == Some("") || is_empty;
    let of_word = |fields: &&'static [Field]| {
        use F::{Crop, FovAxis, Model, Name, Parallel, Perspective, Skip};
        let is_word = matches!(fields, [Model | Name | FovAxis | Crop | Parallel | Perspective | Skip]);
        if is_bare { matches!(fields, [Parallel | Perspective | Crop]) } else { is_word }
    };
    // `1280x720`.
    let size =
        node.name.split_once('x').filter(|_| is_bare).and_then(|(m, n)| Some((m.parse().ok()?, n.parse().ok()?)));
    if let Some((m, n)) = size.filter(|size: &(u32, u32)| size.0.min(size.1) >= 16) {
        let numbers = [m, n].map(|side| Written { value: f64::from(side), error: 0.0 }).to_vec();
        return scope.entries.push(entry(&[F::ImageWidth, F::ImageHeight], "", None, (numbers, Vec::new())));
    }
    if is_word || is_empty {
        match meaning(&path, 0, false).filter(of_word) {
            Some(fields) => scope.entries.push(entry(fields, "", None, node.numbers())),
            None if is_bare || node.name.is_empty() => {}
            None => scope.entries.push(entry(&[F::Unknown], "", None, node.numbers())),
        }
        return;
    }
    if count > 0 || is_inner {
        let is_foreign = is_sensor(&node.name) && matches!(count, 3 | 4 | 9 | 12 | 16);
        if is_foreign && !path.ends_with("tcamimu") && !path.ends_with("timucam") {
            return scope.entries.push(entry(&[F::NotCamera], "", None, node.numbers()));
        }
        let is_vector = |fields: &&'static [Field]| matches!(fields, [F::Eye | F::Target | F::Center | F::Up]);
        for path in [&path, &call] {
            let stripped = path.trim_end_matches(|c: char| c.is_ascii_digit());
            let found = meaning(path, count, is_inner).map(|fields| (fields, ""));
            let numbered = || {
                let fields = meaning(stripped, count, is_inner).filter(|_| stripped.len() < path.len())?;
                Some((fields, &path[stripped.len()..]))
            };
            // A vector with its w.
            let with_w = || {
                let fields = meaning(path, 3, is_inner).filter(is_vector).filter(|_| count == 4)?;
                matches!(node.values()[3], 0.0 | 1.0).then_some((fields, ""))
            };
            if let Some((fields, index)) = found.or_else(numbered).or_else(with_w) {
                let order = node.children().first().map(|child| child.name.as_str());
                let fields = match (fields, order) {
                    ([F::Quaternion], Some("w" | "qw")) => &[F::Wxyz],
                    ([F::Quaternion], Some("x" | "qx")) => &[F::Xyzw],
                    ([F::K], _) if !is_k(&node.values()) => &[F::R],
                    (fields, _) => fields,
                };
                let (mut numbers, lines) = node.numbers();
                numbers.truncate(if is_vector(&fields) { 3 } else { numbers.len() });
                return scope.entries.push(entry(fields, index, None, (numbers, lines)));
            }
            let is_matrix =
                |word: &names::Word| count == 12 || count == 16 && word.kind != Some(MatrixKind::Intrinsics);
            // `matrix_world` is Blender's, `matrixWorld` that of three.js.
            let is_blender = shown.contains("matrix_world");
            let word = if is_blender { names::find(&shown) } else { names::of_name(path) };
            let word = word.filter(|word| is_matrix(word) && (!is_inner || node.children().len() == 1));
            if let Some(word) = word {
                let is_pixels =
                    count == 12 && matches!(word.kind, Some(MatrixKind::Projection | MatrixKind::Intrinsics));
                let fields: &[Field] = match word.kind {
                    _ if is_pixels => &[F::Pinhole],
                    Some(MatrixKind::Projection) => &[F::Projection],
                    _ => &[F::Matrix],
                };
                let index = &path[path.trim_end_matches(|c: char| c.is_ascii_digit()).len()..];
                return scope.entries.push(entry(fields, index, Some(word), node.numbers()));
            }
        }
    }
    match &node.value {
        Value::Inner(nodes) => {
            let is_numbered = node.name.ends_with(|c: char| c.is_ascii_digit());
            let mut inner =
                Scope { name: node.name.clone(), is_item: node.name.is_empty() || is_numbered, ..Scope::default() };
            for (at, child) in nodes.iter().enumerate() {
                let item = (child.name.is_empty() && nodes.len() > 1).then(|| format!("{shown}[{at}]"));
                walk(child, item.as_deref().unwrap_or(&shown), &call, &mut inner);
            }
            scope.inner.push(inner);
        }
        Value::Numbers(..) if node.is_shape() => scope.entries.push(entry(&[F::Skip], "", None, node.numbers())),
        _ => scope.entries.push(entry(&[F::Unknown], "", None, node.numbers())),
    }
}

/// True if a node has names of the table inside.
fn has_names(node: &Node) -> bool {
    let is_matrix = |child: &Node| matches!(child.count(), 12 | 16) && names::of_name(&plain(&child.name)).is_some();
    node.children().iter().any(|child| is_known(&plain(&child.name)) || has_names(child) || is_matrix(child))
}

/// True if nine numbers have the zeros of K, by rows or by columns.
fn is_k(k: &[f64]) -> bool {
    let by_rows = k[6] == 0.0 && k[7] == 0.0;
    let by_columns = k[2] == 0.0 && k[5] == 0.0;
    k[3] == 0.0
        && (by_rows || by_columns)
        && (k[8] - 1.0).abs() < 1e-3
        && k[0] > 1e-6
        && k[4] > 1e-6
        && (k[0] > 1.0 || k[2] != 0.0 || k[6] != 0.0)
}

/// The entries of each camera, with its name.
fn split(scope: Scope, outer: Vec<Entry>, found: &mut Vec<(String, Vec<Entry>)>) {
    let Scope { name, entries, inner, .. } = scope;
    let items = inner.iter().filter(|inner| inner.is_item && inner.has_camera()).count();
    let poses = inner.iter().filter(|inner| inner.has_pose()).count();
    let lenses = inner.iter().filter(|inner| inner.has_lens()).count();
    let alone = inner.iter().filter(|inner| inner.has_lens() && !inner.has_pose()).count();
    // A lens beside several poses is that of all.
    let are_several = items > 1
        || items == 1 && inner.iter().filter(|inner| inner.is_item).count() > 1
        || poses > 1
        || lenses > 1 && !(poses == 1 && alone == 1);
    let (mut own, mut cameras) = (entries, Vec::new());
    for part in inner {
        let is_shared = !part.has_pose() && poses > 1 && alone == 1 && !part.is_item;
        let is_one = if items > 0 && are_several { part.is_item || part.has_camera() } else { part.has_camera() };
        if is_one && !(is_shared && part.has_lens()) { cameras.push(part) } else { part.all(&mut own) }
    }
    let inherited = |entries: Vec<Entry>| {
        let mark = |entry| Entry { is_inherited: true, ..entry };
        entries.into_iter().map(mark).collect::<Vec<_>>()
    };
    if cameras.is_empty() {
        own.extend(outer);
        numbered(&name, own, found);
    } else if cameras.len() > 1 && are_several {
        own.extend(outer);
        let shared = inherited(own);
        for camera in cameras {
            let (name, at) = (camera.name.clone(), found.len());
            split(camera, shared.clone(), found);
            // Its name may be a word of the table: left, right, front.
            if let [(title, entries)] = &mut found[at..]
                && !name.is_empty()
                && !entries.iter().any(|entry| entry.fields == [F::Name] && entry.text == *title)
            {
                *title = name;
            }
        }
    } else {
        // One camera in parts, or a list inside.
        let at = cameras.iter().position(|camera| camera.has_pose()).unwrap_or(0);
        let mut main = cameras.swap_remove(at);
        cameras.into_iter().for_each(|part| part.all(&mut own));
        if main.inner.iter().any(|inner| inner.is_item) {
            own.extend(outer);
            return split(main, inherited(own), found);
        }
        if main.name.is_empty() || is_known(&plain(&main.name)) {
            main.name = name;
        }
        main.entries.extend(own);
        split(main, outer, found);
    }
}

/// Several cameras whose entries are numbered: `P0`, `P1`, `K_02`, `K_03`.
fn numbered(name: &str, mut entries: Vec<Entry>, found: &mut Vec<(String, Vec<Entry>)>) {
    // KITTI: S_rect is the size of the image of P_rect.
    entries.sort_by_key(|entry| !entry.name.to_lowercase().contains("_rect"));
    let is_main = |entry: &&Entry| !entry.index.is_empty() && entry.has(|field| field.is_pose() || field.is_lens());
    let mut indices: Vec<String> = Vec::new();
    for entry in entries.iter().filter(is_main) {
        if !indices.contains(&entry.index) {
            indices.push(entry.index.clone());
        }
    }
    if indices.len() < 2 {
        let title = entries.iter().find(|entry| entry.fields == [F::Name] && !entry.text.is_empty());
        let title = title.filter(|entry| !entry.is_inherited).map(|entry| entry.text.clone());
        let title = title.unwrap_or_else(|| if is_known(&plain(name)) { String::new() } else { name.to_owned() });
        return found.push((title, entries));
    }
    // R and T of a pair lead to the second one.
    let last = indices.last().cloned().unwrap_or_default();
    for index in &indices {
        let is_own = |entry: &&Entry| {
            entry.index == *index
                || entry.index.is_empty()
                    && (*index == last || !entry.has(|field| field.is_pose() || field == F::Baseline))
        };
        let own: Vec<Entry> = entries.iter().filter(is_own).cloned().collect();
        let with = |wanted: &[Field]| {
            let is_it = |entry: &&Entry| entry.index == *index && entry.has(|field| wanted.contains(&field));
            own.iter().find(is_it).map(|entry| entry.name.clone())
        };
        let title = with(&[F::Pinhole]).or_else(|| with(&[F::K, F::Matrix])).unwrap_or_else(|| index.clone());
        found.push((title, own));
    }
}

/// Puts the cameras of a file into one world.
fn rig(cameras: &mut [Pasted], found: &[(String, Vec<Entry>)]) {
    let has = |at: usize, field| found[at].1.iter().any(|entry| entry.has(|own| own == field));
    for at in 1..cameras.len() {
        let before = cameras[at - 1].view();
        let camera = &mut cameras[at];
        if let (true, Some(before), Some(own)) = (camera.is_chained, before, camera.view()) {
            if has(at, F::Matrix) {
                continue;
            }
            camera.set_view(own * before);
        }
    }
    let is_related = |at: usize| cameras[at].is_chained || has(at, F::Baseline);
    let is_pair = (1..cameras.len()).any(is_related)
        || cameras.len() == 2 && cameras[0].entries.is_none() && cameras[1].entries.is_some();
    for at in 0..cameras.len() {
        if !is_pair || cameras[at].entries.is_some() {
            continue;
        }
        let is_right = at == 1 && cameras.len() == 2 || cameras[at].name.to_lowercase().contains("right");
        let baseline = found[at].1.iter().find(|entry| entry.fields == [F::Baseline] && is_right);
        let x = baseline.map(|entry| entry.numbers[0].value);
        cameras[at].set_view(glam::DMat4::from_translation(glam::DVec3::X * -x.unwrap_or(0.0)));
        cameras[at].is_origin = x.is_none();
        if let Some(entry) = baseline {
            let is_it = |left: &LeftOut| left.name == entry.name && left.why == Why::NotUsed;
            cameras[at].left_out.retain(|left| !is_it(left));
            cameras[at].used.push(super::Used {
                name: entry.name.clone(),
                value: entry.value(),
                meaning: F::Baseline.symbol(),
            });
        }
    }
}
