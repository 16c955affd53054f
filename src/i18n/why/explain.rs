//! The side of explanations.

use crate::camera::Decomposition;
use crate::explain::{Axis, Component, Matrix, MatrixFormula, Symbol};
use crate::i18n::Lang;
use crate::i18n::why::conventions;
use crate::numbers::significant;

texts! {
    question_where: "Where does this number come from?", "De onde vem este número?";
    question_where_hint: "Each number with its formula, in matrices, along the way of a point, in w and in the order of transforms", "Cada número com a fórmula, nas matrizes, no caminho de um ponto, em w e na ordem das transformações";
    question_happens: "What happens, in which order?", "O que acontece, e em que ordem?";
    question_happens_hint: "From the scene to the pixels, with the frustum, the stages, hidden surfaces, clipping and depth", "Da cena aos pixels, com o tronco, as etapas, as faces ocultas, o recorte e a profundidade";
    question_called: "What is it called elsewhere?", "Que nome tem em outros lugares?";
    question_called_hint: "The same camera in OpenGL, three.js, computer vision and other sources, also as code and in their conventions", "A mesma câmera em OpenGL, three.js, visão computacional e outras fontes, também como código e nas convenções de cada um";
    question_able: "Can I do it?", "Eu sei fazer?";
    question_able_hint: "Exercises whose answers are checked, and reference pages to read", "Exercícios com respostas conferidas, e verbetes para ler";
    matrices: "Matrices", "Matrizes";
    matrices_hint: "Why each entry of each matrix is what it is", "Por que cada elemento de cada matriz é o que é";
    point: "Follow a point", "Seguir um ponto";
    point_hint: "One point through every space, with all the arithmetic, and back", "Um ponto por todos os espaços, com a conta inteira, e de volta";
    homogeneous: "Dividing by w", "Dividir por w";
    homogeneous_hint: "The fourth coordinate at work in the division, behind the eye, in ideal points, on a segment and on a floor", "A quarta coordenada na divisão, atrás do olho, nos pontos ideais, em um segmento e em um piso";
    stages: "Stages", "Etapas";
    stages_hint: "Each stage of the pipeline, with its input and output, or why it was skipped", "Cada etapa do pipeline, com o que entra e o que sai, ou por que foi omitida";
    one_triangle: "The outcodes and cuts of one triangle →", "Os outcodes e cortes de um triângulo →";
    triangle: "One triangle", "Um triângulo";
    triangle_hint: "One triangle from the scene to its pixels, through facing, outcodes, cuts, division and depth test", "Um triângulo, da cena aos pixels, por orientação, outcodes, cortes, divisão e teste de profundidade";
    hidden_surfaces: "Hidden surfaces", "Faces ocultas";
    hidden_surfaces_hint: "The image painted triangle by triangle, by painter, BSP tree or depth buffer, and the faces turned away", "A imagem pintada triângulo por triângulo, por pintor, árvore BSP ou z-buffer, e as faces de costas";
    clipping: "Clipping", "Recorte";
    clipping_hint: "The parts outside the view volume, the cuts, and why the division must wait", "As partes fora do volume de vista, os cortes, e por que a divisão tem que esperar";
    depth: "Depth, z-fighting", "Profundidade, z-fighting";
    depth_hint: "How depths crowd near 1, what a depth buffer can tell apart, and how z-fighting begins", "Como as profundidades se comprimem perto de 1, o que um z-buffer distingue, e como começa o z-fighting";
    conventions: "Conventions", "Convenções";
    conventions_hint: "NDC of OpenGL, Direct3D and others, reversed depth, row vectors, left-handed view space, side by side", "NDC de OpenGL, Direct3D e outros, profundidade invertida, vetores linha, espaço de vista de mão esquerda, lado a lado";
    no_inverse: "It has no inverse. Something is multiplied by 0 (a scale, or a depth range from n to n) and can't be recovered.", "Não tem inversa. Algo é multiplicado por 0 (uma escala, ou profundidades de n a n) e não pode ser recuperado.";
    film: "Export…", "Exportar…";
    film_hint: "Exports the way from the world to the canonical volume as an animation (GIF, APNG) or a strip of stills (PNG, WebP, JPEG), by the extension of the name", "Exporta o caminho do mundo ao volume canônico como uma animação (GIF, APNG) ou uma tira de quadros (PNG, WebP, JPEG), pela extensão do nome";
    animation: "Animation", "Animação";
    strip: "Strip of stills", "Tira de quadros";
    dialects: "Other libraries", "Outras bibliotecas";
    dialects_hint: "The camera as gluLookAt, three.js, K [R | t] and others write it. Change their numbers to set it, or paste a matrix", "A câmera como gluLookAt, three.js, K [R | t] e outros a escrevem. Mude os números deles para defini-la, ou cole uma matriz";
    order: "Order of transforms", "Ordem das transformações";
    order_hint: "In which order translation, rotation and scaling act on an object, and what a different order does", "Em que ordem translação, rotação e escala agem num objeto, e o que outra ordem faz";
    code: "Code", "Código";
    code_hint: "The camera as code for a library", "A câmera como código para uma biblioteca";
    notes: "Reference", "Verbetes";
    notes_hint: "A short text on each symbol, operation, equation, step and stage; F1 on one of them opens it", "Um texto curto sobre cada símbolo, operação, equação, passo e etapa; F1 sobre um deles o abre";
    exercises: "Exercises", "Exercícios";
    exercises_hint: "Exercises of the lecture notes, and families with new numbers each time. The program checks your answers and explains wrong ones", "Os exercícios das notas de aula, e famílias com números novos a cada vez. O programa confere suas respostas e explica as erradas";
    search_notes: "Search the reference pages", "Pesquisar nos verbetes";
    search_notes_hint: "Words, symbols or numbers of equations. Accents and capitals don't matter. Enter opens the first", "Palavras, símbolos ou números de equações. Acentos e maiúsculas não importam. Enter abre a primeira";
    no_note: "No reference page matches.", "Nenhum verbete corresponde.";
    note_before: "Previous page", "Verbete anterior";
    see_also: "See also", "Veja também";
    in_this_figure: "in this figure", "nesta figura";
    code_for: "Code for", "Código para";
    copy: "Copy", "Copiar";
    copy_code_hint: "Copies the code", "Copia o código";
    steps: "Frustum → cube", "Tronco → cubo";
    steps_hint: "How the view volume becomes the canonical one, step by step, in the decomposition of each source", "Como o volume de vista vira o canônico, passo a passo, na decomposição de cada fonte";
    steps_hidden: "The view of the canonical volume, which shows this, is hidden (Ctrl+2).", "A vista do volume canônico, que mostra isto, está oculta (Ctrl+2).";
    nothing_done: "No step is applied, so this is the world.", "Nenhum passo foi aplicado, e este é o mundo.";
    to_world: "To the world", "Ao mundo";
    step_back: "Step back", "Um passo atrás";
    play: "Play", "Reproduzir";
    hold: "Pause", "Pausar";
    step_forward: "Step forward", "Um passo à frente";
    to_cube: "To the canonical volume", "Ao volume canônico";
    scrubber: "Steps applied", "Passos aplicados";
    scrubber_hint: "Steps applied. The left and right arrows go by a tenth of a step, and with Ctrl to the previous or next whole step",
        "Passos aplicados. As setas esquerda e direita andam um décimo de passo, e com Ctrl vão ao passo inteiro anterior ou seguinte";
    inverse: "inverse", "inversa";
    formulas: "formulas", "fórmulas";
    formulas_hint: "The entries with the symbols of the lecture notes [0]", "Os elementos com os símbolos das notas de aula [0]";
    numbers: "with numbers", "com números";
    numbers_hint: "The same formulas with the numbers of this camera", "As mesmas fórmulas com os números desta câmera";
    values: "values", "valores";
    values_hint: "The values of the formulas, as fractions and roots if they're exact, otherwise as decimals", "Os valores das fórmulas, em frações e raízes quando são exatas, senão em decimais";
    copy_latex: "Copy LaTeX", "Copiar LaTeX";
    copy_latex_hint: "The matrix as it is shown, as a bmatrix", "A matriz como é mostrada, como bmatrix";
    copy_text: "Copy text", "Copiar texto";
    copy_text_hint: "The matrix as it is shown, in rows and columns", "A matriz como é mostrada, em linhas e colunas";
    select_object: "M_m is the matrix of one object. Select one in the world or in the scene (F6).", "M_m é a matriz de um objeto. Selecione um no mundo ou na cena (F6).";
    click_an_entry: "Click an entry to see its formula, its numbers and its value", "Clique em um elemento para ver a fórmula, os números e o valor";
    made_of: "made of (click a symbol to open it)", "feito de (clique num símbolo para abri-lo)";
    parameter: "(parameter)", "(parâmetro)";
    constant: "It is the same for every camera of this kind.", "É o mesmo para toda câmera deste tipo.";
    as_in_the_notes: "Here, as in the lecture notes, points are columns and view space is right-handed.", "Aqui, como nas notas de aula, pontos são colunas e o espaço de vista é de mão direita.";
}

