//! Why an expression is not a number, in both languages.

use super::Lang;
use crate::expression::{self, ExpressionError, ExpressionProblem};

/// Why an expression is not a number, and where in it that shows.
pub(super) fn in_expression(lang: Lang, text: &str, error: &ExpressionError) -> String {
    let (why, marked) = (expression(lang, &error.problem), expression::marked(text, &error.span));
    match lang {
        Lang::En => format!("{why} in {marked}"),
        Lang::PtBr => format!("{why} em {marked}"),
    }
}

/// Why an expression is not a number.
#[must_use]
pub fn expression(lang: Lang, problem: &ExpressionProblem) -> String {
    match (lang, problem) {
        (Lang::En, problem) => problem.to_string(),
        (Lang::PtBr, ExpressionProblem::Empty) => "falta um número".to_owned(),
        (Lang::PtBr, ExpressionProblem::Unexpected(c)) => format!("inesperado: “{c}”"),
        (Lang::PtBr, ExpressionProblem::Unfinished) => "a expressão não terminou".to_owned(),
        (Lang::PtBr, ExpressionProblem::UnknownName(name)) => format!("nome desconhecido: “{name}”"),
        (Lang::PtBr, ExpressionProblem::MissingParenthesis) => "falta um “)”".to_owned(),
        (Lang::PtBr, ExpressionProblem::MixedUnits) => "ângulo e número não se misturam aqui".to_owned(),
        (Lang::PtBr, ExpressionProblem::NotFinite) => "o resultado não é um número finito".to_owned(),
        (Lang::PtBr, ExpressionProblem::TooLong) => "a expressão é longa demais".to_owned(),
    }
}
