//! Files that keep a camera in several places, or in a line: each becomes a tree with a part for each camera.

use glam::{DMat3, DMat4, DQuat, DVec3};

use super::tree::{Node, Value};
use crate::camera::recovery::reading::Written;

/// The parts of one camera.
fn camera(name: &str, mut parts: Vec<Node>) -> Node {
    if !name.is_empty() {
        parts.insert(0, Node::new("name", Value::Word(name.to_owned())));
    }
    Node::new("", Value::Inner(parts))
}

fn list(cameras: Vec<Node>) -> Option<Node> {
    (!cameras.is_empty()).then(|| Node::new("", Value::Inner(cameras)))
}

/// Sixteen numbers by rows, of which the last digits are rounded.
fn matrix(name: &str, m: DMat4) -> Node {
    Node::exact(name, &m.transpose().to_cols_array())
}

/// The models of COLMAP, and their parameters.
const MODELS: [(&str, &str); 11] = [
    ("SIMPLE_PINHOLE", "f cx cy"),
    ("PINHOLE", "fx fy cx cy"),
    ("SIMPLE_RADIAL", "f cx cy k1"),
    ("SIMPLE_RADIAL_FISHEYE", "f cx cy k1"),
    ("RADIAL", "f cx cy k1 k2"),
    ("RADIAL_FISHEYE", "f cx cy k1 k2"),
    ("OPENCV", "fx fy cx cy k1 k2 p1 p2"),
    ("OPENCV_FISHEYE", "fx fy cx cy k1 k2 k3 k4"),
    ("FULL_OPENCV", "fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6"),
    ("FOV", "fx fy cx cy omega"),
    ("THIN_PRISM_FISHEYE", "fx fy cx cy k1 k2 p1 p2 k3 k4 sx1 sy1"),
];

/// `CAMERA_ID MODEL WIDTH HEIGHT PARAMS…` of COLMAP: the number of the camera, and its parts.
fn colmap_lens(line: &str) -> Option<(String, Vec<Node>)> {
    let mut words = line.split_whitespace();
    let (id, model) = (words.next()?, words.next()?);
    let is_model = model.len() > 2 && model.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
    let numbers: Vec<f64> = words.map(str::parse).collect::<Result<_, _>>().ok()?;
    let [width, height, parameters @ ..] = numbers.as_slice() else { return None };
    if !is_model || id.parse::<u32>().is_err() {
        return None;
    }
    let mut parts = vec![
        Node::new("camera_model", Value::Word(model.to_owned())),
        Node::exact("width", &[*width]),
        Node::exact("height", &[*height]),
    ];
    let names = MODELS.iter().find(|row| row.0 == model).map_or("", |row| row.1);
    if names.split(' ').count() == parameters.len() {
        parts.extend(names.split(' ').zip(parameters).map(|(name, value)| Node::exact(name, &[*value])));
    } else {
        parts.push(Node::exact(&format!("{model} PARAMS"), parameters));
    }
    Some((id.to_owned(), parts))
}

/// `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME` of COLMAP: the number of the camera, the name, and the pose.
fn colmap_image(line: &str) -> Option<(&str, String, Vec<Node>)> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let (id, rest) = words.split_first()?;
    id.parse::<u32>().ok()?;
    let numbers: Vec<f64> = rest.get(..7)?.iter().map(|part| part.parse()).collect::<Result<_, _>>().ok()?;
    let camera = rest.get(7).filter(|camera| camera.parse::<u32>().is_ok())?;
    let name = rest.get(8..).filter(|name| !name.is_empty())?.join(" ");
    let norm = numbers[..4].iter().map(|x| x * x).sum::<f64>();
    // A line of points has numbers only, three for each.
    if (norm - 1.0).abs() > 0.02
        || words.len().is_multiple_of(3) && words.iter().all(|word| word.parse::<f64>().is_ok())
    {
        return None;
    }
    Some((camera, name, vec![Node::exact("qvec", &numbers[..4]), Node::exact("tvec", &numbers[4..])]))
}

