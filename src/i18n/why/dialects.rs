//! The camera in other vocabularies, and a pasted matrix.

use crate::camera::{
    Assumed, Axes, Candidate, Certainty, Evidence, Lines, MatrixKind, MatrixTextError, NdcRange, Order, Reading,
    Reason, Recognised, RecoveryError, Unknown,
};
use crate::explain::vocabulary::{CameraNumber, Limitation, Vocabulary};
use crate::i18n::why::conventions::camera_axes;
use crate::i18n::{Lang, messages};
use crate::sanitize::escaped;

texts! {
    fixed_hint: "Follows from the others and cannot be set by itself", "Decorre dos outros e não pode ser definido sozinho";
    pasted: "A matrix → its camera", "Uma matriz → sua câmera";
    pasted_hint: "Paste a matrix, K, a quaternion and t, or a file of another program, as it prints it. The program recognises the matrix, its axes and its NDC as far as the numbers tell. NDC that aren't OpenGL's are those you chose under Conventions.",
        "Cole uma matriz, K, um quatérnio e t, ou um arquivo de outro programa, como ele os escreve. O programa reconhece a matriz, os eixos e as NDC até onde os números dizem; NDC diferentes das de OpenGL são as que você escolheu em Convenções.";
    recognise: "recognise", "reconhecer";
    kind: "The matrix is", "A matriz é";
    kind_hint: "What the matrix does. Camera → world is the inverse of M_v, such as matrix_world of Blender, a node of glTF or matrixWorld of three.js. K [R | t] leads to pixels.",
        "O que a matriz faz. Câmera → mundo é a inversa de M_v, como matrix_world do Blender, um nó de glTF ou matrixWorld de three.js. K [R | t] leva a pixels.";
    axes: "Axes", "Eixos";
    axes_hint: "The program or convention that has these axes", "O programa ou a convenção que tem estes eixos";
    why: "Why", "Por quê";
    instead: "Read it as", "Ler como";
    instead_hint: "Read this way, it gives another camera", "Assim ela dá outra câmera";
    camera: "Camera", "Câmera";
    camera_hint: "The text has several cameras. This is the one you see", "O texto tem várias câmeras. Esta é a que você vê";
    image: "Image of the matrix", "Imagem da matriz";
    image_hint: "The size in pixels of the image that K belongs to. It isn't in the matrix. The figure takes it on with the camera.",
        "O tamanho em pixels da imagem a que K pertence. Não está na matriz. A figura o recebe com a câmera.";
    to_perspective: "Make it a perspective", "Passar à perspectiva";
    to_perspective_hint: "The same camera in perspective. Things at PF keep their size", "A mesma câmera em perspectiva. O que está em PF mantém o tamanho";
    transposed: "row vectors, or by columns", "vetores linha, ou por colunas";
    transposed_hint: "The matrix is written for row vectors or by columns, so it's transposed", "A matriz foi escrita para vetores linha ou por colunas, e é transposta";
    try_transposed: "Transposed, it's the matrix of a camera. Choose “row vectors, or by columns”.", "Transposta, é a matriz de uma câmera. Escolha “vetores linha, ou por colunas”.";
    read_as: "Read in the convention", "Lida na convenção";
    take: "Take this camera", "Usar esta câmera";
    take_all: "Take all cameras", "Usar todas as câmeras";
    take_all_hint: "The first becomes the camera of the figure, and up to 32 others its list of cameras; Ctrl+Z undoes it", "A primeira passa a ser a câmera da figura, e até 32 outras, sua lista de câmeras; Ctrl+Z desfaz";
    take_hint: "The figure takes on the camera of the matrix; Ctrl+Z undoes it", "A figura recebe a câmera da matriz; Ctrl+Z desfaz";
}

/// The title of a vocabulary, and a name that no language changes.
pub fn title(lang: Lang, vocabulary: Vocabulary) -> (&'static str, &'static str) {
    match vocabulary {
        Vocabulary::OpenGl => ("OpenGL, GLU", "opengl"),
        Vocabulary::Vrc => pick!(lang; ("VRP, VPN, VUV: left-handed", "vrc"),
            ("VRP, VPN, VUV: mão esquerda", "vrc")),
        Vocabulary::ReferencePoint => pick!(lang; ("Reference point and view plane", "reference point"),
            ("Ponto de referência e plano de vista", "reference point")),
        Vocabulary::Pinhole => pick!(lang; ("K [R | t]: computer vision", "pinhole"),
            ("K [R | t]: visão computacional", "pinhole")),
    }
}

