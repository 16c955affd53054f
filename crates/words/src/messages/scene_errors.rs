//! The reasons why objects and lights aren't a scene, in both languages.

use super::meshes::mesh;
use super::unreadable::read_problem;
use super::wording::Wording;
use crate::Grammar;
use crate::limits::{MAX_LIGHTS, MAX_OBJECTS, MAX_SEGMENTS, MAX_SHADOW_TEXELS, MIN_SEGMENTS};
use crate::sanitize::escaped;
use crate::scene::{MeshError, SceneError, chain_text};
use crate::window;

texts!("messages/scene_errors");

/// The reason why the objects and lights of a figure aren't a scene. Names the object and the key.
pub fn scene(lang: Lang, error: &SceneError) -> String {
    let (key, why) = (error.key(), scene_wording(lang, error).full);
    match error {
        SceneError::DuplicateName { .. } | SceneError::Cycle { .. } => format!("[[scene.objects]] {key} {why}"),
        SceneError::UnknownParent { name, .. }
        | SceneError::Mesh { name, .. }
        | SceneError::NotFinite { name, .. }
        | SceneError::ZeroScale { name }
        | SceneError::Segments { name, .. } => format!("[[scene.objects]] \"{}\": {key} {why}", escaped(name)),
        SceneError::Light { index, .. } => format!("[[scene.lights]] {}: {key} {why}", index + 1),
        _ => format!("[scene] {key} {why}"),
    }
}

/// The reason why a scene can't be built, for the window, where an object has its name and no section of a file.
pub fn scene_in_window(lang: Lang, error: &SceneError) -> String {
    match error {
        SceneError::Mesh { name, .. } => format!("“{}”: {}", escaped(name), scene_wording(lang, error).in_symbols),
        _ => scene(lang, error),
    }
}

/// The reason why a mesh that's opened by itself makes no scene. It has no section that you could look for.
pub fn opened_mesh(lang: Lang, path: &str, error: &SceneError) -> String {
    let why = scene_wording(lang, error).in_symbols;
    match error {
        // The other formats hold no camera, or none as text.
        SceneError::Mesh { path, error: MeshError::Empty, .. } if path.to_lowercase().ends_with(".gltf") => {
            format!("{why}. {}", window::texts(lang).paste_camera)
        }
        // The file is named in it.
        SceneError::Mesh { .. } => why,
        _ => format!("{path}: {why}"),
    }
}

/// The reason why an object or a light is impossible, in full as after the key, otherwise as beside the field. The full
/// form in English is the error's own.
pub(crate) fn scene_wording(lang: Lang, error: &SceneError) -> Wording {
    let english = |beside_field: &str| Wording::new(error.to_string(), beside_field);
    match (lang.grammar(), error) {
        (Grammar::English, SceneError::DuplicateName { .. }) => english("another object has this name"),
        (Grammar::Portuguese, SceneError::DuplicateName { name }) => Wording::new(
            format!("é \"{}\", como um objeto anterior; permitido: um nome único", escaped(name)),
            "outro objeto tem este nome",
        ),
        (_, SceneError::UnknownParent { parent, .. }) => pick!(lang;
            english(&format!("there is no object “{}”", escaped(parent))),
            Wording::new(format!("é \"{}\", que não é o nome de um objeto; permitido: o nome de um objeto", escaped(parent)), format!("não há objeto “{}”", escaped(parent)))),
        (Grammar::English, SceneError::Cycle { chain }) => {
            english(&format!("parents form a cycle: {}", chain_text(chain)))
        }
        (Grammar::Portuguese, SceneError::Cycle { chain }) => {
            let chain = chain_text(chain);
            Wording::new(
                format!("forma um ciclo ({chain}); permitido: pais que formem uma árvore"),
                format!("os pais formam um ciclo: {chain}"),
            )
        }
        (_, SceneError::NotFinite { .. }) => pick!(lang;
            english("in the world these numbers exceed the range (about 1e308)"),
            Wording::new("leva a números que não são finitos; permitido: transformações cujo produto fique abaixo de cerca de 1e308", "no mundo estes números saem da faixa (cerca de 1e308)")),
        (_, SceneError::ZeroScale { .. }) => pick!(lang; english("the scale must not be 0 along any axis"),
            Wording::new("é 0 em algum eixo; permitido: quaisquer outros números", "a escala não pode ser 0 em nenhum eixo")),
        (Grammar::English, SceneError::Segments { .. }) => english(&segments_allowed(lang)),
        (Grammar::Portuguese, SceneError::Segments { found, .. }) => Wording::new(
            format!("é {found}; permitido: um inteiro de {MIN_SEGMENTS} a {MAX_SEGMENTS}"),
            segments_allowed(lang),
        ),
        (_, SceneError::Mesh { path, error, .. }) => {
            let (path, why) = (escaped(path), after_path(lang, &escaped(path), error));
            Wording::new(format!("\"{path}\"{why}"), format!("{path}{why}"))
        }
        (_, SceneError::TooManyObjects) => pick!(lang; english(&format!("at most {MAX_OBJECTS} objects")),
            Wording::new(format!("são demais, com os de suas malhas; permitido: no máximo {MAX_OBJECTS}"), format!("no máximo {MAX_OBJECTS} objetos"))),
        (Grammar::English, SceneError::TooManyLights { .. }) => english(&format!("at most {MAX_LIGHTS} lights")),
        (Grammar::Portuguese, SceneError::TooManyLights { found }) => Wording::new(
            format!("são {found}; permitido: no máximo {MAX_LIGHTS}"),
            format!("no máximo {MAX_LIGHTS} luzes"),
        ),
        (Grammar::English, SceneError::ShadowMaps { .. }) => {
            english(&format!("shadow maps of at most {MAX_SHADOW_TEXELS} texels together, six for a point light"))
        }
        (Grammar::Portuguese, SceneError::ShadowMaps { texels }) => Wording::new(
            format!(
                "têm mapas de sombras de {texels} texels, seis por luz pontual; permitido: no máximo {MAX_SHADOW_TEXELS}"
            ),
            format!("mapas de sombras de no máximo {MAX_SHADOW_TEXELS} texels ao todo, seis por luz pontual"),
        ),
        (Grammar::English, SceneError::Light { key: "direction", .. }) => english("the direction must not be 0"),
        (Grammar::English, SceneError::Light { .. }) => english("the position must be finite"),
        (Grammar::Portuguese, SceneError::Light { key, .. }) => Wording::new(
            "deve ter três números finitos, nem todos 0 numa direção",
            if *key == "direction" { "a direção não pode ser nula" } else { "a posição tem de ser finita" },
        ),
        (_, other) => english(&other.to_string()),
    }
}

