//! The reason for each entry of M_v and M_p, in one sentence.

use crate::camera::{Ndc, Projection};
use crate::explain::{Matrix, Setting};
use crate::i18n::Lang;

/// English and Portuguese.
type Both = [&'static str; 2];

/// M_v, by rows.
const VIEW: [[Both; 4]; 4] = [
    [
        [
            "u_x is how far a step along x of the world goes to the right of the image. The row is **u**, so the product is the dot product that measures along **u**.",
            "u_x diz quanto um passo ao longo de x do mundo vai à direita da imagem. A linha é **u**, e o produto é o produto escalar que mede ao longo de **u**.",
        ],
        [
            "u_y is how far a step along y of the world goes to the right. It's 0 if **u** is horizontal.",
            "u_y diz quanto um passo ao longo de y do mundo vai à direita. É 0 se **u** é horizontal.",
        ],
        [
            "u_z is how far a step along z of the world goes to the right of the image.",
            "u_z diz quanto um passo ao longo de z do mundo vai à direita da imagem.",
        ],
        [
            "−**u** · **c** brings C to x_c = 0. It's the −C of the translation, measured along **u** because the rotation comes after it.",
            "−**u** · **c** leva C a x_c = 0. É o −C da translação, medido ao longo de **u** porque a rotação vem depois.",
        ],
    ],
    [
        [
            "v_x is how far a step along x of the world goes up in the image. The row is **v**, so the product measures along **v**.",
            "v_x diz quanto um passo ao longo de x do mundo sobe na imagem. A linha é **v**, e o produto mede ao longo de **v**.",
        ],
        [
            "v_y is how far a step along y of the world goes up in the image: 1 for a level camera, less for one that looks up or down.",
            "v_y diz quanto um passo ao longo de y do mundo sobe na imagem: 1 em uma câmera nivelada, menos em uma que olha para cima ou para baixo.",
        ],
        [
            "v_z is how far a step along z of the world goes up in the image.",
            "v_z diz quanto um passo ao longo de z do mundo sobe na imagem.",
        ],
        [
            "−**v** · **c** brings C to y_c = 0, like the entry above it along **u**.",
            "−**v** · **c** leva C a y_c = 0, como o elemento acima ao longo de **u**.",
        ],
    ],
    [
        [
            "n_x is how far a step along x of the world comes towards the viewer. The row is **n**, which points out of the scene.",
            "n_x diz quanto um passo ao longo de x do mundo vem em direção ao observador. A linha é **n**, que aponta para fora da cena.",
        ],
        [
            "n_y is how far a step along y of the world comes towards the viewer. It's greater than 0 for a camera that looks down.",
            "n_y diz quanto um passo ao longo de y do mundo vem em direção ao observador. É maior que 0 em uma câmera que olha para baixo.",
        ],
        [
            "n_z is how far a step along z of the world comes towards the viewer.",
            "n_z diz quanto um passo ao longo de z do mundo vem em direção ao observador.",
        ],
        [
            "−**n** · **c** brings C to z_c = 0. Points in front of C then have z_c < 0, because **n** points backwards.",
            "−**n** · **c** leva C a z_c = 0. Os pontos diante de C têm então z_c < 0, porque **n** aponta para trás.",
        ],
    ],
    [
        [
            "It's 0 because x of the world must not change w, which stays 1 for a point.",
            "É 0, pois o x do mundo não deve mudar w, que continua 1 para um ponto.",
        ],
        ["It's 0 because y of the world must not change w.", "É 0, pois o y do mundo não deve mudar w."],
        [
            "It's 0 because z of the world must not change w. Only M_p puts a depth into it.",
            "É 0, pois o z do mundo não deve mudar w. Só M_p põe nele uma profundidade.",
        ],
        [
            "It's 1 because w is passed on as it is. So points stay points, and directions (w = 0) don't feel the translation.",
            "É 1, pois w passa como está. Assim pontos continuam pontos, e direções (w = 0) não sentem a translação.",
        ],
    ],
];

/// M_p in perspective, by rows.
const PERSPECTIVE: [[Both; 4]; 4] = [
    [
        [
            "2F/(r − l): F projects x_c onto the window, by similar triangles, and 2/(r − l) makes the window 2 wide, from −1 to 1.",
            "2F/(r − l): F projeta x_c na janela, por semelhança de triângulos, e 2/(r − l) dá à janela a largura 2, de −1 a 1.",
        ],
        [
            "It's 0 because a point's height doesn't move its image sideways.",
            "É 0, pois a altura de um ponto não move sua imagem para o lado.",
        ],
        [
            "(r + l)/(r − l) brings the middle of the window to x_n = 0. It stands beside z_c because it has to survive the division by −z_c. It's 0 if the window is symmetric.",
            "(r + l)/(r − l) leva o meio da janela a x_n = 0. Fica junto de z_c porque deve sobreviver à divisão por −z_c. É 0 se a janela é simétrica.",
        ],
        [
            "It's 0 because a number here would be divided by −z_c, and shift near things more than far ones.",
            "É 0, pois um número aqui seria dividido por −z_c, e deslocaria mais o que está perto do que o que está longe.",
        ],
    ],
    [
        [
            "It's 0 because a point's sideways position doesn't move its image up or down.",
            "É 0, pois o deslocamento lateral de um ponto não move sua imagem para cima nem para baixo.",
        ],
        [
            "2F/(t − b): F projects, as in the first row, and 2/(t − b) makes the window 2 high, from −1 to 1.",
            "2F/(t − b): F projeta, como na primeira linha, e 2/(t − b) dá à janela a altura 2, de −1 a 1.",
        ],
        [
            "(t + b)/(t − b) brings the middle of the window to y_n = 0. It's 0 if the window is symmetric.",
            "(t + b)/(t − b) leva o meio da janela a y_n = 0. É 0 se a janela é simétrica.",
        ],
        [
            "It's 0. As in the first row, the division would turn a number here into a shift that depends on the depth.",
            "É 0. Como na primeira linha, a divisão faria de um número aqui um deslocamento que depende da profundidade.",
        ],
    ],
    [
        [
            "It's 0 because all points of a plane parallel to the window must get the same depth, so x_c doesn't count.",
            "É 0, pois todos os pontos de um plano paralelo à janela devem ter a mesma profundidade, então x_c não conta.",
        ],
        [
            "It's 0. For the same reason y_c doesn't count in the depth.",
            "É 0. Pela mesma razão, y_c não conta na profundidade.",
        ],
        [
            "−(B + F)/(B − F) is α of the two conditions z_n = −1 at F and z_n = 1 at B. It's negative because z_n has to reach 1 where z_c = −B.",
            "−(B + F)/(B − F) é o α das duas condições z_n = −1 em F e z_n = 1 em B. É negativo porque z_n deve chegar a 1 em z_c = −B.",
        ],
        [
            "−2BF/(B − F) is β of these two conditions. Divided by −z_c it falls off with the depth, so that F lands on −1 and B on 1.",
            "−2BF/(B − F) é o β dessas duas condições. Dividido por −z_c, diminui com a profundidade, e assim F vai a −1 e B a 1.",
        ],
    ],
    [
        [
            "It's 0 because w must be the depth alone, so x_c doesn't count.",
            "É 0, pois w deve ser só a profundidade, então x_c não conta.",
        ],
        [
            "It's 0 because w must be the depth alone, so y_c doesn't count.",
            "É 0, pois w deve ser só a profundidade, então y_c não conta.",
        ],
        [
            "It's −1 because w has to be the depth, and z_c is negative in front of C, so w_r = −z_c is positive for what is seen.",
            "É −1, pois w deve ser a profundidade, e z_c é negativo diante de C, então w_r = −z_c é positivo para o que se vê.",
        ],
        [
            "It's 0. With a number here w wouldn't be 0 in the plane of C, and the rays wouldn't meet there.",
            "É 0. Com um número aqui w não seria 0 no plano de C, e os raios não se encontrariam ali.",
        ],
    ],
];

/// M_p in parallel projection, by rows.
const PARALLEL: [[Both; 4]; 4] = [
    [
        [
            "2/(r − l) makes the window 2 wide, from −1 to 1. There's no F, because the image of a point has its own x_c.",
            "2/(r − l) dá à janela a largura 2, de −1 a 1. Não há F, porque a imagem de um ponto tem o próprio x_c.",
        ],
        [
            "It's 0 because a point's height doesn't move its image sideways.",
            "É 0, pois a altura de um ponto não move sua imagem para o lado.",
        ],
        [
            "It's 0 because the projectors run along **n**, so the depth doesn't move an image to the side.",
            "É 0, pois os projetores correm ao longo de **n**, então a profundidade não move a imagem para o lado.",
        ],
        [
            "−(r + l)/(r − l) brings the middle of the window to x_n = 0. It stands in the last column because nothing is divided here.",
            "−(r + l)/(r − l) leva o meio da janela a x_n = 0. Fica na última coluna porque aqui nada é dividido.",
        ],
    ],
    [
        [
            "It's 0 because a point's sideways position doesn't move its image up or down.",
            "É 0, pois o deslocamento lateral de um ponto não move sua imagem para cima nem para baixo.",
        ],
        ["2/(t − b) makes the window 2 high, from −1 to 1.", "2/(t − b) dá à janela a altura 2, de −1 a 1."],
        [
            "It's 0 because the projectors run along **n**, so the depth doesn't move an image up or down.",
            "É 0, pois os projetores correm ao longo de **n**, então a profundidade não move a imagem para cima nem para baixo.",
        ],
        [
            "−(t + b)/(t − b) brings the middle of the window to y_n = 0.",
            "−(t + b)/(t − b) leva o meio da janela a y_n = 0.",
        ],
    ],
    [
        [
            "It's 0 because all points of a plane parallel to the window must get the same depth.",
            "É 0, pois todos os pontos de um plano paralelo à janela devem ter a mesma profundidade.",
        ],
        [
            "It's 0. For the same reason y_c doesn't count in the depth.",
            "É 0. Pela mesma razão, y_c não conta na profundidade.",
        ],
        [
            "−2/(B − F) makes the volume 2 deep. The minus turns z round, because z_c falls into the scene and z_n grows.",
            "−2/(B − F) dá ao volume a profundidade 2. O menos inverte z, porque z_c diminui para dentro da cena e z_n cresce.",
        ],
        [
            "−(B + F)/(B − F) brings the middle between the planes, z_c = −(B + F)/2, to z_n = 0.",
            "−(B + F)/(B − F) leva o meio entre os planos, z_c = −(B + F)/2, a z_n = 0.",
        ],
    ],
    [
        [
            "It's 0 because w stays 1 for every point, so x_c doesn't count.",
            "É 0, pois w continua 1 para todo ponto, então x_c não conta.",
        ],
        [
            "It's 0 because w stays 1 for every point, so y_c doesn't count.",
            "É 0, pois w continua 1 para todo ponto, então y_c não conta.",
        ],
        [
            "It's 0 because no depth goes into w, so what is far isn't made smaller.",
            "É 0, pois nenhuma profundidade entra em w, então o que está longe não diminui.",
        ],
        [
            "It's 1 because w stays 1 and the division changes nothing. The 0 that the lecture notes print in (5.15) and (5.16) would send every point to infinity.",
            "É 1, pois w continua 1 e a divisão nada muda. O 0 que as notas de aula imprimem em (5.15) e (5.16) mandaria todo ponto ao infinito.",
        ],
    ],
];

/// The reason for an entry, in Markdown. Rows and columns from 0. `None` for other matrices, and for M_p in another
/// convention of NDC, which has another depth and y.
pub fn reason(lang: Lang, matrix: Matrix, setting: &Setting<'_>, [row, column]: [usize; 2]) -> Option<String> {
    let of_the_notes = setting.space().ndc() == Ndc::default();
    let all = match (matrix, setting.space().camera().projection()) {
        (Matrix::View, _) => &VIEW,
        (Matrix::Projection, _) if !of_the_notes => return None,
        (Matrix::Projection, Projection::Perspective) => &PERSPECTIVE,
        (Matrix::Projection, Projection::Parallel) => &PARALLEL,
        _ => return None,
    };
    let [en, pt] = all.get(row)?.get(column)?;
    let why = (*pick!(lang; en, pt)).to_owned();
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
