//! The reading of a matrix of another program. Every candidate is tried, refused by the numbers or ranked by evidence.

use crate::camera::recovery::evidence::{Weight, is_rigid, is_rotation, is_scaled};
use crate::camera::recovery::text::{GivenLens, Word};
use crate::camera::recovery::{
    Axes, MatrixEntries, MatrixKind, NdcRange, Order, Pasted, Reading, Reason, Recovered, Recovery, RecoveryError,
    Stated, Unknown, pinhole, recover, refusal,
};
use crate::camera::{Camera, ImageSize, Parameters, Projection};

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
    let Some(entries) = &pasted.entries else { return lens_alone(pasted, stated, current) };
    if let Some((row, column, value)) = entries.not_finite() {
        return Err(RecoveryError::NotFinite { row, column, value });
    }
    if entries.count() == 16 {
        refusal::check_singular(entries.matrix(stated.by_columns))?;
    }
    let mut refused = Vec::new();
    let mut candidates: Vec<Candidate> = Vec::new();
    for (reading, order) in hypotheses(entries, stated) {
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
        return Err(refusal::cause(entries, stated, refused));
    }
    let mut found = judged(distinct, &elsewhere, stated);
    found.assumed.retain(|assumed| pasted.image.is_none() || !matches!(assumed, Assumed::Image(_)));
    Ok(found)
}

/// All readings to try: kind × axes × NDC, in every order.
fn hypotheses(entries: &MatrixEntries, stated: &Stated) -> Vec<(Reading, Order)> {
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
                (None, LookAt) => vec![Axes::OPENGL],
            };
            for axes in axes.into_iter().filter(|_| takes_order) {
                for ndc in ranges(*kind, stated) {
                    all.push((Reading { kind: *kind, axes, ndc, image: stated.image }, *order));
                }
            }
        }
    }
    all
}

/// The ranges of NDC that a kind may have.
fn ranges(kind: MatrixKind, stated: &Stated) -> Vec<NdcRange> {
    if !kind.has_ndc() {
        return vec![stated.ndc.unwrap_or_default()];
    }
    if let Some(ndc) = stated.ndc {
        return vec![ndc];
    }
    NdcRange::all().collect()
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
        pinhole::check_pixels(matrix)?;
    }
    reading.ndc.infinite |= reading.kind.has_ndc() && found.unknown.contains(&Unknown::Far);
    if let Some(lens) = pasted.lens.filter(|_| reading.kind.has_camera_axes() || reading.kind == MatrixKind::LookAt) {
        with_lens(&mut found, lens, &reading, current);
    }
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
        with_lens(&mut found, lens, &reading, current);
    }
    Camera::new(&found.parameters)?;
    let (reasons, weight) = (vec![Reason::Pixels], Weight::default());
    let only = Candidate { reading, order: Order::Rows, found, reasons, certainty: Certainty::Only, weight };
    Ok(judged(vec![only], &[], stated))
}

/// The lens that a file has beside a pose.
fn with_lens(found: &mut Recovered, lens: GivenLens, reading: &Reading, current: &Parameters) {
    let mut recovery = Recovery {
        current: *current,
        found: found.parameters,
        reading: *reading,
        unknown: std::mem::take(&mut found.unknown),
    };
    recovery.unknown.retain(|unknown| *unknown != Unknown::Lens);
    let sides = [reading.image.width, reading.image.height].map(f64::from);
    match lens {
        GivenLens::Pixels { focal_lengths, principal_point } => recovery.pixels(focal_lengths, principal_point),
        GivenLens::AngleX(angle) => {
            let f = sides[0] / 2.0 / (angle / 2.0).tan();
            recovery.pixels([f, f], sides.map(|side| side / 2.0));
        }
        GivenLens::AngleY { degrees, aspect, near, far } => {
            recovery.distances();
            let p = &mut recovery.found;
            (p.projection, p.window, p.view_angle) = (Projection::Perspective, None, degrees);
            p.aspect = aspect.unwrap_or_else(|| reading.image.aspect());
            p.near = near.unwrap_or(p.near);
            p.far = far.unwrap_or_else(|| p.far.max(2.0 * p.near));
            if far.is_none() {
                recovery.unknown.push(Unknown::Far);
            }
        }
        GivenLens::Parallel { height, aspect, planes } => {
            if planes.is_none() {
                recovery.distances();
            }
            let p = &mut recovery.found;
            (p.projection, p.window, p.height) = (Projection::Parallel, None, height);
            p.aspect = aspect.unwrap_or_else(|| reading.image.aspect());
            [p.near, p.far] = planes.unwrap_or([p.near, p.far]);
        }
    }
    recovery.unknown.sort();
    recovery.unknown.dedup();
    *found = Recovered { parameters: recovery.found, unknown: recovery.unknown };
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
