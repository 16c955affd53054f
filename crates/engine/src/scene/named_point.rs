//! Points of an object by their names: the tip of a cone, the centre of a ball, a corner of a box.

use std::str::FromStr;

use glam::DVec3;

use super::tree::edit::{object_named, placement};
use super::{ObjectSpec, Preset, SceneSpec, Shape, build, no_files};
use crate::appearance::Style;
use crate::geometry::Aabb;

/// A point of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectPoint {
    /// The tip of a cone or of a pyramid: `tip`.
    Tip,
    /// The centre of the object's own box: `center`.
    Center,
    /// A corner of the object's own box, from 0: (−, −, −), (+, −, −), (+, +, −), (−, +, −), then the same with +z.
    /// Its name counts from 1: `corner:1` … `corner:8`.
    Corner(usize),
    /// A vertex of its mesh, from 0. Its name counts from 1: `vertex:1` ….
    Vertex(usize),
}

impl FromStr for ObjectPoint {
    type Err = ();

    fn from_str(name: &str) -> Result<Self, ()> {
        let Some((kind, number)) = name.split_once(':') else {
            return match name {
                "tip" => Ok(Self::Tip),
                "center" => Ok(Self::Center),
                _ => Err(()),
            };
        };
        let index = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1)).ok_or(())?;
        match kind {
            "corner" => Ok(Self::Corner(index)),
            "vertex" => Ok(Self::Vertex(index)),
            _ => Err(()),
        }
    }
}

impl ObjectPoint {
    /// The point in the world. `None` if the scene has no such object, if the object has no such point, or if its
    /// vertices come from a file.
    pub fn in_world(self, spec: &SceneSpec, object: &str) -> Option<DVec3> {
        let world_from_object = placement(spec, object).ok()??;
        let object = object_named(spec, object)?;
        let shape = object.shape.clone()?;
        // Alone, so that a file of another object doesn't matter.
        let alone = ObjectSpec { parent: None, texture: None, ..object };
        let alone = SceneSpec { preset: Preset::Empty, objects: vec![alone], lights: Vec::new() };
        let scene = build(&alone, &Style::default(), &mut no_files).ok()?;
        let positions = &scene.objects.first()?.mesh.positions;
        let own_box = Aabb::around(positions.iter().copied())?;
        let point = match self {
            Self::Tip if matches!(shape, Shape::Cone | Shape::Pyramid) => {
                positions.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y))?
            }
            Self::Tip => return None,
            Self::Center => own_box.center(),
            Self::Corner(corner) => {
                let Aabb { min, max } = own_box;
                let [x, y] = *[[min.x, min.y], [max.x, min.y], [max.x, max.y], [min.x, max.y]].get(corner % 4)?;
                DVec3::new(x, y, *[min.z, max.z].get(corner / 4)?)
            }
            Self::Vertex(vertex) => *positions.get(vertex)?,
        };
        Some(world_from_object.transform_point3(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box of 2 × 4 × 6 about (1, 0, 0), on a table that is turned by a quarter and raised by 10; and a cone on it.
    fn scene() -> SceneSpec {
        let table = ObjectSpec::group("table").at(0.0, 10.0, 0.0).turned(0.0, 90.0, 0.0);
        let solid = ObjectSpec::new("box", Shape::Box).at(1.0, 0.0, 0.0).scaled(1.0, 2.0, 3.0).under("table");
        let cone = ObjectSpec::new("cone", Shape::Cone).scaled(1.0, 3.0, 1.0).under("table");
        let mesh = ObjectSpec::new("mesh", Shape::Mesh { path: "there.obj".to_owned() });
        SceneSpec { preset: Preset::Cube, objects: vec![table, solid, cone, mesh], lights: Vec::new() }
    }

    #[track_caller]
    fn assert_at(object: &str, point: &str, expected: [f64; 3]) {
        let point: ObjectPoint = point.parse().expect("a name of a point");
        let found = point.in_world(&scene(), object).expect("a point");
        assert!(found.abs_diff_eq(DVec3::from_array(expected), 1e-12), "{object} {point:?}: {found}");
    }

    #[test]
    fn each_name_is_the_point_where_the_scene_has_it() {
        // A quarter about y takes x to −z, and z to x.
        assert_at("box", "center", [0.0, 10.0, -1.0]);
        let corners = [[0.0, -2.0, -3.0], [2.0, -2.0, -3.0], [2.0, 2.0, -3.0], [0.0, 2.0, -3.0]];
        for (k, [x, y, z]) in corners.into_iter().enumerate() {
            assert_at("box", &format!("corner:{}", k + 1), [z, 10.0 + y, -x]);
            assert_at("box", &format!("corner:{}", k + 5), [-z, 10.0 + y, -x]);
        }
        assert_at("cone", "tip", [0.0, 16.0, 0.0]);
        assert_at("cone", "center", [0.0, 13.0, 0.0]);
        // The first vertex of a rim is on +x.
        assert_at("cone", "vertex:1", [0.0, 10.0, -1.0]);
        assert_at("cube", "corner:7", [1.0, 1.0, 1.0]);
    }

    #[test]
    fn no_point_is_invented() {
        for (object, point) in [
            ("box", ObjectPoint::Tip),
            ("box", ObjectPoint::Corner(8)),
            ("box", ObjectPoint::Vertex(1000)),
            ("table", ObjectPoint::Center),
            ("mesh", ObjectPoint::Center),
            ("nothing", ObjectPoint::Center),
        ] {
            assert_eq!(point.in_world(&scene(), object), None, "{object} {point:?}");
        }
        for name in ["", "top", "tip:1", "corner", "corner:0", "vertex:-1", "vertex:a", "center:"] {
            assert_eq!(name.parse::<ObjectPoint>(), Err(()), "{name}");
        }
    }
}
