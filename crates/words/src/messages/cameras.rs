//! Faults and warnings of a camera, an operation or a query about it, in both languages.
//!
//! Keys, words of the figure file, and numbers are the same in every language. Each function is one exhaustive `match`,
//! so an error without a text doesn't compile.

use super::expressions::in_expression;
use super::wording::Wording;
use crate::camera::{
    Amount, CameraError, Checked, Derived, Descriptor, InfiniteParallel, NotProjectable, Operation, OperationError,
    ParameterKey, Range, Warning, is_infinite_far,
};
use crate::inspect::InspectError;
use crate::sanitize::escaped;
use crate::{Grammar, Lang};

/// The reason why parameters aren't a camera, with the keys concerned and the values allowed.
pub fn camera(lang: Lang, error: &CameraError) -> String {
    camera_wording(lang, error).full
}

/// The reason why parameters aren't a camera. The full form in English is the error's own.
pub(crate) fn camera_wording(lang: Lang, error: &CameraError) -> Wording {
    let english = |in_symbols: &str| Wording::new(error.to_string(), in_symbols);
    match (lang.grammar(), error) {
        (_, CameraError::FocalPointAtPosition) => pick!(lang; english("PF must differ from C"),
            Wording::new("focal_point é o mesmo ponto que position; permitido: qualquer outro ponto", "PF tem de ser diferente de C")),
        (_, CameraError::ViewUpZero) => pick!(lang; english("VUP must not be zero"),
            Wording::new("view_up é o vetor nulo; permitido: qualquer outro vetor não colinear com focal_point − position", "VUP não pode ser nulo")),
        (_, CameraError::ViewUpCollinear) => pick!(lang; english("VUP must not be collinear with DOP = PF − C"),
            Wording::new("view_up é colinear com focal_point − position; permitido: qualquer vetor que aponte para outro lado", "VUP não pode ser colinear com DOP = PF − C")),
        (_, CameraError::OutOfRange { key, value, allowed }) => {
            let allowed = range(lang, *allowed);
            let symbol = key.symbol();
            pick!(lang; english(&format!("{symbol} must be {}", allowed.in_symbols)),
                Wording::new(format!("{key} é {value:?}; permitido: {}{}", allowed.full, way_out(*key, *value)), format!("{symbol} tem de ser {}", allowed.in_symbols)))
        }
        (Grammar::English, CameraError::FarNotBeyondNear { .. }) => english("F must be less than B"),
        (Grammar::Portuguese, CameraError::FarNotBeyondNear { near, far }) => Wording::new(
            format!(
                "near é {near:?} e far é {far:?}; permitido: near < far, e na perspectiva 0 < near; para profundidades invertidas, mantenha essa ordem e use --ndc NOME-reversed"
            ),
            "F tem de ser menor que B",
        ),
        (Grammar::English, CameraError::WindowWidth { .. }) => english("l must be less than r"),
        (Grammar::Portuguese, CameraError::WindowWidth { left, right }) => Wording::new(
            format!("window: left é {left:?} e right é {right:?}; permitido: left < right"),
            "l tem de ser menor que r",
        ),
        (Grammar::English, CameraError::WindowHeight { .. }) => english("b must be less than t"),
        (Grammar::Portuguese, CameraError::WindowHeight { bottom, top }) => Wording::new(
            format!("window: bottom é {bottom:?} e top é {top:?}; permitido: bottom < top"),
            "b tem de ser menor que t",
        ),
        (_, CameraError::Overflow { quantity, keys }) => {
            let quantity = derived(lang, *quantity);
            pick!(lang; english(&format!("{} would exceed the range of numbers (about 1e-308 to 1e308)", quantity.in_symbols)),
                Wording::new(format!("{} excederia os limites dos números (cerca de 1e-308 a 1e308); depende de {}", quantity.full, ParameterKey::list(keys)), format!("{} sairia da faixa dos números (cerca de 1e-308 a 1e308)", quantity.in_symbols)))
        }
        (_, other) => Wording::new(other.to_string(), other.to_string()),
    }
}

/// The remedy for a value out of its range, in Portuguese.
fn way_out(key: Checked, value: f64) -> &'static str {
    if is_infinite_far(key, value) { "; para B → ∞, deixe far finito e use --ndc NOME-infinite" } else { "" }
}

