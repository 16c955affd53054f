//! The order of faces by a tree of planes: faces that cross a plane are split (Fuchs, Kedem and Naylor 1980).
//!
//! Large sets are divided until their parts are worth a thread; each part has its corners to itself, and is then put in
//! order in one array of pieces. Which set is divided by which plane does not depend on the threads, and what they find
//! is joined in the order of painting: the result is the same with any number of them.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::cut::{Origin, cut};
use super::pieces::{Corner, Corners, Cut, Cuts, Layer, NewSides, Piece, pieces};
use super::projector::Projector;
use super::split_plane::{self, SplitPlane};
use super::transform::Screen;
use super::visibility::Painter;
use crate::drawing::Surface;
use crate::limits::MAX_PIECE_BYTES;
use crate::progress::{Activity, Progress};

/// An exceeded budget of splitting: pieces of the faces of these layers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct TooManyPieces {
    /// Number of pieces made.
    pub(super) pieces: usize,
    /// Number of pieces of each layer.
    pub(super) of_layer: Vec<usize>,
}

/// Number of corners for which memory is kept: some 30 MiB with all that belongs to them.
const MOST_KEPT: usize = 1 << 19;
/// Parts of a set with fewer pieces are not worth a thread of their own.
const WORTH: usize = 1024;
/// So many times a set is divided for threads.
const DEEPEST: usize = 12;

/// Memory that serves one picture after the other.
#[derive(Debug, Default)]
pub(super) struct BspMemory(Branch);

/// Sorts in an order that is right for each two faces, and gives the number of pieces.
///
/// # Errors
/// [`TooManyPieces`] where there would be more than `max_pieces`, or they would take more than [`MAX_PIECE_BYTES`].
pub(super) fn by_splitting(
    layers: &[Layer],
    projector: &Projector,
    screen: &Screen,
    max_pieces: usize,
    progress: &Progress,
    memory: &mut BspMemory,
) -> Result<(Vec<Surface>, usize), TooManyPieces> {
    from_depth(layers, (projector, screen), max_pieces, progress, 0, memory)
}

/// The same, where so many divisions for threads are taken as done.
fn from_depth(
    layers: &[Layer],
    (projector, screen): (&Projector, &Screen),
    max_pieces: usize,
    progress: &Progress,
    depth: usize,
    BspMemory(memory): &mut BspMemory,
) -> Result<(Vec<Surface>, usize), TooManyPieces> {
    let of_layer: Vec<usize> = layers.iter().map(|layer| layer.surface.triangles.len()).collect();
    let budget = Budget::of(of_layer.iter().sum(), max_pieces);
    if budget.is_exceeded() {
        return Err(TooManyPieces { pieces: of_layer.iter().sum(), of_layer });
    }
    progress.begin(Activity::Ordering, 0);
    let Branch { corners, pieces: set, mut ordered, mut cuts, mut planes, scratch } = std::mem::take(memory);
    let (set, corners, known) = pieces(layers, (set, corners));
    ordered.clear();
    cuts.clear();
    planes.clear();
    let whole = Branch { corners, pieces: set, ordered, cuts, planes, scratch };
    let tolerance = tolerance(&whole.corners.views);
    let tree = Tree { layers, projector, tolerance, progress, budget, sides: NewSides::after(known) };
    let mut ordered = tree.ordered(whole, depth);
    if tree.budget.is_exceeded() {
        return Err(too_many(layers, tree, max_pieces));
    }
    let logs: Vec<&[Cut]> = ordered.iter().map(|branch| branch.cuts.as_slice()).collect();
    let cuts = Cuts::new(tree.sides.count(), &logs);
    let count = ordered.iter().map(|branch| branch.ordered.len()).sum();
    let mut painter = Painter::new(layers, projector, screen, count);
    let parts: Vec<Part> = ordered.iter().flat_map(Branch::parts).collect();
    // As many at a time as there is memory for.
    for some in parts.chunks(PARTS) {
        let borders: Vec<_> = some.par_iter().map(|part| part.borders(&cuts)).collect();
        for (part, (all, ends)) in some.iter().zip(borders) {
            let mut first = 0;
            for (piece, end) in part.pieces.iter().zip(ends) {
                painter.paint(piece, &all[first..end]);
                first = end;
            }
        }
    }
    let surfaces = painter.surfaces;
    // The last branch has the memory of the first; a great deal of it is not kept.
    *memory = ordered.pop().filter(|last| last.corners.views.len() < MOST_KEPT).unwrap_or_default();
    Ok((surfaces, count))
}

/// Some pieces of a branch, in the order of painting.
#[derive(Clone, Copy)]
struct Part<'a> {
    corners: &'a Corners,
    pieces: &'a [Piece],
}

