//! What went wrong, or may not have been meant, in both languages.
//!
//! Keys, words of the figure file, and numbers are the same in every language. Each function is one exhaustive `match`: an
//! error without a text does not compile.

use std::io;

use super::Lang;
use crate::camera::{CameraError, Derived, Operation, OperationError, Range, Warning};
use crate::export::png::PngError;
use crate::figure::FigureError;
use crate::figure::error::{Allowed, Problem};
use crate::files::FileError;
use crate::inspect::InspectError;
use crate::scene::SceneError;
use crate::scene::primitives::{MAX_SEGMENTS, MIN_SEGMENTS};

/// One of the two texts.
pub(super) fn pick(lang: Lang, en: impl Into<String>, pt_br: impl Into<String>) -> String {
    match lang {
        Lang::En => en.into(),
        Lang::PtBr => pt_br.into(),
    }
}

/// Why parameters are no camera, with the keys concerned and what is allowed.
#[must_use]
pub fn camera(lang: Lang, error: &CameraError) -> String {
    match error {
        CameraError::FocalPointAtPosition => pick(
            lang,
            "focal_point is the same point as position; allowed: any other point",
            "focal_point é o mesmo ponto que position; permitido: qualquer outro ponto",
        ),
        CameraError::ViewUpZero => pick(
            lang,
            "view_up is the zero vector; allowed: any other vector that is not collinear with focal_point − position",
            "view_up é o vetor nulo; permitido: qualquer outro vetor não colinear com focal_point − position",
        ),
        CameraError::ViewUpCollinear => pick(
            lang,
            "view_up is collinear with focal_point − position; allowed: any vector that points to another side",
            "view_up é colinear com focal_point − position; permitido: qualquer vetor que aponte para outro lado",
        ),
        CameraError::OutOfRange { key, value, allowed } => {
            let allowed = range(lang, *allowed);
            pick(
                lang,
                format!("{key} is {value:?}; allowed: {allowed}"),
                format!("{key} é {value:?}; permitido: {allowed}"),
            )
        }
        CameraError::FarNotBeyondNear { near, far } => pick(
            lang,
            format!("near is {near:?} and far is {far:?}; allowed: 0 < near < far"),
            format!("near é {near:?} e far é {far:?}; permitido: 0 < near < far"),
        ),
        CameraError::WindowWidth { left, right } => pick(
            lang,
            format!("window: left is {left:?} and right is {right:?}; allowed: left < right"),
            format!("window: left é {left:?} e right é {right:?}; permitido: left < right"),
        ),
        CameraError::WindowHeight { bottom, top } => pick(
            lang,
            format!("window: bottom is {bottom:?} and top is {top:?}; allowed: bottom < top"),
            format!("window: bottom é {bottom:?} e top é {top:?}; permitido: bottom < top"),
        ),
        CameraError::Overflow { quantity, keys } => {
            let (quantity, keys) = (derived(lang, *quantity), keys.join(", "));
            pick(
                lang,
                format!("{quantity} would exceed the range of numbers (about 1e-308 to 1e308); it follows from {keys}"),
                format!("{quantity} excederia os limites dos números (cerca de 1e-308 a 1e308); depende de {keys}"),
            )
        }
    }
}

fn range(lang: Lang, range: Range) -> String {
    match range {
        Range::Finite => pick(lang, "a finite number", "um número finito"),
        Range::Positive => pick(lang, "a finite number greater than 0", "um número finito maior que 0"),
        Range::HalfTurn => pick(lang, "greater than 0 and less than 180 degrees", "maior que 0 e menor que 180 graus"),
    }
}

fn derived(lang: Lang, quantity: Derived) -> String {
    match quantity {
        Derived::Distance => {
            pick(lang, "the distance from position to focal_point", "a distância de position a focal_point")
        }
        Derived::Window => pick(lang, "the view window", "a janela de projeção"),
        Derived::ViewMatrix => pick(lang, "the view matrix", "a matriz de visão"),
        Derived::ProjectionMatrix => pick(lang, "the projection matrix", "a matriz de projeção"),
        Derived::ViewProjectionMatrix => {
            pick(lang, "the product of projection and view matrix", "o produto das matrizes de projeção e de visão")
        }
        Derived::VolumeCorners => pick(lang, "the corners of the view volume", "os vértices do volume de vista"),
    }
}