/// A limitation of a vocabulary, or a difference to the notes.
pub fn limitation(lang: Lang, limitation: Limitation) -> String {
    let text = match limitation {
        Limitation::SymmetricOnly => pick!(lang; "It can express only symmetric windows, and this one isn't.",
            "Só exprime janelas simétricas, e esta não é."),
        Limitation::PerspectiveOnly => pick!(lang; "It can express perspective only.",
            "Só exprime a perspectiva."),
        Limitation::NoClippingPlanes => pick!(lang; "F and B aren't part of it, so they stay as they are.",
            "F e B não fazem parte e ficam como estão."),
        Limitation::NoFocalPoint => pick!(lang; "PF isn't part of it, so it stays at its distance D.",
            "PF não faz parte e fica à distância D."),
        Limitation::ViewPlaneIsNear => pick!(lang;
            "Its view plane may lie anywhere. Here it's the front plane, so D = F and z_{vp} = −F.",
            "O plano de vista pode ficar em qualquer lugar. Aqui é o plano da frente, e assim D = F e z_{vp} = −F."),
        Limitation::LeftHanded => {
            pick!(lang; "It's left-handed, so n points into the scene, along DOP, and u = n × v.",
            "É de mão esquerda, e n aponta para a cena, ao longo de DOP, e u = n × v.")
        }
        Limitation::Coordinates => pick!(lang;
            "z_{near} and z_{far} are coordinates, negative. The lecture notes have the distances F and B.",
            "z_{near} e z_{far} são coordenadas, negativas. As notas de aula têm as distâncias F e B."),
        Limitation::YDown => {
            let axes = camera_axes(lang, Axes::OPENCV);
            return both!(lang; "{axes}; pixels from the corner of the image, as in (5.22).",
                "{axes}; pixels a partir do canto da imagem, como em (5.22).");
        }
    };
    text.to_owned()
}

/// The effect of a number on the camera.
pub fn number_hint(lang: Lang, quantity: CameraNumber) -> &'static str {
    match quantity {
        CameraNumber::Axis(..) => pick!(lang;
            "An entry of a rotation is a cosine, from −1 to 1. The camera turns about the origin until this entry has the number. R stays a rotation, so other entries change too. t doesn't change, so C = −Rᵀ t moves",
            "Um elemento de uma rotação é um cosseno, de −1 a 1. A câmera gira em torno da origem até que este elemento tenha o número. R continua uma rotação, e outros elementos mudam também. t não muda, e C = −Rᵀ t se move"),
        CameraNumber::Translation(_) => pick!(lang;
            "The world's origin in the axes of K. The camera moves along one of its own axes, without a turn",
            "A origem do mundo nos eixos de K. A câmera se move ao longo de um de seus eixos, sem girar"),
        CameraNumber::FocalLength(_) => pick!(lang;
            "The focal length in pixels. If it's greater, the window is smaller and things look larger",
            "A distância focal em pixels. Se é maior, a janela é menor e as coisas parecem maiores"),
        CameraNumber::PrincipalPoint(_) => pick!(lang;
            "The pixel where DOP meets the image. It moves the window off the axis",
            "O pixel em que DOP encontra a imagem. Ele desloca a janela em relação ao eixo"),
        _ => pick!(lang; "Sets the camera", "Define a câmera"),
    }
}

/// The kind of a matrix.
pub fn kind(lang: Lang, kind: MatrixKind) -> &'static str {
    match kind {
        MatrixKind::View => pick!(lang; "M_v: view", "M_v: vista"),
        MatrixKind::Projection => pick!(lang; "M_p: projection", "M_p: projeção"),
        MatrixKind::ViewProjection => pick!(lang; "M_p M_v: both", "M_p M_v: as duas"),
        MatrixKind::CameraToWorld => pick!(lang; "camera → world", "câmera → mundo"),
        MatrixKind::Pinhole => "K [R | t]",
        MatrixKind::Intrinsics => pick!(lang; "K alone", "só K"),
        MatrixKind::LookAt => "C, PF, VUP",
    }
}

