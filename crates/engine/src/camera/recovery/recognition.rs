//! The reading of a matrix of another program. Every candidate is tried, refused by the numbers or ranked by evidence.

use glam::{DMat4, DVec3, DVec4};

use super::evidence::{Weight, is_rigid, is_rotation, is_scaled};
use super::solve::{Recovery, check_pixels};
use super::text::{GivenLens, Side, Size, Word};
use super::{
    Lines, MatrixEntries, MatrixKind, Pasted, Reading, Reason, Recovered, RecoveryError, SLACK, Stated, Unknown,
    recover,
};
use crate::camera::{Axes, Camera, ImageSize, NdcRange, Order, Parameters, Projection};

crate::worded! {
    /// The reason why a matrix is read as it is.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Evidence {
        /// No other reading gives a camera.
        Only = "only",
        /// The camera is level and upright in no other reading.
        Level = "level",
        /// The origin lies in front of the camera in no other reading that is as level.
        OriginAhead = "origin-ahead",
        /// There is none, because others fit as well.
        Nothing = "nothing",
    }
    /// The name in the output of the command line.
    pub fn name
}

crate::worded! {
    /// The certainty of a reading.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Certainty {
        /// Others are about as likely.
        Open = "open",
        /// The evidence is for this one. Others aren't refused.
        Likely = "likely",
        /// The numbers, or words of the text, refuse all others.
        Only = "only",
    }
    /// The name in the output of the command line.
    pub fn name
}

/// A reading that the numbers allow, with its camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The reading.
    pub reading: Reading,
    /// The order of its numbers.
    pub order: Order,
    /// Its camera.
    pub found: Recovered,
    /// The evidence for it and against it.
    pub reasons: Vec<Reason>,
    /// How sure it is.
    pub certainty: Certainty,
    weight: Weight,
}

/// A part of the best reading that was assumed, with the best reading in which it differs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Assumed {
    /// The kind. The index of the other reading.
    Kind(usize),
    /// The axes. The index of the other reading.
    Axes(usize),
    /// The order. The index of the other reading.
    Order(usize),
    /// The NDC. The index of the other reading.
    Ndc(usize),
    /// The size of the image.
    Image(ImageSize),
}

/// A matrix whose readings were recognised.
#[derive(Clone, Debug, PartialEq)]
pub struct Recognised {
    /// All readings that fit and give different cameras, the best first. At least one.
    pub readings: Vec<Candidate>,
    /// The reason why the first is the best.
    pub evidence: Evidence,
    /// Other kinds as which it gives another camera, the likelier first.
    pub others: Vec<MatrixKind>,
    /// Parts of the first reading that neither you nor the text stated, and that the numbers leave open.
    pub assumed: Vec<Assumed>,
}

impl Recognised {
    /// The best reading.
    pub fn best(&self) -> &Candidate {
        // `recognise` refuses an empty list.
        &self.readings[0]
    }
}

/// The points for the reading of a weak word: more than a rival order, less than a level camera has.
const WEAK_WORD: f64 = 6.0;

/// The points against columns if you stated the kind but not the columns, so that only rows that give no camera lose to
/// them.
const UNSTATED_COLUMNS: f64 = 30.0;

/// The points by which a reading is better than the next, so that it is likely: odds of 20 to 1.
const LIKELY: f64 = 3.0;

