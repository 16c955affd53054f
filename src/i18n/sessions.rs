//! What is said about windows that did not close, in both languages.

use std::time::Duration;

use super::Lang;

/// What was left is in the file at `path`, and cannot be understood.
#[must_use]
pub fn damaged(lang: Lang, path: &str) -> String {
    match lang {
        Lang::En => format!("What a window left that did not close cannot be understood. It is kept in {path}"),
        Lang::PtBr => format!("O que uma janela que não fechou deixou não pode ser entendido. Está guardado em {path}"),
    }
}

/// The last session is back without some keys of its figure; the whole is in the file at `path`.
#[must_use]
pub fn in_part(lang: Lang, keys: &str, path: &str) -> String {
    match lang {
        Lang::En => format!(
            "The last session is back, but this version does not know {keys}. All of it is kept in {path}; saving asks for another file."
        ),
        Lang::PtBr => format!(
            "A última sessão voltou, mas esta versão não conhece {keys}. Tudo está guardado em {path}; salvar pede outro arquivo."
        ),
    }
}

/// What cannot be kept: what this window shows, preferences, progress with exercises; `why` is a sentence with the name
/// of the file.
#[must_use]
pub fn not_kept(lang: Lang, [session, preferences, progress]: [bool; 3], why: &str) -> String {
    let not_remembered = match (lang, preferences, progress) {
        (_, false, false) => "",
        (Lang::En, true, false) => "Preferences are not remembered",
        (Lang::En, false, true) => "Progress with exercises is not remembered",
        (Lang::En, true, true) => "Preferences and progress with exercises are not remembered",
        (Lang::PtBr, true, false) => "As preferências não são lembradas",
        (Lang::PtBr, false, true) => "O progresso nos exercícios não é lembrado",
        (Lang::PtBr, true, true) => "As preferências e o progresso nos exercícios não são lembrados",
    };
    match (lang, session, not_remembered) {
        (_, false, _) => format!("{not_remembered}: {why}"),
        (Lang::En, true, "") => {
            format!("Changes of this window would be lost in a crash: {why}. It is tried again.")
        }
        (Lang::En, true, _) => format!("{not_remembered}, and changes of this window would be lost in a crash: {why}"),
        (Lang::PtBr, true, "") => {
            format!("Mudanças desta janela se perderiam em uma queda: {why}. Tenta-se de novo.")
        }
        (Lang::PtBr, true, _) => {
            format!("{not_remembered}, e mudanças desta janela se perderiam em uma queda: {why}")
        }
    }
}

/// Nothing can be kept, because the system names no folder for it.
#[must_use]
pub const fn no_home(lang: Lang) -> &'static str {
    match lang {
        Lang::En => {
            "Preferences and progress are not remembered, and changes would be lost in a crash: your account has no home folder"
        }
        Lang::PtBr => {
            "Preferências e progresso não são lembrados, e mudanças se perderiam em uma queda: sua conta não tem pasta pessoal"
        }
    }
}

/// All slots hold what other windows have left.
#[must_use]
pub fn no_slot(lang: Lang, slots: usize) -> String {
    match lang {
        Lang::En => format!(
            "Changes of this window would be lost in a crash: there are {slots} unsaved windows already. Restore or discard what is listed."
        ),
        Lang::PtBr => format!(
            "Mudanças desta janela se perderiam em uma queda: já há {slots} janelas não salvas. Restaure ou descarte o que está na lista."
        ),
    }
}

/// The preferences cannot be understood; they are in the file at `path` now.
#[must_use]
pub fn preferences_set_aside(lang: Lang, path: &str) -> String {
    match lang {
        Lang::En => format!("The preferences cannot be understood. They are kept in {path}; new ones are begun."),
        Lang::PtBr => {
            format!("As preferências não podem ser entendidas. Estão guardadas em {path}; outras são começadas.")
        }
    }
}

/// What is kept of exercises cannot be understood; it is in the file at `path` now.
#[must_use]
pub fn progress_set_aside(lang: Lang, path: &str) -> String {
    match lang {
        Lang::En => {
            format!("Your progress with exercises cannot be understood. It is kept in {path}; a new one is begun.")
        }
        Lang::PtBr => {
            format!("Seu progresso nos exercícios não pode ser entendido. Está guardado em {path}; outro é começado.")
        }
    }
}

/// Of several files that were dropped at once, only the first was taken.
#[must_use]
pub fn first_of_dropped(lang: Lang, path: &str, count: usize) -> String {
    match lang {
        Lang::En => format!("Of {count} files, the window takes one: {path}"),
        Lang::PtBr => format!("De {count} arquivos, a janela recebe um: {path}"),
    }
}

/// How long ago something was.
#[must_use]
pub fn ago(lang: Lang, age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    let (hours, days) = (minutes / 60, minutes / 1440);
    match (lang, minutes) {
        (Lang::En, 0) => "just now".to_owned(),
        (Lang::PtBr, 0) => "agora mesmo".to_owned(),
        (Lang::En, 0..60) => format!("{minutes} min ago"),
        (Lang::En, 60..2880) => format!("{hours} h ago"),
        (Lang::En, _) => format!("{days} days ago"),
        (Lang::PtBr, 0..60) => format!("há {minutes} min"),
        (Lang::PtBr, 60..2880) => format!("há {hours} h"),
        (Lang::PtBr, _) => format!("há {days} dias"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_are_told_in_the_unit_that_fits() {
        let told =
            |seconds| (ago(Lang::En, Duration::from_secs(seconds)), ago(Lang::PtBr, Duration::from_secs(seconds)));
        assert_eq!(told(59), ("just now".to_owned(), "agora mesmo".to_owned()));
        assert_eq!(told(7199), ("1 h ago".to_owned(), "há 1 h".to_owned()));
        assert_eq!(told(172_800), ("2 days ago".to_owned(), "há 2 dias".to_owned()));
    }
}