/// The order of the numbers.
pub fn order(lang: Lang, order: Order) -> &'static str {
    match order {
        Order::Rows => pick!(lang; "by rows", "por linhas"),
        Order::Columns => pick!(lang; "by columns", "por colunas"),
        Order::RotationThenTranslation => pick!(lang; "R by rows, then t", "R por linhas, depois t"),
        Order::WxyzThenT => pick!(lang; "a quaternion w x y z, then t", "um quatérnio w x y z, depois t"),
        Order::XyzwThenT => pick!(lang; "a quaternion x y z w, then t", "um quatérnio x y z w, depois t"),
        Order::TThenXyzw => pick!(lang; "t, then a quaternion x y z w", "t, depois um quatérnio x y z w"),
        Order::TThenWxyz => pick!(lang; "t, then a quaternion w x y z", "t, depois um quatérnio w x y z"),
    }
}

/// The way a matrix was read, and the reason.
pub fn reading(lang: Lang, candidate: &Candidate, evidence: Evidence) -> String {
    let Reading { kind: of, axes: whose, ndc, .. } = candidate.reading;
    let (kind, axes) = (kind(lang, of), whose.title);
    let mut said = both!(lang; "Read as {kind}", "Lida como {kind}");
    if of.has_camera_axes() {
        said += &both!(lang; " in the axes of {axes}", " nos eixos de {axes}");
    }
    if of.has_ndc() {
        let ndc = ndc.name();
        said += &both!(lang; " for the NDC {ndc}", " para o NDC {ndc}");
    }
    if candidate.order != Order::Rows {
        said += ", ";
        said += order(lang, candidate.order);
    }
    said + match (evidence, candidate.certainty) {
        (Evidence::Level, _) => pick!(lang; ": only then is the camera level and upright.",
            ": só assim a câmera fica nivelada e de pé."),
        (Evidence::OriginAhead, _) => pick!(lang; ": only then is the origin in front of it.",
            ": só assim a origem fica diante dela."),
        (_, Certainty::Only) => ".",
        (_, Certainty::Likely) => pick!(lang; ". This is likely, not certain.", ". É provável, não certo."),
        (_, Certainty::Open) => pick!(lang; ". Its numbers fit other readings as well.",
            ". Os números servem também a outras leituras."),
    }
}

/// Evidence for a reading, or against it.
pub fn reason(lang: Lang, reason: Reason) -> String {
    let text = match reason {
        Reason::Word(word) => return both!(lang; "the text says {word}", "o texto diz {word}"),
        Reason::Level => pick!(lang; "the camera is level", "a câmera está nivelada"),
        Reason::Upright => pick!(lang; "the camera is upright", "a câmera está de pé"),
        Reason::UpsideDown => {
            pick!(lang; "against it: the camera is upside down", "contra: a câmera está de cabeça para baixo")
        }
        Reason::OriginAhead => pick!(lang; "the camera looks towards the origin", "a câmera olha para a origem"),
        Reason::OriginBehind => pick!(lang; "against it: the camera looks away from the origin",
            "contra: a câmera dá as costas à origem"),
        Reason::RoundPosition => pick!(lang; "C has short coordinates", "C tem coordenadas curtas"),
        Reason::RoundPlanes => pick!(lang; "F or B is a short number", "F ou B é um número curto"),
        Reason::ProjectionPattern => pick!(lang; "the zeros and ±1 are those of a projection",
            "os zeros e o ±1 são os de uma projeção"),
        Reason::Pixels => pick!(lang; "f and the principal point are those of an image",
            "f e o ponto principal são os de uma imagem"),
        Reason::Unusual => pick!(lang; "against it: θ, A, the middle of the window or B/F is unusual",
            "contra: θ, A, o meio da janela ou B/F é incomum"),
    };
    text.to_owned()
}

