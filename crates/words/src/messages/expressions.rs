//! The reasons why an expression isn't a number, in both languages.

use crate::expression::{self, ExpressionError, ExpressionProblem};
use crate::sanitize::escaped;

texts!("messages/expressions");

/// The reason why an expression isn't a number, and the place in it.
pub(crate) fn in_expression(lang: Lang, text: &str, error: &ExpressionError) -> String {
    let (why, marked) = (expression(lang, &error.problem), expression::marked(text, &error.span));
    text!(lang, in_expression, why, marked)
}

/// The reason why an expression isn't a number.
pub fn expression(lang: Lang, problem: &ExpressionProblem) -> String {
    translated! { lang, problem;
        ExpressionProblem::Empty => "falta um número";
        ExpressionProblem::Unexpected(c) => "inesperado: “{}”" (escaped(&c.to_string()));
        ExpressionProblem::Unfinished => "a expressão não terminou";
        ExpressionProblem::UnknownName(name) => "nome desconhecido: “{}”" (escaped(name));
        ExpressionProblem::MissingParenthesis => "falta um “)”";
        ExpressionProblem::MixedUnits => "ângulo e número não se misturam aqui";
        ExpressionProblem::NoUnit(number) => "aqui um ângulo precisa de sua unidade: escreva ({}°)" (escaped(number));
        ExpressionProblem::NotFinite => "o resultado não é um número finito";
        ExpressionProblem::TooLong => "a expressão é longa demais";
    }
}

/// A number isn't whole.
pub fn not_whole(lang: Lang) -> &'static str {
    text!(lang, not_whole)
}

/// A field is full.
pub fn at_most_characters(lang: Lang, most: usize) -> String {
    text!(lang, at_most_characters, most)
}

/// A number is outside a range, which may be that of all numbers greater than 0.
pub fn outside(lang: Lang, low: f64, high: f64) -> String {
    let [least, greatest] = [low, high].map(|bound| lang.mark().printed(&bound.to_string()));
    if low == f64::MIN_POSITIVE {
        return text!(lang, outside_low).to_owned();
    }
    text!(lang, outside, least, greatest)
}