texts_with_values! {
    /// The place of an entry. Rows and columns from 0.
    entry(lang, matrix: &str, row: usize, column: usize): "{matrix}, row {row}, column {column}",
        "{matrix}, linha {row}, coluna {column}" (row = row + 1, column = column + 1);

    /// The sum in which an entry occurs, for a point.
    used_in(lang, point: &str, symbol: &str): "for {point} it appears in the sum of {symbol}, in the term",
        "para {point} aparece na soma de {symbol}, no termo";

    /// The matrix of a step. The first is 1.
    factor(lang, step: usize): "The matrix of step {step}", "A matriz do passo {step}";

    /// The handedness of the axes from here on.
    handedness(lang, hand: &str): "from here on {hand}: z is reversed", "daqui em diante, {hand}: z se inverte";
}

/// The effect of a matrix.
pub const fn matrix(lang: Lang, matrix: Matrix) -> &'static str {
    match matrix {
        Matrix::Model => pick!(lang; "object → world", "objeto → mundo"),
        Matrix::InverseModel => pick!(lang; "world → object", "mundo → objeto"),
        Matrix::Parent => pick!(lang; "parent → world", "pai → mundo"),
        Matrix::InverseParent => pick!(lang; "world → parent", "mundo → pai"),
        Matrix::View => pick!(lang; "world → view", "mundo → vista"),
        Matrix::InverseView => pick!(lang; "view → world", "vista → mundo"),
        Matrix::Projection => pick!(lang; "view → clip", "vista → recorte"),
        Matrix::InverseProjection => pick!(lang; "clip → view", "recorte → vista"),
        Matrix::ViewProjection => pick!(lang; "world → clip", "mundo → recorte"),
        Matrix::InverseViewProjection => pick!(lang; "clip → world", "recorte → mundo"),
        Matrix::Viewport => pick!(lang; "NDC → viewport", "NDC → viewport (tela)"),
        Matrix::InverseViewport => pick!(lang; "viewport → NDC", "viewport (tela) → NDC"),
    }
}