impl Part<'_> {
    /// All corners of its pieces, and where those of each end.
    fn borders(&self, cuts: &Cuts) -> (Vec<(DVec3, Corner)>, Vec<usize>) {
        let (mut all, mut ends) = (Vec::with_capacity(4 * self.pieces.len()), Vec::with_capacity(self.pieces.len()));
        for piece in self.pieces {
            cuts.complete(self.corners.whole(piece), &mut all);
            ends.push(all.len());
        }
        (all, ends)
    }
}

/// Number of pieces of a part, at most.
const PART: usize = 1024;
/// Number of parts that are completed together.
const PARTS: usize = 16;

/// The same again up to the piece that is too much, by one thread: how many of each there were then.
fn too_many(layers: &[Layer], tree: Tree, max_pieces: usize) -> TooManyPieces {
    let (set, corners, known) = pieces(layers, Default::default());
    let tree = Tree { budget: Budget::of(set.len(), max_pieces), sides: NewSides::after(known), ..tree };
    let Branch { pieces, ordered, .. } = tree.in_one_array(Branch { corners, pieces: set, ..Branch::default() });
    let mut of_layer = vec![0; layers.len()];
    pieces.iter().chain(&ordered).for_each(|piece| of_layer[piece.layer()] += 1);
    TooManyPieces { pieces: of_layer.iter().sum(), of_layer }
}

/// The distance from a plane within which a point is on it: a share of the extent of all faces, and the rounding of
/// their coordinates. Where the scene is small and far away, the second is much less than a share of the distance.
fn tolerance(corners: &[DVec3]) -> f64 {
    const OF_EXTENT: f64 = 1e-10;
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = corners.iter().fold(none, |(low, high), &c| (low.min(c), high.max(c)));
    let farthest = corners.iter().fold(0.0, |most: f64, c| most.max(c.abs().max_element()));
    let extent = if corners.is_empty() { 0.0 } else { (high - low).max_element() };
    let tolerance = extent * OF_EXTENT + 4.0 * farthest * f64::EPSILON;
    if tolerance.is_nan() { 0.0 } else { tolerance }
}

/// The work of splitting so far, and how much is allowed.
struct Budget {
    pieces: AtomicUsize,
    bytes: AtomicUsize,
    max_pieces: usize,
}

impl Budget {
    /// Before anything is split.
    fn of(pieces: usize, max_pieces: usize) -> Self {
        Self { pieces: pieces.into(), bytes: (pieces * bytes(3)).into(), max_pieces }
    }

    /// Records that a piece with `whole` corners has become two.
    fn split(&self, whole: usize, [front, back]: [usize; 2]) {
        self.pieces.fetch_add(1, Ordering::Relaxed);
        self.bytes.fetch_add(bytes(front) + bytes(back) - bytes(whole), Ordering::Relaxed);
    }

    /// It only grows: whether it is exceeded in the end does not depend on the threads.
    fn is_exceeded(&self) -> bool {
        self.pieces.load(Ordering::Relaxed) > self.max_pieces || self.bytes.load(Ordering::Relaxed) > MAX_PIECE_BYTES
    }
}

/// Memory of a piece with this number of corners, at most: its corners are there twice while it is split.
fn bytes(corners: usize) -> usize {
    40 + corners * 64
}

/// All that branches have in common.
struct Tree<'a> {
    layers: &'a [Layer],
    projector: &'a Projector,
    tolerance: f64,
    progress: &'a Progress,
    budget: Budget,
    sides: NewSides,
}

/// Some pieces, with their corners; and the work on them.
#[derive(Debug, Default)]
struct Branch {
    corners: Corners,
    /// To be put in order.
    pieces: Vec<Piece>,
    /// In the order of painting.
    ordered: Vec<Piece>,
    /// Where sides were cut, in the order in which it was done.
    cuts: Vec<Cut>,
    planes: Vec<Option<SplitPlane>>,
    scratch: Scratch,
}

/// Memory that serves one set after the other.
#[derive(Debug, Default)]
struct Scratch {
    on: Vec<Piece>,
    far: Vec<Piece>,
    candidates: Vec<SplitPlane>,
    along: Vec<f64>,
    distances: Vec<f64>,
    parts: [Vec<(DVec3, Corner)>; 2],
}

/// A treatment of the pieces from a place on.
enum Task {
    Order(usize),
    Paint(usize),
}

