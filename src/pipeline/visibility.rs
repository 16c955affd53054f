//! The order of faces where no depth buffer decides: painter's algorithm by centroids, and by a BSP tree that splits.
//!
//! Both take the surfaces as they were shaded, and give them back in the order in which they are to be painted, one
//! over the other, and how many pieces these are. Translucent faces blend as they come.

use std::collections::HashMap;

use glam::DVec3;

use super::cut::{Origin, cut};
use super::projector::Projector;
use super::resample::{VertexOrigin, append, surface_like, takes};
use super::transform::{Screen, on_grid};
use crate::drawing::Surface;
use crate::limits::MAX_PIECE_BYTES;
use crate::progress::{Activity, Progress};

/// A surface with the data for sorting it.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// As it was shaded.
    pub(super) surface: Surface,
    /// Its vertices in view space.
    pub(super) view: Vec<DVec3>,
    /// No face of it can hide another: front faces of something convex.
    pub(super) never_hides_itself: bool,
}

/// A corner of a face that may have been split.
#[derive(Clone, Copy, Debug)]
struct FaceCorner {
    view: DVec3,
    /// Share of each corner of the whole face.
    weights: [f64; 3],
    /// A corner of the whole face.
    original: bool,
    /// The line that the side from here to the next corner lies on.
    side: usize,
}

impl FaceCorner {
    /// Its origin, if these are the vertices of the whole face.
    fn origin(&self, of: [u32; 3]) -> VertexOrigin {
        match self.weights.iter().position(|&weight| self.original && weight == 1.0) {
            Some(own) => VertexOrigin::Vertex(of[own]),
            None => VertexOrigin::Between { of, weights: self.weights },
        }
    }
}

/// The sides of faces, with the points at which any face was split there. A face keeps its neighbour's points in its
/// own border: both sides of the border have the same corners on the grid of the image, and no gap opens between them.
#[derive(Clone, Debug, Default)]
struct Sides {
    known: HashMap<[u64; 6], usize>,
    cuts: Vec<Vec<DVec3>>,
}

impl Sides {
    /// The side between two corners of whole faces; the same for both faces that have it.
    fn between(&mut self, a: DVec3, b: DVec3) -> usize {
        let bits = |p: DVec3| p.to_array().map(f64::to_bits);
        let (a, b) = (bits(a).min(bits(b)), bits(a).max(bits(b)));
        let next = self.cuts.len();
        let side = *self.known.entry([a[0], a[1], a[2], b[0], b[1], b[2]]).or_insert(next);
        if side == next {
            self.cuts.push(Vec::new());
        }
        side
    }

    /// A side that splitting makes.
    fn new_side(&mut self) -> usize {
        self.cuts.push(Vec::new());
        self.cuts.len() - 1
    }

    /// All corners of a piece, with those that its neighbours' pieces have in its border.
    fn complete(&self, piece: &Piece) -> Vec<FaceCorner> {
        let mut all = Vec::new();
        for (i, a) in piece.corners.iter().enumerate() {
            all.push(*a);
            let b = &piece.corners[(i + 1) % piece.corners.len()];
            let along = b.view - a.view;
            let place = |p: DVec3| (p - a.view).dot(along) / along.length_squared();
            let cuts = self.cuts[a.side].iter().filter(|&&p| p != a.view && p != b.view);
            let mut cuts: Vec<(f64, DVec3)> =
                cuts.map(|&p| (place(p), p)).filter(|(t, _)| *t > 0.0 && *t < 1.0).collect();
            cuts.sort_by(|p, q| p.0.total_cmp(&q.0));
            cuts.dedup_by_key(|cut| cut.1);
            all.extend(cuts.iter().map(|&(t, view)| FaceCorner {
                view,
                weights: std::array::from_fn(|k| a.weights[k] * (1.0 - t) + b.weights[k] * t),
                original: false,
                side: a.side,
            }));
        }
        all
    }
}

/// A face or a piece of one: convex, plane.
#[derive(Clone, Debug)]
struct Piece {
    layer: usize,
    triangle: u32,
    corners: Vec<FaceCorner>,
}

/// Sorted by the distance of the centroid, the farthest first. Wrong where faces interlock or differ much in size, and
/// there to be seen failing.
pub(super) fn by_centroid(layers: &[Layer], projector: &Projector, screen: &Screen) -> (Vec<Surface>, usize) {
    let (all, _) = pieces(layers);
    let distance = |piece: &Piece| piece.corners.iter().map(|c| -c.view.z).sum::<f64>();
    let mut pieces: Vec<(f64, Piece)> = all.into_iter().map(|piece| (distance(&piece), piece)).collect();
    // Of equal distances the first listed is painted last: it stays, as in a depth buffer.
    pieces.reverse();
    pieces.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut painter = Painter { layers, projector, screen, surfaces: Vec::new(), last_layer: usize::MAX };
    for (_, piece) in &pieces {
        painter.paint(piece, &piece.corners);
    }
    (painter.surfaces, pieces.len())
}

