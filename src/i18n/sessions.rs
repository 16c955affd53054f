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

/// What this window shows is not written down; `why` is a sentence with the name of the file.
#[must_use]
pub fn not_written(lang: Lang, why: &str) -> String {
    match lang {
        Lang::En => format!("Changes of this window would be lost in a crash: {why}. It is tried again."),
        Lang::PtBr => format!("Mudanças desta janela se perderiam em uma queda: {why}. Tenta-se de novo."),
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

/// The preferences are not written down; `why` is a sentence with the name of the file.
#[must_use]
pub fn preferences_not_written(lang: Lang, why: &str) -> String {
    match lang {
        Lang::En => format!("Preferences are not remembered: {why}"),
        Lang::PtBr => format!("As preferências não são lembradas: {why}"),
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

/// What is kept of exercises is not written down; `why` is a sentence with the name of the file.
#[must_use]
pub fn progress_not_written(lang: Lang, why: &str) -> String {
    match lang {
        Lang::En => format!("Progress with exercises is not remembered: {why}"),
        Lang::PtBr => format!("O progresso nos exercícios não é lembrado: {why}"),
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
