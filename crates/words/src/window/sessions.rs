//! Messages about windows that didn't close, in both languages.

use std::time::Duration;

texts!("window/sessions");

texts_with_values! {
    /// The rest of a session is in the file at `path`, and can't be read.
    damaged(lang, path: &str);

    /// The last session is back without some keys of its figure. The whole is in the file at `path`.
    in_part(lang, keys: &str, path: &str);

    /// All slots hold sessions of other windows.
    no_slot(lang, slots: usize);

    /// The preferences can't be parsed. They are in the file at `path` now.
    preferences_set_aside(lang, path: &str);

    /// The progress in exercises can't be read. It's in the file at `path` now.
    progress_set_aside(lang, path: &str);

    /// Several files were dropped at once, and only the first was taken.
    first_of_dropped(lang, path: &str, count: usize);
}

/// Data that can't be stored: the session of this window, preferences, progress in exercises. `why` is a sentence with
/// the name of the file.
pub fn not_kept(lang: Lang, [session, preferences, progress]: [bool; 3], why: &str) -> String {
    let not_remembered = match (preferences, progress) {
        (false, false) => "",
        (true, false) => text!(lang, not_kept_preferences),
        (false, true) => text!(lang, not_kept_progress),
        (true, true) => text!(lang, not_kept_both),
    };
    match (session, not_remembered) {
        (false, _) => format!("{not_remembered}: {why}"),
        (true, "") => text!(lang, not_kept, why),
        (true, _) => text!(lang, not_kept_after_crash, not_remembered, why),
    }
}

/// Nothing can be stored, because the system names no folder for it.
pub const fn no_home(lang: Lang) -> &'static str {
    text!(lang, no_home)
}

/// An age, in words.
pub fn ago(lang: Lang, age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    let (hours, days) = (minutes / 60, minutes / 1440);
    match minutes {
        0 => text!(lang, ago_zero).to_owned(),
        1..60 => text!(lang, ago_minutes, minutes),
        60..2880 => text!(lang, ago_hours, hours),
        _ => text!(lang, ago_days, days),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_have_the_unit_that_fits() {
        let told =
            |seconds| (ago(Lang::En, Duration::from_secs(seconds)), ago(Lang::PtBr, Duration::from_secs(seconds)));
        assert_eq!(told(59), ("just now".to_owned(), "agora mesmo".to_owned()));
        assert_eq!(told(7199), ("1 h ago".to_owned(), "há 1 h".to_owned()));
        assert_eq!(told(172_800), ("2 days ago".to_owned(), "há 2 dias".to_owned()));
    }
}