/// A part of the first reading that was assumed, and the camera otherwise.
pub fn assumed(lang: Lang, found: &Recognised, assumed: Assumed) -> String {
    let best = found.best();
    let other = |at: usize| found.readings.get(at).unwrap_or(best);
    match assumed {
        Assumed::Kind(at) => {
            let (name, camera) = (kind(lang, other(at).reading.kind), camera(lang, other(at)));
            both!(lang; "As {name} it has {camera}.", "Como {name}, tem {camera}.")
        }
        Assumed::Axes(at) => {
            let (taken, name) = (best.reading.axes.title, other(at).reading.axes.title);
            let camera = camera(lang, other(at));
            both!(lang; "The axes are those of {taken}. In those of {name} it has {camera}.",
                "Os eixos são os de {taken}. Nos de {name}, tem {camera}.")
        }
        Assumed::Order(at) => {
            let (taken, name) = (order(lang, best.order), order(lang, other(at).order));
            let camera = camera(lang, other(at));
            both!(lang; "The order is: {taken}. If it's {name}, it has {camera}.",
                "A ordem é: {taken}. Se for {name}, tem {camera}.")
        }
        Assumed::Ndc(at) => {
            let [taken, name] = [best, other(at)].map(|c| ndc(c.reading.ndc));
            let camera = camera(lang, other(at));
            both!(lang; "The NDC are {taken}. In {name} it has {camera}.", "O NDC é {taken}. Em {name}, tem {camera}.")
        }
        Assumed::Image(size) => {
            let [m, n] = [size.width, size.height];
            both!(lang; "The image has {m} × {n} pixels, which K doesn't say.", "A imagem tem {m} × {n} pixels, o que K não diz.")
        }
    }
}

/// A range of NDC with its depths.
fn ndc(ndc: NdcRange) -> String {
    let NdcRange { at_near, at_far, .. } = ndc;
    let depths = format!("z_n {at_near} … {at_far}").replace('-', "−");
    format!("{} ({depths})", ndc.name())
}

/// The numbers of another reading's camera.
fn camera(lang: Lang, candidate: &Candidate) -> String {
    let p = &candidate.found.parameters;
    let mark = lang.mark();
    if candidate.reading.kind == MatrixKind::Projection {
        let [near, far] = [p.near, p.far].map(|x| mark.number(x, 4));
        return format!("F = {near}, B = {far}");
    }
    let tuple = |v: glam::DVec3| mark.tuple(&v.to_array(), 4);
    let dop = (p.focal_point - p.position).normalize_or_zero();
    let mut said = format!("C = {}, DOP = {}", tuple(p.position), tuple(dop));
    if candidate.reading.kind == MatrixKind::ViewProjection {
        let [near, far] = [p.near, p.far].map(|x| mark.number(x, 4));
        said += &format!(", F = {near}, B = {far}");
    }
    said
}

