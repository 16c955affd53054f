//! The camera in other vocabularies, and a pasted matrix.

use crate::camera::{
    Assumed, Axes, Candidate, Certainty, Evidence, LeftOut, Lines, MatrixKind, MatrixTextError, NdcRange, Order,
    Reading, Reason, Recognised, RecoveryError, Unknown, Why,
};
use crate::explain::vocabulary::{CameraNumber, Limitation, Vocabulary};
use crate::sanitize::escaped;
use crate::why::conventions::camera_axes;
use crate::{Grammar, messages};

texts!("why/dialects");

/// The title of a vocabulary, and a name that no language changes.
pub fn title(lang: Lang, vocabulary: Vocabulary) -> (&'static str, &'static str) {
    match vocabulary {
        Vocabulary::OpenGl => ("OpenGL, GLU", "opengl"),
        Vocabulary::Vrc => (text!(lang, title_vrc), "vrc"),
        Vocabulary::ReferencePoint => (text!(lang, title_reference_point), "reference point"),
        Vocabulary::Pinhole => (text!(lang, title_pinhole), "pinhole"),
    }
}

/// A limitation of a vocabulary, or a difference to the notes.
pub fn limitation(lang: Lang, limitation: Limitation) -> String {
    let text = match limitation {
        Limitation::SymmetricOnly => text!(lang, limitation_symmetric_only),
        Limitation::PerspectiveOnly => text!(lang, limitation_perspective_only),
        Limitation::OutOfRange => text!(lang, limitation_out_of_range),
        Limitation::NoClippingPlanes => text!(lang, limitation_no_clipping_planes),
        Limitation::NoFocalPoint => text!(lang, limitation_no_focal_point),
        Limitation::ViewPlaneIsNear => text!(lang, limitation_view_plane_is_near),
        Limitation::LeftHanded => {
            text!(lang, limitation_left_handed)
        }
        Limitation::Coordinates => text!(lang, limitation_coordinates),
        Limitation::YDown => {
            let axes = camera_axes(lang, Axes::OPENCV);
            return text!(lang, limitation_ydown, axes);
        }
    };
    text.to_owned()
}

/// The effect of a number on the camera.
pub fn number_hint(lang: Lang, quantity: CameraNumber) -> &'static str {
    match quantity {
        CameraNumber::Axis(..) => text!(lang, number_hint_axis),
        CameraNumber::Translation(_) => text!(lang, number_hint_translation),
        CameraNumber::FocalLength(_) => text!(lang, number_hint_focal_length),
        CameraNumber::PrincipalPoint(_) => text!(lang, number_hint_principal_point),
        _ => text!(lang, number_hint_sets),
    }
}

/// The kind of a matrix.
pub fn kind(lang: Lang, kind: MatrixKind) -> &'static str {
    match kind {
        MatrixKind::View => text!(lang, kind_view),
        MatrixKind::Projection => text!(lang, kind_projection),
        MatrixKind::ViewProjection => text!(lang, kind_view_projection),
        MatrixKind::CameraToWorld => text!(lang, kind_camera_to_world),
        MatrixKind::Pinhole => "K [R | t]",
        MatrixKind::Intrinsics => text!(lang, kind_intrinsics),
        MatrixKind::LookAt => "C, PF, VUP",
    }
}

/// The order of the numbers.
pub fn order(lang: Lang, order: Order) -> &'static str {
    match order {
        Order::Rows => text!(lang, order_rows),
        Order::Columns => text!(lang, order_columns),
        Order::RotationThenTranslation => text!(lang, order_rotation_then_translation),
        Order::WxyzThenT => text!(lang, order_wxyz_then_t),
        Order::XyzwThenT => text!(lang, order_xyzw_then_t),
        Order::TThenXyzw => text!(lang, order_tthen_xyzw),
        Order::TThenWxyz => text!(lang, order_tthen_wxyz),
    }
}