/// Reads a camera of a text as stated, and recognises the rest.
///
/// Every kind is tried in all axes, ranges of NDC and orders that it may have. The numbers refuse most of them. The
/// evidence ranks the others. See [`Reason`].
///
/// # Errors
/// The error of the likeliest reading, if none gives a camera.
pub fn recognise(pasted: &Pasted, stated: &Stated, current: &Parameters) -> Result<Recognised, RecoveryError> {
    if let Some(error) = &pasted.refused {
        return Err(error.clone());
    }
    let Some(entries) = &pasted.entries else { return lens_alone(pasted, stated, current) };
    // What a format states isn't for the numbers to overrule.
    let format = pasted.word.filter(|word| !word.is_weak && word.axes.is_some() && word.order.is_some());
    let stated = &format.map_or(*stated, |word| Stated {
        kind: stated.kind.or(word.kind),
        axes: stated.axes.or(word.axes),
        by_columns: stated.by_columns || word.order == Some(Order::Columns),
        ..*stated
    });
    if let Some((row, column, value)) = entries.not_finite() {
        return Err(RecoveryError::NotFinite { row, column, value });
    }
    if entries.count() == 16 {
        check_disparity(entries.matrix(false))?;
        check_singular(entries.matrix(stated.by_columns))?;
    }
    let mut refused = Vec::new();
    let mut candidates: Vec<Candidate> = Vec::new();
    let axes = pasted.word.and_then(|word| word.axes);
    for (reading, order) in hypotheses(entries, stated, axes) {
        match candidate((reading, order), entries, (pasted, stated), current) {
            Ok(candidate) => candidates.push(candidate),
            Err(error) => refused.push((reading, order, error)),
        }
    }
    candidates.sort_by(|a, b| b.weight.score.total_cmp(&a.weight.score));
    let (mut readings, elsewhere): (Vec<_>, Vec<_>) =
        candidates.into_iter().partition(|c| stated.kind.is_none_or(|kind| c.reading.kind == kind));
    if let Some(word) = &pasted.word {
        follow(word, stated, entries, &mut readings);
    }
    let mut distinct: Vec<Candidate> = Vec::new();
    for candidate in readings {
        if !distinct.iter().any(|other| is_same(&other.found.parameters, &candidate.found.parameters)) {
            distinct.push(candidate);
        }
    }
    if distinct.is_empty() {
        return Err(cause(entries, stated, refused));
    }
    let elsewhere = if format.is_some() { &[][..] } else { &elsewhere };
    Ok(capped(judged(distinct, elsewhere, stated), pasted))
}

/// A reading isn't certain while an entry that the image could show is left out, nor are three vectors without names.
fn capped(mut found: Recognised, pasted: &Pasted) -> Recognised {
    found.assumed.retain(|assumed| pasted.image.is_none() || !matches!(assumed, Assumed::Image(_)));
    let best = &mut found.readings[0];
    let is_partial = pasted.left_out.iter().any(|left| left.why.changes_image() != Some(false));
    let is_bare = best.reading.kind == MatrixKind::LookAt && pasted.word.is_none();
    // The range of NDC of M_p beside a pose may be another one.
    if is_partial || is_bare || pasted.projection.is_some() {
        best.certainty = best.certainty.min(Certainty::Likely);
    }
    found
}

/// All readings to try: kind × axes × NDC, in every order. `named` are the axes that a word of the text means.
fn hypotheses(entries: &MatrixEntries, stated: &Stated, named: Option<Axes>) -> Vec<(Reading, Order)> {
    use MatrixKind::{CameraToWorld, Intrinsics, LookAt, Pinhole, Projection, View, ViewProjection};
    let mut kinds = match entries.count() {
        7 => vec![CameraToWorld, View],
        9 => vec![Intrinsics, LookAt],
        12 => vec![CameraToWorld, View, Pinhole],
        _ => vec![CameraToWorld, View, Projection, ViewProjection, Pinhole],
    };
    kinds.extend(stated.kind.filter(|kind| !kinds.contains(kind)));
    // A quaternion has no columns.
    let by_columns = stated.by_columns && entries.count() != 7;
    let orders = if by_columns { &[Order::Columns] } else { entries.orders() };
    let mut all = Vec::new();
    for order in orders {
        for kind in &kinds {
            let takes_order = match kind {
                Pinhole | Intrinsics => matches!(order, Order::Rows | Order::Columns),
                LookAt => *order == Order::Rows,
                _ => true,
            };
            let axes: Vec<Axes> = match (stated.axes, kind) {
                (Some(axes), _) => vec![axes],
                (None, View | CameraToWorld) => Axes::ALL.to_vec(),
                (None, Projection) => vec![Axes::OPENGL, Axes::DIRECT3D, Axes::OPENCV],
                (None, ViewProjection) => vec![Axes::OPENGL, Axes::OPENCV, Axes::DIRECT3D],
                (None, Pinhole | Intrinsics) => vec![Axes::OPENCV],
                (None, LookAt) => vec![named.unwrap_or(Axes::OPENGL)],
            };
            for axes in axes.into_iter().filter(|_| takes_order) {
                let ranges = if stated.ndc.is_none() && kind.has_ndc() {
                    NdcRange::all().collect()
                } else {
                    vec![stated.ndc.unwrap_or_default()]
                };
                for ndc in ranges {
                    all.push((Reading { kind: *kind, axes, ndc, image: stated.image }, *order));
                }
            }
        }
    }
    all
}