fn range(lang: Lang, range: Range) -> Wording {
    let english = |in_symbols: &str| Wording::new(range.to_string(), in_symbols);
    match range {
        Range::Finite => pick!(lang; english("a finite number"),
            Wording::new("um número finito", "um número finito")),
        Range::Positive => pick!(lang; english("greater than 0"),
            Wording::new("um número finito maior que 0", "maior que 0")),
        Range::HalfTurn => pick!(lang; english("greater than 0° and less than 180°"),
            Wording::new("maior que 0 e menor que 180 graus", "maior que 0° e menor que 180°")),
    }
}

fn derived(lang: Lang, quantity: Derived) -> Wording {
    let english = |in_symbols: &str| Wording::new(quantity.to_string(), in_symbols);
    match quantity {
        Derived::Distance => pick!(lang; english("The distance D"),
            Wording::new("a distância de position a focal_point", "A distância D")),
        Derived::Window => pick!(lang; english("The view window"),
            Wording::new("a janela de vista", "A janela de vista")),
        Derived::ViewMatrix => pick!(lang; english("The view matrix"),
            Wording::new("a matriz de vista", "A matriz de vista")),
        Derived::ProjectionMatrix => pick!(lang; english("The projection matrix"),
            Wording::new("a matriz de projeção", "A matriz de projeção")),
        Derived::ViewProjectionMatrix => pick!(lang; english("The product of the matrices"),
            Wording::new("o produto das matrizes de projeção e de vista", "O produto das matrizes")),
        Derived::VolumeCorners => pick!(lang; english("A corner of the view volume"),
            Wording::new("os vértices do volume de vista", "Um vértice do volume de vista")),
    }
}

/// The reason why a text isn't an operation.
pub fn operation(lang: Lang, error: &OperationError) -> String {
    let names = || Operation::names().join(", ");
    translated! { lang, error;
        OperationError::NoValue { text } =>
            "\"{}\" não é uma operação; permitido: NOME=VALOR, em que NOME é um de {}" (escaped(text), names());
        OperationError::UnknownName { name } => "não há a operação \"{}\"; permitido: {}" (escaped(name), names());
        OperationError::NotANumber { descriptor, value, error } =>
            "{} é \"{}\": {}; permitido: {}" (descriptor.word, escaped(value), in_expression(lang, value, error), amount_in_portuguese(descriptor));
        OperationError::NotAFactor { descriptor, value } | OperationError::WrongCount { descriptor, value } =>
            "{} é \"{}\"; permitido: {}" (descriptor.word, escaped(value), amount_in_portuguese(descriptor));
    }
}

fn amount_in_portuguese(descriptor: &Descriptor) -> String {
    let word = descriptor.word;
    match descriptor.amount {
        Amount::Angle => format!("um número finito de graus, como {word}=30"),
        Amount::Factor => format!("um número finito maior que 0, como {word}=1.5"),
        Amount::Length => format!("dois números finitos DX,DY em unidades da cena, como {word}=1,-0.5"),
    }
}

/// The reason why a camera has no matrices in a convention of NDC.
pub(crate) fn infinite_parallel(lang: Lang, error: InfiniteParallel) -> String {
    translated! { lang, error;
        InfiniteParallel(ndc) =>
            "{} leva o plano de fundo ao infinito, o que em projeção paralela dá o mesmo z a todas as profundidades; permitido: projection = \"perspective\", ou uma convenção sem -infinite" (ndc.name());
    }
}

/// The reason why a depth belongs to no point.
pub fn no_way_back(lang: Lang, error: NotProjectable) -> String {
    translated! { lang, error;
        NotProjectable::EmptyDepthRange { depth } =>
            "toda profundidade é {depth}: com depth_near = depth_far perde-se o caminho de volta";
        NotProjectable::BeyondInfinity { depth, near, infinity } =>
            "profundidade {depth}: nenhum ponto do mundo está tão longe; do plano da frente ao infinito, as profundidades vão de {near} até antes de {infinity}";
        NotProjectable::InPlaneOfEye =>
            "distância 0: no plano do olho nenhum ponto tem imagem; permitido: qualquer outra distância, como F";
        NotProjectable::Overflow { depth } =>
            "profundidade {depth}: as coordenadas do ponto excederiam os limites dos números (cerca de 1e-308 a 1e308)";
    }
}