/// The way a matrix was read, and the reason.
pub fn reading(lang: Lang, candidate: &Candidate, evidence: Evidence) -> String {
    let Reading { kind: of, axes: whose, ndc, .. } = candidate.reading;
    let (kind, axes) = (kind(lang, of), whose.title);
    let mut said = text!(lang, reading_said, kind);
    if of.has_camera_axes() {
        said += &text!(lang, reading_of, axes);
    }
    if of.has_ndc() {
        let ndc = ndc.name();
        said += &text!(lang, reading_of_ndc, ndc);
    }
    if candidate.order != Order::Rows {
        said += ", ";
        said += order(lang, candidate.order);
    }
    said + match (evidence, candidate.certainty) {
        (Evidence::Level, _) => text!(lang, reading_level),
        (Evidence::OriginAhead, _) => text!(lang, reading_origin_ahead),
        (_, Certainty::Only) => ".",
        (_, Certainty::Likely) => text!(lang, reading_likely),
        (_, Certainty::Open) => text!(lang, reading_open),
    }
}

/// Evidence for a reading, or against it.
pub fn reason(lang: Lang, reason: Reason) -> String {
    let text = match reason {
        Reason::Word(word) => return text!(lang, reason_word, word),
        Reason::Level => text!(lang, reason_level),
        Reason::Upright => text!(lang, reason_upright),
        Reason::UpsideDown => {
            text!(lang, reason_upside_down)
        }
        Reason::OriginAhead => text!(lang, reason_origin_ahead),
        Reason::OriginBehind => text!(lang, reason_origin_behind),
        Reason::RoundPosition => text!(lang, reason_round_position),
        Reason::RoundPlanes => text!(lang, reason_round_planes),
        Reason::ProjectionPattern => text!(lang, reason_projection_pattern),
        Reason::Pixels => text!(lang, reason_pixels),
        Reason::Unusual => text!(lang, reason_unusual),
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
            text!(lang, assumed_kind, name, camera)
        }
        Assumed::Axes(at) => {
            let (taken, name) = (best.reading.axes.title, other(at).reading.axes.title);
            let camera = camera(lang, other(at));
            text!(lang, assumed_axes, taken, name, camera)
        }
        Assumed::Order(at) => {
            let (taken, name) = (order(lang, best.order), order(lang, other(at).order));
            let camera = camera(lang, other(at));
            text!(lang, assumed_order, taken, name, camera)
        }
        Assumed::Ndc(at) => {
            let [taken, name] = [best, other(at)].map(|c| ndc(c.reading.ndc));
            let camera = camera(lang, other(at));
            text!(lang, assumed_ndc, taken, name, camera)
        }
        Assumed::Image(size) => {
            let [m, n] = [size.width, size.height];
            text!(lang, assumed_image, m, n)
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
            text!(lang, unknown_focal_distance)
        }
        Unknown::ViewUp => text!(lang, unknown_view_up),
        Unknown::PositionAlongNormal => text!(lang, unknown_position_along_normal),
        Unknown::WindowCentre => text!(lang, unknown_window_centre),
        Unknown::Far => text!(lang, unknown_far),
        Unknown::Lens => text!(lang, unknown_lens),
        Unknown::Window => text!(lang, unknown_window),
        Unknown::Pose => text!(lang, unknown_pose),
        Unknown::RigOrigin => text!(lang, unknown_rig_origin),
        Unknown::DepthDirection => text!(lang, unknown_depth_direction),
        Unknown::LeftHandedView => text!(lang, unknown_left_handed_view),
        Unknown::Rounded => text!(lang, unknown_rounded),
        Unknown::Scaled => text!(lang, unknown_scaled),
        Unknown::WorldTurned => text!(lang, unknown_world_turned),
        Unknown::WorldMirrored => text!(lang, unknown_world_mirrored),
        Unknown::WorldExchanged => text!(lang, unknown_world_exchanged),
        Unknown::ClippingPlanes => text!(lang, unknown_clipping_planes),
        Unknown::ImageSize => text!(lang, unknown_image_size),
        Unknown::PixelAspect => text!(lang, unknown_pixel_aspect),
        Unknown::SkewDropped => text!(lang, unknown_skew_dropped),
        Unknown::SignReversed => text!(lang, unknown_sign_reversed),
        Unknown::PrincipalPoint => text!(lang, unknown_principal_point),
        Unknown::ImageTurned => text!(lang, unknown_image_turned),
        Unknown::WideAngle => text!(lang, unknown_wide_angle),
        Unknown::NormalisedPixels => {
            text!(lang, unknown_normalised_pixels)
        }
    }
}

