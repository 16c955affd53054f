//! Files that keep a camera in several places, or in a line: each becomes a tree with a part for each camera.

use glam::{DMat3, DMat4, DQuat, DVec3, dcamera};

use super::tree::{DEPTH, Node, Value, fold, listed};
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
                    None => parts.push(Node::new(&format!("camera {id}"), Value::Word("?".to_owned()))),
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

/// The place of a part of a scene. A camera has no scale: rotations above it turn it, and scales above it only move it.
#[derive(Clone, Default)]
struct Place {
    world: DMat4,
    turn: DMat3,
    parts: Vec<Node>,
}

impl Place {
    /// A part inside this one: its steps, the outermost first. Those that aren't known stay as they are.
    fn inside<'a>(&self, path: &str, steps: impl Iterator<Item = &'a Node>) -> Self {
        let mut place = self.clone();
        for node in steps {
            let known = step(node);
            let end = if known.is_some() { "part" } else { "step" };
            place.parts.push(Node { name: format!("{path}.{}.{end}", node.name), ..node.clone() });
            let Some(own) = known else { continue };
            let unit = |axis: glam::DVec4| axis.truncate().normalize_or_zero();
            let turn = DMat3::from_cols(unit(own.x_axis), unit(own.y_axis), unit(own.z_axis));
            let mirror = if turn.determinant() < 0.0 { DVec3::new(-1.0, 1.0, 1.0) } else { DVec3::ONE };
            let is_scale = node.name.to_lowercase().ends_with("scale");
            place.world *= own;
            place.turn *= if is_scale { DMat3::IDENTITY } else { turn * DMat3::from_diagonal(mirror) };
        }
        place
    }

    /// A camera that stands here, with its lens.
    fn camera<'a>(self, program: &str, name: &str, lens: impl Iterator<Item = &'a Node>) -> Node {
        let scale = DMat3::from_mat4(self.world);
        let mut rigid = DMat4::from_mat3(self.turn);
        rigid.w_axis = self.world.w_axis;
        // Another last row stays, so that it's refused.
        let is_affine = self.world.row(3) == glam::DVec4::W;
        let mut own = vec![matrix(&format!("{program}.matrix"), if is_affine { rigid } else { self.world })];
        if !scale.abs_diff_eq(self.turn, 1e-5) {
            let lengths = [scale.x_axis, scale.y_axis, scale.z_axis].map(DVec3::length);
            own.push(Node::exact(&format!("{program}.scale"), &lengths));
        }
        own.extend(self.parts);
        own.extend(lens.cloned());
        camera(name, own)
    }
}

/// A step of a transform, by its name in USD, pbrt, COLLADA, glTF or three.js.
fn step(node: &Node) -> Option<DMat4> {
    let values = node.values();
    let vector = |k: usize| DVec3::from_slice(&values[k..k + 3]);
    let turn = |axis: DVec3, degrees: f64| Some(DMat4::from_axis_angle(axis.try_normalize()?, degrees.to_radians()));
    let quaternion = |q: [f64; 4]| DMat4::from_quat(DQuat::from_array(q).normalize());
    let name = if node.call.is_empty() { &node.name } else { &node.call };
    Some(match (name.as_str(), values.as_slice()) {
        // COLLADA has rows, the others columns.
        ("matrix" | "transform" | "Transform" | "ConcatTransform", m) => {
            let m = DMat4::from_cols_array(m.try_into().ok()?);
            if node.call.is_empty() { m } else { m.transpose() }
        }
        ("translate" | "Translate" | "translation", [_, _, _]) => DMat4::from_translation(vector(0)),
        ("scale" | "Scale", [_, _, _]) => DMat4::from_scale(vector(0)),
        ("rotation", [x, y, z, w]) | ("orient", [w, x, y, z]) => quaternion([*x, *y, *z, *w]),
        ("Rotate", [degrees, _, _, _]) => turn(vector(1), *degrees)?,
        ("rotate", [_, _, _, degrees]) => turn(vector(0), *degrees)?,
        ("LookAt", values) if values.len() == 9 => dcamera::lh::view::look_at_mat4(vector(0), vector(3), vector(6)),
        ("lookat", values) if values.len() == 9 => {
            dcamera::rh::view::look_at_mat4(vector(0), vector(3), vector(6)).inverse()
        }
        // `rotateXYZ` turns about x first.
        (name, angles) => {
            let axes = name.strip_prefix("rotate").filter(|axes| !axes.is_empty() && axes.len() == angles.len())?;
            axes.chars().try_fold(DMat4::IDENTITY, |m, axis| {
                let axis = "XYZ".find(axis)?;
                Some(turn(DVec3::AXES[axis], angles[if angles.len() == 1 { 0 } else { axis }])? * m)
            })?
        }
    })
}

