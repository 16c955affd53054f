//! The order of faces by a tree of planes: faces that cross a plane are split (Fuchs, Kedem and Naylor 1980).
//!
//! A set of pieces is divided by a plane of one of them. The pieces behind it, seen from the eye, are painted first,
//! then those in the plane, then those before it. Each of the two sides is divided in its turn. Splitting may go on for
//! long, so it has a budget.

use glam::DVec3;

use super::painter::{Painter, ToImage};
use super::pieces::{Corner, Cuts, Layer, Piece, pieces};
use crate::drawing::Surface;
use crate::geometry::try_unit;
use crate::limits::MAX_PIECE_BYTES;
use crate::pipeline::mesh::cut::{Origin, cut};
use crate::pipeline::space::projector::Projector;
use crate::progress::{Activity, Progress};

/// An exceeded budget of splitting. The pieces are of the faces of these layers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TooManyPieces {
    /// Number of pieces made.
    pub(crate) pieces: usize,
    /// Number of pieces of each layer.
    pub(crate) of_layer: Vec<usize>,
}

/// Sorts in an order that is right for each two faces, and gives the number of pieces.
///
/// # Errors
/// [`TooManyPieces`] if there would be more than `max_pieces`, or they would take more than [`MAX_PIECE_BYTES`].
pub(crate) fn by_splitting(
    layers: &[Layer],
    projector: &Projector,
    image: &ToImage,
    max_pieces: usize,
    progress: &Progress,
) -> Result<(Vec<Surface>, usize), TooManyPieces> {
    let faces = layers.iter().map(|layer| layer.surface.triangles.len()).sum();
    let budget = Budget { pieces: faces, bytes: faces * bytes(3), max_pieces };
    if budget.is_exceeded() {
        let of_layer = layers.iter().map(|layer| layer.surface.triangles.len()).collect();
        return Err(TooManyPieces { pieces: faces, of_layer });
    }
    progress.begin(Activity::Ordering, 0);
    let (set, sides) = pieces(layers);
    let mut tree =
        BspTree { layers, projector, tolerance: tolerance(&set), budget, cuts: Cuts::new(sides), ordered: Vec::new() };
    tree.order(set, progress)?;
    let mut painter = Painter::new(layers, image);
    for piece in &tree.ordered {
        painter.paint(piece, &tree.cuts.border(&piece.corners));
    }
    Ok((painter.surfaces, tree.ordered.len()))
}

/// The distance from a plane within which a point is on it: a share of the extent of all faces, and the rounding of
/// their coordinates. If the scene is small and far away, the second is much less than a share of the distance.
fn tolerance(set: &[Piece]) -> f64 {
    const OF_EXTENT: f64 = 1e-10;
    let corners = || set.iter().flat_map(|piece| &piece.corners).map(|corner| corner.view);
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = corners().fold(none, |(low, high), c| (low.min(c), high.max(c)));
    let farthest = corners().fold(0.0, |most: f64, c| most.max(c.abs().max_element()));
    let extent = if set.is_empty() { 0.0 } else { (high - low).max_element() };
    let tolerance = extent * OF_EXTENT + 4.0 * farthest * f64::EPSILON;
    if tolerance.is_nan() { 0.0 } else { tolerance }
}

/// The work of splitting so far, and how much is allowed.
struct Budget {
    pieces: usize,
    bytes: usize,
    max_pieces: usize,
}

impl Budget {
    /// Records that a piece with `whole` corners has become two.
    fn split(&mut self, whole: usize, [front, back]: [usize; 2]) {
        self.pieces += 1;
        self.bytes += bytes(front) + bytes(back) - bytes(whole);
    }

    fn is_exceeded(&self) -> bool {
        self.pieces > self.max_pieces || self.bytes > MAX_PIECE_BYTES
    }
}

/// Memory of a piece with this number of corners, at most.
fn bytes(corners: usize) -> usize {
    40 + corners * 64
}

struct BspTree<'a> {
    layers: &'a [Layer],
    projector: &'a Projector,
    tolerance: f64,
    budget: Budget,
    cuts: Cuts,
    /// In the order of painting.
    ordered: Vec<Piece>,
}

/// A treatment of some pieces.
enum Task {
    Order(Vec<Piece>),
    Paint(Vec<Piece>),
}

impl Task {
    fn pieces(&self) -> &[Piece] {
        let (Self::Order(set) | Self::Paint(set)) = self;
        set
    }
}

