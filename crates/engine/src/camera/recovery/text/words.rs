//! Words of a text that say which matrix it is: one row each.

use crate::camera::recovery::{Axes, MatrixKind, Order, Reading};

/// A word, and the reading that it means. `None` leaves a part of it open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Word {
    pub(crate) word: &'static str,
    pub(crate) kind: Option<MatrixKind>,
    pub(crate) axes: Option<Axes>,
    pub(crate) order: Option<Order>,
    /// Other things have this name too, so it refuses nothing.
    pub(crate) is_weak: bool,
}

impl Word {
    /// A word that leaves nothing open.
    pub(crate) const fn full(word: &'static str, kind: MatrixKind, axes: Axes, order: Order) -> Self {
        Self { order: Some(order), ..with_axes(word, kind, axes) }
    }

    /// True if it means a reading in each of its parts.
    pub(crate) fn means(&self, reading: &Reading, order: Order) -> bool {
        self.kind.is_none_or(|kind| kind == reading.kind)
            && self.axes.is_none_or(|axes| axes == reading.axes)
            && self.order.is_none_or(|own| own == order)
    }
}

const fn row(word: &'static str, kind: MatrixKind) -> Word {
    Word { word, kind: Some(kind), axes: None, order: None, is_weak: false }
}

const fn with_axes(word: &'static str, kind: MatrixKind, axes: Axes) -> Word {
    Word { axes: Some(axes), ..row(word, kind) }
}

/// Without regard to capitals and underscores. A word stands before the shorter ones that it contains.
const WORDS: [Word; 42] = [
    row("worldviewproj", MatrixKind::ViewProjection),
    row("modelviewproj", MatrixKind::ViewProjection),
    row("viewproj", MatrixKind::ViewProjection),
    with_axes("fullprojtransform", MatrixKind::ViewProjection, Axes::OPENCV),
    with_axes("matrixworldinverse", MatrixKind::View, Axes::OPENGL),
    with_axes("worldtocameramatrix", MatrixKind::View, Axes::UNITY),
    with_axes("cameratoworldmatrix", MatrixKind::CameraToWorld, Axes::UNITY),
    with_axes("localtoworldmatrix", MatrixKind::CameraToWorld, Axes::DIRECT3D),
    with_axes("matrixworld", MatrixKind::CameraToWorld, Axes::OPENGL),
    Word::full("transformmatrix", MatrixKind::CameraToWorld, Axes::BLENDER, Order::Rows),
    with_axes("extrinsic", MatrixKind::View, Axes::OPENCV),
    with_axes("worldviewtransform", MatrixKind::View, Axes::OPENCV),
    // Godot: the order of its numbers depends on how they're written.
    with_axes("transform3d", MatrixKind::CameraToWorld, Axes::OPENGL),
    row("toworld", MatrixKind::CameraToWorld),
    Word::full("tcamimu", MatrixKind::View, Axes::OPENCV, Order::Rows),
    Word::full("tcambody", MatrixKind::View, Axes::OPENCV, Order::Rows),
    Word::full("timucam", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word::full("tbs", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    row("tcamworld", MatrixKind::View),
    row("tworldcam", MatrixKind::CameraToWorld),
    with_axes("cameratransform", MatrixKind::CameraToWorld, Axes::OPENGL),
    row("viewmatrix", MatrixKind::View),
    row("viewmat", MatrixKind::View),
    row("viewtransform", MatrixKind::View),
    row("modelview", MatrixKind::View),
    row("worldtocam", MatrixKind::View),
    row("world2cam", MatrixKind::View),
    row("w2c", MatrixKind::View),
    row("tcw", MatrixKind::View),
    row("cameratoworld", MatrixKind::CameraToWorld),
    row("camtoworld", MatrixKind::CameraToWorld),
    row("cam2world", MatrixKind::CameraToWorld),
    row("c2w", MatrixKind::CameraToWorld),
    row("twc", MatrixKind::CameraToWorld),
    row("projection", MatrixKind::Projection),
    row("perspective", MatrixKind::Projection),
    row("projmat", MatrixKind::Projection),
    row("projmatrix", MatrixKind::Projection),
    row("intrinsic", MatrixKind::Intrinsics),
    row("cameramatrix", MatrixKind::Intrinsics),
    row("cameraposition", MatrixKind::LookAt),
    // Files of glTF and three.js: sixteen numbers by columns, of a node.
    Word { is_weak: true, ..Word::full("\"matrix\":", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Columns) },
];

/// Names of matrices that say all of them. A longer path ends in one.
const NAMES: [Word; 6] = [
    Word::full("gltf.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("three.js.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("open3d.pose", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word::full("metashape.transform", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word { is_weak: true, ..row("transform", MatrixKind::CameraToWorld) },
    Word { is_weak: true, ..Word::full("matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Columns) },
];

/// The word that a name in plain letters is.
pub(crate) fn of_name(path: &str) -> Option<Word> {
    let last = path.rsplit('.').next().unwrap_or(path);
    let is_end = |row: &&Word| path.strip_suffix(row.word).is_some_and(|rest| rest.is_empty() || rest.ends_with('.'));
    let contained = || WORDS.iter().find(|row| last.contains(row.word));
    NAMES.iter().find(is_end).or_else(contained).copied()
}

/// The word of a text that says which matrix it is.
pub(crate) fn find(text: &str) -> Option<Word> {
    let plain: String = text.to_lowercase().chars().filter(|c| !c.is_whitespace() && *c != '_').collect();
    // `matrix_world` is Blender's, `matrixWorld` that of three.js.
    if text.contains("matrix_world") {
        return Some(with_axes("matrix_world", MatrixKind::CameraToWorld, Axes::BLENDER));
    }
    // The columns of glam have names.
    if text.contains("x_axis") {
        let word = WORDS.into_iter().find(|row| plain.contains(row.word));
        let open = Word { word: "x_axis", kind: None, axes: None, order: None, is_weak: false };
        return Some(Word { order: Some(Order::Columns), ..word.unwrap_or(open) });
    }
    WORDS.into_iter().find(|row| plain.contains(row.word))
}
