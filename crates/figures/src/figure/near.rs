//! Guesses the key that an author probably meant.

/// Keys and words, with their names in other programs and in the notes, and typing errors.
const SYNONYMS: &[(&str, &str)] = &[
    ("view_angle", "fov fovy fov_y field_of_view angle theta viewangle"),
    ("position", "eye c location camera_position from pos"),
    ("view_up", "up vup up_vector"),
    ("focal_point", "lookat look_at target center centre at to pf ref"),
    ("near", "znear z_near near_plane front"),
    ("far", "zfar z_far far_plane back"),
    ("aspect", "aspect_ratio ratio"),
    ("parallel", "orthographic orthogonal ortho"),
    ("projection", "type mode"),
    ("shape", "type"),
    ("kind", "type"),
    ("left", "l"),
    ("right", "r"),
    ("bottom", "b"),
    ("top", "t"),
    ("width", "w"),
    ("height", "h"),
    ("color", "colour"),
    ("translate", "position translation"),
    ("rotate", "rotation"),
    ("scale", "size"),
    ("segments", "slices resolution"),
    ("path", "file"),
    ("points", "vertices segments"),
    ("antialias", "samples msaa antialiasing"),
    ("target", "position focal_point"),
    ("depth", "z_buffer zbuffer"),
    ("clipping", "clip"),
    ("culled", "culling cull"),
    ("camera", "cam"),
    ("box", "cube"),
    ("sphere", "ball"),
    ("title", "name heading"),
    ("caption", "description"),
    ("pictures", "views"),
    ("arrangement", "layout"),
    ("panel", "explanation tab"),
    ("photograph", "photo"),
    ("photograph_opacity", "opacity"),
    ("torus", "donut"),
];

/// The entry of `known` that `word` probably means, or its section if it has another `home`.
pub(super) fn key(word: &str, known: &[&str], home: impl Fn(&str) -> Option<String>) -> Option<String> {
    let lower = word.to_lowercase();
    known
        .iter()
        .find(|key| key.eq_ignore_ascii_case(word))
        .map(|key| (*key).to_owned())
        .or_else(|| synonym(word, known))
        .or_else(|| home(&lower))
        .or_else(|| by_letters(word, known.iter().copied()))
        .or_else(|| SYNONYMS.iter().find(|(_, words)| has(words, &lower)).and_then(|(key, _)| home(key)))
}

/// The entry of `known` that `word` probably means.
pub(super) fn word(word: &str, known: &[&str]) -> Option<String> {
    synonym(word, known).or_else(|| by_letters(word, known.iter().copied()))
}

/// The label name that `name` probably means.
pub(super) fn name(name: &str, known: &[&str]) -> Option<String> {
    let same = known.iter().find(|other| other.eq_ignore_ascii_case(name));
    same.map(|same| (*same).to_owned()).or_else(|| by_letters(name, known.iter().copied()))
}

fn synonym(word: &str, known: &[&str]) -> Option<String> {
    let word = word.to_lowercase().replace('-', "_");
    SYNONYMS.iter().find(|(key, words)| has(words, &word) && known.contains(key)).map(|(key, _)| (*key).to_owned())
}

fn has(words: &str, word: &str) -> bool {
    words.split(' ').any(|one| one == word)
}

/// The entry of `known` that differs least in its letters, if the difference is small.
pub(super) fn by_letters<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    const LONGEST: usize = 64;
    let plain = |s: &str| s.to_lowercase().replace(['-', ' '], "_");
    let word = plain(word);
    let letters = word.chars().count();
    if letters > LONGEST {
        return None;
    }
    // Inserted, deleted and replaced letters, and letters that have changed places with their neighbours.
    let (best, steps) = known.map(|k| (k, strsim::osa_distance(&word, &plain(k)))).min_by_key(|(_, steps)| *steps)?;
    (steps <= 2 && steps * 2 < letters.max(2)).then(|| best.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::figure::keys::home;

    const CAMERA: &[&str] = &["position", "focal_point", "view_up", "view_angle", "aspect", "near", "far"];

    #[test]
    fn other_programs_names_lead_to_ours() {
        for (theirs, ours) in [("fov", "view_angle"), ("eye", "position"), ("up", "view_up"), ("zNear", "near")] {
            assert_eq!(key(theirs, CAMERA, home).as_deref(), Some(ours));
        }
    }

    #[test]
    fn typing_errors_lead_to_the_key() {
        for (typed, ours) in
            [("focalpoint", "focal_point"), ("apsect", "aspect"), ("View_Up", "view_up"), ("nera", "near")]
        {
            assert_eq!(key(typed, CAMERA, home).as_deref(), Some(ours));
        }
    }

    #[test]
    fn a_key_in_the_wrong_section_is_sent_home() {
        assert_eq!(key("theme", CAMERA, home).as_deref(), Some("[style] theme"));
        assert_eq!(key("fov", &["width", "height"], home).as_deref(), Some("[camera] view_angle"));
    }

    #[test]
    fn names_that_resemble_nothing_get_no_suggestion() {
        assert_eq!(key("banana", CAMERA, home), None);
        assert_eq!(key("", CAMERA, home), None);
        assert_eq!(key(&"near".repeat(100_000), CAMERA, home), None);
    }

    #[test]
    fn a_word_may_differ_by_less_than_half_of_its_letters_and_by_two() {
        let near = |typed: &str, known: &'static str| by_letters(typed, [known].into_iter()).is_some();
        assert!(near("abcde", "abxye") && near("abc", "abx"), "two of five, one of three");
        assert!(!near("abcd", "xycd") && !near("ab", "ax"), "half");
        assert!(!near("abcdefghij", "xyzdefghij"), "three");
        let long = "a".repeat(64);
        assert_eq!(
            by_letters(&long, [&long[1..]].into_iter()).as_deref(),
            Some(&long[1..]),
            "the longest that is looked at"
        );
        assert_eq!(by_letters(&"a".repeat(65), [long.as_str()].into_iter()), None);
    }
}