/// Why a text is no operation.
#[must_use]
pub fn operation(lang: Lang, error: &OperationError) -> String {
    let names = Operation::NAMES.join(", ");
    match error {
        OperationError::NoValue { text } => pick(
            lang,
            format!("{text:?} is no operation; allowed: NAME=VALUE, where NAME is one of {names}"),
            format!("{text:?} não é uma operação; permitido: NOME=VALOR, em que NOME é um de {names}"),
        ),
        OperationError::UnknownName { name } => pick(
            lang,
            format!("there is no operation {name:?}; allowed: {names}"),
            format!("não há a operação {name:?}; permitido: {names}"),
        ),
        OperationError::NotAnAngle { name, value } => pick(
            lang,
            format!("{name} is {value:?}; allowed: a finite number of degrees, such as {name}=30"),
            format!("{name} é {value:?}; permitido: um número finito de graus, como {name}=30"),
        ),
        OperationError::NotAFactor { name, value } => pick(
            lang,
            format!("{name} is {value:?}; allowed: a finite number greater than 0, such as {name}=1.5"),
            format!("{name} é {value:?}; permitido: um número finito maior que 0, como {name}=1.5"),
        ),
        OperationError::NotAStep { value } => pick(
            lang,
            format!("pan is {value:?}; allowed: two finite numbers DX,DY in scene units, such as pan=1,-0.5"),
            format!("pan é {value:?}; permitido: dois números finitos DX,DY em unidades da cena, como pan=1,-0.5"),
        ),
    }
}

/// Why there are no numbers to report.
#[must_use]
pub fn inspect(lang: Lang, error: &InspectError) -> String {
    match error {
        InspectError::Camera(error) => camera(lang, error),
        InspectError::Operation { operation, error } => {
            let why = camera(lang, error);
            pick(lang, format!("operation {operation}: {why}"), format!("operação {operation}: {why}"))
        }
        InspectError::Point { point, space } => {
            let [x, y, z] = point.to_array();
            pick(
                lang,
                format!(
                    "point {x},{y},{z}: its coordinates in {space} would exceed the range of numbers (about 1e-308 to 1e308)"
                ),
                format!(
                    "ponto {x},{y},{z}: suas coordenadas ({space}) excederiam os limites dos números (cerca de 1e-308 a 1e308)"
                ),
            )
        }
        InspectError::Pixel { pixel: [i, j] } => pick(
            lang,
            format!("pixel {i},{j}: its ray would exceed the range of numbers (about 1e-308 to 1e308)"),
            format!("pixel {i},{j}: seu raio excederia os limites dos números (cerca de 1e-308 a 1e308)"),
        ),
    }
}

/// What is possible, but probably not what was meant.
#[must_use]
pub fn warning(lang: Lang, warning: &Warning) -> String {
    match warning {
        Warning::ViewUpNearlyCollinear { degrees } => pick(
            lang,
            warning.to_string(),
            format!(
                "view_up está a apenas {degrees:.3e} graus da direção de projeção: seus últimos dígitos decidem o que fica para cima"
            ),
        ),
        Warning::DepthPrecision { ratio, step } => pick(
            lang,
            warning.to_string(),
            format!(
                "far / near é {ratio:.3e}: um z-buffer de 24 bits não distingue profundidades que diferem menos de {step:.3e} no plano far; afaste near da câmera"
            ),
        ),
        Warning::FocalPointClipped { distance, near, far } => pick(
            lang,
            warning.to_string(),
            format!(
                "focal_point está à distância {distance}, que não fica entre near = {near} e far = {far}: o que a câmera mira é recortado"
            ),
        ),
        Warning::WideAngle { degrees } => pick(
            lang,
            warning.to_string(),
            format!("a janela abrange {degrees:.6} graus: perto das bordas tudo fica esticado"),
        ),
        Warning::FarFromOrigin { ratio, digits } => pick(
            lang,
            warning.to_string(),
            format!(
                "a câmera está {ratio:.3e} vezes mais longe da origem que de focal_point: restam só {digits} de 15 dígitos para o que ela vê"
            ),
        ),
        Warning::AspectMismatch { window, image } => pick(
            lang,
            warning.to_string(),
            format!(
                "a janela de projeção tem razão de aspecto {window:.6} e a imagem {image:.6}: as formas são esticadas"
            ),
        ),
    }
}

