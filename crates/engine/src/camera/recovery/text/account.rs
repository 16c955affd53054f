//! The camera of some entries. Each entry ends in a list: used, or left out with a reason.

use super::camera::{Entry, Said, Sign, matrix_of, word};
use super::names::{Field as F, plain};
use super::{GivenLens, LeftOut, Pasted, Size, Used, Why, image_size};
use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::{Axes, MatrixKind, MatrixTextError, Order};

/// True for the model of a lens that is no pinhole.
fn is_no_pinhole(model: &str) -> bool {
    let parts =
        ["fish", "equidist", "omni", "spheric", "equirect", "panoram", "cylind", "kannala", "eucm", "double_sphere"];
    parts.iter().any(|part| model.contains(part)) || matches!(model, "ds" | "fov" | "kb" | "kb4")
}

/// Puts each entry into one of the lists.
fn account(pasted: &mut Pasted, said: &Said<'_>, is_rectified: bool) {
    let is_fisheye = said.words().split(' ').any(is_no_pinhole);
    let mut coefficients = Vec::new();
    for (at, entry) in said.entries.iter().enumerate() {
        let name = entry.name.clone();
        let is_taken = said.taken.iter().any(|(_, own)| *own == at);
        let first = entry.fields.first().copied().unwrap_or(F::Unknown);
        let value = entry.value();
        let why = match first {
            F::Skip | F::Ignored => Some(Why::SaysNothing),
            F::NotCamera | F::Map9 | F::Map12 | F::Map16 => Some(Why::NotCamera),
            F::Distortion | F::Coefficient => {
                let own: Vec<f64> = entry.numbers.iter().map(|number| number.value).collect();
                let is_zero = own.iter().all(|k| *k == 0.0);
                if !is_rectified && !is_zero {
                    coefficients.push((at, own));
                    continue;
                }
                Some(if is_zero { Why::Zero } else { Why::BeforeRectification })
            }
            F::Model if is_no_pinhole(&entry.text.to_lowercase()) && !is_rectified => Some(Why::Fisheye),
            F::Model | F::Name | F::Part | F::FovAxis => None,
            F::Binning if entry.numbers.iter().all(|number| number.value <= 1.0) => None,
            F::Unknown => Some(Why::Unknown),
            _ if said.repeated.contains(&at) && entry.fields.len() == 1 => {
                Some(if entry.is_inherited { Why::Overridden } else { Why::Repeated })
            }
            // The pose is a matrix.
            F::Up if !is_taken && pasted.entries.is_some() => Some(Why::Overridden),
            _ if is_taken => None,
            _ if is_rectified => Some(Why::BeforeRectification),
            F::Crop | F::FullWidth | F::FullHeight | F::CropX | F::CropY | F::CropWidth | F::CropHeight => {
                Some(Why::SaysNothing)
            }
            F::Pan | F::FilmOffset if entry.numbers.iter().all(|number| number.value == 0.0) => Some(Why::Zero),
            F::FilmGauge | F::HalfHeight | F::HalfWidth | F::Chain => Some(Why::Overridden),
            _ => Some(Why::NotUsed),
        };
        match why {
            None => pasted.used.push(Used { name, value, meaning: first.symbol() }),
            Some(why) => pasted.left_out.push(LeftOut { name, value, why }),
        }
    }
    if !coefficients.is_empty() {
        let names: Vec<&str> = coefficients.iter().map(|(at, _)| said.entries[*at].name.as_str()).collect();
        let own: Vec<(String, Vec<f64>)> =
            coefficients.iter().map(|(at, k)| (plain(&said.entries[*at].name), k.clone())).collect();
        let model = said.words().trim().to_owned();
        let why =
            if is_fisheye { Why::Fisheye } else { Why::Distortion { model, pixels: pasted.shift_at_corner(&own) } };
        let value = coefficients.iter().map(|(at, _)| said.entries[*at].value()).collect::<Vec<_>>().join(" ");
        pasted.left_out.insert(0, LeftOut { name: names.join(", "), value, why });
    }
    // What a picture can't show comes first.
    pasted.left_out.sort_by_key(|left| left.why.changes_image() == Some(false));
}

