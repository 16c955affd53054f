//! Faults of figure files, in both languages.

use super::cameras::camera;
use super::expressions::in_expression;
use super::scene_errors::scene_wording;
use super::toml_complaints;
use crate::figure::FigureError;
use crate::figure::error::{Allowed, Problem};
use crate::formula::{FormulaError, FormulaProblem};
use crate::i18n::Lang;
use crate::limits::{MAX_FORMULA, MAX_TEXTURE_SCALE};
use crate::sanitize::escaped;

/// The reason why a text isn't a figure: line, key, the value found, the values allowed.
pub fn figure(lang: Lang, error: &FigureError) -> String {
    let line = both!(lang; "line {}", "linha {}"; error.line);
    format!("{line}: {}", without_line(lang, error))
}

/// The same for a text that isn't in a file.
pub fn without_line(lang: Lang, error: &FigureError) -> String {
    let FigureError { key, problem, .. } = error;
    let what = self::problem(lang, problem);
    match problem {
        // These name the keys themselves. For ours the section is enough.
        Problem::Camera(_) => {
            // A list has two brackets.
            let section = ["]]", "]"].iter().find_map(|end| Some(&key[..key.find(end)? + end.len()]));
            format!("{} {what}", section.unwrap_or("[camera]"))
        }
        Problem::NotUtf8 { .. }
        | Problem::TooLarge { .. }
        | Problem::Syntax { .. }
        | Problem::Unquoted { .. }
        | Problem::Duplicate
        | Problem::Rival { .. }
        | Problem::TooMany { .. }
        | Problem::UnknownKey { .. }
        | Problem::Value { .. }
        | Problem::Expression { .. }
        | Problem::Missing { .. }
        | Problem::Formula(_)
        | Problem::Scene { .. } => {
            let key = if key.is_empty() { String::new() } else { format!("{key} ") };
            format!("{key}{what}")
        }
    }
}

/// The text after line and key.
pub(in crate::i18n) fn problem(lang: Lang, problem: &Problem) -> String {
    match problem {
        Problem::NotUtf8 { byte } => both!(lang; "byte {byte:#04x} is not UTF-8; allowed: text in UTF-8",
            "o byte {byte:#04x} não é UTF-8; permitido: texto em UTF-8"),
        Problem::TooLarge { limit } => both!(lang; "the file is too large; allowed: at most {limit} bytes",
            "o arquivo é grande demais; permitido: no máximo {limit} bytes"),
        Problem::Syntax { found, detail } => {
            let in_portuguese = toml_in_portuguese(detail);
            both!(lang; "cannot be read as TOML: {found} ({detail}); allowed: KEY = VALUE with texts in quotes and a point in decimals, such as near = 0.5",
                "não pode ser lido como TOML: {found} ({in_portuguese}); permitido: CHAVE = VALOR com textos entre aspas e ponto nos decimais, como near = 0.5")
        }
        Problem::Unquoted { text } => both!(lang;
            "is {text}; allowed: a number, or an expression in quotes, \"{text}\"",
            "é {text}; permitido: um número, ou uma expressão entre aspas, \"{text}\""),
        Problem::Duplicate => both!(lang; "appears twice; allowed: once", "aparece duas vezes; permitido: uma"),
        Problem::Rival { other, ways } => {
            let ways = ways.join(", ");
            both!(lang; "and {other} stand side by side, and each gives θ; allowed: one of {ways}",
                "e {other} aparecem juntas, e cada uma dá θ; permitido: uma de {ways}")
        }
        Problem::TooMany { count, limit } => both!(lang; "are {count}; allowed: at most {limit}",
            "são {count}; permitido: no máximo {limit}"),
        Problem::UnknownKey { near, known } => {
            let (near, known) = (meant(lang, near.as_deref()), known.join(", "));
            both!(lang; "is unknown{near}; allowed: {known}", "não existe{near}; permitido: {known}")
        }
        Problem::Value { found, allowed } => {
            let allowed = self::allowed(lang, allowed);
            both!(lang; "is {found}; allowed: {allowed}", "é {found}; permitido: {allowed}")
        }
        Problem::Expression { text, error, allowed } => {
            let (why, allowed) = (in_expression(lang, text, error), self::allowed(lang, allowed));
            both!(lang; "is \"{}\": {why}; allowed: {allowed}",
                "é \"{}\": {why}; permitido: {allowed}"; escaped(text))
        }
        Problem::Missing { allowed } => {
            let allowed = self::allowed(lang, allowed);
            both!(lang; "is missing; needed: {allowed}", "está faltando; necessário: {allowed}")
        }
        Problem::Formula(error) => formula(lang, error),
        Problem::Scene { error, near } => scene_wording(lang, error).full + &meant(lang, near.as_deref()),
        Problem::Camera(error) => camera(lang, error),
    }
}