/// The camera of a reading, if the numbers allow it.
fn candidate(
    (mut reading, order): (Reading, Order),
    entries: &MatrixEntries,
    (pasted, stated): (&Pasted, &Stated),
    current: &Parameters,
) -> Result<Candidate, RecoveryError> {
    let matrix = entries.in_order(order);
    let mut found = recover(&reading, matrix, current)?;
    let is_stated = stated.kind == Some(reading.kind);
    if reading.kind == MatrixKind::LookAt && !is_stated && is_rotation(matrix) {
        return Err(RecoveryError::RotationAlone);
    }
    if found.unknown.contains(&Unknown::LeftHandedView) && stated.axes.is_none() {
        return Err(RecoveryError::Hand { left: !reading.axes.left_handed, title: reading.axes.title });
    }
    if reading.axes == Axes::VRC {
        found.unknown.push(Unknown::LeftHandedView);
    }
    if found.unknown.contains(&Unknown::Scaled) && !is_stated && !is_scaled(matrix) {
        return Err(RecoveryError::Length { row: 1, length: matrix.row(0).truncate().length() });
    }
    let must_be_pixels = entries.count() == 16 || order == Order::Columns || is_rigid(matrix);
    if reading.kind == MatrixKind::Pinhole && !is_stated && must_be_pixels {
        check_pixels(matrix)?;
    }
    reading.ndc.infinite |= reading.kind.has_ndc() && found.unknown.contains(&Unknown::Far);
    if let Some(lens) = pasted.lens.filter(|_| reading.kind.has_camera_axes() || reading.kind == MatrixKind::LookAt) {
        with_lens(&mut found, (lens, pasted.image.is_some()), &reading, current)?;
    }
    if let Some(projection) = &pasted.projection {
        let stated = Stated { kind: Some(MatrixKind::Projection), axes: None, ..*stated };
        let lens = recognise(projection, &stated, current)?.best().found.clone();
        let Parameters { position, focal_point, view_up, .. } = found.parameters;
        found.parameters = Parameters { position, focal_point, view_up, ..lens.parameters };
        let of_lens = |unknown: &Unknown| matches!(unknown, Unknown::Lens | Unknown::Window | Unknown::ClippingPlanes);
        found.unknown.retain(|unknown| !of_lens(unknown));
        found.unknown.extend(lens.unknown.into_iter().filter(|unknown| *unknown != Unknown::Pose));
    }
    found.unknown.extend(pasted.is_scaled.then_some(Unknown::Scaled));
    found.unknown.extend(pasted.is_origin.then_some(Unknown::RigOrigin));
    if pasted.image.is_some() {
        found.unknown.retain(|unknown| *unknown != Unknown::ImageSize);
    }
    let camera = Camera::new(&found.parameters)?;
    let mut weight = Weight::new((&reading, order), (matrix, entries), &found, &camera);
    if is_stated && !stated.by_columns && order == Order::Columns {
        // If you state the kind, you'd state the columns too.
        weight.score -= UNSTATED_COLUMNS;
    }
    let reasons = weight.reasons.clone();
    Ok(Candidate { reading, order, found, reasons, certainty: Certainty::Open, weight })
}