/// An exceeded budget of splitting: pieces of the faces of these layers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct TooManyPieces {
    /// Number of pieces made.
    pub(super) pieces: usize,
    /// Number of pieces of each layer.
    pub(super) of_layer: Vec<usize>,
}

/// Sorts in an order that is right for each two faces: a tree of planes of faces; faces that cross a plane are split
/// (Fuchs, Kedem and Naylor 1980).
///
/// # Errors
/// [`TooManyPieces`] where there would be more than `max_pieces`, or they would take more than [`MAX_PIECE_BYTES`].
pub(super) fn by_splitting(
    layers: &[Layer],
    projector: &Projector,
    screen: &Screen,
    max_pieces: usize,
    progress: &Progress,
) -> Result<(Vec<Surface>, usize), TooManyPieces> {
    enum Task {
        Order(Vec<Piece>),
        Paint(Vec<Piece>),
    }
    let mut made = Made::of(layers, max_pieces);
    if made.is_too_much() {
        return Err(made.into_error());
    }
    let (all, mut sides) = pieces(layers);
    let tolerance = tolerance(&all);
    let mut ordered: Vec<Piece> = Vec::new();
    // A tree that is one long branch must not exhaust the stack: the tasks wait here, the next at the end.
    let mut tasks = vec![Task::Order(all)];
    progress.begin(Activity::Ordering, 0);
    while let Some(task) = tasks.pop().filter(|_| !progress.is_cancelled()) {
        match task {
            // Of faces in one plane the first listed is painted last: it stays, as in a depth buffer.
            Task::Paint(pieces) => ordered.extend(pieces.into_iter().rev()),
            Task::Order(set) => {
                let alone = set.first().is_none_or(|first| {
                    layers[first.layer].never_hides_itself && set.iter().all(|piece| piece.layer == first.layer)
                });
                let plane = if alone || set.len() < 2 { None } else { best_plane(&set, tolerance) };
                let Some(plane) = plane else {
                    tasks.push(Task::Paint(set));
                    continue;
                };
                let parts = plane.divide(set, tolerance, &mut sides, &mut made);
                if made.is_too_much() {
                    return Err(made.into_error());
                }
                let (near, far) =
                    if plane.faces_eye(projector) { (parts.front, parts.back) } else { (parts.back, parts.front) };
                tasks.extend([Task::Order(near), Task::Paint(parts.on), Task::Order(far)]);
            }
        }
    }
    let mut painter = Painter { layers, projector, screen, surfaces: Vec::new(), last_layer: usize::MAX };
    for piece in &ordered {
        painter.paint(piece, &sides.complete(piece));
    }
    Ok((painter.surfaces, ordered.len()))
}

/// The distance from a plane within which a point is on it: a share of the extent of all faces, and the rounding of
/// their coordinates. Where the scene is small and far away, the second is much less than a share of the distance.
fn tolerance(all: &[Piece]) -> f64 {
    const OF_EXTENT: f64 = 1e-10;
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let corners = || all.iter().flat_map(|piece| &piece.corners);
    let (low, high) = corners().fold(none, |(low, high), c| (low.min(c.view), high.max(c.view)));
    let farthest = corners().fold(0.0, |most: f64, c| most.max(c.view.abs().max_element()));
    let extent = if all.is_empty() { 0.0 } else { (high - low).max_element() };
    extent * OF_EXTENT + 4.0 * farthest * f64::EPSILON
}

/// The work of splitting so far.
struct Made {
    of_layer: Vec<usize>,
    pieces: usize,
    bytes: usize,
    max_pieces: usize,
}

impl Made {
    /// Before anything is split.
    fn of(layers: &[Layer], max_pieces: usize) -> Self {
        let of_layer: Vec<usize> = layers.iter().map(|layer| layer.surface.triangles.len()).collect();
        let pieces = of_layer.iter().sum();
        Self { of_layer, pieces, bytes: pieces * bytes(3), max_pieces }
    }

    /// Records that a piece with `whole` corners has become two.
    fn split(&mut self, layer: usize, whole: usize, [front, back]: [usize; 2]) {
        self.of_layer[layer] += 1;
        self.pieces += 1;
        self.bytes = self.bytes + bytes(front) + bytes(back) - bytes(whole);
    }