/// The reason why an entry of a file isn't in the camera.
pub fn left_out(lang: Lang, left: &LeftOut) -> String {
    let text = match &left.why {
        Why::Distortion { model, pixels } => {
            let model = if model.is_empty() { "k" } else { model };
            let (model, value) = (escaped(model), escaped(&left.value));
            return match pixels {
                Some(pixels) => {
                    let pixels = lang.mark().number(*pixels, 3);
                    text!(lang, left_distortion_by, model, value, pixels)
                }
                None => text!(lang, left_distortion, model, value),
            };
        }
        Why::Unknown => text!(lang, left_unknown),
        Why::NotUsed => text!(lang, left_not_used),
        Why::Repeated => text!(lang, left_repeated),
        Why::Overridden => text!(lang, left_overridden),
        Why::SaysNothing => text!(lang, left_says_nothing),
        Why::Zero => text!(lang, left_zero),
        Why::BeforeRectification => text!(lang, left_before_rectification),
        Why::NotCamera => text!(lang, left_not_camera),
        Why::Fisheye => text!(lang, left_fisheye),
    };
    text.to_owned()
}

/// How many cameras of a file were taken.
pub fn taken(lang: Lang, count: usize, all: usize) -> String {
    text!(lang, taken, count, all)
}

/// A camera of a file that isn't taken.
pub fn not_taken(lang: Lang, name: &str, error: Option<&RecoveryError>) -> String {
    let name = escaped(name);
    match error {
        Some(error) => {
            let why = recovery_error(lang, error);
            text!(lang, not_taken_because, name, why)
        }
        None => text!(lang, not_taken_full, name),
    }
}

/// The reason why a text isn't a matrix.
pub fn unreadable(lang: Lang, fault: &MatrixTextError) -> String {
    translated! { lang, fault;
        MatrixTextError::Count(count) =>
            "{count} números, e nenhum nome diz o que são; sem nomes são lidos 16 números (uma matriz), 12 (K [R | t], ou R e t), 9 (K, ou C, PF e VUP) ou 7 (um quatérnio e t); o guia “Câmeras de outros programas” lista os arquivos e nomes que são lidos";
        MatrixTextError::NoCamera(format) => "não há câmera nele; {format} não tem nenhuma das chaves de uma câmera";
        MatrixTextError::NotText => "não é texto nem GLB";
        MatrixTextError::Elided => "“...” está no lugar de números que foram omitidos; escreva todos";
        MatrixTextError::Latex =>
            "LaTeX com várias matrizes não pode ser lido; cole apenas os números de M_v, ou os de M_p";
        MatrixTextError::NotCamera(name) =>
            "{} não é a matriz de uma câmera, pelo nome; cole K, R e t, ou uma matriz de vista ou de projeção" (escaped(name));
        MatrixTextError::Incomplete(names) =>
            "{} não pode ser lido como uma câmera: uma pose precisa de uma posição e de suas direções, de R e t, ou de um quatérnio e t; o guia “Câmeras de outros programas” lista os nomes que são lidos" (escaped(names));
        MatrixTextError::Range { name, value, allowed } => "{} é {value}; permitido: {allowed}" (escaped(name));
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
    if let (Grammar::English, RecoveryError::Length { row, length }) = (lang.grammar(), error) {
        return format!("row {row} has length {}; the rows of a view matrix are unit vectors", number(*length));
    }
    translated! { lang, error;
        RecoveryError::Camera(error) => "{}" (messages::camera(lang, error));
        RecoveryError::Unread(fault) => "{}" (unreadable(lang, fault));
        RecoveryError::Disparity =>
            "ela leva um pixel e sua disparidade a um ponto (Q de stereoRectify), o que nenhuma câmera faz; cole P1 ou P2";
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
        return text!(lang, no_such_camera_names, wanted);
    }
    text!(lang, no_such_camera, wanted, names)
}
