//! `[[points]]`: followed points of the world, each with a name.

use glam::DVec3;

/// A followed point.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedPoint {
    /// Not empty, and no other point of the figure has it.
    pub name: String,
    /// World.
    pub position: DVec3,
}

/// True if a point may have this name: it isn't empty, and none of the `others` has it.
pub fn may_be_named<'a>(name: &str, mut others: impl Iterator<Item = &'a NamedPoint>) -> bool {
    !name.is_empty() && others.all(|other| other.name != name)
}

/// The first free name of P, Q, R … P2, Q2 …
pub fn free_name(points: &[NamedPoint]) -> String {
    const LETTERS: [&str; 4] = ["P", "Q", "R", "S"];
    let round = |k: usize| LETTERS.map(|letter| if k == 0 { letter.to_owned() } else { format!("{letter}{}", k + 1) });
    (0..).flat_map(round).find(|name| may_be_named(name, points.iter())).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_free_name_is_new_and_stays_so_however_many_there_are() {
        let mut points = Vec::new();
        for _ in 0..10 {
            let name = free_name(&points);
            assert!(may_be_named(&name, points.iter()), "{name}");
            points.push(NamedPoint { name, position: DVec3::ZERO });
        }
        let names: Vec<_> = points.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["P", "Q", "R", "S", "P2", "Q2", "R2", "S2", "P3", "Q3"]);
        assert!(!may_be_named("", [].iter()));
    }
}