/// `cameras.txt` and `images.txt` of COLMAP, one after the other or alone.
///
/// <https://colmap.github.io/format.html>: the pose leads from the world to the camera, in the axes of `OpenCV`.
pub(crate) fn colmap(text: &str) -> Option<Node> {
    let (mut lenses, mut poses) = (Vec::new(), Vec::new());
    let mut lines = text.lines().map(str::trim).filter(|line| !line.starts_with('#')).peekable();
    let mut has_pose = false;
    while let Some(line) = lines.next() {
        if line.is_empty() {
            continue;
        }
        if let Some(lens) = colmap_lens(line) {
            lenses.push(lens);
            continue;
        }
        let is_points = |line: &&str| line.split_whitespace().all(|word| word.parse::<f64>().is_ok());
        match colmap_image(line) {
            Some((id, name, mut parts)) => {
                match lenses.iter().find(|lens: &&(String, Vec<Node>)| lens.0 == id) {
                    Some((_, lens)) => parts.extend(lens.clone()),
                    None if lenses.is_empty() => {}
                    None => parts.push(Node::new("camera", Value::Word(id.to_owned()))),
                }
                poses.push(camera(&name, parts));
                has_pose = true;
                // The points of the image.
                lines.next_if(is_points);
            }
            // A line that should be an image keeps its place.
            None if has_pose || !lenses.is_empty() => {
                let name = line.split_whitespace().last().unwrap_or_default();
                poses.push(camera(name, vec![Node::new("line", Value::Word(line.to_owned()))]));
            }
            None => return None,
        }
    }
    if has_pose { list(poses) } else { list(lenses.into_iter().map(|(id, parts)| camera(&id, parts)).collect()) }
}

/// The lines of one pose.
const LINES: usize = 5;

/// A trajectory of `Open3D`, `.log`: for each pose a line of three whole numbers, and four lines of a matrix.
///
/// <https://www.open3d.org/docs/release/python_api/open3d.io.read_pinhole_camera_trajectory.html>: the matrix leads
/// from the camera to the world, in the axes of `OpenCV`.
pub(crate) fn trajectory(text: &str) -> Option<Node> {
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    if !lines.len().is_multiple_of(LINES) {
        return None;
    }
    list(lines.chunks(LINES).map(pose_of_log).collect::<Option<_>>()?)
}

fn pose_of_log(lines: &[&str]) -> Option<Node> {
    let (head, rows) = lines.split_first()?;
    let head: Vec<&str> = head.split_whitespace().collect();
    if head.len() != 3 || head.iter().any(|number| number.parse::<u32>().is_err()) {
        return None;
    }
    let rows: Vec<Vec<f64>> = rows.iter().map(|row| numbers(row)).collect::<Option<_>>()?;
    // Eigen prints about eight digits.
    let written = |value: &f64| Written { value: *value, error: 1e-8 * value.abs().max(1.0) };
    let entries: Vec<Written> = rows.concat().iter().map(written).collect();
    let is_square = rows.iter().all(|row| row.len() == 4);
    is_square.then(|| camera(head[0], vec![Node::new("Open3D.pose", Value::Numbers(entries, vec![4; 4]))]))
}

fn numbers(line: &str) -> Option<Vec<f64>> {
    line.split([' ', '\t', ',']).filter(|part| !part.is_empty()).map(|part| part.parse().ok()).collect()
}

/// `_par.txt` of the multiple view stereo data of Middlebury: a count, then a name, K, R and t in each line.
pub(crate) fn middlebury(text: &str) -> Option<Node> {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.next()?.parse::<u32>().ok()?;
    let line = |line: &str| {
        let (name, rest) = line.split_once(char::is_whitespace)?;
        let numbers = numbers(rest).filter(|numbers| numbers.len() == 21)?;
        let parts = [("K", 0..9), ("R", 9..18), ("t", 18..21)];
        Some(camera(name, parts.map(|(name, range)| Node::exact(name, &numbers[range])).into()))
    };
    list(lines.map(line).collect::<Option<_>>()?)
}

/// A trajectory whose head names its columns: `# timestamp tx ty tz qx qy qz qw` of TUM.
pub(crate) fn table(text: &str) -> Option<Node> {
    let (heads, lines): (Vec<&str>, Vec<&str>) =
        text.lines().map(str::trim).filter(|line| !line.is_empty()).partition(|line| line.starts_with('#'));
    let head = heads.iter().map(|head| {
        let words = head.trim_start_matches('#').split([' ', '\t', ',']).filter(|word| !word.is_empty());
        words.map(str::to_lowercase).collect::<Vec<_>>()
    });
    let wanted = ["tx", "ty", "tz", "qx", "qy", "qz", "qw"];
    let mut heads = head.filter_map(|head| {
        let places = wanted.map(|name| head.iter().position(|own| own == name));
        Some((places.into_iter().collect::<Option<Vec<_>>>()?, head.len()))
    });
    let (places, columns) = heads.next()?;
    let line = |line: &&str| {
        let numbers = numbers(line).filter(|numbers| numbers.len() == columns)?;
        let at = |places: &[usize]| places.iter().map(|at| numbers[*at]).collect::<Vec<_>>();
        let time = Node::exact("timestamp", &[numbers[0]]);
        let (t, q) = (Node::exact("position", &at(&places[..3])), Node::exact("xyzw", &at(&places[3..])));
        Some(camera("", vec![time, t, q]))
    };
    list(lines.iter().map(line).collect::<Option<_>>()?)
}