impl BspTree<'_> {
    /// Puts all pieces in order. `tasks` wait in a list, the next at the end, so that a tree of one long branch can't
    /// exhaust the stack.
    fn order(&mut self, set: Vec<Piece>, progress: &Progress) -> Result<(), TooManyPieces> {
        let mut tasks = vec![Task::Order(set)];
        while !tasks.is_empty() && !progress.is_cancelled() {
            if self.budget.is_exceeded() {
                return Err(self.too_many(&tasks));
            }
            match tasks.pop() {
                Some(Task::Order(set)) => match self.plane(&set) {
                    Some(plane) => {
                        let [near, on, far] = self.divide(set, &plane);
                        tasks.extend([Task::Order(near), Task::Paint(on), Task::Order(far)]);
                    }
                    None => self.paint(set),
                },
                Some(Task::Paint(set)) => self.paint(set),
                None => {}
            }
        }
        Ok(())
    }

    fn too_many(&self, tasks: &[Task]) -> TooManyPieces {
        let mut of_layer = vec![0; self.layers.len()];
        let waiting = tasks.iter().flat_map(Task::pieces);
        waiting.chain(&self.ordered).for_each(|piece| of_layer[piece.layer] += 1);
        TooManyPieces { pieces: of_layer.iter().sum(), of_layer }
    }

    /// The first listed of the faces in one plane is painted last. It stays, as in a depth buffer.
    fn paint(&mut self, set: Vec<Piece>) {
        self.ordered.extend(set.into_iter().rev());
    }

    /// The plane that divides a set, if any. It's the best of some planes of faces, and in large sets of some upright
    /// planes through the middle too. The first of equals wins.
    fn plane(&self, set: &[Piece]) -> Option<SplitPlane> {
        const TRIED: usize = 6;
        const LARGE: usize = 128;
        let [first, _, ..] = set else { return None };
        if self.layers[first.layer].never_hides_itself && set.iter().all(|piece| piece.layer == first.layer) {
            return None;
        }
        let plane_of = |piece: &Piece| SplitPlane::of(&piece.corners);
        let mut candidates: Vec<SplitPlane> =
            set.iter().step_by(set.len().div_ceil(TRIED)).filter_map(plane_of).collect();
        if candidates.is_empty() {
            candidates.extend(set.iter().find_map(plane_of));
        }
        if set.len() > LARGE && !candidates.is_empty() {
            for axis in DVec3::AXES {
                let mut along: Vec<f64> = set.iter().map(|piece| axis.dot(piece.corners[0].view)).collect();
                let middle = along.len() / 2;
                let (_, median, _) = along.select_nth_unstable_by(middle, f64::total_cmp);
                candidates.push(SplitPlane { point: axis * *median, normal: axis });
            }
        }
        let costs = candidates.into_iter().filter_map(|plane| Some((plane.cost(set, self.tolerance)?, plane)));
        costs.min_by_key(|(cost, _)| *cost).map(|(_, plane)| plane)
    }

    /// Divides a set into the pieces nearer to the eye, those in the plane and those behind it, each in the order they
    /// had.
    fn divide(&mut self, set: Vec<Piece>, plane: &SplitPlane) -> [Vec<Piece>; 3] {
        let [mut front, mut on, mut back] = [const { Vec::new() }; 3];
        for piece in set {
            match plane.sides(&piece, self.tolerance) {
                (false, false) => on.push(piece),
                (true, false) => front.push(piece),
                (false, true) => back.push(piece),
                (true, true) => {
                    let [before, behind] = self.split(plane, &piece);
                    front.push(before);
                    back.push(behind);
                }
            }
        }
        if plane.faces_eye(self.projector) { [front, on, back] } else { [back, on, front] }
    }

    /// The two pieces, in front and behind, of one that crosses the plane.
    fn split(&mut self, plane: &SplitPlane, piece: &Piece) -> [Piece; 2] {
        let corners = &piece.corners;
        let new_side = self.cuts.new_side();
        let distances: Vec<f64> = corners.iter().map(|corner| plane.distance(corner.view, self.tolerance)).collect();
        // `side`: 1 on the front, −1 on the back. If the border leaves it, the piece follows the plane.
        let corner = |origin: Origin, side: f64| {
            let next_is_beyond = |first: usize| side * distances[(first + 1) % corners.len()] < 0.0;
            match origin {
                Origin::Corner(i) => {
                    let leaves = distances[i] == 0.0 && next_is_beyond(i);
                    Corner { side: if leaves { new_side } else { corners[i].side }, ..corners[i] }
                }
                Origin::Edge(edge) => {
                    let (inside, outside) = (&corners[edge.inside], &corners[edge.outside]);
                    let view = inside.view * edge.shares[0] + outside.view * edge.shares[1];
                    let weights = std::array::from_fn(|k| edge.mean(inside.weights[k], outside.weights[k]));
                    let side = if next_is_beyond(edge.first) { new_side } else { corners[edge.first].side };
                    Corner { view, weights, original: false, side }
                }
            }
        };
        let (mut front, mut back) = (Vec::new(), Vec::new());
        cut(
            corners.len(),
            |i| distances[i],
            |origin| {
                let corner = corner(origin, 1.0);
                if let Origin::Edge(edge) = origin {
                    self.cuts.add(corners[edge.first].side, corner.view);
                }
                front.push(corner);
            },
            |origin| back.push(corner(origin, -1.0)),
        );
        self.budget.split(corners.len(), [front.len(), back.len()]);
        [front, back].map(|corners| Piece { corners, ..*piece })
    }
}

