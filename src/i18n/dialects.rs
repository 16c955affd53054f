//! The camera in other vocabularies, and a matrix that is pasted.

use super::{Lang, messages};
use crate::camera::{Axes, Evidence, Lines, MatrixKind, MatrixTextError, Reading, RecoveryError, Unknown};
use crate::explain::vocabulary::{Limitation, Vocabulary};
use crate::sanitize::escaped;

texts! {
    number_hint: "Sets the camera", "Define a câmera";
    fixed_hint: "Follows from the others and cannot be set by itself", "Decorre dos outros e não pode ser definido sozinho";
    pasted: "A matrix → its camera", "Uma matriz → sua câmera";
    pasted_hint: "Paste sixteen numbers, or the twelve of K [R | t], as any program writes them. What the matrix is, and in whose axes, is recognised where its numbers tell; NDC are those chosen under Conventions.",
        "Cole dezesseis números, ou os doze de K [R | t], como qualquer programa os escreve. O que a matriz é, e em que eixos, se reconhece onde os números o dizem; as NDC são as escolhidas em Convenções.";
    recognise: "recognise", "reconhecer";
    kind: "The matrix is", "A matriz é";
    kind_hint: "What the matrix does. Camera → world is the inverse of M_v: matrix_world of Blender, a node of glTF, matrixWorld of three.js. K [R | t] leads to pixels.",
        "O que a matriz faz. Câmera → mundo é a inversa de M_v: matrix_world do Blender, um nó de glTF, matrixWorld de three.js. K [R | t] leva a pixels.";
    axes: "Axes", "Eixos";
    axes_hint: "Whose axes. OpenGL, glTF, three.js: x right, y up, z towards the viewer; y is up in the world. Blender: the same, but z is up in the world, which is turned. OpenCV: x right, y down, z into the scene.",
        "Os eixos de quem. OpenGL, glTF, three.js: x à direita, y para cima, z rumo ao observador; no mundo, y é para cima. Blender: os mesmos, mas no mundo z é para cima, e ele é girado. OpenCV: x à direita, y para baixo, z para dentro da cena.";
    instead: "Read it as", "Ler como";
    instead_hint: "As this, it gives another camera", "Assim ela dá outra câmera";
    image: "Image of the matrix", "Imagem da matriz";
    image_hint: "The size in pixels of the image that K belongs to. It is not in the matrix; the figure takes it on with the camera.",
        "O tamanho em pixels da imagem a que K pertence. Não está na matriz; a figura o recebe com a câmera.";
    to_perspective: "Make it a perspective", "Passar à perspectiva";
    to_perspective_hint: "The same camera in perspective; things at PF keep their size", "A mesma câmera em perspectiva; o que está em PF mantém o tamanho";
    transposed: "row vectors, or by columns", "vetores linha, ou por colunas";
    transposed_hint: "The matrix is written for row vectors, or by columns: it is transposed", "A matriz foi escrita para vetores linha, ou por colunas: é transposta";
    try_transposed: "Transposed, it is the matrix of a camera: choose “row vectors, or by columns”.", "Transposta, é a matriz de uma câmera: escolha “vetores linha, ou por colunas”.";
    read_as: "Read in the convention", "Lida na convenção";
    take: "Take this camera", "Usar esta câmera";
    take_hint: "The figure takes on the camera of the matrix; Ctrl+Z undoes it", "A figura recebe a câmera da matriz; Ctrl+Z desfaz";
}

/// The title of a vocabulary, and a name that no language changes.
#[must_use]
pub fn title(lang: Lang, vocabulary: Vocabulary) -> (&'static str, &'static str) {
    match (lang, vocabulary) {
        (_, Vocabulary::OpenGl) => ("OpenGL, GLU [2]", "opengl"),
        (Lang::En, Vocabulary::Vrc) => ("VRP, VPN, VUV [3]: left-handed", "vrc"),
        (Lang::PtBr, Vocabulary::Vrc) => ("VRP, VPN, VUV [3]: mão esquerda", "vrc"),
        (Lang::En, Vocabulary::ReferencePoint) => ("Reference point and view plane [1]", "reference point"),
        (Lang::PtBr, Vocabulary::ReferencePoint) => ("Ponto de referência e plano de vista [1]", "reference point"),
        (Lang::En, Vocabulary::Pinhole) => ("K [R | t]: computer vision", "pinhole"),
        (Lang::PtBr, Vocabulary::Pinhole) => ("K [R | t]: visão computacional", "pinhole"),
    }
}