/// The reason why there are no numbers to report.
pub fn inspect(lang: Lang, error: &InspectError) -> String {
    translated! { lang, error;
        InspectError::Camera(error) => "{}" (camera(lang, error));
        InspectError::InfiniteParallel(error) => "{}" (infinite_parallel(lang, *error));
        InspectError::Operation { operation, error } => "operação {operation}: {}" (camera(lang, error));
        InspectError::Point { point, space } =>
            "ponto {},{},{}: suas coordenadas ({space}) excederiam os limites dos números (cerca de 1e-308 a 1e308)" (point.x, point.y, point.z);
        InspectError::DepthPixel { pixel: [i, j], error } =>
            "pixel {i},{j} com profundidade: {}" (no_way_back(lang, *error));
        InspectError::Pixel { pixel: [i, j] } =>
            "pixel {i},{j}: seu raio excederia os limites dos números (cerca de 1e-308 a 1e308)";
    }
}

/// A warning about a camera that is possible, but probably not meant.
pub fn warning(lang: Lang, warning: &Warning) -> String {
    warning_wording(lang, warning).full
}

/// A warning about a camera that is possible, but probably not meant. The full form in English is the warning's own.
pub(crate) fn warning_wording(lang: Lang, warning: &Warning) -> Wording {
    let english = |in_symbols: String| Wording::new(warning.to_string(), in_symbols);
    let printed = |number: String| lang.mark().printed(&number);
    match (lang.grammar(), warning) {
        (_, Warning::ViewUpNearlyCollinear { degrees }) => pick!(lang;
            english(format!("VUP is only {degrees:.2e}° away from DOP: its last digits decide which way is up")),
            Wording::new(format!("view_up está a apenas {degrees:.3e} graus da direção de projeção: seus últimos dígitos decidem o que fica para cima"), format!("VUP está a só {degrees}° de DOP: seus últimos dígitos decidem o que fica para cima", degrees = printed(format!("{degrees:.2e}"))))),
        (_, Warning::DepthPrecision { ratio, step }) => pick!(lang;
            english(format!("B/F is {ratio:.2e}: at the back plane a 24-bit depth buffer cannot tell apart depths that differ by less than {step:.2e}; move F away from the camera")),
            Wording::new(format!("far / near é {ratio:.3e}: um z-buffer de 24 bits não distingue profundidades que diferem menos de {step:.3e} no plano de fundo; afaste near da câmera"), format!("B/F é {ratio}: um z-buffer de 24 bits não distingue, no fundo, profundidades a menos de {step}; afaste F da câmera", ratio = printed(format!("{ratio:.2e}")), step = printed(format!("{step:.2e}"))))),
        (Grammar::English, Warning::FocalPointClipped { .. }) => {
            english("PF is not between F and B: what the camera looks at is clipped away".to_owned())
        }
        (Grammar::Portuguese, Warning::FocalPointClipped { distance, near, far }) => Wording::new(
            format!(
                "focal_point está à distância {distance}, que não fica entre near = {near} e far = {far}: o que a câmera mira é recortado"
            ),
            "PF não está entre F e B: o que a câmera olha é recortado",
        ),
        (_, Warning::WideAngle { degrees }) => pick!(lang;
            english(format!("The window spans {degrees:.1}°: everything is stretched towards its borders")),
            Wording::new(format!("a janela abrange {degrees:.6} graus: perto das bordas tudo fica esticado"), format!("A janela abrange {degrees}°: perto das bordas tudo se estica", degrees = printed(format!("{degrees:.1}"))))),
        (_, Warning::FarFromOrigin { ratio, digits }) => pick!(lang;
            english(format!("The camera is {ratio:.2e} times farther from the origin than from PF: only {digits} of 15 digits are left for what it sees")),
            Wording::new(format!("a câmera está {ratio:.3e} vezes mais longe da origem que de focal_point: restam só {digits} de 15 dígitos para o que ela vê"), format!("A câmera está {ratio} vezes mais longe da origem que de PF: só {digits} de 15 dígitos sobram para o que ela vê", ratio = printed(format!("{ratio:.2e}"))))),
        (_, Warning::AspectMismatch { window, image }) => pick!(lang;
            english(format!("The window has aspect {window:.4} and the image {image:.4}: shapes are stretched")),
            Wording::new(format!("a janela de vista tem razão de aspecto {window:.6} e a imagem {image:.6}: as formas são esticadas"), format!("A janela tem aspecto {window} e a imagem {image}: as formas se esticam", window = printed(format!("{window:.4}")), image = printed(format!("{image:.4}"))))),
    }
}
