//! The reason why no reading of a matrix gives a camera.

use glam::{DMat4, DVec3, DVec4};

use crate::camera::recovery::evidence::is_rotation;
use crate::camera::recovery::{Lines, MatrixEntries, MatrixKind, Order, Reading, RecoveryError, SLACK, Stated};

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