impl Tree<'_> {
    /// The pieces of a branch in the order of painting: by branches, one after the other.
    fn ordered(&self, mut branch: Branch, depth: usize) -> Vec<Branch> {
        let is_small = branch.pieces.len() < 2 * WORTH || depth == DEEPEST;
        let plane = if is_small { None } else { self.plane(&mut branch, 0) };
        let Some(plane) = plane else { return vec![self.in_one_array(branch)] };
        let [near, on] = branch.divide(self, &plane, 0);
        if self.is_stopped() || near < WORTH || branch.pieces.len() - near - on < WORTH {
            return vec![self.finished(branch, vec![Task::Order(0), Task::Paint(near), Task::Order(near + on)])];
        }
        let mut far = branch.apart(near + on);
        let mut on = branch.apart(near);
        on.ordered = std::mem::take(&mut on.pieces);
        on.ordered.reverse();
        // The cuts that were made first come first.
        std::mem::swap(&mut branch.cuts, &mut far.cuts);
        let (mut all, near) = rayon::join(|| self.ordered(far, depth + 1), || self.ordered(branch, depth + 1));
        all.push(on);
        all.extend(near);
        all
    }

    /// The same as one branch.
    fn in_one_array(&self, branch: Branch) -> Branch {
        self.finished(branch, vec![Task::Order(0)])
    }

    /// Does what is left to do. A tree that is one long branch must not exhaust the stack: `tasks` wait, the next at
    /// the end, and each is about the pieces from its place to the end.
    fn finished(&self, mut branch: Branch, mut tasks: Vec<Task>) -> Branch {
        while let Some(task) = tasks.pop().filter(|_| !self.is_stopped()) {
            let first = match task {
                Task::Paint(first) => {
                    branch.paint(first);
                    continue;
                }
                Task::Order(first) => first,
            };
            let Some(plane) = self.plane(&mut branch, first) else {
                branch.paint(first);
                continue;
            };
            let [near, on] = branch.divide(self, &plane, first);
            tasks.extend([Task::Order(first), Task::Paint(first + near), Task::Order(first + near + on)]);
        }
        branch
    }

    fn is_stopped(&self) -> bool {
        self.budget.is_exceeded() || self.progress.is_cancelled()
    }

    /// The plane that divides the pieces from a place on, if they are to be divided: of some planes of faces, and in
    /// large sets of some upright planes through the middle too, the best.
    fn plane(&self, branch: &mut Branch, first: usize) -> Option<SplitPlane> {
        const TRIED: usize = 6;
        const LARGE: usize = 128;
        let Branch { corners, pieces, planes, scratch: Scratch { candidates, along, .. }, .. } = branch;
        let set = &mut pieces[first..];
        let &[of, _, ..] = &*set else { return None };
        if self.layers[of.layer()].never_hides_itself && set.iter().all(|piece| piece.layer == of.layer) {
            return None;
        }
        let mut plane_of = |piece: &mut Piece| {
            if piece.plane == u32::MAX {
                piece.plane = super::pieces::to_u32(planes.len());
                planes.push(SplitPlane::of(corners.of(piece)));
            }
            planes[piece.plane as usize]
        };
        let step = set.len().div_ceil(TRIED);
        candidates.clear();
        candidates.extend(set.iter_mut().step_by(step).filter_map(&mut plane_of));
        if candidates.is_empty() {
            candidates.extend(set.iter_mut().find_map(&mut plane_of));
        }
        if set.len() > LARGE && !candidates.is_empty() {
            for axis in DVec3::AXES {
                along.clear();
                along.extend(set.iter().map(|piece| axis.dot(corners.views[piece.first])));
                let middle = along.len() / 2;
                let (_, median, _) = along.select_nth_unstable_by(middle, f64::total_cmp);
                candidates.push(SplitPlane { point: axis * *median, normal: axis });
            }
        }
        split_plane::best(candidates, set, corners, self.tolerance)
    }
}