/// Keeps the readings that a word of the text means, if there are some. What you state yourself goes first. A weak word
/// only adds to their evidence.
fn follow(word: &Word, stated: &Stated, entries: &MatrixEntries, readings: &mut Vec<Candidate>) {
    let is_twelve = entries.count() == 12;
    let kind = word.kind.filter(|_| stated.kind.is_none()).map(|kind| match kind {
        // The 3 × 4 matrix of OpenCV and ROS has the name of a projection.
        MatrixKind::Projection | MatrixKind::Intrinsics if is_twelve => MatrixKind::Pinhole,
        kind => kind,
    });
    let keep = |readings: &mut Vec<Candidate>, is_meant: &dyn Fn(&Candidate) -> bool| {
        let any = readings.iter().any(is_meant);
        if any {
            readings.retain(is_meant);
        }
        any
    };
    if word.is_weak {
        for candidate in readings.iter_mut().filter(|c| word.means(&c.reading, c.order)) {
            candidate.weight.score += WEAK_WORD;
            candidate.reasons.insert(0, Reason::Word(word.word));
        }
        readings.sort_by(|a, b| b.weight.score.total_cmp(&a.weight.score));
        return;
    }
    if let Some(kind) = kind
        && !keep(readings, &|c: &Candidate| c.reading.kind == kind)
    {
        return;
    }
    if let Some(axes) = word.axes.filter(|_| stated.axes.is_none()) {
        keep(readings, &|c: &Candidate| c.reading.axes == axes);
    }
    if let Some(order) = word.order.filter(|_| !stated.by_columns) {
        keep(readings, &|c: &Candidate| c.order == order);
    }
    for candidate in readings {
        candidate.reasons.insert(0, Reason::Word(word.word));
    }
}

/// The readings with their certainty, the other kinds and the assumptions.
fn judged(mut readings: Vec<Candidate>, elsewhere: &[Candidate], stated: &Stated) -> Recognised {
    // Shares of the sides and pixels of a tiny image are the same numbers.
    let is_odd =
        |unknown: &Unknown| matches!(unknown, Unknown::PrincipalPoint | Unknown::WideAngle | Unknown::NormalisedPixels);
    let gap = readings.get(1).map(|second| readings[0].weight.score - second.weight.score);
    readings[0].certainty = match gap {
        None if readings[0].found.unknown.iter().any(is_odd) => Certainty::Likely,
        None => Certainty::Only,
        Some(gap) if gap >= LIKELY => Certainty::Likely,
        Some(_) => Certainty::Open,
    };
    let best = &readings[0];
    let rank = |c: &Candidate| (c.weight.is_level, c.weight.is_ahead);
    let evidence = if readings.len() == 1 {
        Evidence::Only
    } else if best.weight.is_level && readings[1..].iter().all(|c| !c.weight.is_level) {
        Evidence::Level
    } else if readings[1..].iter().all(|c| rank(c) < rank(best)) {
        Evidence::OriginAhead
    } else {
        Evidence::Nothing
    };
    let mut others = Vec::new();
    for candidate in readings[1..].iter().chain(elsewhere) {
        let kind = candidate.reading.kind;
        let differs = !is_same(&candidate.found.parameters, &best.found.parameters);
        if kind != best.reading.kind && differs && !others.contains(&kind) {
            others.push(kind);
        }
    }
    let assumed = assumptions(&readings, stated);
    Recognised { readings, evidence, others, assumed }
}

/// The parts of the best reading that another reading changes.
fn assumptions(readings: &[Candidate], stated: &Stated) -> Vec<Assumed> {
    let best = &readings[0];
    let other = |differs: &dyn Fn(&Candidate) -> bool| readings.iter().position(differs);
    let same_kind = |c: &Candidate| c.reading.kind == best.reading.kind;
    let mut assumed = Vec::new();
    assumed.extend(other(&|c| !same_kind(c)).map(Assumed::Kind));
    if best.reading.kind.has_pose() {
        assumed.extend(other(&|c| same_kind(c) && c.reading.axes != best.reading.axes).map(Assumed::Axes));
    }
    assumed.extend(other(&|c| same_kind(c) && c.order != best.order).map(Assumed::Order));
    if best.reading.kind.has_ndc() && stated.ndc.is_none() {
        let same = |c: &Candidate| same_kind(c) && c.order == best.order && c.reading.axes == best.reading.axes;
        assumed.extend(other(&|c| same(c) && c.reading.ndc != best.reading.ndc).map(Assumed::Ndc));
    }
    if best.reading.kind.has_pixels() {
        assumed.push(Assumed::Image(stated.image));
    }
    assumed
}

