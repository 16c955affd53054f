//! Why each entry of M_v and M_p is what it is, in one sentence.

use crate::camera::{Ndc, Projection};
use crate::explain::{Matrix, Setting};
use crate::i18n::Lang;

/// English and Portuguese.
type Both = [&'static str; 2];

/// M_v, by rows.
const VIEW: [[Both; 4]; 4] = [
    [
        [
            "u_x is how far a step along x of the world goes to the right of the image: the row is **u**, so the product is the dot product that measures along **u**.",
            "u_x diz quanto um passo ao longo de x do mundo vai à direita da imagem: a linha é **u**, e o produto é o produto escalar que mede ao longo de **u**.",
        ],
        [
            "u_y is how far a step along y of the world goes to the right; it is 0 if **u** is horizontal.",
            "u_y diz quanto um passo ao longo de y do mundo vai à direita; é 0 se **u** é horizontal.",
        ],
        [
            "u_z is how far a step along z of the world goes to the right of the image.",
            "u_z diz quanto um passo ao longo de z do mundo vai à direita da imagem.",
        ],
        [
            "−**u** · **c** brings C to x_c = 0: it is the −C of the translation, measured along **u** because the rotation comes after it.",
            "−**u** · **c** leva C a x_c = 0: é o −C da translação, medido ao longo de **u** porque a rotação vem depois.",
        ],
    ],
    [
        [
            "v_x is how far a step along x of the world goes up in the image: the row is **v**, so the product measures along **v**.",
            "v_x diz quanto um passo ao longo de x do mundo sobe na imagem: a linha é **v**, e o produto mede ao longo de **v**.",
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
            "n_x is how far a step along x of the world comes towards the viewer: the row is **n**, which points out of the scene.",
            "n_x diz quanto um passo ao longo de x do mundo vem em direção a quem vê: a linha é **n**, que aponta para fora da cena.",
        ],
        [
            "n_y is how far a step along y of the world comes towards the viewer: greater than 0 for a camera that looks down.",
            "n_y diz quanto um passo ao longo de y do mundo vem em direção a quem vê: maior que 0 em uma câmera que olha para baixo.",
        ],
        [
            "n_z is how far a step along z of the world comes towards the viewer.",
            "n_z diz quanto um passo ao longo de z do mundo vem em direção a quem vê.",
        ],
        [
            "−**n** · **c** brings C to z_c = 0; what lies in front of C then has z_c < 0, because **n** points backwards.",
            "−**n** · **c** leva C a z_c = 0; o que está diante de C fica então com z_c < 0, porque **n** aponta para trás.",
        ],
    ],
    [
        [
            "0: x of the world must not change w, which stays 1 for a point.",
            "0: o x do mundo não deve mudar w, que continua 1 para um ponto.",
        ],
        ["0: y of the world must not change w.", "0: o y do mundo não deve mudar w."],
        [
            "0: z of the world must not change w; only M_p puts a depth into it.",
            "0: o z do mundo não deve mudar w; só M_p põe nele uma profundidade.",
        ],
        [
            "1: w is passed on as it is, so points stay points, and directions (w = 0) don't feel the translation.",
            "1: w passa como está, e assim pontos continuam pontos, e direções (w = 0) não sentem a translação.",
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
            "0: how high a point is doesn't move its image to the side.",
            "0: a altura de um ponto não move sua imagem para o lado.",
        ],
        [
            "(r + l)/(r − l) brings the middle of the window to x_n = 0; it stands beside z_c because it has to survive the division by −z_c, and is 0 if the window is symmetric.",
            "(r + l)/(r − l) leva o meio da janela a x_n = 0; fica junto de z_c porque deve sobreviver à divisão por −z_c, e é 0 se a janela é simétrica.",
        ],
        [
            "0: a number here would be divided by −z_c, and shift near things more than far ones.",
            "0: um número aqui seria dividido por −z_c, e deslocaria mais o que está perto do que o que está longe.",
        ],
    ],
    [
        [
            "0: how far to the side a point is doesn't move its image up or down.",
            "0: quanto um ponto está para o lado não move sua imagem para cima nem para baixo.",
        ],
        [
            "2F/(t − b): F projects, as in the first row, and 2/(t − b) makes the window 2 high, from −1 to 1.",
            "2F/(t − b): F projeta, como na primeira linha, e 2/(t − b) dá à janela a altura 2, de −1 a 1.",
        ],
        [
            "(t + b)/(t − b) brings the middle of the window to y_n = 0; it is 0 if the window is symmetric.",
            "(t + b)/(t − b) leva o meio da janela a y_n = 0; é 0 se a janela é simétrica.",
        ],
        [
            "0: as in the first row, the division would turn a number here into a shift that depends on the depth.",
            "0: como na primeira linha, a divisão faria de um número aqui um deslocamento que depende da profundidade.",
        ],
    ],
    [
        [
            "0: all points of a plane parallel to the window shall get the same depth, so x_c doesn't count.",
            "0: todos os pontos de um plano paralelo à janela devem ter a mesma profundidade, então x_c não conta.",
        ],
        [
            "0: for the same reason y_c doesn't count in the depth.",
            "0: pela mesma razão, y_c não conta na profundidade.",
        ],
        [
            "−(B + F)/(B − F) is α of the two conditions z_n = −1 at F and z_n = 1 at B; it is negative because z_n has to reach 1 where z_c = −B.",
            "−(B + F)/(B − F) é o α das duas condições z_n = −1 em F e z_n = 1 em B; é negativo porque z_n deve chegar a 1 em z_c = −B.",
        ],
        [
            "−2BF/(B − F) is β of these two conditions: divided by −z_c it falls off with the depth, so that F lands on −1 and B on 1.",
            "−2BF/(B − F) é o β dessas duas condições: dividido por −z_c, diminui com a profundidade, e assim F vai a −1 e B a 1.",
        ],
    ],
    [
        [
            "0: w shall be the depth alone, so x_c doesn't count.",
            "0: w deve ser só a profundidade, então x_c não conta.",
        ],
        [
            "0: w shall be the depth alone, so y_c doesn't count.",
            "0: w deve ser só a profundidade, então y_c não conta.",
        ],
        [
            "−1: w has to be the depth, and z_c is negative in front of C, so w_r = −z_c is positive for what is seen.",
            "−1: w deve ser a profundidade, e z_c é negativo diante de C, então w_r = −z_c é positivo para o que se vê.",
        ],
        [
            "0: with a number here w would not be 0 in the plane of C, and the rays would not meet there.",
            "0: com um número aqui w não seria 0 no plano de C, e os raios não se encontrariam ali.",
        ],
    ],
];

/// M_p in parallel projection, by rows.
const PARALLEL: [[Both; 4]; 4] = [
    [
        [
            "2/(r − l) makes the window 2 wide, from −1 to 1; no F, because the image of a point has its own x_c.",
            "2/(r − l) dá à janela a largura 2, de −1 a 1; sem F, porque a imagem de um ponto tem o próprio x_c.",
        ],
        [
            "0: how high a point is doesn't move its image to the side.",
            "0: a altura de um ponto não move sua imagem para o lado.",
        ],
        [
            "0: the projectors run along **n**, so the depth doesn't move an image to the side.",
            "0: os projetores correm ao longo de **n**, então a profundidade não move a imagem para o lado.",
        ],
        [
            "−(r + l)/(r − l) brings the middle of the window to x_n = 0; it stands in the last column because nothing is divided here.",
            "−(r + l)/(r − l) leva o meio da janela a x_n = 0; fica na última coluna porque aqui nada é dividido.",
        ],
    ],
    [
        [
            "0: how far to the side a point is doesn't move its image up or down.",
            "0: quanto um ponto está para o lado não move sua imagem para cima nem para baixo.",
        ],
        ["2/(t − b) makes the window 2 high, from −1 to 1.", "2/(t − b) dá à janela a altura 2, de −1 a 1."],
        [
            "0: the projectors run along **n**, so the depth doesn't move an image up or down.",
            "0: os projetores correm ao longo de **n**, então a profundidade não move a imagem para cima nem para baixo.",
        ],
        [
            "−(t + b)/(t − b) brings the middle of the window to y_n = 0.",
            "−(t + b)/(t − b) leva o meio da janela a y_n = 0.",
        ],
    ],
    [
        [
            "0: all points of a plane parallel to the window shall get the same depth.",
            "0: todos os pontos de um plano paralelo à janela devem ter a mesma profundidade.",
        ],
        [
            "0: for the same reason y_c doesn't count in the depth.",
            "0: pela mesma razão, y_c não conta na profundidade.",
        ],
        [
            "−2/(B − F) makes the volume 2 deep; the minus turns z round, because z_c falls into the scene and z_n grows.",
            "−2/(B − F) dá ao volume a profundidade 2; o menos inverte z, porque z_c diminui para dentro da cena e z_n cresce.",
        ],
        [
            "−(B + F)/(B − F) brings the middle between the planes, z_c = −(B + F)/2, to z_n = 0.",
            "−(B + F)/(B − F) leva o meio entre os planos, z_c = −(B + F)/2, a z_n = 0.",
        ],
    ],
    [
        [
            "0: w stays 1 for every point, so x_c doesn't count.",
            "0: w continua 1 para todo ponto, então x_c não conta.",
        ],
        [
            "0: w stays 1 for every point, so y_c doesn't count.",
            "0: w continua 1 para todo ponto, então y_c não conta.",
        ],
        [
            "0: no depth goes into w, so what is far isn't made smaller.",
            "0: nenhuma profundidade entra em w, então o que está longe não diminui.",
        ],
        [
            "1: w stays 1, and the division changes nothing; the 0 that the lecture notes print in (5.15) and (5.16) would send every point to infinity.",
            "1: w continua 1, e a divisão nada muda; o 0 que as notas de aula imprimem em (5.15) e (5.16) mandaria todo ponto ao infinito.",
        ],
    ],
];

/// Why an entry is what it is, in Markdown; rows and columns from 0. `None` for other matrices, and for M_p in another
/// convention of NDC, whose depth and y are others.
#[must_use]
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
    // As (5.14) and (5.16) write it.
    let of_sides = [("2F/(r − l)", "2F/W"), ("2/(r − l)", "2/W"), ("2F/(t − b)", "2F/H"), ("2/(t − b)", "2/H")];
    Some(of_sides.into_iter().fold(why, |why, (sides, size)| why.replace(sides, size)))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::{Camera, ImageSize, Parameters, ViewWindow};
    use crate::explain::MatrixFormula;

    /// A constant entry is named by its number, and a formula by its signs.
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
                            for (number, start) in [(0.0, "0: "), (1.0, "1: "), (-1.0, "−1: ")] {
                                assert_eq!(
                                    constant == Some(number),
                                    why.starts_with(start),
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