/// The cameras of glTF: each node that has one, in the world of its scene.
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
    let mut waiting: Vec<_> = roots.map(|node| (node, Place::default())).collect();
    let mut found = Vec::new();
    for _ in 0..MAX_STEPS {
        let Some((at, parent)) = waiting.pop() else { break };
        if parent.parts.len() > MAX_PARTS {
            continue;
        }
        let node = nodes[at];
        let keys: &[&str] =
            if node.child("matrix").is_some() { &["matrix"] } else { &["translation", "rotation", "scale"] };
        let place = parent.inside(&format!("nodes[{at}]"), keys.iter().filter_map(|key| node.child(key)));
        waiting.extend(children(node).into_iter().rev().map(|child| (child, place.clone())));
        if let Some(lens) = node.number("camera").and_then(|at| index(at, lenses.len())).map(|at| lenses[at]) {
            let name = [lens, node].iter().find_map(|thing| thing.child("name")?.word()).unwrap_or_default();
            found.push(place.camera("glTF", name, lens.children().iter().filter(|child| child.name != "name")));
        }
    }
    beside(file, &["nodes", "cameras"], found)
}

/// Cameras, and the other parts of their file.
fn beside(file: &Node, taken: &[&str], cameras: Vec<Node>) -> Option<Node> {
    let others = file.children().iter().filter(|child| !taken.contains(&child.name.as_str()));
    let shown = |child: &Node| match child.values().as_slice() {
        few if few.len() <= 16 => few.iter().map(f64::to_string).collect::<Vec<_>>().join(" "),
        many => format!("{} numbers", many.len()),
    };
    let others = others.map(|child| Node::new(&child.name, Value::Word(shown(child))));
    let cameras = list(cameras)?;
    Some(Node::new("", Value::Inner(others.chain([cameras]).collect())))
}

/// The cameras of an object of three.js and of its children.
pub(crate) fn three_js(file: &Node) -> Option<Node> {
    let mut found = Vec::new();
    three_js_object(file.child("object").unwrap_or(file), &Place::default(), &mut found);
    list(found)
}

fn three_js_object(object: &Node, parent: &Place, found: &mut Vec<Node>) {
    let place = Place { parts: Vec::new(), ..parent.inside("", object.child("matrix").into_iter()) };
    let kind = object.child("type").and_then(Node::word);
    if matches!(kind, Some("PerspectiveCamera" | "OrthographicCamera")) {
        let others = object.children().iter().filter(|child| !matches!(child.name.as_str(), "matrix" | "children"));
        found.push(place.clone().camera("three.js", "", others));
    }
    items(object.child("children")).into_iter().for_each(|child| three_js_object(child, &place, found));
}

/// The cameras of USD as text: each `def Camera`, in the places of the parts around it.
pub(crate) fn usd(file: &Node) -> Option<Node> {
    let up = file.children().iter().flat_map(Node::children).find(|child| child.name == "upAxis");
    let program = if up.and_then(Node::word) == Some("Z") { "USD.z_up" } else { "USD" };
    let mut found = Vec::new();
    usd_parts(file.children(), "", program, &Place::default(), &mut found);
    list(found)
}

fn usd_parts(nodes: &[Node], path: &str, program: &str, parent: &Place, found: &mut Vec<Node>) {
    for pair in nodes.windows(2).filter(|pair| matches!(pair[0].name.as_str(), "def" | "over")) {
        let [.., Node { value: Value::Inner(body), .. }] = pair[1].children() else { continue };
        let name = pair[1].children().iter().find_map(Node::word).unwrap_or_default();
        let is_step = |node: &&[Node]| node[0].name == "xformOp";
        let steps = || body.windows(2).filter(is_step).map(|pair| &pair[1]);
        let order = body.iter().find(|node| node.name == "xformOpOrder").map(Node::children).unwrap_or_default();
        let named = |op: &Node| {
            steps().find(|step| op.word().and_then(|op| op.strip_prefix("xformOp:")) == Some(step.name.as_str()))
        };
        let known: Vec<&Node> = order.iter().filter_map(named).collect();
        let known = if known.is_empty() { steps().collect() } else { known };
        let path = format!("{path}/{name}");
        let place = parent.inside(&path, known.into_iter());
        if pair[1].name == "Camera" {
            let is_lens = |child: &&Node| {
                child.word() != Some("") && steps().all(|step| !std::ptr::eq(step, *child)) && child.name != "token"
            };
            // What USD has if it isn't said.
            let defaults = [("focalLength", 50.0), ("horizontalAperture", 20.955), ("verticalAperture", 15.2908)];
            let has = |name: &str| body.iter().any(|node| node.name == name);
            let defaults: Vec<Node> =
                defaults.iter().filter(|(name, _)| !has(name)).map(|(name, x)| Node::exact(name, &[*x])).collect();
            found.push(place.clone().camera(program, name, body.iter().filter(is_lens).chain(&defaults)));
        }
        usd_parts(body, &path, program, &place, found);
    }
}