/// A limitation of a vocabulary, or a difference to the notes.
#[must_use]
pub fn limitation(lang: Lang, limitation: Limitation) -> &'static str {
    match (lang, limitation) {
        (Lang::En, Limitation::SymmetricOnly) => "It can express symmetric windows only: this one is not.",
        (Lang::PtBr, Limitation::SymmetricOnly) => "Só exprime janelas simétricas: esta não é.",
        (Lang::En, Limitation::PerspectiveOnly) => "It can express perspective only.",
        (Lang::PtBr, Limitation::PerspectiveOnly) => "Só exprime a perspectiva.",
        (Lang::En, Limitation::NoClippingPlanes) => "F and B are not part of it: they stay as they are.",
        (Lang::PtBr, Limitation::NoClippingPlanes) => "F e B não fazem parte: ficam como estão.",
        (Lang::En, Limitation::NoFocalPoint) => "PF is not part of it: it stays at its distance D.",
        (Lang::PtBr, Limitation::NoFocalPoint) => "PF não faz parte: fica à sua distância D.",
        (Lang::En, Limitation::ViewPlaneIsNear) => {
            "Its view plane may lie anywhere; here it is the front plane, so D = F and z_{vp} = −F."
        }
        (Lang::PtBr, Limitation::ViewPlaneIsNear) => {
            "Seu plano de vista pode ficar em qualquer lugar; aqui é o plano da frente: D = F e z_{vp} = −F."
        }
        (Lang::En, Limitation::LeftHanded) => "Left-handed: n points into the scene, along DOP, and u = n × v.",
        (Lang::PtBr, Limitation::LeftHanded) => "Mão esquerda: n aponta para a cena, ao longo de DOP, e u = n × v.",
        (Lang::En, Limitation::Coordinates) => {
            "z_{near} and z_{far} are coordinates, negative, where [0] has distances F and B."
        }
        (Lang::PtBr, Limitation::Coordinates) => {
            "z_{near} e z_{far} são coordenadas, negativas, onde [0] tem as distâncias F e B."
        }
        (Lang::En, Limitation::YDown) => {
            "x to the right, y down, z into the scene; pixels from the corner of the image, as in (5.22)."
        }
        (Lang::PtBr, Limitation::YDown) => {
            "x para a direita, y para baixo, z para dentro da cena; pixels a partir do canto da imagem, como em (5.22)."
        }
    }
}

/// The kind of a matrix.
#[must_use]
pub fn kind(lang: Lang, kind: MatrixKind) -> &'static str {
    match (lang, kind) {
        (Lang::En, MatrixKind::View) => "M_v: view",
        (Lang::PtBr, MatrixKind::View) => "M_v: vista",
        (Lang::En, MatrixKind::Projection) => "M_p: projection",
        (Lang::PtBr, MatrixKind::Projection) => "M_p: projeção",
        (Lang::En, MatrixKind::ViewProjection) => "M_p M_v: both",
        (Lang::PtBr, MatrixKind::ViewProjection) => "M_p M_v: as duas",
        (Lang::En, MatrixKind::CameraToWorld) => "camera → world",
        (Lang::PtBr, MatrixKind::CameraToWorld) => "câmera → mundo",
        (_, MatrixKind::Pinhole) => "K [R | t]",
    }
}

/// Whose axes.
#[must_use]
pub const fn axes(axes: Axes) -> &'static str {
    match axes {
        Axes::OpenGl => "OpenGL, glTF, three.js",
        Axes::Blender => "Blender",
        Axes::OpenCv => "OpenCV",
    }
}

/// How a matrix was read, and why.
#[must_use]
pub fn reading(lang: Lang, reading: &Reading, by_columns: bool, evidence: Evidence) -> String {
    let (kind, axes) = (kind(lang, reading.kind), axes(reading.axes));
    let mut said = both!(lang; "Read as {kind}", "Lida como {kind}");
    if reading.kind.has_camera_axes() {
        said += &both!(lang; " in the axes of {axes}", " nos eixos de {axes}");
    }
    if by_columns {
        said += pick!(lang; ", by columns", ", por colunas");
    }
    said + match (lang, evidence) {
        (_, Evidence::Only) => ".",
        (Lang::En, Evidence::Level) => ": only so is the camera level and upright.",
        (Lang::PtBr, Evidence::Level) => ": só assim a câmera fica nivelada e de pé.",
        (Lang::En, Evidence::OriginAhead) => ": only so does it have the origin before it.",
        (Lang::PtBr, Evidence::OriginAhead) => ": só assim a origem fica diante dela.",
        (Lang::En, Evidence::Nothing) => ". Its numbers fit other readings as well.",
        (Lang::PtBr, Evidence::Nothing) => ". Os números servem também a outras leituras.",
    }
}

