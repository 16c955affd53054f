//! Messages about windows that didn't close, in both languages.

use std::time::Duration;

use crate::i18n::Lang;

texts_with_values! {
    /// The rest of a session is in the file at `path`, and can't be read.
    damaged(lang, path: &str): "The unsaved changes of a window that did not close properly cannot be read. They are kept in {path}",
        "As mudanças não salvas de uma janela que não fechou direito não podem ser lidas. Estão guardadas em {path}";

    /// The last session is back without some keys of its figure. The whole is in the file at `path`.
    in_part(lang, keys: &str, path: &str): "The last session is restored, but this version does not know {keys}. Everything is kept in {path}. Saving asks for another file.",
        "A última sessão foi restaurada, mas esta versão não conhece {keys}. Tudo está guardado em {path}. Salvar pede outro arquivo.";

    /// All slots hold sessions of other windows.
    no_slot(lang, slots: usize): "A crash would lose the changes in this window, because there are already {slots} unsaved windows. Restore or discard some of those in the list.",
        "Uma falha do programa perderia as mudanças desta janela, pois já há {slots} janelas não salvas. Restaure ou descarte algumas da lista.";

    /// The preferences can't be parsed. They are in the file at `path` now.
    preferences_set_aside(lang, path: &str): "The preferences can't be read. They're kept in {path}, and you begin with new ones.",
        "As preferências não podem ser lidas. Estão guardadas em {path}, e você começa com novas.";

    /// The progress in exercises can't be read. It's in the file at `path` now.
    progress_set_aside(lang, path: &str): "Your progress in exercises can't be read. It's kept in {path}, and you begin anew.",
        "Seu progresso nos exercícios não pode ser lido. Está guardado em {path}, e você recomeça.";

    /// Several files were dropped at once, and only the first was taken.
    first_of_dropped(lang, path: &str, count: usize): "Of {count} files, the window opens one: {path}",
        "De {count} arquivos, a janela abre um: {path}";
}

/// Data that can't be stored: the session of this window, preferences, progress in exercises. `why` is a sentence with
/// the name of the file.
pub fn not_kept(lang: Lang, [session, preferences, progress]: [bool; 3], why: &str) -> String {
    let not_remembered = match (preferences, progress) {
        (false, false) => "",
        (true, false) => pick!(lang; "Preferences are not saved", "As preferências não são salvas"),
        (false, true) => pick!(lang; "Progress in exercises is not saved", "O progresso nos exercícios não é salvo"),
        (true, true) => pick!(lang; "Preferences and progress in exercises are not saved",
            "As preferências e o progresso nos exercícios não são salvos"),
    };
    match (session, not_remembered) {
        (false, _) => format!("{not_remembered}: {why}"),
        (true, "") => both!(lang; "Changes in this window would be lost in a crash: {why}. Trying again.",
            "Mudanças desta janela se perderiam em uma falha do programa: {why}. Nova tentativa em andamento."),
        (true, _) => both!(lang; "{not_remembered}, and changes in this window would be lost in a crash: {why}",
            "{not_remembered}, e mudanças desta janela se perderiam em uma falha do programa: {why}"),
    }
}

/// Nothing can be stored, because the system names no folder for it.
pub const fn no_home(lang: Lang) -> &'static str {
    pick!(lang; "Your account has no home folder, so preferences and progress aren't saved, and a crash would lose your changes",
        "Sua conta não tem pasta pessoal. Preferências e progresso não são salvos, e uma falha do programa perderia suas mudanças")
}

/// An age, in words.
pub fn ago(lang: Lang, age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    let (hours, days) = (minutes / 60, minutes / 1440);
    match minutes {
        0 => both!(lang; "just now", "agora mesmo"),
        1..60 => both!(lang; "{minutes} min ago", "há {minutes} min"),
        60..2880 => both!(lang; "{hours} h ago", "há {hours} h"),
        _ => both!(lang; "{days} days ago", "há {days} dias"),
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