/// The cameras of COLLADA: each node that has one, in the places of the nodes around it.
pub(crate) fn collada(file: &Node) -> Option<Node> {
    let file = file.child("COLLADA")?;
    let up = file.child("asset").and_then(|asset| asset.child("up_axis")?.word());
    let program = if up == Some("Z_UP") { "COLLADA.z_up" } else { "COLLADA" };
    let mut found = Vec::new();
    for scene in file.child("library_visual_scenes")?.children() {
        let lenses = file.child("library_cameras").map(Node::children).unwrap_or_default();
        collada_nodes(scene, lenses, program, &Place::default(), &mut found);
    }
    beside(file, &["library_visual_scenes", "library_cameras"], found)
}

fn collada_nodes(node: &Node, lenses: &[Node], program: &str, parent: &Place, found: &mut Vec<Node>) {
    let word = |node: &Node, name: &str| node.child(name).and_then(Node::word).unwrap_or_default().to_owned();
    for node in node.children().iter().filter(|node| node.call == "node") {
        let steps = node.children().iter().filter(|child| step(child).is_some());
        let place = parent.inside(&word(node, "id"), steps);
        for instance in node.children().iter().filter(|child| child.call == "instance_camera") {
            let url = word(instance, "url");
            let lens = lenses.iter().find(|lens| url.strip_prefix('#') == Some(&word(lens, "id")));
            let lens = lens.map(Node::children).unwrap_or_default();
            let lens = lens.iter().filter(|child| !matches!(child.name.as_str(), "id" | "name"));
            found.push(place.clone().camera(program, &word(node, "name"), lens));
        }
        collada_nodes(node, lenses, program, &place, found);
    }
}

/// A camera of pbrt below several steps, which lead from the world to the camera. A mirror among them makes the world
/// right-handed.
pub(crate) fn pbrt(file: &Node) -> Option<Node> {
    let place = |name: &str| file.children().iter().position(|node| node.name == name);
    // RenderMan's steps stand behind its projection.
    let end = place("Camera").or(place("WorldBegin").filter(|_| place("Projection").is_some()))?;
    let is_step = |node: &&Node| node.name.starts_with(char::is_uppercase) && step(node).is_some();
    let steps: Vec<&Node> = file.children()[..end].iter().filter(is_step).collect();
    let is_one = matches!(steps[..], [only] if only.name == "LookAt");
    if steps.is_empty() {
        return None;
    }
    let start = steps.iter().rposition(|node| node.name == "Transform").unwrap_or(0);
    let mut view = steps[start..].iter().filter_map(|node| step(node)).fold(DMat4::IDENTITY, |m, step| m * step);
    let mirrors = view.determinant() < 0.0;
    if mirrors {
        view = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)) * view;
    }
    let mut own = vec![matrix(if mirrors { "pbrt.mirrored.view" } else { "pbrt.view" }, view)];
    own.truncate(usize::from(!is_one));
    own.extend(file.children().iter().take_while(|node| node.name != "WorldBegin").map(|node| {
        let name = match node.name.as_str() {
            "Camera" => "Camera.projection".to_owned(),
            name if !is_one && is_step(&node) => format!("{name}.part"),
            name => name.to_owned(),
        };
        Node { name, ..node.clone() }
    }));
    list(vec![camera("", own)])
}