/// Why a text is no figure: line, key, what was found, what is allowed.
#[must_use]
pub fn figure(lang: Lang, error: &FigureError) -> String {
    let FigureError { line, key, problem } = error;
    let what = self::problem(lang, problem);
    let line = pick(lang, format!("line {line}"), format!("linha {line}"));
    match problem {
        // These name the keys themselves.
        Problem::Camera(_) => format!("{line}: [camera] {what}"),
        _ if key.is_empty() => format!("{line}: {what}"),
        _ => format!("{line}: {key} {what}"),
    }
}

/// Why a specification is no scene; names the key.
#[must_use]
pub fn scene(lang: Lang, error: &SceneError) -> String {
    let object = |name: &str| format!("[[scene.objects]] {name:?}");
    match error {
        SceneError::DuplicateName { name } => {
            format!("[[scene.objects]] name {}", problem(lang, &Problem::DuplicateName { name: name.clone() }))
        }
        SceneError::UnknownParent { name, parent } => {
            let why = problem(lang, &Problem::UnknownParent { name: parent.clone(), near: None });
            format!("{}: parent {why}", object(name))
        }
        SceneError::Cycle { chain } => {
            let chain = chain.join(" → ");
            pick(
                lang,
                format!("[[scene.objects]] parent goes round in a circle ({chain}); allowed: parents that form a tree"),
                format!("[[scene.objects]] parent forma um ciclo ({chain}); permitido: pais que formem uma árvore"),
            )
        }
        SceneError::NotFinite { name, key } => {
            let object = object(name);
            pick(
                lang,
                format!(
                    "{object}: {key} leads to numbers that are not finite; allowed: transforms whose product stays below about 1e308"
                ),
                format!(
                    "{object}: {key} leva a números que não são finitos; permitido: transformações cujo produto fique abaixo de cerca de 1e308"
                ),
            )
        }
        SceneError::ZeroScale { name } => format!(
            "{}: scale {}",
            object(name),
            pick(
                lang,
                "is 0 along an axis; allowed: any other numbers",
                "é 0 em algum eixo; permitido: quaisquer outros números"
            )
        ),
        SceneError::Segments { name, found } => {
            let allowed = Allowed::IntegerIn(i64::from(MIN_SEGMENTS), i64::from(MAX_SEGMENTS));
            let why = problem(lang, &Problem::Value { found: found.to_string(), allowed });
            format!("{}: segments {why}", object(name))
        }
        SceneError::Mesh { name, path, error } => {
            format!("{}: path {path:?}: {}", object(name), super::meshes::mesh(lang, error))
        }
        SceneError::Light { index, key } => {
            let which = index + 1;
            pick(
                lang,
                format!("[[scene.lights]] {which}: {key} must be three finite numbers, not all 0 for a direction"),
                format!("[[scene.lights]] {which}: {key} deve ter três números finitos, nem todos 0 numa direção"),
            )
        }
    }
}

/// What comes after line and key.
fn problem(lang: Lang, problem: &Problem) -> String {
    match problem {
        Problem::NotUtf8 { byte } => pick(
            lang,
            format!("byte {byte:#04x} is no UTF-8; allowed: text in UTF-8"),
            format!("o byte {byte:#04x} não é UTF-8; permitido: texto em UTF-8"),
        ),
        Problem::TooLarge { limit } => pick(
            lang,
            format!("the file is too large; allowed: at most {limit} bytes"),
            format!("o arquivo é grande demais; permitido: no máximo {limit} bytes"),
        ),
        Problem::Syntax { found, detail } => pick(
            lang,
            format!(
                "cannot be read as TOML: {found} ({detail}); allowed: KEY = VALUE with texts in quotes and a point in decimals, such as near = 0.5"
            ),
            format!(
                "não pode ser lido como TOML: {found} ({detail}); permitido: CHAVE = VALOR com textos entre aspas e ponto nos decimais, como near = 0.5"
            ),
        ),
        Problem::Duplicate => pick(lang, "is there twice; allowed: once", "aparece duas vezes; permitido: uma"),
        Problem::UnknownKey { near, known } => {
            let (near, known) = (meant(lang, near.as_deref()), known.join(", "));
            pick(lang, format!("is unknown{near}; allowed: {known}"), format!("não existe{near}; permitido: {known}"))
        }
        Problem::Value { found, allowed } => {
            let allowed = self::allowed(lang, allowed);
            pick(lang, format!("is {found}; allowed: {allowed}"), format!("é {found}; permitido: {allowed}"))
        }
        Problem::Missing { allowed } => {
            let allowed = self::allowed(lang, allowed);
            pick(lang, format!("is missing; needed: {allowed}"), format!("está faltando; necessário: {allowed}"))
        }
        Problem::DuplicateName { name } => pick(
            lang,
            format!("is {name:?}, as an object before it; allowed: a name of its own"),
            format!("é {name:?}, como um objeto anterior; permitido: um nome próprio"),
        ),
        Problem::UnknownParent { name, near } => {
            let near = meant(lang, near.as_deref());
            pick(
                lang,
                format!("is {name:?}, and no object is called so{near}; allowed: the name of an object"),
                format!("é {name:?}, e nenhum objeto se chama assim{near}; permitido: o nome de um objeto"),
            )
        }
        Problem::ParentCycle { name } => pick(
            lang,
            format!("makes {name:?} its own ancestor; allowed: parents that form a tree"),
            format!("torna {name:?} ancestral de si mesmo; permitido: pais que formem uma árvore"),
        ),
        Problem::Camera(error) => camera(lang, error),
    }
}