/// A quantity that a matrix leaves open.
#[must_use]
pub fn unknown(lang: Lang, unknown: Unknown) -> &'static str {
    match (lang, unknown) {
        (Lang::En, Unknown::FocalDistance) => "D is unknown: a direction has no length. PF keeps its distance.",
        (Lang::PtBr, Unknown::FocalDistance) => {
            "D é desconhecido: uma direção não tem comprimento. PF mantém sua distância."
        }
        (Lang::En, Unknown::ViewUp) => "VUP is unknown, only v is known: the present VUP stays if it fits.",
        (Lang::PtBr, Unknown::ViewUp) => "VUP é desconhecido, só se conhece v: o VUP atual fica, se servir.",
        (Lang::En, Unknown::PositionAlongNormal) => {
            "In parallel projection C may lie anywhere along n: it is put where F does not change."
        }
        (Lang::PtBr, Unknown::PositionAlongNormal) => {
            "Em projeção paralela C pode ficar em qualquer lugar ao longo de n: é posto onde F não muda."
        }
        (Lang::En, Unknown::WindowCentre) => {
            "An off-axis window and a C shifted sideways give the same matrix: the window is taken as symmetric."
        }
        (Lang::PtBr, Unknown::WindowCentre) => {
            "Uma janela fora do eixo e um C deslocado dão a mesma matriz: a janela é tomada como simétrica."
        }
        (Lang::En, Unknown::Far) => "The back plane is at infinity: B stays as it was.",
        (Lang::PtBr, Unknown::Far) => "O plano de fundo está no infinito: B fica como estava.",
        (Lang::En, Unknown::Lens) => "Window, F and B are not in it: they stay as they were.",
        (Lang::PtBr, Unknown::Lens) => "Janela, F e B não estão nela: ficam como estavam.",
        (Lang::En, Unknown::Pose) => "C, PF and VUP are not in M_p: they stay as they were.",
        (Lang::PtBr, Unknown::Pose) => "C, PF e VUP não estão em M_p: ficam como estavam.",
        (Lang::En, Unknown::DepthDirection) => {
            "z grows towards the viewer there, as in no camera of [0]: the volume is the same, z_n changes sign."
        }
        (Lang::PtBr, Unknown::DepthDirection) => {
            "Ali z cresce rumo ao observador, como em nenhuma câmera de [0]: o volume é o mesmo, z_n troca de sinal."
        }
        (Lang::En, Unknown::LeftHandedView) => "The axes are left-handed, as in [3]: n is reversed.",
        (Lang::PtBr, Unknown::LeftHandedView) => "Os eixos são de mão esquerda, como em [3]: n é invertido.",
        (Lang::En, Unknown::Rounded) => {
            "Its axes are unit vectors at right angles only to within their digits: they were orthonormalised."
        }
        (Lang::PtBr, Unknown::Rounded) => {
            "Seus eixos só são versores perpendiculares até os seus dígitos: foram ortonormalizados."
        }
        (Lang::En, Unknown::Scaled) => {
            "Its columns do not have length 1: the object is scaled. A camera has no scale; it was divided out."
        }
        (Lang::PtBr, Unknown::Scaled) => {
            "Suas colunas não têm comprimento 1: o objeto tem escala. Uma câmera não tem; ela foi dividida fora."
        }
        (Lang::En, Unknown::WorldTurned) => {
            "z is up in that world: it was turned, (x, y, z) → (x, z, −y), so that y is up, as exporters of glTF do."
        }
        (Lang::PtBr, Unknown::WorldTurned) => {
            "Nesse mundo z é para cima: ele foi girado, (x, y, z) → (x, z, −y), para que y o seja, como fazem os exportadores de glTF."
        }
        (Lang::En, Unknown::ClippingPlanes) => "F and B are unknown: K [R | t] has none. They stay as they were.",
        (Lang::PtBr, Unknown::ClippingPlanes) => "F e B são desconhecidos: K [R | t] não os tem. Ficam como estavam.",
        (Lang::En, Unknown::ImageSize) => {
            "The size of the image is unknown: the window is that of the size given here. Pixels are counted from the corner, as in (5.22); OpenCV counts from the middle of the first, half a pixel less."
        }
        (Lang::PtBr, Unknown::ImageSize) => {
            "O tamanho da imagem é desconhecido: a janela é a do tamanho dado aqui. Os pixels se contam a partir do canto, como em (5.22); OpenCV conta a partir do meio do primeiro, meio pixel a menos."
        }
        (Lang::En, Unknown::PixelAspect) => "f_x and f_y differ: its pixels are not square, so A is not m/n.",
        (Lang::PtBr, Unknown::PixelAspect) => "f_x e f_y diferem: seus pixels não são quadrados, e A não é m/n.",
        (Lang::En, Unknown::SkewDropped) => "K has a skew of the size of its last digits: it was taken as 0.",
        (Lang::PtBr, Unknown::SkewDropped) => {
            "K tem uma obliquidade (skew) do tamanho dos seus últimos dígitos: foi tomada como 0."
        }
        (Lang::En, Unknown::SignReversed) => {
            "Its determinant is negative: all signs were reversed, because K [R | t] is known up to a factor. If its factor counts, the image is mirrored."
        }
        (Lang::PtBr, Unknown::SignReversed) => {
            "Seu determinante é negativo: todos os sinais foram trocados, pois K [R | t] só se conhece a menos de um fator. Se o fator conta, a imagem é espelhada."
        }
    }
}

