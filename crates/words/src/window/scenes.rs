//! The words of the scene: its tree, its objects and lights.

use crate::scene::import::mesh_endings;
use crate::scene::{LightKind, LostFeature, Preset, Shape};

texts!("window/scenes");

impl Texts {
    /// The name of a shape. A group has none.
    pub fn shape(&self, shape: Option<&Shape>) -> &'static str {
        match shape {
            None => self.group,
            Some(Shape::Box) => self.shape_box,
            Some(Shape::Prism) => self.shape_prism,
            Some(Shape::Pyramid) => self.shape_pyramid,
            Some(Shape::Sphere) => self.shape_sphere,
            Some(Shape::Ellipsoid) => self.shape_ellipsoid,
            Some(Shape::Cylinder) => self.shape_cylinder,
            Some(Shape::Cone) => self.shape_cone,
            Some(Shape::Torus) => self.shape_torus,
            Some(Shape::Grid) => self.shape_grid,
            Some(Shape::Points(_)) => self.shape_points,
            Some(Shape::Segments(_)) => self.shape_segments,
            Some(Shape::Mesh { .. }) => self.shape_mesh,
        }
    }

    /// The name of a kind of light.
    pub fn light(&self, kind: LightKind) -> &'static str {
        match kind {
            LightKind::Directional => self.directional,
            LightKind::Point => self.point,
        }
    }
}

texts_with_values! {
    /// The hint at the field for the path of a mesh file.
    path_hint(lang): (endings = mesh_endings());
    /// The name of mesh files in a dialog for files.
    mesh_filter(lang): (endings = mesh_endings());
}

/// The displayed name of an object of a named scene. Figure files have the name itself.
pub fn preset_object(lang: Lang, name: &str) -> String {
    pick!(lang; name.to_owned(), name.split(' ').map(in_portuguese).collect::<Vec<_>>().join(" "))
}

fn in_portuguese(word: &str) -> &str {
    match word {
        "ball" => "bola",
        "beam" => "viga",
        "box" => "caixa",
        "chimney" => "chaminé",
        "column" => "coluna",
        "cone" => "cone",
        "crown" => "copa",
        "cube" => "cubo",
        "cylinder" => "cilindro",
        "door" => "porta",
        "ellipsoid" => "elipsoide",
        "floor" => "piso",
        "grid" => "grade",
        "ground" => "chão",
        "house" => "casa",
        "left" => "esquerda",
        "points" => "pontos",
        "prism" => "prisma",
        "pyramid" => "pirâmide",
        "right" => "direita",
        "roof" => "telhado",
        "segments" => "segmentos",
        "sphere" => "esfera",
        "step" => "degrau",
        "table" => "mesa",
        "torus" => "toro",
        "tree" => "árvore",
        "trunk" => "tronco",
        "walls" => "paredes",
        "window" => "janela",
        other => other,
    }
}

/// The features of a named scene that the list of its objects can't express, as a sentence. Empty if it expresses all.
pub fn lost(lang: Lang, preset: Preset) -> String {
    let lost = beyond(lang, preset.beyond_objects());
    if lost.is_empty() { lost } else { format!("{} {lost}.", texts(lang).lost) }
}

/// The features that a list of objects can't express, as a list.
pub fn beyond(lang: Lang, lost: &[LostFeature]) -> String {
    let word = |what: &LostFeature| match what {
        LostFeature::NumberedFaces => text!(lang, beyond_numbered_faces),
        LostFeature::TiledFloor => text!(lang, beyond_tiled_floor),
        LostFeature::InnerSides => text!(lang, beyond_inner_sides),
        LostFeature::CornerNames => text!(lang, beyond_corner_names),
        LostFeature::WireCube => text!(lang, beyond_wire_cube),
        LostFeature::LetterF => text!(lang, beyond_letter_f),
        LostFeature::Rays => text!(lang, beyond_rays),
    };
    lost.iter().map(word).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::Theme;
    use crate::scene::palette::SceneColors;
    use crate::scene::preset_objects;

    #[test]
    fn every_object_of_a_named_scene_has_a_name_in_both_languages() {
        let mut same = std::collections::BTreeSet::new();
        for preset in [
            Preset::Primitives,
            Preset::Cube,
            Preset::House,
            Preset::Corridor,
            Preset::Pyramid,
            Preset::NdcCube,
            Preset::Exercise51,
            Preset::Exercise52,
            Preset::Exercise53,
        ] {
            for object in preset_objects(preset, &SceneColors::of(Theme::Light)) {
                assert_eq!(preset_object(Lang::En, &object.name), object.name);
                let shown = preset_object(Lang::PtBr, &object.name);
                if shown == object.name {
                    same.insert(shown);
                }
            }
        }
        assert_eq!(same.into_iter().collect::<Vec<_>>(), ["P", "cone"]);
        assert_eq!(preset_object(Lang::PtBr, "column left 3"), "coluna esquerda 3");
    }
}