/// The camera of a file that has no pose.
fn lens_alone(pasted: &Pasted, stated: &Stated, current: &Parameters) -> Result<Recognised, RecoveryError> {
    let reading =
        Reading { kind: MatrixKind::Intrinsics, axes: Axes::OPENCV, ndc: NdcRange::default(), image: stated.image };
    let mut found = Recovered { parameters: *current, unknown: vec![Unknown::Pose] };
    if let Some(lens) = pasted.lens {
        with_lens(&mut found, (lens, pasted.image.is_some()), &reading, current)?;
    }
    if pasted.image.is_some() {
        found.unknown.retain(|unknown| *unknown != Unknown::ImageSize);
    }
    Camera::new(&found.parameters)?;
    let (reasons, weight) = (vec![Reason::Pixels], Weight::default());
    let only = Candidate { reading, order: Order::Rows, found, reasons, certainty: Certainty::Only, weight };
    Ok(capped(judged(vec![only], &[], stated), pasted))
}

/// The lens that a file has beside a pose, or alone. `has_image`: the file has the size of its image.
fn with_lens(
    found: &mut Recovered,
    (lens, has_image): (GivenLens, bool),
    reading: &Reading,
    current: &Parameters,
) -> Result<(), RecoveryError> {
    let mut recovery = Recovery {
        current: *current,
        found: found.parameters,
        reading: *reading,
        unknown: std::mem::take(&mut found.unknown),
    };
    recovery.unknown.retain(|unknown| *unknown != Unknown::Lens);
    if !lens.is_parallel || lens.near.is_none() {
        recovery.distances();
    }
    let p = &mut recovery.found;
    p.near = lens.near.unwrap_or(p.near);
    p.far = lens.far.unwrap_or_else(|| p.far.max(2.0 * p.near));
    let near = p.near;
    let zoom = if lens.zoom > 0.0 { lens.zoom } else { 1.0 };
    let [m, n] = [reading.image.width, reading.image.height].map(f64::from);
    let own = current.window.map_or(current.aspect, |w| (w.right - w.left) / (w.top - w.bottom));
    let aspect = lens.aspect.unwrap_or(if has_image { reading.image.aspect() } else { own });
    if lens.size != Size::Open || lens.is_parallel {
        p.projection = if lens.is_parallel { Projection::Parallel } else { Projection::Perspective };
    }
    let size = match lens.size {
        Size::Open => {
            p.aspect = lens.aspect.unwrap_or(p.aspect);
            recovery.unknown.push(Unknown::Window);
            None
        }
        Size::Pixels { focal_lengths, principal_point, skew } => {
            recovery.skew(skew, focal_lengths[0])?;
            let point = principal_point.unwrap_or([m / 2.0, n / 2.0]);
            let f = focal_lengths.map(|f| f * zoom);
            if lens.is_parallel {
                let [width, height] = [m / f[0], n / f[1]];
                recovery.window([width, height], [(0.5 - point[0] / m) * width, (point[1] / n - 0.5) * height]);
            } else {
                recovery.pixels(f, point);
            }
            None
        }
        Size::Length(side, length) => {
            let length = if lens.is_slope && !lens.is_parallel { length * near } else { length };
            let height = match side {
                Side::Up => length,
                Side::Across => length / aspect,
                Side::Smaller => length / aspect.min(1.0),
                Side::Larger => length / aspect.max(1.0),
            };
            let sides = [aspect * height / zoom, height / zoom];
            let of = if lens.shift_of_height { [sides[1]; 2] } else { sides };
            Some((sides, [lens.shift[0] * of[0], lens.shift[1] * of[1]]))
        }
        Size::Sides([left, right, bottom, top]) => {
            Some(([(right - left) / zoom, (top - bottom) / zoom], [(left + right) / 2.0, (bottom + top) / 2.0]))
        }
    };
    if let Some(([width, height], mut middle)) = size {
        let [x, y, across, down] = lens.crop.unwrap_or([0.0, 0.0, 1.0, 1.0]);
        middle[0] += (x + across / 2.0 - 0.5) * width;
        middle[1] += (0.5 - y - down / 2.0) * height;
        recovery.window([across * width, down * height], middle);
        // The numbers themselves, without the rounding of products.
        let p = &mut recovery.found;
        if p.window.is_none() && lens.crop.is_none() {
            p.aspect = if matches!(lens.size, Size::Sides(_)) { p.aspect } else { aspect };
            p.view_angle = lens.degrees.filter(|_| zoom == 1.0).unwrap_or(p.view_angle);
        }
    }
    recovery.unknown.retain(|unknown| *unknown != Unknown::ClippingPlanes);
    recovery.unknown.extend(match (lens.near, lens.far) {
        (None, None) => Some(Unknown::ClippingPlanes),
        (Some(_), None) => Some(Unknown::Far),
        _ => None,
    });
    recovery.unknown.sort();
    recovery.unknown.dedup();
    *found = Recovered { parameters: recovery.found, unknown: recovery.unknown };
    Ok(())
}