/// The reason why a mesh file can't be used, after its name, which isn't repeated.
fn after_path(lang: Lang, path: &str, error: &MeshError) -> String {
    match error {
        MeshError::Unreadable(error) if error.file == path => format!(" {}", read_problem(lang, &error.problem)),
        error => format!(": {}", mesh(lang, error)),
    }
}

/// The allowed numbers of segments, beside the field.
pub fn segments_allowed(lang: Lang) -> String {
    text!(lang, segments_allowed, MIN_SEGMENTS, MAX_SEGMENTS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::read;
    use crate::messages::figure;
    use crate::scene::{ReadError, ReadProblem};

    #[test]
    fn every_error_is_worded_twice_in_both_languages() {
        let (name, path) = (|| "a".to_owned(), "a.obj".to_owned());
        let lost = ReadError { file: path.clone(), problem: ReadProblem::Directory };
        for error in [
            SceneError::DuplicateName { name: name() },
            SceneError::UnknownParent { name: name(), parent: "b".to_owned() },
            SceneError::Cycle { chain: vec![name(), name()] },
            SceneError::NotFinite { name: name(), key: "translate" },
            SceneError::ZeroScale { name: name() },
            SceneError::Segments { name: name(), found: 2 },
            SceneError::Mesh { name: name(), path, error: MeshError::Unreadable(Box::new(lost)) },
            SceneError::Light { index: 0, key: "direction" },
            SceneError::Light { index: 0, key: "position" },
        ] {
            let (en, pt) = (scene_wording(Lang::En, &error), scene_wording(Lang::PtBr, &error));
            assert_eq!(en.full, error.to_string());
            assert_ne!(en.full, pt.full);
            assert_ne!(en.in_symbols, pt.in_symbols);
            assert!(scene(Lang::PtBr, &error).ends_with(&pt.full));
        }
    }

    #[test]
    fn a_path_appears_once_if_it_was_looked_for_under_the_same_name() {
        let of = |file: &str| SceneError::Mesh {
            name: "a".to_owned(),
            path: "a.obj".to_owned(),
            error: MeshError::Unreadable(Box::new(ReadError {
                file: file.to_owned(),
                problem: ReadProblem::Directory,
            })),
        };
        for lang in [Lang::En, Lang::PtBr] {
            for text in [scene(lang, &of("a.obj")), scene_wording(lang, &of("a.obj")).in_symbols] {
                assert_eq!(text.matches("a.obj").count(), 1, "{text}");
            }
            assert!(scene(lang, &of("/elsewhere/a.obj")).contains("\"a.obj\": /elsewhere/a.obj"));
        }
    }

    #[test]
    fn the_object_that_was_probably_meant_is_named_last() {
        let text = "[scene]\npreset = \"empty\"\n[[scene.objects]]\nname = \"arm\"\n[[scene.objects]]\nname = \"hand\"\nparent = \"amr\"\n";
        let error = read::parse(text).expect_err("a fault");
        assert_eq!(
            figure(Lang::En, &error),
            "line 7: [[scene.objects]] parent is \"amr\", which is not the name of an object; allowed: the name of an object \
             (did you mean arm?)"
        );
        assert!(figure(Lang::PtBr, &error).ends_with("o nome de um objeto (você quis dizer arm?)"));
    }
}