/// A plane in view space. It's stored as a point and not as a distance from the eye, so that differences are taken
/// before products.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplitPlane {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
}

impl SplitPlane {
    /// The plane of a face with these corners; `None` for one without area.
    pub(crate) fn of(corners: &[Corner]) -> Option<Self> {
        let &[a, b, c, ..] = corners else { return None };
        Some(Self { point: a.view, normal: try_unit((b.view - a.view).cross(c.view - a.view))? })
    }

    /// 0 for a point on it.
    pub(crate) fn distance(&self, p: DVec3, tolerance: f64) -> f64 {
        let distance = self.normal.dot(p - self.point);
        if distance.abs() <= tolerance { 0.0 } else { distance }
    }

    /// `true` if the eye is in front of the plane.
    pub(crate) fn faces_eye(&self, projector: &Projector) -> bool {
        if projector.projection.is_perspective() { self.normal.dot(self.point) <= 0.0 } else { self.normal.z >= 0.0 }
    }

    /// A pair: true if any corner is in front, and true if any is behind.
    pub(crate) fn sides(&self, piece: &Piece, tolerance: f64) -> (bool, bool) {
        let (mut most, mut least) = (0.0, 0.0);
        for corner in &piece.corners {
            let distance = self.normal.dot(corner.view - self.point);
            most = if distance > most { distance } else { most };
            least = if distance < least { distance } else { least };
        }
        (most > tolerance, least < -tolerance)
    }

    /// The disadvantage of dividing a set by this plane: pieces that it splits, and sides that are uneven. `None` if it
    /// leaves the whole set on one side, which would go on for ever.
    pub(crate) fn cost(&self, set: &[Piece], tolerance: f64) -> Option<usize> {
        let (mut before, mut behind, mut split) = (0_usize, 0_usize, 0_usize);
        for piece in set {
            let (is_before, is_behind) = self.sides(piece, tolerance);
            before += usize::from(is_before);
            behind += usize::from(is_behind);
            split += usize::from(is_before && is_behind);
        }
        (before < set.len() && behind < set.len()).then(|| 8 * split + before.abs_diff(behind))
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::appearance::Rgba;
    use crate::camera::{Camera, Parameters};

    /// Two layers of triangles that cross one another, some with common sides.
    fn layers() -> Vec<Layer> {
        let mut state = 11_u64;
        let mut number = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 40).unwrap()) / f64::from(1_u32 << 24) - 0.5
        };
        let mut layer = |color| {
            let (mut view, mut triangles) = (Vec::new(), Vec::new());
            for k in 0..1500_u32 {
                let middle = 4.0 * DVec3::new(number(), number(), number()) - 8.0 * DVec3::Z;
                view.extend((0..4).map(|_| middle + 0.3 * DVec3::new(number(), number(), number())));
                triangles.extend([[4 * k, 4 * k + 1, 4 * k + 2], [4 * k + 1, 4 * k, 4 * k + 3]]);
            }
            let positions = view.iter().map(|p| p.as_vec3().to_array()).collect();
            Layer { surface: Surface::solid(positions, triangles, color), view, never_hides_itself: false }
        };
        vec![layer(Rgba::rgb(200, 0, 0)), layer(Rgba::rgb(0, 0, 200).with_alpha(100))]
    }

    fn sorted(max_pieces: usize) -> Result<(Vec<Surface>, usize), TooManyPieces> {
        let projector = Projector::new(&Camera::new(&Parameters::default()).unwrap());
        by_splitting(&layers(), &projector, &|p| (p.0.as_vec3().to_array(), 1.0), max_pieces, &Progress::default())
    }

    #[test]
    fn faces_that_cross_are_split() {
        let (_, pieces) = sorted(usize::MAX).unwrap();
        assert!(pieces > 6000 + 500, "{pieces}");
    }

    #[test]
    fn too_many_pieces_are_counted_by_layer() {
        let over = sorted(6300).unwrap_err();
        assert!(over.pieces > 6300 && over.of_layer.iter().sum::<usize>() == over.pieces);
    }
}