fn meant(lang: Lang, near: Option<&str>) -> String {
    near.map_or_else(String::new, |near| {
        pick(lang, format!(" (did you mean {near}?)"), format!(" (você quis dizer {near}?)"))
    })
}

fn allowed(lang: Lang, allowed: &Allowed) -> String {
    match allowed {
        Allowed::Number => pick(lang, "a finite number", "um número finito"),
        Allowed::PositiveNumber => pick(lang, "a finite number greater than 0", "um número finito maior que 0"),
        Allowed::NumberIn(least, most) => {
            pick(lang, format!("a number from {least} to {most}"), format!("um número de {least} a {most}"))
        }
        Allowed::IntegerIn(least, most) => {
            pick(lang, format!("an integer from {least} to {most}"), format!("um inteiro de {least} a {most}"))
        }
        Allowed::Integers(choice) => {
            let choice: Vec<_> = choice.iter().map(ToString::to_string).collect();
            choice.join(", ")
        }
        Allowed::Vector => pick(lang, "three finite numbers, [x, y, z]", "três números finitos, [x, y, z]"),
        Allowed::NonZeroVector => {
            pick(lang, "three finite numbers, [x, y, z], not all 0", "três números finitos, [x, y, z], nem todos 0")
        }
        Allowed::NonZeroScale => pick(
            lang,
            "three finite numbers, [x, y, z], none of them 0",
            "três números finitos, [x, y, z], nenhum deles 0",
        ),
        Allowed::Points => pick(lang, "a list of points, [[x, y, z], …]", "uma lista de pontos, [[x, y, z], …]"),
        Allowed::PointPairs => pick(
            lang,
            "a list of an even number of points, [[x, y, z], [x, y, z], …]",
            "uma lista com um número par de pontos, [[x, y, z], [x, y, z], …]",
        ),
        Allowed::Color => pick(
            lang,
            "\"#rrggbb\" or \"#rrggbbaa\" with hexadecimal digits",
            "\"#rrggbb\" ou \"#rrggbbaa\" com dígitos hexadecimais",
        ),
        Allowed::Text => pick(lang, "a text in quotes that is not empty", "um texto entre aspas, não vazio"),
        Allowed::Word { words, near } => {
            let words: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
            format!("{}{}", words.join(", "), meant(lang, near.as_deref()))
        }
        Allowed::Section => pick(lang, "a section with keys", "uma seção com chaves"),
        Allowed::Sections => pick(
            lang,
            "sections in double brackets, or a list of inline tables",
            "seções entre colchetes duplos, ou uma lista de tabelas em linha",
        ),
    }
}

/// Why the file called `name` cannot be used.
#[must_use]
pub fn file(lang: Lang, name: &str, error: &FileError) -> String {
    match error {
        FileError::Read(error) => {
            let why = system(lang, error);
            pick(lang, format!("{name} cannot be read: {why}"), format!("{name} não pode ser lido: {why}"))
        }
        FileError::Write(error) => {
            let why = system(lang, error);
            pick(lang, format!("{name} cannot be written: {why}"), format!("{name} não pode ser gravado: {why}"))
        }
        FileError::Directory => pick(
            lang,
            format!("{name} is a directory; allowed: a file"),
            format!("{name} é um diretório; permitido: um arquivo"),
        ),
        FileError::TooLarge => pick(
            lang,
            format!("{name} is larger than any figure or picture; allowed: at most 1 GiB"),
            format!("{name} é maior que qualquer figura ou imagem; permitido: no máximo 1 GiB"),
        ),
        FileError::Png(error) => format!("{name}: {}", png(lang, error)),
        FileError::Figure(error) => format!("{name}, {}", figure(lang, error)),
    }
}