    fn is_too_much(&self) -> bool {
        self.pieces > self.max_pieces || self.bytes > MAX_PIECE_BYTES
    }

    fn into_error(self) -> TooManyPieces {
        TooManyPieces { pieces: self.pieces, of_layer: self.of_layer }
    }
}

/// Memory of a piece with this number of corners.
fn bytes(corners: usize) -> usize {
    size_of::<Piece>() + corners * size_of::<FaceCorner>()
}

fn pieces(layers: &[Layer]) -> (Vec<Piece>, Sides) {
    let own = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let (mut all, mut sides) = (Vec::new(), Sides::default());
    for (k, layer) in layers.iter().enumerate() {
        for (triangle, corners) in (0_u32..).zip(&layer.surface.triangles) {
            let view = corners.map(|i| layer.view[i as usize]);
            let corner = |i: usize| FaceCorner {
                view: view[i],
                weights: own[i],
                original: true,
                side: sides.between(view[i], view[(i + 1) % 3]),
            };
            all.push(Piece { layer: k, triangle, corners: (0..3).map(corner).collect() });
        }
    }
    (all, sides)
}

/// A plane in view space that separates faces. It stores a point of it, and not its distance from the eye, so that
/// differences are taken before products.
#[derive(Clone, Copy, Debug)]
struct SplitPlane {
    point: DVec3,
    normal: DVec3,
}

#[derive(Default)]
struct Divided {
    front: Vec<Piece>,
    on: Vec<Piece>,
    back: Vec<Piece>,
}

impl SplitPlane {
    /// The plane of a face; `None` for one without area.
    fn of(piece: &Piece) -> Option<Self> {
        let [a, b, c] = [0, 1, 2].map(|i| piece.corners[i].view);
        let normal = crate::geometry::try_unit((b - a).cross(c - a))?;
        Some(Self { point: a, normal })
    }

    fn distance(&self, p: DVec3, tolerance: f64) -> f64 {
        let distance = self.normal.dot(p - self.point);
        if distance.abs() <= tolerance { 0.0 } else { distance }
    }

    /// True where the eye is in front of the plane.
    fn faces_eye(&self, projector: &Projector) -> bool {
        if projector.perspective { self.normal.dot(self.point) <= 0.0 } else { self.normal.z >= 0.0 }
    }

    /// Number of `set` that it splits, and the imbalance of the rest.
    fn cost(&self, set: &[Piece], tolerance: f64) -> usize {
        let (mut front, mut back, mut split) = (0_usize, 0_usize, 0_usize);
        for piece in set {
            let (before, behind) = self.sides(piece, tolerance);
            match (before, behind) {
                (true, true) => split += 1,
                (true, false) => front += 1,
                (false, true) => back += 1,
                (false, false) => {}
            }
        }
        8 * split + front.abs_diff(back)
    }

    /// Whether any corner is in front, and whether any is behind.
    fn sides(&self, piece: &Piece, tolerance: f64) -> (bool, bool) {
        piece.corners.iter().fold((false, false), |(before, behind), corner| {
            let distance = self.distance(corner.view, tolerance);
            (before || distance > 0.0, behind || distance < 0.0)
        })
    }

    fn divide(&self, set: Vec<Piece>, tolerance: f64, sides: &mut Sides, made: &mut Made) -> Divided {
        let mut parts = Divided::default();
        for piece in set {
            match self.sides(&piece, tolerance) {
                (false, false) => parts.on.push(piece),
                (true, false) => parts.front.push(piece),
                (false, true) => parts.back.push(piece),
                (true, true) => {
                    let (front, back) = self.split(&piece, tolerance, sides);
                    made.split(piece.layer, piece.corners.len(), [front.corners.len(), back.corners.len()]);
                    parts.front.push(front);
                    parts.back.push(back);
                }
            }
        }
        parts
    }

