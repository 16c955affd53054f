//! Faults of figure files, in both languages.

use super::cameras::camera;
use super::expressions::in_expression;
use super::scene_errors::scene_wording;
use super::toml_complaints;
use crate::figure::FigureError;
use crate::figure::error::{Allowed, Problem};
use crate::formula::{FormulaError, FormulaProblem};
use crate::limits::{MAX_FORMULA, MAX_TEXTURE_SCALE};
use crate::sanitize::escaped;

texts!("messages/figure_files");

/// The reason why a text isn't a figure: line, key, the value found, the values allowed.
pub fn figure(lang: Lang, error: &FigureError) -> String {
    let line = text!(lang, figure, line = error.line);
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
pub(crate) fn problem(lang: Lang, problem: &Problem) -> String {
    match problem {
        Problem::NotUtf8 { byte } => text!(lang, problem_not_utf8, byte),
        Problem::TooLarge { limit } => text!(lang, problem_too_large, limit),
        Problem::Syntax { found, detail } => {
            let detail = toml_complaint(lang, detail);
            text!(lang, problem_syntax, found, detail)
        }
        Problem::Unquoted { text } => text!(lang, problem_unquoted, text),
        Problem::Duplicate => text!(lang, problem_duplicate).to_owned(),
        Problem::Rival { other, ways } => {
            let ways = ways.join(", ");
            text!(lang, problem_rival, other, ways)
        }
        Problem::TooMany { count, limit } => text!(lang, problem_too_many, count, limit),
        Problem::UnknownKey { near, known } => {
            let (near, known) = (meant(lang, near.as_deref()), known.join(", "));
            text!(lang, problem_unknown_key, near, known)
        }
        Problem::Value { found, allowed } => {
            let allowed = self::allowed(lang, allowed);
            text!(lang, problem_value, found, allowed)
        }
        Problem::Expression { text, error, allowed } => {
            let (why, allowed) = (in_expression(lang, text, error), self::allowed(lang, allowed));
            text!(lang, problem_expression, text = escaped(text), why, allowed)
        }
        Problem::Missing { allowed } => {
            let allowed = self::allowed(lang, allowed);
            text!(lang, problem_missing, allowed)
        }
        Problem::Formula(error) => formula(lang, error),
        Problem::Scene { error, near } => scene_wording(lang, error).full + &meant(lang, near.as_deref()),
        Problem::Camera(error) => camera(lang, error),
    }
}

/// The reason why a formula of a text is refused.
pub(crate) fn formula(lang: Lang, FormulaError { formula, problem }: &FormulaError) -> String {
    let (limit, depth) = MAX_FORMULA;
    let why = match problem {
        FormulaProblem::Open => text!(lang, formula_open).to_owned(),
        FormulaProblem::Empty => text!(lang, formula_empty).to_owned(),
        FormulaProblem::Word(word) => text!(lang, formula_word, word = escaped(word)),
        FormulaProblem::Environment(name) => text!(lang, formula_environment, name = escaped(name)),
        FormulaProblem::Character('\n') => text!(lang, formula_character).to_owned(),
        FormulaProblem::Character(c) => text!(lang, formula_character_named, named = named(*c)),
        FormulaProblem::Unbalanced(what) => text!(lang, formula_unbalanced, what = escaped(what)),
        FormulaProblem::NotOnALine(what) => text!(lang, formula_not_on_aline, what = escaped(what)),
        FormulaProblem::TooLong => text!(lang, formula_too_long, limit, depth),
    };
    let formula = escaped(formula);
    text!(lang, formula, formula, why)
}

/// A character with its number, so that look-alikes can be distinguished.
fn named(c: char) -> String {
    format!("{} (U+{:04X})", escaped(&c.to_string()), u32::from(c))
}

/// A complaint of the TOML parser, which speaks English. Its common ones are known, others stay as they are.
fn toml_complaint(lang: Lang, detail: &str) -> &str {
    let own = toml_complaints::texts(lang).entries();
    let mut known = toml_complaints::texts(Lang::En).entries().into_iter().zip(own);
    let found = known.find(|((_, english), (_, own))| detail.starts_with(english) && own != english);
    found.map_or(detail, |(_, (_, own))| own)
}

pub(crate) fn meant(lang: Lang, near: Option<&str>) -> String {
    near.map(escaped).map_or_else(String::new, |near| text!(lang, meant, near))
}

fn allowed(lang: Lang, allowed: &Allowed) -> String {
    match allowed {
        Allowed::Number => text!(lang, allowed_number).to_owned(),
        Allowed::PositiveNumber => text!(lang, allowed_positive_number).to_owned(),
        Allowed::NumberIn(least, most) => text!(lang, allowed_number_in, least, most),
        Allowed::HalfTurn => text!(lang, allowed_half_turn).to_owned(),
        Allowed::PositivePair => text!(lang, allowed_positive_pair).to_owned(),
        Allowed::IntegerIn(least, most) => text!(lang, allowed_integer_in, least, most),
        Allowed::Integers(choice) => {
            let choice: Vec<_> = choice.iter().map(ToString::to_string).collect();
            choice.join(", ")
        }
        Allowed::Switch => "true, false".to_owned(),
        Allowed::SwitchOr(words) => {
            words.iter().fold("true, false".to_owned(), |list, word| format!("{list}, \"{word}\""))
        }
        Allowed::Vector => text!(lang, allowed_vector).to_owned(),
        Allowed::NonZeroVector => text!(lang, allowed_non_zero_vector).to_owned(),
        Allowed::TextureScale => text!(lang, allowed_texture_scale, MAX_TEXTURE_SCALE),
        Allowed::NonZeroScale => text!(lang, allowed_non_zero_scale).to_owned(),
        Allowed::Camera => text!(lang, allowed_camera).to_owned(),
        Allowed::PointInImage => text!(lang, allowed_point_in_image).to_owned(),
        Allowed::ObjectPoint => text!(lang, allowed_object_point).to_owned(),
        Allowed::Seen => text!(lang, allowed_seen).to_owned(),
        Allowed::Points => text!(lang, allowed_points).to_owned(),
        Allowed::PointPairs => text!(lang, allowed_point_pairs).to_owned(),
        Allowed::Color => text!(lang, allowed_color).to_owned(),
        Allowed::Text => text!(lang, allowed_text).to_owned(),
        Allowed::Word { words, near } => {
            format!("{}{}", quoted(words), meant(lang, near.as_deref()))
        }
        Allowed::Words(words) => text!(lang, allowed_words, quoted = quoted(words)),
        Allowed::TomlValue => text!(lang, allowed_toml_value).to_owned(),
        Allowed::Pair => text!(lang, allowed_pair).to_owned(),
        Allowed::Pixel => text!(lang, allowed_pixel).to_owned(),
        Allowed::Matrix => text!(lang, allowed_matrix).to_owned(),
        Allowed::Bilingual
        | Allowed::BilingualLine { .. }
        | Allowed::ToldList
        | Allowed::Texts
        | Allowed::Line { .. }
        | Allowed::Name { .. }
        | Allowed::FreeName => allowed_text(lang, allowed),
        Allowed::Operations => text!(lang, allowed_operations).to_owned(),
        Allowed::KeyOfSteps => text!(lang, allowed_key_of_steps).to_owned(),
        Allowed::Exercise => text!(lang, allowed_exercise).to_owned(),
        Allowed::Ways => text!(lang, allowed_ways).to_owned(),
        Allowed::Pixels => text!(lang, allowed_pixels).to_owned(),
        Allowed::Numbers => text!(lang, allowed_numbers).to_owned(),
        Allowed::Quantity => text!(lang, allowed_quantity).to_owned(),
        Allowed::NotAbove(key) => text!(lang, allowed_not_above, key),
        Allowed::Compatible => text!(lang, allowed_compatible).to_owned(),
        Allowed::TwoVectors => text!(lang, allowed_two_vectors).to_owned(),
        Allowed::Either(one, other) => text!(lang, allowed_either, one, other),
        Allowed::Choice(choices) => {
            choices.iter().map(|choice| format!("\"{}\"", escaped(choice))).collect::<Vec<_>>().join(", ")
        }
        Allowed::WrongAnswer => text!(lang, allowed_wrong_answer).to_owned(),
        Allowed::NotePlace => text!(lang, allowed_note_place).to_owned(),
        Allowed::PairIn(least, most) => text!(lang, allowed_pair_in, least, most),
        Allowed::Section => text!(lang, allowed_section).to_owned(),
        Allowed::Sections => text!(lang, allowed_sections).to_owned(),
    }
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}

/// The allowed forms of a text.
fn allowed_text(lang: Lang, allowed: &Allowed) -> String {
    match allowed {
        Allowed::BilingualLine { limit } => {
            let longest = text!(lang, allowed_text_longest, limit);
            allowed_text(lang, &Allowed::Bilingual) + &longest
        }
        Allowed::ToldList => text!(lang, allowed_text_told_list).to_owned(),
        Allowed::Line { limit } => text!(lang, allowed_text_line, limit),
        Allowed::Texts => text!(lang, allowed_text_texts).to_owned(),
        Allowed::Name { limit } => text!(lang, allowed_text_name, limit),
        Allowed::FreeName => text!(lang, allowed_text_free_name).to_owned(),
        _ => text!(lang, allowed_text_plain).to_owned(),
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
    fn messages_name_line_key_value_and_allowed_values() {
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