/// A quantity that a matrix leaves open.
pub fn unknown(lang: Lang, unknown: Unknown) -> &'static str {
    match unknown {
        Unknown::FocalDistance => {
            pick!(lang; "D is unknown, because a direction has no length. PF keeps its distance.",
            "D é desconhecido, pois uma direção não tem comprimento. PF mantém a distância.")
        }
        Unknown::ViewUp => pick!(lang; "VUP is unknown, only v is known. The present VUP stays if it fits.",
            "VUP é desconhecido, só se conhece v. O VUP atual fica, se servir."),
        Unknown::PositionAlongNormal => pick!(lang;
            "In parallel projection C may lie anywhere along n. It's put so that F doesn't change.",
            "Em projeção paralela C pode ficar em qualquer lugar ao longo de n. É posto de modo que F não mude."),
        Unknown::WindowCentre => pick!(lang;
            "An off-axis window and a C shifted sideways give the same matrix. The window is taken as symmetric.",
            "Uma janela fora do eixo e um C deslocado dão a mesma matriz. Supõe-se a janela simétrica."),
        Unknown::Far => pick!(lang; "The back plane is at infinity: B stays as it was.",
            "O plano de fundo está no infinito: B fica como estava."),
        Unknown::Lens => pick!(lang; "Window, F and B aren't in it, so they stay as they were.",
            "Janela, F e B não estão nela e ficam como estavam."),
        Unknown::Pose => pick!(lang; "C, PF and VUP aren't in this matrix, so they stay as they were.",
            "C, PF e VUP não estão nesta matriz e ficam como estavam."),
        Unknown::DepthDirection => pick!(lang;
            "z grows towards the viewer there, as in no camera of the lecture notes. The volume is the same, but z_n changes sign.",
            "Ali z cresce rumo ao observador, como em nenhuma câmera das notas de aula. O volume é o mesmo, mas z_n troca de sinal."),
        Unknown::LeftHandedView => pick!(lang; "The axes are left-handed, as in the pipeline notes, so n is reversed.",
            "Os eixos são de mão esquerda, como nas notas do pipeline, e n é invertido."),
        Unknown::Rounded => pick!(lang;
            "Its axes are unit vectors at right angles only to within their digits, so they were orthonormalised.",
            "Seus eixos só são versores perpendiculares até onde vão os dígitos, e foram ortonormalizados."),
        Unknown::Scaled => pick!(lang;
            "Its columns don't have length 1, so the object is scaled. A camera has no scale, so it was divided out.",
            "As colunas não têm comprimento 1, pois o objeto tem escala. Uma câmera não tem, e a escala foi eliminada."),
        Unknown::WorldTurned => pick!(lang;
            "z is up in that world. It was turned, (x, y, z) → (x, z, −y), so that y is up, as exporters of glTF do.",
            "Nesse mundo z é para cima. Ele foi girado, (x, y, z) → (x, z, −y), para que y aponte para cima, como fazem os exportadores de glTF."),
        Unknown::WorldMirrored => pick!(lang;
            "That world is left-handed. Its z was reversed, (x, y, z) → (x, y, −z), so that the image is not mirrored.",
            "Esse mundo é de mão esquerda. Seu z foi invertido, (x, y, z) → (x, y, −z), para que a imagem não fique espelhada."),
        Unknown::WorldExchanged => pick!(lang;
            "That world is left-handed with z up. So y and z were exchanged, (x, y, z) → (x, z, y), so that y is up and the image is not mirrored.",
            "Esse mundo é de mão esquerda e nele z é para cima. Por isso y e z foram trocados, (x, y, z) → (x, z, y), para que y seja para cima e a imagem não fique espelhada."),
        Unknown::ClippingPlanes => pick!(lang; "F and B are unknown: K [R | t] has none. They stay as they were.",
            "F e B são desconhecidos: K [R | t] não os tem. Ficam como estavam."),
        Unknown::ImageSize => pick!(lang;
            "The size of the image is unknown, so the window is that of the size given here. Pixels are counted from the corner, as in (5.22). OpenCV counts from the middle of the first, half a pixel less.",
            "O tamanho da imagem é desconhecido, e a janela é a do tamanho dado aqui. Os pixels se contam a partir do canto, como em (5.22). OpenCV conta a partir do meio do primeiro, meio pixel a menos."),
        Unknown::PixelAspect => pick!(lang; "f_x and f_y differ. Its pixels aren't square, so A isn't m/n.",
            "f_x e f_y diferem. Os pixels não são quadrados, e A não é m/n."),
        Unknown::SkewDropped => pick!(lang; "K has a skew of the size of its last digits. It was taken as 0.",
            "K tem uma obliquidade (skew) do tamanho dos seus últimos dígitos. Foi considerada 0."),
        Unknown::SignReversed => pick!(lang;
            "Its determinant is negative. All signs were reversed, because K [R | t] is known up to a factor. If its factor counts, the image is mirrored.",
            "O determinante é negativo. Todos os sinais foram trocados, pois K [R | t] só se conhece a menos de um fator. Se o fator conta, a imagem é espelhada."),
        Unknown::PrincipalPoint => pick!(lang;
            "The principal point lies far from the middle of the image, which is unlikely. Is K that of another image size?",
            "O ponto principal fica longe do meio da imagem, o que é improvável: K é de outro tamanho de imagem?"),
        Unknown::ImageTurned => pick!(lang;
            "The principal point is the middle of the image with its sides exchanged. Is K that of n × m pixels?",
            "O ponto principal é o meio da imagem de lados trocados: K é de n × m pixels?"),
        Unknown::WideAngle => pick!(lang; "The angle of the image is greater than 150°, which is unlikely.",
            "O ângulo da imagem é maior que 150°, o que é improvável."),
        Unknown::NormalisedPixels => {
            pick!(lang; "K is normalised. Its numbers are fractions of the sides of the image.",
            "K é normalizada. Os números são frações dos lados da imagem.")
        }
    }
}

/// The reason why a text isn't a matrix.
pub fn unreadable(lang: Lang, fault: &MatrixTextError) -> String {
    translated! { lang, fault;
        MatrixTextError::Count(count) =>
            "{count} números; uma matriz tem 16, quatro linhas de quatro, ou 12: K [R | t], ou 9: K, ou 7: um quatérnio e t";
        MatrixTextError::NoCamera(format) => "não há câmera nele; {format} não tem nenhuma das chaves de uma câmera";
        MatrixTextError::NotText => "não é texto nem GLB";
        MatrixTextError::Elided => "“...” está no lugar de números que foram omitidos; escreva todos";
        MatrixTextError::Part(part) => "“{}” não é um número" (escaped(part));
    }
}