/// True if two cameras are the same but for rounding.
fn is_same(a: &Parameters, b: &Parameters) -> bool {
    let numbers = |p: &Parameters| {
        let window = p.window.map_or([0.0; 4], |w| [w.left, w.right, w.bottom, w.top]);
        let lens = [p.view_angle, p.height, p.aspect, p.near, p.far];
        let pose = [p.position, p.focal_point, p.view_up].map(|v| v.to_array());
        (pose.concat(), [&window[..], &lens[..]].concat())
    };
    let ((pose_a, lens_a), (pose_b, lens_b)) = (numbers(a), numbers(b));
    let size = pose_a.iter().chain(&pose_b).fold(0.0_f64, |size, x| size.max(x.abs()));
    a.projection == b.projection
        && pose_a.iter().zip(&pose_b).all(|(a, b)| (a - b).abs() <= 1e-9 * size)
        && lens_a.iter().zip(&lens_b).all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs().max(b.abs()))
}

/// A reading that the numbers refused.
pub(crate) type Refused = (Reading, Order, RecoveryError);

/// Refuses Q of `stereoRectify`, which leads from a pixel and its disparity to a point: no camera.
///
/// # Errors
/// [`RecoveryError::Disparity`].
pub(crate) fn check_disparity(m: DMat4) -> Result<(), RecoveryError> {
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| m.row(i).to_array());
    let is_row = |row: [f64; 4], places: &[usize]| {
        (0..4).all(|i| places.contains(&i) == (row[i] != 0.0) || places.len() == 2 && i == 3)
    };
    let is_q = is_row(a, &[0, 3]) && is_row(b, &[1, 3]) && is_row(c, &[3]) && is_row(d, &[2, 3]);
    if is_q && a[3].abs() > 2.0 * a[0].abs() { Err(RecoveryError::Disparity) } else { Ok(()) }
}