/// The reason why this equation is in force.
pub fn in_force(lang: Lang, formulas: &MatrixFormula) -> String {
    let (en, pt) = match formulas.equation {
        "(5.13)" => ("perspective, with any window", "perspectiva, com qualquer janela"),
        "(5.14)" => {
            ("perspective, with a window symmetric about DOP", "perspectiva, com janela simétrica em torno de DOP")
        }
        "(5.15)" => ("parallel, with any window", "paralela, com qualquer janela"),
        "(5.16)" => ("parallel, with a window symmetric about DOP", "paralela, com janela simétrica em torno de DOP"),
        "" => (
            "the lecture notes have no equation for it, because it follows from the others",
            "as notas de aula não têm equação para ela, pois decorre das outras",
        ),
        _ => ("the equation of the lecture notes", "a equação das notas de aula"),
    };
    both!(lang; "{} {en}", "{} {pt}"; formulas.equation).trim().to_owned()
}

/// A symbol, in a few words.
pub fn symbol(lang: Lang, symbol: Symbol) -> String {
    let of = |component: Component, en: &str, pt: &str| both!(lang; "{} of {en}", "{} de {pt}"; component.letter());
    let plain = |en: &str, pt: &str| pick!(lang; en.to_owned(), pt.to_owned());
    match symbol {
        Symbol::Axis(Axis::U, c) => of(c, "u, to the right of the camera", "u, à direita da câmera"),
        Symbol::Axis(Axis::V, c) => of(c, "v, upwards from the camera", "v, para cima da câmera"),
        Symbol::Axis(Axis::N, c) => of(c, "n, from PF towards C", "n, de PF para C"),
        Symbol::Position(c) => of(c, "C, the position", "C, a posição"),
        Symbol::FocalPoint(c) => of(c, "PF, the focal point", "PF, o ponto focal"),
        Symbol::ViewUp(c) => of(c, "VUP", "VUP"),
        Symbol::Distance => plain("from C to PF", "de C a PF"),
        Symbol::Near => plain("from C to the window, the front plane", "de C à janela, o plano da frente"),
        Symbol::Far => plain("from C to the back plane", "de C ao plano de fundo"),
        Symbol::Left => plain("left side of the window", "lado esquerdo da janela"),
        Symbol::Right => plain("right side of the window", "lado direito da janela"),
        Symbol::Bottom => plain("lower side of the window", "lado inferior da janela"),
        Symbol::Top => plain("upper side of the window", "lado superior da janela"),
        Symbol::Width => plain("width of the window", "largura da janela"),
        Symbol::Height => plain("height of the window", "altura da janela"),
        Symbol::Aspect => plain("aspect of the window", "aspecto da janela"),
        Symbol::ViewAngle => plain("view angle", "ângulo de vista"),
        Symbol::ImageWidth => plain("columns of the image", "colunas da imagem"),
        Symbol::ImageHeight => plain("rows of the image", "linhas da imagem"),
        Symbol::ViewportX => plain("left side of the viewport", "lado esquerdo da viewport"),
        Symbol::ViewportY => plain("lower side of the viewport", "lado inferior da viewport"),
        Symbol::ViewportWidth => plain("width of the viewport", "largura da viewport"),
        Symbol::ViewportHeight => plain("height of the viewport", "altura da viewport"),
        Symbol::DepthNear => plain("Z of the front plane", "Z do plano da frente"),
        Symbol::DepthFar => plain("Z of the back plane", "Z do plano de fundo"),
        Symbol::Translate(c) => of(c, "the object's translation", "a translação do objeto"),
        Symbol::Rotate(c) => both!(lang; "the object's rotation about {}",
            "a rotação do objeto em torno de {}"; c.letter()),
        Symbol::Scale(c) => of(c, "the object's scale", "a escala do objeto"),
        Symbol::Entry(matrix, row, column) => entry(lang, matrix.text(), row.into(), column.into()),
        Symbol::Local(c) => of(c, "the point, in its object's space", "o ponto, no espaço do objeto"),
        Symbol::World(c) => of(c, "the point, in the world", "o ponto, no mundo"),
        Symbol::View(c) => of(c, "the point, in view space", "o ponto, no espaço de vista"),
        Symbol::Clip(c) => of(c, "the point, in clip space", "o ponto, no espaço de recorte"),
        Symbol::Homogeneous(c) => of(c, "the point, before it is divided by w", "o ponto, antes de ser dividido por w"),
        Symbol::Ndc(c) => of(c, "the point, in NDC", "o ponto, em NDC"),
        Symbol::Window(c) => of(c, "the point, on the window", "o ponto, na janela"),
        Symbol::Pixel(c) => of(c, "the point's pixel", "o pixel do ponto"),
        Symbol::Viewport(c) => of(c, "the point, in the viewport", "o ponto, na viewport"),
    }
}