/// A line of a matrix, with its article.
const fn line(lines: Lines) -> &'static str {
    match lines {
        Lines::Rows => "a linha",
        Lines::Columns => "a coluna",
    }
}

/// The reason why a matrix isn't that of a camera.
pub fn recovery_error(lang: Lang, error: &RecoveryError) -> String {
    let number = |x: f64| lang.mark().number(x, 4);
    if let (Lang::En, RecoveryError::Length { row, length }) = (lang, error) {
        return format!("row {row} has length {}; the rows of a view matrix are unit vectors", number(*length));
    }
    translated! { lang, error;
        RecoveryError::Camera(error) => "{}" (messages::camera(lang, error));
        RecoveryError::Length { row, length } =>
            "a linha {row} tem comprimento {}; as linhas de uma matriz de vista são versores" (number(*length));
        RecoveryError::NotFinite { row, column, value } =>
            "o elemento {row},{column} é {value}, que não é um número finito";
        RecoveryError::ViewUpAlongView { lines, a, b } =>
            "{0} {a} e {0} {b} são zero: u e v não têm comprimento, como num look-at cujo VUP está ao longo da vista; a matriz é singular" (line(*lines));
        RecoveryError::Determinant =>
            "o determinante é 0: a matriz é singular, e pontos diferentes teriam a mesma imagem e profundidade";
        RecoveryError::NoPixels { focal_length, x, y } =>
            "como K [R | t], f seria {} e o ponto principal ({}, {}): não são pixels de uma imagem" (number(*focal_length), number(*x), number(*y));
        RecoveryError::RotationAlone =>
            "nove números são K, de linhas f_x s c_x, 0 f_y c_y e 0 0 1, ou C, PF e VUP; estes são uma rotação, à qual falta t";
        RecoveryError::NotIntrinsics { row, column, value, expected } =>
            "o elemento {row},{column} é {}; em K ele é {expected}" (number(*value));
        RecoveryError::Hand { left, title } =>
            "ali os eixos são de mão {}, e os de {title} não são" (if *left { "esquerda" } else { "direita" });
        RecoveryError::Quaternion =>
            "sete números são um quatérnio e t, ou t e um quatérnio; nem os quatro primeiros nem os quatro últimos têm comprimento 1";
        RecoveryError::LastRow { last } =>
            "a última linha é {}; a de uma câmera é 0 0 0 1 (vista, paralela) ou, a menos de um fator, −n e n·c (perspectiva: 0 0 −1 0)" (last.to_array().map(number).join(" "));
        RecoveryError::Shear { lines, a, b, cosine } =>
            "{0} {a} e {0} {b} não são perpendiculares (o cosseno entre elas é {1}): um cisalhamento, que nenhuma câmera tem" (line(*lines), number(*cosine));
        RecoveryError::NotZero { row, column, value } =>
            "o elemento {row},{column} é {}; numa matriz de projeção ele é 0" (number(*value));
        RecoveryError::Mirrored =>
            "ela espelha: esquerda e direita, ou em cima e embaixo, estão trocados, o que nenhuma câmera faz";
        RecoveryError::Singular { lines, at } => "{} {at} é zero: a matriz é singular" (line(*lines));
        RecoveryError::Skew { skew, focal_length } =>
            "K tem obliquidade (skew) {} (f_x é {}): seus pixels são paralelogramos, o que nenhuma janela tem" (number(*skew), number(*focal_length));
        RecoveryError::Affine => "a linha da profundidade é 0 0 0 w: uma câmera afim, cujo centro está no infinito";
        RecoveryError::Depths { near, far, fits } =>
            "F e B seriam {} e {}, e é preciso 0 < F < B (na projeção paralela, F < B){}" (number(*near), number(*far), fits.map_or_else(String::new, |ndc| format!("; lida como {}, é uma câmera", ndc.name())));
    }
}

/// A camera that a file doesn't have, and those that it has.
pub fn no_such_camera(lang: Lang, wanted: &str, names: &[String]) -> String {
    let (wanted, names) = (escaped(wanted), escaped(&names.join(", ")).to_string());
    if names.is_empty() {
        return both!(lang; "there is only one camera, and it isn't “{wanted}”", "há uma só câmera, e “{wanted}” não é ela");
    }
    both!(lang; "no camera “{wanted}”; there are {names}", "não há câmera “{wanted}”; há {names}")
}