impl Branch {
    fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        self.ordered.chunks(PART).map(|pieces| Part { corners: &self.corners, pieces })
    }

    /// Of faces in one plane the first listed is painted last: it stays, as in a depth buffer.
    fn paint(&mut self, first: usize) {
        self.ordered.extend(self.pieces.drain(first..).rev());
    }

    /// The pieces from a place on as a branch of their own.
    fn apart(&mut self, first: usize) -> Self {
        let mut pieces = self.pieces.split_off(first);
        Self { corners: self.corners.extracted(&mut pieces), pieces, ..Self::default() }
    }

    /// Divides the pieces from a place on: those nearer to the eye come first, then those in the plane, then those
    /// behind it, each in the order they had. Returns the number of the first and of the second.
    fn divide(&mut self, tree: &Tree, plane: &SplitPlane, first: usize) -> [usize; 2] {
        let front_is_near = plane.faces_eye(tree.projector);
        let (mut near, mut far, end) = (first, 0, self.pieces.len());
        self.scratch.on.clear();
        let mut behind = std::mem::take(&mut self.scratch.far);
        if let Some(of) = self.pieces.get(first) {
            behind.resize(behind.len().max(end - first), *of);
        }
        for k in first..end {
            let piece = self.pieces[k];
            let (mut nearer, mut farther) = (piece, piece);
            let sides = plane.sides(self.corners.of(&piece), tree.tolerance);
            match sides {
                (false, false) => self.scratch.on.push(piece),
                (true, true) => {
                    let [front, back] = self.split(tree, plane, &piece);
                    (nearer, farther) = if front_is_near { (front, back) } else { (back, front) };
                }
                _ => {}
            }
            // Written to both places, and counted where it belongs: which one is next is anybody's guess.
            let (is_near, is_far) = if front_is_near { sides } else { (sides.1, sides.0) };
            self.pieces[near] = nearer;
            behind[far] = farther;
            near += usize::from(is_near);
            far += usize::from(is_far);
        }
        self.pieces.truncate(near);
        self.pieces.extend_from_slice(&self.scratch.on);
        self.pieces.extend_from_slice(&behind[..far]);
        self.scratch.far = behind;
        [near - first, self.scratch.on.len()]
    }

    /// The two pieces, in front and behind, of one that crosses the plane.
    fn split(&mut self, tree: &Tree, plane: &SplitPlane, piece: &Piece) -> [Piece; 2] {
        let Scratch { distances, parts: [front, back], .. } = &mut self.scratch;
        let new_side = tree.sides.next();
        let (views, rest) = self.corners.whole(piece);
        let count = views.len();
        distances.clear();
        distances.extend(views.iter().map(|&view| plane.distance(view, tree.tolerance)));
        front.clear();
        back.clear();
        // `side`: 1 on the front, −1 on the back. Where the border leaves it, the piece goes on along the plane.
        let corner = |origin: Origin, side: f64| {
            let next_is_beyond = |first: usize| side * distances[(first + 1) % count] < 0.0;
            match origin {
                Origin::Corner(i) => {
                    let leaves = distances[i] == 0.0 && next_is_beyond(i);
                    (views[i], Corner { side: if leaves { new_side } else { rest[i].side }, ..rest[i] })
                }
                Origin::Edge(edge) => {
                    let (inside, outside) = (&rest[edge.inside], &rest[edge.outside]);
                    let view = views[edge.inside] * edge.shares[0] + views[edge.outside] * edge.shares[1];
                    let weights = std::array::from_fn(|k| edge.mean(inside.weights[k], outside.weights[k]));
                    let side = if next_is_beyond(edge.first) { new_side } else { rest[edge.first].side };
                    (view, Corner { weights, original: false, side })
                }
            }
        };
        cut(
            count,
            |i| distances[i],
            |origin| {
                let corner = corner(origin, 1.0);
                if let Origin::Edge(edge) = origin {
                    self.cuts.push((rest[edge.first].side, corner.0));
                }
                front.push(corner);
            },
            |origin| back.push(corner(origin, -1.0)),
        );
        tree.budget.split(count, [front.len(), back.len()]);
        [self.corners.add(piece, front), self.corners.add(piece, back)]
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::appearance::Rgba;
    use crate::camera::{Camera, Parameters};
    use crate::pipeline::Target;

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

    fn sorted(max_pieces: usize, depth: usize, threads: usize) -> Result<(Vec<Surface>, usize), TooManyPieces> {
        let projector = Projector::new(&Camera::new(&Parameters::default()).unwrap());
        let target = Target { width: 300, height: 200, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
        let (screen, progress) = (Screen::new(target), Progress::default());
        let threads = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        threads.install(|| {
            from_depth(&layers(), (&projector, &screen), max_pieces, &progress, depth, &mut BspMemory::default())
        })
    }

    #[test]
    fn neither_threads_nor_the_parts_for_them_change_the_order() {
        let one = sorted(usize::MAX, DEEPEST, 1).unwrap();
        assert!(one.1 > 6000 + 500, "{}", one.1);
        for (depth, threads) in [(0, 1), (0, 3), (DEEPEST - 1, 2)] {
            assert!(sorted(usize::MAX, depth, threads).unwrap() == one, "{depth} {threads}");
        }
    }

    #[test]
    fn what_is_too_much_is_counted_up_to_the_same_piece() {
        let one = sorted(6300, DEEPEST, 1).unwrap_err();
        assert!(one.pieces > 6300 && one.of_layer.iter().sum::<usize>() == one.pieces);
        for threads in [1, 3] {
            assert_eq!(sorted(6300, 0, threads).unwrap_err(), one);
        }
    }
}