/// The reason why a formula of a text is refused.
pub(in crate::i18n) fn formula(lang: Lang, FormulaError { formula, problem }: &FormulaError) -> String {
    let (limit, depth) = MAX_FORMULA;
    let why = match problem {
        FormulaProblem::Open => both!(lang; "no dollar sign closes it", "nenhum cifrão a fecha"),
        FormulaProblem::Empty => both!(lang; "it is empty", "está vazia"),
        FormulaProblem::Word(word) => both!(lang; "{} is not a mathematical command",
            "{} não é um comando de matemática"; escaped(word)),
        FormulaProblem::Environment(name) => both!(lang; "the environment {} is not a mathematical one",
            "o ambiente {} não é de matemática"; escaped(name)),
        FormulaProblem::Character('\n') => both!(lang; "it contains a blank line", "contém uma linha em branco"),
        FormulaProblem::Character(c) => both!(lang; "the character {} is not allowed there",
            "o caractere {} não é permitido ali"; named(*c)),
        FormulaProblem::Unbalanced(what) => both!(lang; "{} has no counterpart",
            "{} não tem par"; escaped(what)),
        FormulaProblem::NotOnALine(what) => both!(lang; "{} cannot be shown on the one line of a label",
            "{} não cabe na única linha de um rótulo"; escaped(what)),
        FormulaProblem::TooLong => both!(lang;
            "it has more than {limit} characters, or more than {depth} nested pairs of braces",
            "tem mais de {limit} caracteres, ou mais de {depth} pares de chaves aninhados"),
    };
    let formula = escaped(formula);
    both!(lang; "has the formula \"${formula}$\": {why}; allowed between dollar signs: mathematics in LaTeX, such as \\frac{{1}}{{2}} and \\theta, and no dollar sign elsewhere",
        "tem a fórmula \"${formula}$\": {why}; permitido entre cifrões: matemática em LaTeX, como \\frac{{1}}{{2}} e \\theta, e nenhum cifrão em outro lugar")
}

/// A character with its number, so that look-alikes can be distinguished.
fn named(c: char) -> String {
    format!("{} (U+{:04X})", escaped(&c.to_string()), u32::from(c))
}

/// The TOML parser speaks English. Its common complaints are known, others stay as they are.
fn toml_in_portuguese(detail: &str) -> &str {
    let portuguese = toml_complaints::texts(Lang::PtBr).entries();
    let both = toml_complaints::texts(Lang::En).entries().into_iter().zip(portuguese);
    let mut known = both.map(|((_, english), (_, portuguese))| (english, portuguese));
    known.find(|(english, _)| detail.starts_with(english)).map_or(detail, |(_, portuguese)| portuguese)
}

pub(in crate::i18n) fn meant(lang: Lang, near: Option<&str>) -> String {
    near.map(escaped).map_or_else(String::new, |near| {
        both!(lang; " (did you mean {near}?)",
        " (você quis dizer {near}?)")
    })
}