/// `sfm_data.json` of `OpenMVG`: each view has the numbers of its lens and of its pose.
pub(crate) fn open_mvg(file: &Node) -> Option<Node> {
    let (views, lenses) = (file.child("views")?, items(file.child("intrinsics")));
    let poses = items(file.child("extrinsics"));
    let of = |list: &[&Node], key: Option<f64>| {
        list.iter().find(|item| key.is_some() && item.number("key") == key).map(|item| (*item).clone())
    };
    let view = |view: &Node| {
        let (value, pointer) = (view.child("value")?, view.child("value")?.child("ptr_wrapper")?);
        let data = pointer.child("data")?;
        let parts = [of(&lenses, data.number("id_intrinsic")), of(&poses, data.number("id_pose"))];
        let around = [view, value, pointer].into_iter().flat_map(Node::children);
        let around = around.filter(|node| !matches!(node.name.as_str(), "value" | "ptr_wrapper" | "data"));
        let own = data.children().iter().chain(around).cloned().chain(parts.into_iter().flatten());
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
        let sensor = all("sensors", "sensor").find(|sensor| sensor.number("id") == id);
        let of_sensor = sensor.map(Node::children).unwrap_or_default().iter();
        let is_taken = |child: &&Node| node.child(&child.name).is_some_and(|first| std::ptr::eq(first, *child));
        let others = node.children().iter();
        let others = others.filter(|child| !(matches!(child.name.as_str(), "label" | "transform") && is_taken(child)));
        parts.extend(others.chain(of_sensor.filter(|child| child.name != "calibration")).cloned());
        if let Some(lens) = sensor.and_then(|sensor| sensor.child("calibration").or(sensor.child("resolution"))) {
            // Older files have f_x, and count from the corner.
            let title = if lens.child("f").is_some() { "Metashape" } else { "calibration" };
            parts.push(Node::new(title, lens.value.clone()));
        }
        camera(&name, parts)
    };
    list(all("cameras", "camera").map(one).collect())
}

/// The numbers of a text, or the text.
fn content(text: &str) -> Value {
    match listed(text) {
        Some(numbers) => {
            let lines = text.lines().map(|line| line.split_whitespace().count()).filter(|count| *count > 0).collect();
            Value::Numbers(numbers, lines)
        }
        None => Value::Word(text.to_owned()),
    }
}

/// The tree of XML.
pub(crate) fn xml_tree(text: &str) -> Node {
    Node::new("", fold(xml(text)))
}

/// The elements of XML: attributes are nodes as well. An attribute that names an element is its name.
fn xml(text: &str) -> Vec<Node> {
    let mut open: Vec<(Node, Vec<Node>)> = vec![Default::default()];
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        let between = rest[..at].trim();
        // There is always the whole.
        if let Some((_, inner)) = open.last_mut().filter(|_| !between.is_empty()) {
            inner.push(Node::new("", content(between)));
        }
        rest = &rest[at..];
        let end = if rest.starts_with("<!--") { "-->" } else { ">" };
        let Some(length) = rest.find(end) else { break };
        let tag = &rest[1..length];
        rest = &rest[length + end.len()..];
        if tag.starts_with(['?', '!']) {
            continue;
        }
        if !tag.starts_with('/') && open.len() <= DEPTH {
            open.push(element(tag.trim_end_matches('/')));
        }
        if (tag.starts_with('/') || tag.ends_with('/')) && open.len() > 1 {
            // It has more than the whole.
            close(&mut open);
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop().map(|(_, inner)| inner).unwrap_or_default()
}

/// Puts the last open element into the one around it.
fn close(open: &mut Vec<(Node, Vec<Node>)>) {
    if let Some((mut node, inner)) = open.pop()
        && let Some((_, outer)) = open.last_mut()
    {
        node.value = fold(inner);
        outer.push(node);
    }
}

fn element(tag: &str) -> (Node, Vec<Node>) {
    let (name, mut rest) = tag.split_once(char::is_whitespace).unwrap_or((tag, ""));
    let mut node = Node { name: name.to_owned(), call: name.to_owned(), ..Node::default() };
    let mut inner = Vec::new();
    while let Some((key, after)) = rest.split_once('=') {
        let after = after.trim_start();
        let Some(mark) = after.chars().next().filter(|c| matches!(c, '"' | '\'')) else { break };
        let Some((value, after)) = after[1..].split_once(mark) else { break };
        rest = after;
        match key.trim() {
            "name" | "sid" if name != "node" && name != "camera" => value.clone_into(&mut node.name),
            "value" | "data" => inner.push(Node::new("", content(value))),
            key => inner.push(Node::new(key, content(value))),
        }
    }
    (node, inner)
}
