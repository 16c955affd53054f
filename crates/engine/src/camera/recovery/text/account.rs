//! Each entry of a text ends in a list: used, or left out with a reason.

use super::camera::Said;
use super::names::{Field as F, plain};
use super::{LeftOut, Pasted, Used, Why};

/// True for the model of a lens that is no pinhole.
fn is_no_pinhole(model: &str) -> bool {
    let parts =
        ["fish", "equidist", "omni", "spheric", "equirect", "panoram", "cylind", "kannala", "eucm", "double_sphere"];
    parts.iter().any(|part| model.contains(part)) || matches!(model, "ds" | "fov" | "kb" | "kb4")
}

/// Puts each entry into one of the lists.
pub(crate) fn account(pasted: &mut Pasted, said: &Said<'_>, is_rectified: bool) {
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