fn allowed(lang: Lang, allowed: &Allowed) -> String {
    match allowed {
        Allowed::Number => both!(lang; "a finite number", "um número finito"),
        Allowed::PositiveNumber => both!(lang; "a finite number greater than 0", "um número finito maior que 0"),
        Allowed::NumberIn(least, most) => both!(lang; "a number from {least} to {most}",
            "um número de {least} a {most}"),
        Allowed::HalfTurn => both!(lang; "degrees greater than 0 and less than 180",
            "graus maiores que 0 e menores que 180"),
        Allowed::PositivePair => both!(lang; "two finite numbers greater than 0, [36.0, 24.0]",
            "dois números finitos maiores que 0, [36.0, 24.0]"),
        Allowed::IntegerIn(least, most) => both!(lang; "an integer from {least} to {most}",
            "um inteiro de {least} a {most}"),
        Allowed::Integers(choice) => {
            let choice: Vec<_> = choice.iter().map(ToString::to_string).collect();
            choice.join(", ")
        }
        Allowed::Switch => "true, false".to_owned(),
        Allowed::SwitchOr(words) => {
            words.iter().fold("true, false".to_owned(), |list, word| format!("{list}, \"{word}\""))
        }
        Allowed::Vector => both!(lang; "three finite numbers, [x, y, z]", "três números finitos, [x, y, z]"),
        Allowed::NonZeroVector => both!(lang; "three finite numbers, [x, y, z], not all 0",
            "três números finitos, [x, y, z], nem todos 0"),
        Allowed::TextureScale => both!(lang; "two numbers, neither 0 and none beyond ±{MAX_TEXTURE_SCALE}",
            "dois números, nenhum deles 0 nem além de ±{MAX_TEXTURE_SCALE}"),
        Allowed::NonZeroScale => both!(lang; "three finite numbers, [x, y, z], none of them 0",
            "três números finitos, [x, y, z], nenhum deles 0"),
        Allowed::Camera => both!(lang; "the name of one of the [[cameras]]", "o nome de uma das [[cameras]]"),
        Allowed::PointInImage => pick!(lang;
            "a point that lies in the image: the name of a point of the figure, [x, y, z], { object = \"…\", vertex = \"…\" }, { view = [x, y, z] }, { ndc = [x, y, z] }, { clip = [x, y, z, w] } or { pixel = [i, j] }".to_owned(),
            "um ponto que caia na imagem: o nome de um ponto da figura, [x, y, z], { object = \"…\", vertex = \"…\" }, { view = [x, y, z] }, { ndc = [x, y, z] }, { clip = [x, y, z, w] } ou { pixel = [i, j] }".to_owned()),
        Allowed::ObjectPoint => pick!(lang;
            "a point that this object has: \"tip\" of a cone or a pyramid, \"center\", \"corner:1\" to \"corner:8\" of its own box, or \"vertex:1\" and so on; objects from a file have none".to_owned(),
            "um ponto que este objeto tem: \"tip\" de um cone ou de uma pirâmide, \"center\", \"corner:1\" a \"corner:8\" de sua própria caixa, ou \"vertex:1\" e assim por diante; objetos de um arquivo não têm nenhum".to_owned()),
        Allowed::Seen => {
            both!(lang; "\"next\", or a list such as [\"roll=30\", \"camera.near=2\"]",
            "\"next\", ou uma lista como [\"roll=30\", \"camera.near=2\"]")
        }
        Allowed::Points => both!(lang; "a list of points, [[x, y, z], …]", "uma lista de pontos, [[x, y, z], …]"),
        Allowed::PointPairs => both!(lang; "a list of an even number of points, [[x, y, z], [x, y, z], …]",
            "uma lista com um número par de pontos, [[x, y, z], [x, y, z], …]"),
        Allowed::Color => both!(lang; "\"#rrggbb\" or \"#rrggbbaa\" with hexadecimal digits",
            "\"#rrggbb\" ou \"#rrggbbaa\" com dígitos hexadecimais"),
        Allowed::Text => both!(lang; "a non-empty text in quotes", "um texto entre aspas, não vazio"),
        Allowed::Word { words, near } => {
            format!("{}{}", quoted(words), meant(lang, near.as_deref()))
        }
        Allowed::Words(words) => both!(lang; "a list of {}", "uma lista de {}"; quoted(words)),
        Allowed::TomlValue => pick!(lang;
            "a TOML value, such as \"clip\", 0.4, [1, 2, 3] or { way = \"notes\", at = 2.5 }".to_owned(),
            "um valor de TOML, como \"clip\", 0.4, [1, 2, 3] ou { way = \"notes\", at = 2.5 }".to_owned()),
        Allowed::Pair => both!(lang; "[x, y], two numbers", "[x, y], dois números"),
        Allowed::Pixel => both!(lang; "[i, j], two whole numbers", "[i, j], dois números inteiros"),
        Allowed::Matrix => both!(lang; "[[…], […], […], […]], four rows of four numbers",
            "[[…], […], […], […]], quatro linhas de quatro números"),
        Allowed::Bilingual
        | Allowed::BilingualLine { .. }
        | Allowed::ToldList
        | Allowed::Texts
        | Allowed::Line { .. }
        | Allowed::Name { .. }
        | Allowed::FreeName => allowed_text(lang, allowed),
        Allowed::Operations => both!(lang;
            "a list of operations that this camera can perform, such as [\"azimuth=30\", \"zoom=2\"]",
            "uma lista de operações que esta câmera pode executar, como [\"azimuth=30\", \"zoom=2\"]"),
        Allowed::KeyOfSteps => both!(lang;
            "keys or sections that the steps before have, such as [\"show.stage\", \"labels\"]",
            "chaves ou seções que os passos anteriores têm, como [\"show.stage\", \"labels\"]"),
        Allowed::Exercise => both!(lang; "an exercise of the program, as `camera-lab exercise list` names it",
            "um exercício do programa, como o nomeia `camera-lab exercise list`"),
        Allowed::Ways => both!(lang;
            "a list of operations and keys that the step's figure can have, such as [\"azimuth=30\", \"camera.near=2\"]",
            "uma lista de operações e chaves que a figura do passo pode ter, como [\"azimuth=30\", \"camera.near=2\"]"),
        Allowed::Pixels => both!(lang; "a list of pixels, [[i, j], …], in whole numbers",
            "uma lista de pixels, [[i, j], …], em números inteiros"),
        Allowed::Numbers => both!(lang;
            "a number or an expression, [a, b, …], or [[…], […], …] with rows of equal length",
            "um número ou uma expressão, [a, b, …], ou [[…], […], …] com linhas de mesmo comprimento"),
        Allowed::Quantity => both!(lang;
            "a path in the output of inspect for this figure, such as \"basis.u\" or \"points.0.ndc\"",
            "um caminho na saída de inspect para esta figura, como \"basis.u\" ou \"points.0.ndc\""),
        Allowed::NotAbove(key) => both!(lang; "a number that is not above {key}", "um número que não passe de {key}"),
        Allowed::Compatible => both!(lang; "conditions that one figure can meet together",
            "condições que uma mesma figura possa cumprir juntas"),
        Allowed::TwoVectors => both!(lang;
            "paths to two vectors in the output of inspect, such as [\"camera.view_up\", \"dop\"]",
            "caminhos a dois vetores na saída de inspect, como [\"camera.view_up\", \"dop\"]"),
        Allowed::Either(one, other) => both!(lang; "either {one} or {other}", "ou {one} ou {other}"),
        Allowed::Choice(choices) => {
            choices.iter().map(|choice| format!("\"{}\"", escaped(choice))).collect::<Vec<_>>().join(", ")
        }
        Allowed::WrongAnswer => both!(lang; "a wrong answer, which the message explains",
            "uma resposta errada, que a mensagem explica"),
        Allowed::NotePlace => pick!(lang;
            "[x, y, z] of the world, [x, y] of the image from 0 to 1, { object = \"…\", vertex = 0 } or { object = \"…\", edge = 0 }".to_owned(),
            "[x, y, z] do mundo, [x, y] da figura de 0 a 1, { object = \"…\", vertex = 0 } ou { object = \"…\", edge = 0 }".to_owned()),
        Allowed::PairIn(least, most) => both!(lang; "two numbers, [x, y], each from {least} to {most}",
            "dois números, [x, y], cada um de {least} a {most}"),
        Allowed::Section => both!(lang; "a section with keys", "uma seção com chaves"),
        Allowed::Sections => both!(lang; "sections in double brackets, or a list of inline tables",
            "seções entre colchetes duplos, ou uma lista de tabelas em linha"),
    }
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}

