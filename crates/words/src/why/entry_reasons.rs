//! The reason for each entry of M_v and M_p, in one sentence.

use crate::camera::{Ndc, Projection};
use crate::explain::{Matrix, Setting};

texts!("why/entry_reasons");

/// The reason for an entry, in Markdown. Rows and columns from 0. `None` for other matrices, and for M_p in another
/// convention of NDC, which has another depth and y.
pub fn reason(lang: Lang, matrix: Matrix, setting: &Setting<'_>, [row, column]: [usize; 2]) -> Option<String> {
    let of_the_notes = setting.space().ndc() == Ndc::default();
    let all = match (matrix, setting.space().camera().projection()) {
        (Matrix::View, _) => [text!(lang, view_x), text!(lang, view_y), text!(lang, view_z), text!(lang, view_w)],
        (Matrix::Projection, _) if !of_the_notes => return None,
        (Matrix::Projection, Projection::Perspective) => [
            text!(lang, perspective_x),
            text!(lang, perspective_y),
            text!(lang, perspective_z),
            text!(lang, perspective_w),
        ],
        (Matrix::Projection, Projection::Parallel) => {
            [text!(lang, parallel_x), text!(lang, parallel_y), text!(lang, parallel_z), text!(lang, parallel_w)]
        }
        _ => return None,
    };
    let why = (*all.get(row)?.get(column)?).to_owned();
    if !setting.space().camera().has_symmetric_window() {
        return Some(why);
    }
    // In the notation of (5.14) and (5.16).
    let of_sides = [("2F/(r − l)", "2F/W"), ("2/(r − l)", "2/W"), ("2F/(t − b)", "2F/H"), ("2/(t − b)", "2/H")];
    Some(of_sides.into_iter().fold(why, |why, (sides, size)| why.replace(sides, size)))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::{Camera, ImageSize, Parameters, ViewWindow};
    use crate::explain::MatrixFormula;

    /// The reason of a constant entry begins with its number.
    #[test]
    fn every_entry_has_its_own_reason() {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let window = Some(ViewWindow { left: -1.0, right: 2.0, bottom: -1.0, top: 3.0 });
            let camera = Camera::new(&Parameters { projection, window, ..Parameters::default() }).unwrap();
            let setting = Setting::new(camera.notes_clip_space(), ImageSize { width: 4, height: 3 }, None);
            for matrix in [Matrix::View, Matrix::Projection] {
                let formulas = MatrixFormula::new(matrix, &setting);
                for lang in [Lang::En, Lang::PtBr] {
                    let mut all = Vec::new();
                    for row in 0..4 {
                        for column in 0..4 {
                            let why = reason(lang, matrix, &setting, [row, column]).unwrap();
                            let formula = formulas.entry(row, column);
                            let constant = formula.symbols().is_empty().then(|| formula.value(&setting));
                            let is = if lang == Lang::En { "It's" } else { "É" };
                            for (number, written) in [(0.0, "0"), (1.0, "1"), (-1.0, "−1")] {
                                let rest = why.strip_prefix(&format!("{is} {written}"));
                                assert_eq!(
                                    constant == Some(number),
                                    rest.is_some_and(|rest| rest.starts_with([' ', ',', '.'])),
                                    "{matrix:?} {row} {column}: {why}"
                                );
                            }
                            assert!(why.ends_with('.') && !all.contains(&why), "{why}");
                            all.push(why);
                        }
                    }
                }
            }
            assert!(reason(Lang::En, Matrix::Viewport, &setting, [0, 0]).is_none());
            let symmetric = Camera::new(&Parameters { projection, ..Parameters::default() }).unwrap();
            let setting = Setting::new(symmetric.notes_clip_space(), ImageSize { width: 4, height: 3 }, None);
            let why = reason(Lang::En, Matrix::Projection, &setting, [0, 0]).unwrap();
            assert!(why.contains("2/W") && !why.contains("(r − l)"), "{why}");
        }
    }
}