/// The items of a list. A list of one object is the object.
fn items(node: Option<&Node>) -> Vec<&Node> {
    let Some(node) = node else { return Vec::new() };
    let children = node.children();
    if children.is_empty() || children.iter().any(|child| !child.name.is_empty()) {
        return vec![node];
    }
    children.iter().collect()
}

/// The most steps from the roots of a scene. More are a cycle, or made to take all the time there is.
const MAX_STEPS: usize = 100_000;

/// The most parts of a pose above a camera. More are a cycle.
const MAX_PARTS: usize = 200;

/// The cameras of glTF: each node that has one, in the world of its scene.
///
/// A camera has no scale: of the nodes above it, rotations turn it, and scales only move it.
pub(crate) fn gltf(file: &Node) -> Option<Node> {
    let (nodes, lenses) = (items(file.child("nodes")), items(file.child("cameras")));
    file.child("asset").or(file.child("scenes"))?;
    let index = |value: f64, length: usize| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number that isn't an index is cut"
        )]
        let at = value.max(0.0) as usize;
        (at < length).then_some(at)
    };
    let children = |node: &Node| -> Vec<usize> {
        let list = node.child("children").map(Node::values).unwrap_or_default();
        list.into_iter().filter(|x| x.is_finite()).filter_map(|value| index(value, nodes.len())).collect()
    };
    let mut is_inner = vec![false; nodes.len()];
    nodes.iter().flat_map(|node| children(node)).for_each(|child| is_inner[child] = true);
    let roots = (0..nodes.len()).rev().filter(|node| !is_inner[*node]);
    let start = (DMat4::IDENTITY, DMat3::IDENTITY, Vec::<Node>::new());
    let mut waiting: Vec<_> = roots.map(|node| (node, start.clone())).collect();
    let mut found = Vec::new();
    for _ in 0..MAX_STEPS {
        let Some((at, (parent, turn, mut parts))) = waiting.pop() else { break };
        if parts.len() > MAX_PARTS {
            continue;
        }
        let node = nodes[at];
        let (own, own_turn) = transform(node);
        let (world, turn) = (parent * own, turn * own_turn);
        let keys = ["matrix", "translation", "rotation", "scale"];
        parts.extend(
            keys.into_iter()
                .filter_map(|key| node.child(key))
                .map(|part| Node { name: format!("nodes[{at}].{}.part", part.name), ..part.clone() }),
        );
        if let Some(lens) = node.number("camera").and_then(|at| index(at, lenses.len())).map(|at| lenses[at]) {
            let name = [lens, node].iter().find_map(|thing| thing.child("name")?.word().map(str::to_owned));
            let scale = DMat3::from_mat4(world);
            let is_rigid = scale.abs_diff_eq(turn, 1e-9);
            let rigid = DMat4::from_cols(
                turn.x_axis.extend(0.0),
                turn.y_axis.extend(0.0),
                turn.z_axis.extend(0.0),
                world.w_axis,
            );
            let mut own = vec![matrix("glTF.matrix", rigid)];
            own.extend((!is_rigid).then(|| {
                Node::exact("glTF.scale", &[scale.x_axis.length(), scale.y_axis.length(), scale.z_axis.length()])
            }));
            own.extend(parts.clone());
            own.extend(lens.children().iter().filter(|child| child.name != "name").cloned());
            found.push(camera(&name.unwrap_or_default(), own));
        }
        waiting.extend(children(node).into_iter().rev().map(|child| (child, (world, turn, parts.clone()))));
    }
    let others = file.children().iter().filter(|child| !matches!(child.name.as_str(), "nodes" | "cameras"));
    let others = others.map(|child| Node::new(&child.name, Value::Word(format!("{} numbers", child.values().len()))));
    let cameras = list(found)?;
    Some(Node::new("", Value::Inner(others.chain([cameras]).collect())))
}