/// The allowed forms of a text.
fn allowed_text(lang: Lang, allowed: &Allowed) -> String {
    match allowed {
        Allowed::BilingualLine { limit } => {
            let longest = both!(lang; ", of at most {limit} characters on one line",
                ", de no máximo {limit} caracteres em uma linha");
            allowed_text(lang, &Allowed::Bilingual) + &longest
        }
        Allowed::ToldList => pick!(lang;
            "a list of texts, each as \"…\" or { en = \"…\", \"pt-BR\" = \"…\" }".to_owned(),
            "uma lista de textos, cada um como \"…\" ou { en = \"…\", \"pt-BR\" = \"…\" }".to_owned()),
        Allowed::Line { limit } => both!(lang; "a text in quotes, of 1 to {limit} characters on one line",
            "um texto entre aspas, de 1 a {limit} caracteres em uma linha"),
        Allowed::Texts => both!(lang; "a list of texts in quotes", "uma lista de textos entre aspas"),
        Allowed::Name { limit } => both!(lang; "at most {limit} letters, digits, -, _ and .",
            "no máximo {limit} letras, dígitos, -, _ e ."),
        Allowed::FreeName => both!(lang; "a name that no other exercise has",
            "um nome que nenhum outro exercício tem"),
        _ => pick!(lang; "a text in quotes, or { en = \"…\", \"pt-BR\" = \"…\" }".to_owned(),
            "um texto entre aspas, ou { en = \"…\", \"pt-BR\" = \"…\" }".to_owned()),
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
            ("[reveal]\ndepth = 1", &["2", "[reveal] depth", "1", "true", "false", "\"linear\""]),
            ("[reveal]\nculled = \"no\"", &["2", "[reveal] culled", "\"no\"", "true", "false"]),
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
    fn common_complaints_of_the_toml_parser_are_translated() {
        for (text, portuguese) in [
            ("[camera]\nnear = 1,5", "há algo a mais depois do valor"),
            ("[camera]\nprojection = parallel", "textos precisam de aspas"),
            ("[camera]\nposition = [1, 2", "falta fechar uma lista com ]"),
            ("[camera]\nposition = [1, 2\nnear = 3", "falta uma vírgula entre os elementos da lista"),
            ("[camera", "falta fechar uma seção com ]"),
            ("[camera]\nnear", "chave sem valor"),
            ("[camera]\nnear = .5", "falta um dígito antes do ponto"),
            ("[camera]\nnear = 5.", "falta um dígito depois do ponto"),
            ("[camera]\nnear = \"5", "falta fechar um texto com aspas"),
        ] {
            let (_, pt) = both(text);
            assert!(pt.contains(portuguese), "{pt}");
        }
    }
}