/// Why a text is not a matrix.
#[must_use]
pub fn unreadable(lang: Lang, fault: &MatrixTextError) -> String {
    match (lang, fault) {
        (Lang::En, fault) => fault.to_string(),
        (Lang::PtBr, MatrixTextError::Count(count)) => {
            format!("{count} números; uma matriz tem 16, quatro linhas de quatro, ou 12: K [R | t]")
        }
        (Lang::PtBr, MatrixTextError::Part(part)) => format!("“{}” não é um número", escaped(part)),
    }
}

/// A line of a matrix, with its article.
const fn line(lines: Lines) -> &'static str {
    match lines {
        Lines::Rows => "a linha",
        Lines::Columns => "a coluna",
    }
}

/// Why a matrix is not that of a camera.
#[must_use]
pub fn recovery_error(lang: Lang, error: &RecoveryError) -> String {
    let number = |x: f64| lang.mark().number(x, 4);
    match (lang, error) {
        (_, RecoveryError::Camera(error)) => messages::camera(lang, error),
        (Lang::En, RecoveryError::Length { row, length }) => {
            format!("row {row} has length {}; the rows of a view matrix are unit vectors", number(*length))
        }
        (Lang::En, error) => error.to_string(),
        (Lang::PtBr, RecoveryError::NotFinite { row, column }) => {
            format!("o elemento {row},{column} não é um número finito")
        }
        (Lang::PtBr, RecoveryError::LastRow { last }) => format!(
            "a última linha é {}; a de uma câmera é 0 0 0 1 (vista, paralela) ou, a menos de um fator, −n e n·c (perspectiva: 0 0 −1 0)",
            last.to_array().map(number).join(" ")
        ),
        (Lang::PtBr, RecoveryError::Shear { lines, a, b, cosine }) => format!(
            "{} {a} e {} {b} não são perpendiculares (o cosseno entre elas é {}): um cisalhamento, que nenhuma câmera tem",
            line(*lines),
            line(*lines),
            number(*cosine)
        ),
        (Lang::PtBr, RecoveryError::Length { row, length }) => {
            format!("a linha {row} tem comprimento {}; as linhas de uma matriz de vista são versores", number(*length))
        }
        (Lang::PtBr, RecoveryError::NotZero { row, column, value }) => {
            format!("o elemento {row},{column} é {}; numa matriz de projeção ele é 0", number(*value))
        }
        (Lang::PtBr, RecoveryError::Mirrored) => {
            "ela espelha: esquerda e direita, ou em cima e embaixo, estão trocados, o que nenhuma câmera faz".to_owned()
        }
        (Lang::PtBr, RecoveryError::Singular { lines, at }) => {
            format!("{} {at} é zero: a matriz é singular", line(*lines))
        }
        (Lang::PtBr, RecoveryError::Skew { skew, focal_length }) => format!(
            "K tem obliquidade (skew) {} (f_x é {}): seus pixels são paralelogramos, o que nenhuma janela tem",
            number(*skew),
            number(*focal_length)
        ),
        (Lang::PtBr, RecoveryError::Affine) => {
            "a linha da profundidade é 0 0 0 w: uma câmera afim, cujo centro está no infinito".to_owned()
        }
        (Lang::PtBr, RecoveryError::Depths { near, far, fits }) => {
            let fits = fits.map_or_else(String::new, |ndc| format!("; lida como {}, é uma câmera", ndc.name()));
            format!("F e B seriam {} e {}, e é preciso 0 < F < B{fits}", number(*near), number(*far))
        }
    }
}