/// A node's matrix, or T R S, and how it turns.
fn transform(node: &Node) -> (DMat4, DMat3) {
    if let Some(Ok(own)) = node.child("matrix").map(|matrix| <[f64; 16]>::try_from(matrix.values())) {
        let m = DMat4::from_cols_array(&own);
        let unit = |axis: glam::DVec4| axis.truncate().normalize_or_zero();
        let turn = DMat3::from_cols(unit(m.x_axis), unit(m.y_axis), unit(m.z_axis));
        let mirror = if turn.determinant() < 0.0 { DVec3::new(-1.0, 1.0, 1.0) } else { DVec3::ONE };
        return (m, turn * DMat3::from_diagonal(mirror));
    }
    let three = |key: &str, default: f64| match node.child(key).map(Node::values).as_deref() {
        Some([x, y, z]) => DVec3::new(*x, *y, *z),
        _ => DVec3::splat(default),
    };
    let rotation = match node.child("rotation").map(Node::values).as_deref() {
        Some([x, y, z, w]) => DQuat::from_xyzw(*x, *y, *z, *w).normalize(),
        _ => DQuat::IDENTITY,
    };
    let m = DMat4::from_scale_rotation_translation(three("scale", 1.0), rotation, three("translation", 0.0));
    (m, DMat3::from_quat(rotation))
}

/// The cameras of an object of three.js and of its children.
pub(crate) fn three_js(file: &Node) -> Option<Node> {
    let mut found = Vec::new();
    three_js_object(file.child("object").unwrap_or(file), DMat4::IDENTITY, &mut found);
    list(found)
}

fn three_js_object(object: &Node, parent: DMat4, found: &mut Vec<Node>) {
    let own = object.child("matrix").and_then(|m| <[f64; 16]>::try_from(m.values()).ok());
    let world = parent * own.map_or(DMat4::IDENTITY, |m| DMat4::from_cols_array(&m));
    let kind = object.child("type").and_then(Node::word);
    if matches!(kind, Some("PerspectiveCamera" | "OrthographicCamera")) {
        let mut parts = vec![matrix("three.js.matrix", world)];
        let others = object.children().iter().filter(|child| !matches!(child.name.as_str(), "matrix" | "children"));
        parts.extend(others.cloned());
        found.push(camera("", parts));
    }
    items(object.child("children")).into_iter().for_each(|child| three_js_object(child, world, found));
}

/// `sfm_data.json` of `OpenMVG`: each view has the numbers of its lens and of its pose.
pub(crate) fn open_mvg(file: &Node) -> Option<Node> {
    let (views, lenses) = (file.child("views")?, items(file.child("intrinsics")));
    let poses = items(file.child("extrinsics"));
    let of = |list: &[&Node], key: Option<f64>| {
        list.iter().find(|item| key.is_some() && item.number("key") == key).map(|item| (*item).clone())
    };
    let view = |view: &Node| {
        let data = view.child("value")?.child("ptr_wrapper")?.child("data")?;
        let parts = [of(&lenses, data.number("id_intrinsic")), of(&poses, data.number("id_pose"))];
        let own = data.children().iter().cloned().chain(parts.into_iter().flatten());
        Some(Node::new("", Value::Inner(own.collect())))
    };
    list(items(Some(views)).into_iter().map(view).collect::<Option<_>>()?)
}

/// `cameras.xml` of Metashape: each camera has its sensor, and the chunk has a place in the world.
pub(crate) fn metashape(file: &Node) -> Option<Node> {
    let chunk = file.child("document")?.child("chunk")?;
    let all = |list: &str, item: &'static str| {
        chunk.child(list).map(Node::children).unwrap_or_default().iter().filter(move |node| node.name == item)
    };
    let part = |name: &str, count: usize| {
        let values = chunk.child("transform")?.child(name)?.values();
        (values.len() == count).then_some(values)
    };
    let mut world = DMat4::IDENTITY;
    if let (Some(r), Some(t)) = (part("rotation", 9), part("translation", 3)) {
        let scale = part("scale", 1).map_or(1.0, |scale| scale[0]);
        let r = DMat3::from_cols_slice(&r).transpose();
        world =
            DMat4::from_scale_rotation_translation(DVec3::splat(scale), DQuat::from_mat3(&r), DVec3::from_slice(&t));
    }
    let one = |node: &Node| {
        let name = node.child("label").and_then(Node::word).unwrap_or_default().to_owned();
        let mut parts = Vec::new();
        if let Some(Ok(own)) = node.child("transform").map(|matrix| <[f64; 16]>::try_from(matrix.values())) {
            parts.push(matrix("Metashape.transform", world * DMat4::from_cols_array(&own).transpose()));
        }
        let id = node.number("sensor_id");
        let lens = all("sensors", "sensor").find(|sensor| sensor.number("id") == id);
        if let Some(lens) = lens.and_then(|sensor| sensor.child("calibration").or(sensor.child("resolution"))) {
            // Older files have f_x, and count from the corner.
            let title = if lens.child("f").is_some() { "Metashape" } else { "calibration" };
            parts.push(Node::new(title, lens.value.clone()));
        }
        camera(&name, parts)
    };
    list(all("cameras", "camera").map(one).collect())
}
