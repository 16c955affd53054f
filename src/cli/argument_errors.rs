//! Faulty arguments in words. Clap speaks English.

use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::sanitize;
use camera_lab_words::{Grammar, Lang, command_line as texts};

/// Faulty arguments, in one paragraph.
pub(super) fn in_words(lang: Lang, error: &clap::Error) -> String {
    let before_the_command =
        error.kind() == ErrorKind::ArgumentConflict && error.get(ContextKind::InvalidSubcommand).is_some();
    let what = match lang.grammar() {
        _ if before_the_command => texts::before_the_command(lang).to_owned(),
        Grammar::Portuguese => portuguese(error),
        Grammar::English => english(error),
    };
    // It may contain typed text of any length.
    let what = sanitize::within(&what, 600);
    format!("{what}{}", texts::see_help(lang))
}

/// Clap's own words, without its usage lines, on one line.
fn english(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let parts: Vec<String> = text
        .split("\n\n")
        .map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "))
        .filter(|part| !part.is_empty() && !part.starts_with("Usage:") && !part.starts_with("For more information"))
        .collect();
    let text = parts.join("; ");
    text.strip_prefix("error: ").unwrap_or(&text).to_owned()
}

fn portuguese(error: &clap::Error) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        Some(ContextValue::Number(number)) => number.to_string(),
        _ => String::new(),
    };
    let arg = context(ContextKind::InvalidArg);
    let value = context(ContextKind::InvalidValue);
    let mut text = match error.kind() {
        ErrorKind::InvalidValue if value.is_empty() => format!("falta um valor para '{arg}'"),
        ErrorKind::InvalidValue => format!("valor '{value}' inválido para '{arg}'"),
        ErrorKind::UnknownArgument => format!("argumento '{arg}' desconhecido"),
        ErrorKind::InvalidSubcommand => format!("comando '{}' desconhecido", context(ContextKind::InvalidSubcommand)),
        ErrorKind::ValueValidation => format!("valor '{value}' inválido para '{arg}'"),
        ErrorKind::TooManyValues => format!("valor '{value}' a mais para '{arg}'"),
        ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues => format!("número errado de valores para '{arg}'"),
        ErrorKind::NoEquals => format!("falta '=' depois de '{arg}'"),
        ErrorKind::ArgumentConflict => {
            let other = context(ContextKind::PriorArg);
            if other.is_empty() || other == arg {
                format!("'{arg}' só pode ser usado uma vez")
            } else {
                format!("'{arg}' não pode ser usado com '{other}'")
            }
        }
        ErrorKind::MissingRequiredArgument => format!("falta o argumento obrigatório {arg}"),
        ErrorKind::InvalidUtf8 => "um argumento não é UTF-8".to_owned(),
        _ => english(error),
    };
    for (kind, before) in [
        (ContextKind::ValidValue, "permitido"),
        (ContextKind::SuggestedArg, "você quis dizer"),
        (ContextKind::SuggestedValue, "você quis dizer"),
        (ContextKind::SuggestedSubcommand, "você quis dizer"),
    ] {
        let found = context(kind);
        if !found.is_empty() {
            text += &format!("; {before}: {found}");
        }
    }
    text
}