/// The camera of some entries.
pub(crate) fn assemble(name: &str, entries: &[Entry], sign: Sign) -> Pasted {
    let mut said = Said::new(entries, sign);
    let mut pasted = Pasted { name: name.to_owned(), ..Pasted::default() };
    let mut image = said.number(F::ImageWidth).zip(said.number(F::ImageHeight)).map(|(m, n)| [m, n]);
    match said.lens(&mut image) {
        Ok(lens) => pasted.lens = lens,
        Err(error) => pasted.refused = Some(error.into()),
    }
    pasted.image = image.and_then(|[m, n]| image_size(m, n));
    let is_vision = matches!(pasted.lens, Some(GivenLens { size: Size::Pixels { .. }, .. })) || said.has(F::Rvec);
    let has_matrix = said.has(F::Pinhole);
    pasted.is_scaled = said.number(F::Scale).is_some();
    if let Some((entries, word)) = said.pose(is_vision) {
        (pasted.entries, pasted.word) = (Some(entries), Some(word));
    }
    if has_matrix {
        // K, its distortion and R are those before rectification.
        pasted.lens = None;
    }
    if let (Some(d), Some(lens)) = (pasted.entries.as_ref().and_then(|_| distance_of(&pasted)), &mut pasted.lens) {
        lens.near = lens.near.or(said.number(F::NearOfTarget).map(|near| d + near).filter(|near| *near > 0.0));
        lens.far = lens.far.or(said.number(F::FarOfTarget).map(|far| d + far));
    }
    // POV-Ray: a parallel window is as large as that of the angle at the target.
    if let Some(lens) = pasted.lens.filter(|lens| lens.is_parallel) {
        let d = pasted.entries.as_ref().and_then(|_| distance_of(&pasted));
        let slope = |angle: f64| 2.0 * (angle.to_radians() / 2.0).tan();
        let size = match (lens.size, d) {
            (Size::AngleY(angle), Some(d)) => Size::Height(d * slope(angle)),
            (Size::SlopeX(slope), Some(d)) => Size::Width(d * slope),
            (Size::AngleY(_) | Size::SlopeX(_) | Size::SlopeSmaller(_) | Size::SlopeLarger(_), _) => Size::Open,
            (size, _) => size,
        };
        pasted.lens = Some(GivenLens { size, ..lens });
    }
    pasted.is_chained = said.has(F::Chain);
    if let (None, Some(chain)) = (&pasted.entries, said.list(F::Chain)) {
        let m = matrix_of(&chain, 4);
        let view = word("T_cn_cnm1", MatrixKind::View, Some(Axes::OPENCV), Some(Order::Rows));
        (pasted.entries, pasted.word) = (Some(MatrixEntries::of_matrix(m, 0.0)), Some(view));
    }
    // R alone may be that of a rectification, if it turns nothing.
    let is_identity = |said: &Said<'_>| {
        said.first.iter().all(|(field, _, numbers)| {
            let is_one = |(k, x): (usize, &Written)| (x.value - f64::from(u8::from(k % 4 == 0))).abs() < 1e-9;
            let is_r = *field == F::R && said.name(F::R).to_lowercase().ends_with('r');
            !field.is_pose() || *field == F::Up || is_r && numbers.iter().enumerate().all(is_one)
        })
    };
    let is_half = pasted.entries.is_none() && !is_identity(&said);
    if (is_half || pasted.entries.is_none() && pasted.lens.is_none()) && pasted.refused.is_none() {
        let is_part = |entry: &&Entry| entry.has(|field| field.is_pose() || field.is_lens() && !is_half);
        let mut names: Vec<&str> = entries.iter().filter(is_part).map(|entry| entry.name.as_str()).collect();
        if names.is_empty() {
            names.extend(entries.iter().take(3).map(|entry| entry.name.as_str()));
        }
        pasted.refused = Some(MatrixTextError::Incomplete(names.join(", ")).into());
    }
    account(&mut pasted, &said, has_matrix);
    pasted
}

/// D of a look-at.
fn distance_of(pasted: &Pasted) -> Option<f64> {
    let entries = pasted.entries.as_ref().filter(|entries| entries.count() == 9)?;
    let m = entries.matrix(false);
    Some((m.row(0) - m.row(1)).truncate().length())
}
