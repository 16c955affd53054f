use super::setting;
use crate::exercises::{Expected, Free, Kind, entries};

#[test]
fn every_way_leads_to_the_answer() {
    let (mut ways, mut missing) = (0, Vec::new());
    for entry in entries() {
        for seed in 0..4 {
            let exercise = entry.exercise(seed, &Free::new());
            for ask in &exercise.asks {
                let steps = ask.steps();
                let Some(right) = ask.expected().table().filter(|_| !steps.is_empty()) else {
                    assert!(
                        matches!(ask.kind, Kind::Choice(_) | Kind::Camera) || steps.is_empty(),
                        "{} {}",
                        entry.id,
                        ask.name
                    );
                    continue;
                };
                ways += 1;
                let context = format!("{} seed {seed} {}", entry.id, ask.name);
                let rows: Vec<f64> = steps.iter().flat_map(|step| &step.rows).map(|row| row.value).collect();
                if entry.id == "outcodes" {
                    // An outcode isn't a computed number. It consists of the signs of the rows.
                    let signs: Vec<f64> = rows.iter().map(|value| f64::from(u8::from(*value < 0.0))).collect();
                    assert_eq!(right.entries, signs, "{context}");
                    continue;
                }
                // Entries that are 0 or 1 for every camera have no row. The painter's order is that of the rows, and
                // has no row itself.
                let is_given = |value: f64| value == 0.0 || value.abs() == 1.0;
                let is_read_off = entry.id == "painter";
                for value in right.entries.iter().filter(|value| !is_given(**value) && !is_read_off) {
                    let near = |row: &f64| (row - value).abs() <= 1e-9 * value.abs().max(1.0);
                    if !rows.iter().any(near) {
                        missing.push(format!("{context}: {value}"));
                    }
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(ways > 250, "{ways}");
}

#[test]
fn every_row_is_its_formula_also_on_the_way_to_a_camera() {
    let mut cameras = 0;
    for entry in entries() {
        for seed in 0..4 {
            let exercise = entry.exercise(seed, &Free::new());
            for ask in &exercise.asks {
                let context = format!("{} seed {seed} {}", entry.id, ask.name);
                let steps = ask.steps();
                let mut values = Vec::new();
                for step in &steps {
                    let Ok(camera) = step.subject.camera() else { panic!("{context}: {}", step.heading) };
                    let setting = setting(&camera, &step.subject);
                    let setting = step.point.map_or_else(|| setting.clone(), |point| setting.clone().with_point(point));
                    for row in &step.rows {
                        let of_formula = row.formula.value(&setting);
                        let near = (of_formula - row.value).abs() <= 1e-9 * row.value.abs().max(1.0);
                        assert!(near, "{context}, {}: {of_formula} for {}", step.heading, row.value);
                        values.push(row.value);
                    }
                }
                let Expected::Camera(_, model, ..) = ask.expected() else { continue };
                cameras += 1;
                let wanted = [model.position.to_array(), model.focal_point.to_array()].concat();
                for value in wanted.into_iter().filter(|value| *value != 0.0) {
                    let near = |row: &f64| (row - value).abs() <= 1e-9 * value.abs().max(1.0);
                    let is_given = entry.id == "match-picture" && model.focal_point.to_array().contains(&value);
                    assert!(is_given || values.iter().any(near), "{context}: {value} in {values:?}");
                }
            }
        }
    }
    assert_eq!(cameras, 4 + 4 + 4 + 4, "of [0] 5.3 and three families");
}