/// Refuses a matrix that has no inverse, and names the line that is zero.
///
/// # Errors
/// [`RecoveryError::ViewUpAlongView`], [`RecoveryError::Singular`] or [`RecoveryError::Determinant`].
pub(crate) fn check_singular(m: DMat4) -> Result<(), RecoveryError> {
    let rows = [0, 1, 2, 3].map(|i| m.row(i));
    let columns = [0, 1, 2, 3].map(|i| m.col(i));
    let size = m.to_cols_array().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    // The translation stays if u and v have no length, so the first three entries count.
    for (lines, all) in [(Lines::Rows, rows), (Lines::Columns, columns)] {
        let is_zero = |line: &DVec4| line.truncate().length() <= 1e-12 * size;
        let zeros: Vec<usize> = (0..3).filter(|i| is_zero(&all[*i])).map(|i| i + 1).collect();
        let is_view = all[3] == DVec4::W || lines == Lines::Columns && all[3].w == 1.0;
        if let ([a, b], true) = (zeros.as_slice(), is_view && all[3].truncate() == DVec3::ZERO) {
            return Err(RecoveryError::ViewUpAlongView { lines, a: *a, b: *b });
        }
        if let Some(at) = all.iter().position(|line| line.length() <= 1e-12 * size) {
            return Err(RecoveryError::Singular { lines, at: at + 1 });
        }
    }
    // Hadamard: the determinant is at most the product of the lengths, and this share of it for an axis of 1e-14.
    let most: f64 = rows.iter().map(|row| row.length()).product();
    if m.determinant().abs() <= 1e-14 * most {
        return Err(RecoveryError::Determinant);
    }
    Ok(())
}

/// The error of the reading that the numbers come nearest to.
pub(crate) fn cause(entries: &MatrixEntries, stated: &Stated, refused: Vec<Refused>) -> RecoveryError {
    let of = |kind: MatrixKind, order: Order| move |r: &&Refused| r.0.kind == kind && r.1 == order;
    let first = |kind: MatrixKind, order: Order| {
        let errors = || refused.iter().filter(of(kind, order)).map(|r| &r.2);
        // A wrong hand or a mirror is the error of a row, not of the matrix, if other rows have another one.
        let is_of_row = |e: &&RecoveryError| matches!(e, RecoveryError::Hand { .. } | RecoveryError::Mirrored);
        errors().find(|e| !is_of_row(e)).or_else(|| errors().next()).cloned()
    };
    let order = if stated.by_columns { Order::Columns } else { Order::Rows };
    let (kind, order) = match (stated.kind, entries.count()) {
        (Some(kind), _) => (kind, entries.orders().first().copied().filter(|_| !stated.by_columns).unwrap_or(order)),
        (None, 7) => return RecoveryError::Quaternion,
        (None, 9) if is_rotation(entries.matrix(false)) => return RecoveryError::RotationAlone,
        (None, 9) => (MatrixKind::Intrinsics, order),
        (None, 12) if entries.orders()[0] == Order::RotationThenTranslation => (MatrixKind::View, entries.orders()[0]),
        (None, 12) => (MatrixKind::Pinhole, order),
        (None, _) => nearest(entries, stated),
    };
    // Each reading that was tried left its error.
    first(kind, order).or_else(|| refused.first().map(|r| r.2.clone())).unwrap_or(RecoveryError::Mirrored)
}

/// Sixteen numbers: a view ends in 0 0 0 1, a projection has its zeros.
fn nearest(entries: &MatrixEntries, stated: &Stated) -> (MatrixKind, Order) {
    let orders: &[Order] = if stated.by_columns { &[Order::Columns] } else { &[Order::Rows, Order::Columns] };
    let violations = |m: DMat4| {
        let size = m.to_cols_array().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let zeros = [(0, 1), (0, 3), (1, 0), (1, 3), (2, 0), (2, 1), (3, 0), (3, 1), (3, 3)];
        zeros.into_iter().filter(|(row, column)| m.row(*row)[*column].abs() > SLACK * size).count()
    };
    for order in orders {
        let last = entries.in_order(*order).row(3);
        if last.truncate().length() <= SLACK * last.w.abs() {
            return (MatrixKind::View, *order);
        }
    }
    let nearest = orders.iter().min_by_key(|order| violations(entries.in_order(**order))).copied();
    let order = nearest.unwrap_or(Order::Rows);
    let is_projection = violations(entries.in_order(order)) <= 2;
    (if is_projection { MatrixKind::Projection } else { MatrixKind::ViewProjection }, order)
}