/// Why a picture cannot be written or read.
#[must_use]
pub fn png(lang: Lang, error: &PngError) -> String {
    match error {
        PngError::Encode(why) => pick(
            lang,
            format!("the picture cannot be written as PNG ({why})"),
            format!("a imagem não pode ser gravada como PNG ({why})"),
        ),
        PngError::Damaged(why) => {
            pick(lang, format!("the PNG is damaged ({why})"), format!("o PNG está danificado ({why})"))
        }
        PngError::NoFigure => pick(
            lang,
            "this PNG holds no figure; allowed: a figure file, or a picture that camera-lab wrote",
            "este PNG não contém uma figura; permitido: um arquivo de figura, ou uma imagem gravada por camera-lab",
        ),
    }
}

/// What the system said, in our words where the case is common.
fn system(lang: Lang, error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => {
            pick(lang, "there is no such file or directory", "o arquivo ou diretório não existe")
        }
        io::ErrorKind::PermissionDenied => pick(lang, "permission denied", "permissão negada"),
        io::ErrorKind::IsADirectory => pick(lang, "it is a directory", "é um diretório"),
        io::ErrorKind::NotADirectory => {
            pick(lang, "a part of the path is no directory", "uma parte do caminho não é um diretório")
        }
        io::ErrorKind::StorageFull => pick(lang, "the disk is full", "o disco está cheio"),
        io::ErrorKind::ReadOnlyFilesystem => pick(lang, "the disk is read-only", "o disco é somente de leitura"),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::read;

    fn both(text: &str) -> (String, String) {
        let error = read::parse(text).expect_err("a fault");
        (figure(Lang::En, &error), figure(Lang::PtBr, &error))
    }

    #[test]
    fn messages_name_line_key_value_and_what_is_allowed() {
        for (text, parts) in [
            ("[camera]\nfov = 3", &["2", "[camera] fov", "view_angle"][..]),
            ("[camera]\nview_angle = 180", &["2", "view_angle", "180.0"]),
            ("[camera]\nnear = 7\nfar = 3", &["3", "near", "7.0", "far", "3.0"]),
            ("[camera]\nposition = \"abc\"", &["2", "[camera] position", "\"abc\"", "[x, y, z]"]),
            ("[scene]\npreset = \"huose\"", &["2", "[scene] preset", "\"huose\"", "\"ndc-cube\"", "house"]),
            ("[image]\nwidth = 0", &["2", "[image] width", "0", "16384"]),
            ("[camera]\nnear = 1,5", &["2", "[camera] near", "1,5"]),
        ] {
            let (en, pt) = both(text);
            for part in parts {
                assert!(en.contains(part), "{part}: {en}");
                assert!(pt.contains(part), "{part}: {pt}");
            }
            assert_ne!(en, pt);
            assert!(!en.contains('\n') && !pt.contains('\n'));
        }
    }

    #[test]
    fn the_two_languages_read_well() {
        let (en, pt) = both("[style]\nantialias = 3");
        assert_eq!(en, "line 2: [style] antialias is 3; allowed: 1, 4, 16");
        assert_eq!(pt, "linha 2: [style] antialias é 3; permitido: 1, 4, 16");
        let (en, pt) = both("[camera]\nview_up = [0, 0, 0]");
        assert!(en.starts_with("line 2: [camera] view_up is the zero vector; allowed:"), "{en}");
        assert!(pt.starts_with("linha 2: [camera] view_up é o vetor nulo; permitido:"), "{pt}");
    }

    #[test]
    fn files_are_named() {
        let missing = FileError::Read(io::ErrorKind::NotFound.into());
        assert_eq!(file(Lang::En, "a.toml", &missing), "a.toml cannot be read: there is no such file or directory");
        assert_eq!(file(Lang::PtBr, "a.toml", &missing), "a.toml não pode ser lido: o arquivo ou diretório não existe");
    }
}
