//! The key that was probably meant.

/// Names of the keys in other programs, in the notes and in hasty typing.
const SYNONYMS: &[(&str, &str)] = &[
    ("fov", "view_angle"),
    ("fovy", "view_angle"),
    ("fov_y", "view_angle"),
    ("field_of_view", "view_angle"),
    ("angle", "view_angle"),
    ("theta", "view_angle"),
    ("viewangle", "view_angle"),
    ("eye", "position"),
    ("c", "position"),
    ("location", "position"),
    ("camera_position", "position"),
    ("from", "position"),
    ("pos", "position"),
    ("up", "view_up"),
    ("vup", "view_up"),
    ("up_vector", "view_up"),
    ("lookat", "focal_point"),
    ("look_at", "focal_point"),
    ("target", "focal_point"),
    ("center", "focal_point"),
    ("centre", "focal_point"),
    ("at", "focal_point"),
    ("to", "focal_point"),
    ("pf", "focal_point"),
    ("ref", "focal_point"),
    ("znear", "near"),
    ("z_near", "near"),
    ("near_plane", "near"),
    ("front", "near"),
    ("zfar", "far"),
    ("z_far", "far"),
    ("far_plane", "far"),
    ("back", "far"),
    ("aspect_ratio", "aspect"),
    ("ratio", "aspect"),
    ("orthographic", "parallel"),
    ("orthogonal", "parallel"),
    ("ortho", "parallel"),
    ("type", "projection"),
    ("type", "shape"),
    ("type", "kind"),
    ("mode", "projection"),
    ("l", "left"),
    ("r", "right"),
    ("b", "bottom"),
    ("t", "top"),
    ("w", "width"),
    ("h", "height"),
    ("colour", "color"),
    ("position", "translate"),
    ("translation", "translate"),
    ("rotation", "rotate"),
    ("size", "scale"),
    ("slices", "segments"),
    ("resolution", "segments"),
    ("file", "path"),
    ("vertices", "points"),
    ("segments", "points"),
    ("samples", "antialias"),
    ("msaa", "antialias"),
    ("antialiasing", "antialias"),
    ("position", "target"),
    ("focal_point", "target"),
    ("z_buffer", "depth"),
    ("zbuffer", "depth"),
    ("clip", "clipping"),
    ("culling", "culled"),
    ("cull", "culled"),
    ("cam", "camera"),
    ("cube", "box"),
    ("ball", "sphere"),
    ("name", "title"),
    ("heading", "title"),
    ("description", "caption"),
    ("views", "pictures"),
    ("layout", "arrangement"),
    ("explanation", "panel"),
    ("tab", "panel"),
    ("photo", "photograph"),
    ("opacity", "photograph_opacity"),
    ("donut", "torus"),
];

/// The section of a key, for keys in the wrong section.
const HOMES: &[(&str, &str)] = &[
    ("position", "camera"),
    ("focal_point", "camera"),
    ("view_up", "camera"),
    ("projection", "camera"),
    ("view_angle", "camera"),
    ("aspect", "camera"),
    ("near", "camera"),
    ("far", "camera"),
    ("window", "camera"),
    ("width", "image"),
    ("height", "image"),
    ("undistorted", "image"),
    ("photograph", "image"),
    ("photograph_opacity", "image"),
    ("depth_near", "viewport"),
    ("depth_far", "viewport"),
    ("preset", "scene"),
    ("objects", "scene"),
    ("lights", "scene"),
    ("shading", "style"),
    ("visibility", "style"),
    ("hidden_lines", "style"),
    ("antialias", "style"),
    ("theme", "style"),
    ("depth_format", "style"),
    ("depth", "reveal"),
    ("outside", "reveal"),
    ("clipping", "reveal"),
    ("divide_first", "reveal"),
    ("culled", "reveal"),
    ("vanishing", "reveal"),
    ("single_precision", "reveal"),
    ("pictures", "screen"),
    ("arrangement", "screen"),
    ("panel", "screen"),
    ("wiper", "compare"),
    ("differences", "compare"),
];

/// The one of `known` that `word` probably means, or the section where the key belongs.
pub(super) fn key(word: &str, known: &[&str]) -> Option<String> {
    known
        .iter()
        .find(|key| key.eq_ignore_ascii_case(word))
        .map(|key| (*key).to_owned())
        .or_else(|| synonym(word, known))
        .or_else(|| home(&word.to_lowercase()))
        .or_else(|| by_letters(word, known.iter().copied()))
        .or_else(|| SYNONYMS.iter().find(|(other, _)| *other == word.to_lowercase()).and_then(|(_, key)| home(key)))
}

/// The one of `known` that `word` probably means.
pub(super) fn word(word: &str, known: &[&str]) -> Option<String> {
    synonym(word, known).or_else(|| by_letters(word, known.iter().copied()))
}

/// The one of the names of labels that `name` probably means.
pub(super) fn name(name: &str, known: &[&str]) -> Option<String> {
    let same = known.iter().find(|other| other.eq_ignore_ascii_case(name));
    same.map(|same| (*same).to_owned()).or_else(|| by_letters(name, known.iter().copied()))
}

fn synonym(word: &str, known: &[&str]) -> Option<String> {
    let word = word.to_lowercase().replace('-', "_");
    SYNONYMS.iter().find(|(other, key)| *other == word && known.contains(key)).map(|(_, key)| (*key).to_owned())
}

fn home(key: &str) -> Option<String> {
    HOMES.iter().find(|(k, _)| *k == key).map(|(k, section)| format!("[{section}] {k}"))
}

/// The one of `known` that differs least in its letters, where that is little.
pub(super) fn by_letters<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    const LONGEST: usize = 64;
    let plain = |s: &str| s.to_lowercase().replace(['-', ' '], "_");
    let word = plain(word);
    let letters = word.chars().count();
    if letters > LONGEST {
        return None;
    }
    // Inserted, deleted, replaced letters, and such as have changed places with their neighbours.
    let (best, steps) = known.map(|k| (k, strsim::osa_distance(&word, &plain(k)))).min_by_key(|(_, steps)| *steps)?;
    (steps <= 2 && steps * 2 < letters.max(2)).then(|| best.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: &[&str] = &["position", "focal_point", "view_up", "view_angle", "aspect", "near", "far"];

    #[test]
    fn other_programs_names_lead_to_ours() {
        for (theirs, ours) in [("fov", "view_angle"), ("eye", "position"), ("up", "view_up"), ("zNear", "near")] {
            assert_eq!(key(theirs, CAMERA).as_deref(), Some(ours));
        }
    }

    #[test]
    fn typing_errors_lead_to_the_key() {
        for (typed, ours) in
            [("focalpoint", "focal_point"), ("apsect", "aspect"), ("View_Up", "view_up"), ("nera", "near")]
        {
            assert_eq!(key(typed, CAMERA).as_deref(), Some(ours));
        }
    }

    #[test]
    fn a_key_in_the_wrong_section_is_sent_home() {
        assert_eq!(key("theme", CAMERA).as_deref(), Some("[style] theme"));
        assert_eq!(key("fov", &["width", "height"]).as_deref(), Some("[camera] view_angle"));
    }

    #[test]
    fn what_resembles_nothing_gets_no_suggestion() {
        assert_eq!(key("banana", CAMERA), None);
        assert_eq!(key("", CAMERA), None);
        assert_eq!(key(&"near".repeat(100_000), CAMERA), None);
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