/// The matrices of a way to the canonical volume.
pub const fn decomposition(lang: Lang, decomposition: Decomposition) -> &'static str {
    match decomposition {
        Decomposition::Notes => pick!(lang; "M_p M_v, ÷ w", "M_p M_v, ÷ w"),
        Decomposition::Box => "S T P",
        Decomposition::Scale => "M_{xyscale} M_{pers}",
        Decomposition::Normalised => "M_P N",
    }
}

/// The product of the first steps.
pub fn product(lang: Lang, steps: usize) -> String {
    match steps {
        1 => both!(lang; "The product so far is the first step alone", "O produto até aqui é só o primeiro passo"),
        _ => both!(lang; "The product so far: step {steps} … step 1",
            "O produto até aqui: passo {steps} … passo 1"),
    }
}

/// The product of all steps compared with M_p M_v in the convention in which they end: `ratio` times it, but for
/// `rest`, relative to the greatest entry.
pub fn comparison(lang: Lang, decomposition: Decomposition, ratio: f64, rest: f64) -> String {
    const ROUNDING: f64 = 1e-9;
    let number = |value: f64, digits| lang.mark().printed(&significant(value, digits));
    let ndc = decomposition.ndc();
    let (from, to) = (number(ndc.depths()[0], 2), number(ndc.depths()[1], 2));
    let convention = conventions::name(lang, ndc);
    if rest.is_nan() || rest > ROUNDING {
        let rest = number(rest, 2);
        return both!(lang; "The product of all steps differs from M_p M_v ({convention}) by {rest} of its greatest entry.",
            "O produto de todos os passos difere de M_p M_v ({convention}) em {rest} do seu maior elemento.");
    }
    let (k, same) = (number(ratio, 5), (ratio - 1.0).abs() <= ROUNDING);
    match same {
        true => both!(lang; "The product of all steps is M_p M_v ({convention}: z_n from {from} to {to}).",
            "O produto de todos os passos é M_p M_v ({convention}: z_n de {from} a {to})."),
        false => both!(lang;
            "The product of all steps is {k} · M_p M_v ({convention}: z_n from {from} to {to}). They're the same points, since the division by w cancels the factor.",
            "O produto de todos os passos é {k} · M_p M_v ({convention}: z_n de {from} a {to}). São os mesmos pontos, pois a divisão por w cancela o fator."),
    }
}