    /// The two pieces of one that crosses the plane.
    fn split(&self, piece: &Piece, tolerance: f64, sides: &mut Sides) -> (Piece, Piece) {
        let (mut front, mut back) = (Vec::new(), Vec::new());
        let new_side = sides.new_side();
        let all = &piece.corners;
        let distances: Vec<f64> = all.iter().map(|corner| self.distance(corner.view, tolerance)).collect();
        // `side`: 1 on the front, −1 on the back. Where the border leaves it, the piece goes on along the plane.
        let corner = |origin: Origin, side: f64| {
            let next_is_beyond = |first: usize| side * distances[(first + 1) % all.len()] < 0.0;
            match origin {
                Origin::Corner(i) => {
                    let leaves = distances[i] == 0.0 && next_is_beyond(i);
                    FaceCorner { side: if leaves { new_side } else { all[i].side }, ..all[i] }
                }
                Origin::Edge(edge) => {
                    let (inside, outside) = (&all[edge.inside], &all[edge.outside]);
                    FaceCorner {
                        view: inside.view * edge.shares[0] + outside.view * edge.shares[1],
                        weights: std::array::from_fn(|k| edge.mean(inside.weights[k], outside.weights[k])),
                        original: false,
                        side: if next_is_beyond(edge.first) { new_side } else { all[edge.first].side },
                    }
                }
            }
        };
        cut(
            all.len(),
            |i| distances[i],
            |origin| {
                let corner = corner(origin, 1.0);
                if let Origin::Edge(edge) = origin {
                    sides.cuts[all[edge.first].side].push(corner.view);
                }
                front.push(corner);
            },
            |origin| back.push(corner(origin, -1.0)),
        );
        (Piece { corners: front, ..piece.clone() }, Piece { corners: back, ..piece.clone() })
    }
}

/// Of some planes of faces, and in large sets of some upright planes through the middle too, the one that splits least
/// and divides most evenly; `None` where no face has an area.
fn best_plane(set: &[Piece], tolerance: f64) -> Option<SplitPlane> {
    const TRIED: usize = 6;
    const LARGE: usize = 128;
    let step = set.len().div_ceil(TRIED);
    let mut candidates: Vec<SplitPlane> = set.iter().step_by(step).filter_map(SplitPlane::of).collect();
    if candidates.is_empty() {
        candidates.extend(set.iter().find_map(SplitPlane::of));
    }
    if set.len() > LARGE && !candidates.is_empty() {
        for axis in DVec3::AXES {
            let mut along: Vec<f64> = set.iter().map(|piece| axis.dot(piece.corners[0].view)).collect();
            let middle = along.len() / 2;
            let (_, median, _) = along.select_nth_unstable_by(middle, f64::total_cmp);
            candidates.push(SplitPlane { point: axis * *median, normal: axis });
        }
    }
    let useful = |plane: &SplitPlane| {
        // A plane that leaves the whole set on one side would go on for ever.
        let (before, behind) = set.iter().fold((0, 0), |(before, behind), piece| {
            let (b, h) = plane.sides(piece, tolerance);
            (before + usize::from(b), behind + usize::from(h))
        });
        before < set.len() && behind < set.len()
    };
    candidates.into_iter().filter(useful).min_by_key(|plane| plane.cost(set, tolerance))
}

/// Puts pieces one after the other into as few surfaces as their paints allow.
struct Painter<'a> {
    layers: &'a [Layer],
    projector: &'a Projector,
    screen: &'a Screen,
    surfaces: Vec<Surface>,
    last_layer: usize,
}

impl Painter<'_> {
    /// Paints a piece, whose border has these corners.
    fn paint(&mut self, piece: &Piece, corners: &[FaceCorner]) {
        let layer = &self.layers[piece.layer];
        let old = &layer.surface;
        let of = old.triangles[piece.triangle as usize];
        let same_layer = self.last_layer == piece.layer;
        self.last_layer = piece.layer;
        if !self.surfaces.last().is_some_and(|last| same_layer || takes(last, old)) {
            self.surfaces.push(surface_like(old));
        }
        let Some(surface) = self.surfaces.last_mut() else { return };
        let first = u32::try_from(surface.positions.len()).unwrap_or(u32::MAX);
        let origins: Vec<VertexOrigin> = corners.iter().map(|corner| corner.origin(of)).collect();
        for (corner, origin) in corners.iter().zip(&origins) {
            let whole = match origin {
                VertexOrigin::Vertex(i) => Some(*i as usize),
                VertexOrigin::Between { .. } => None,
            };
            surface.positions.push(match whole {
                Some(i) => old.positions[i],
                None => on_grid(self.screen.project(self.projector, self.projector.clip(corner.view))),
            });
            if !old.inverse_w.is_empty() {
                surface.inverse_w.push(match whole {
                    Some(i) => old.inverse_w[i],
                    None => self.projector.depths.relative_inverse_w(-corner.view.z),
                });
            }
        }
        let last = first + u32::try_from(corners.len()).unwrap_or(0);
        let before = surface.triangles.len();
        surface.triangles.extend((first + 1..last.saturating_sub(1)).map(|k| [first, k, k + 1]));
        let pieces = surface.triangles.len() - before;
        append(surface, old, &origins, piece.triangle, pieces);
    }
}
