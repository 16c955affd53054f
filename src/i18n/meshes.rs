//! What is wrong with a mesh file, in both languages.

use super::Lang;
use super::unreadable::unreadable;
use crate::scene::{GltfFault, MeshError, ObjFault};

/// Why a mesh file cannot be used.
pub(super) fn mesh(lang: Lang, error: &MeshError) -> String {
    let text = |en: &str, pt: &str| match lang {
        Lang::En => en.to_owned(),
        Lang::PtBr => pt.to_owned(),
    };
    match error {
        MeshError::Unreadable(error) => unreadable(lang, error),
        MeshError::Format => text(
            "the format is not known; allowed: a name that ends with .obj, .gltf or .glb",
            "o formato não é conhecido; permitido: um nome que termine com .obj, .gltf ou .glb",
        ),
        MeshError::Empty => text("there is no face in it", "não há nenhuma face nele"),
        MeshError::TooLarge => text("it has too many vertices", "ele tem vértices demais"),
        MeshError::Obj { line, fault } => format!("{} {line}: {}", text("line", "linha"), obj(lang, fault)),
        MeshError::Json { line, column, detail } => {
            format!("{} {line}, {} {column}: {detail}", text("line", "linha"), text("column", "coluna"))
        }
        MeshError::Gltf { place, fault } if place.is_empty() => gltf(lang, fault),
        MeshError::Gltf { place, fault } => format!("{place}: {}", gltf(lang, fault)),
    }
}

fn obj(lang: Lang, fault: &ObjFault) -> String {
    match fault {
        _ if lang == Lang::En => fault.to_string(),
        ObjFault::Number { found } => format!("\"{found}\" não é um número finito"),
        ObjFault::Coordinates { found } => format!("há {found} coordenadas; são necessárias 3"),
        ObjFault::Corners { found } => format!("uma face com {found} vértices; são necessários pelo menos 3"),
        ObjFault::Corner { found } => {
            format!("\"{found}\" não é um vértice de face; escreve-se v, v/vt, v//vn ou v/vt/vn com números inteiros")
        }
        ObjFault::Index { found, points, normals } => {
            format!("\"{found}\" indica um ponto ou uma normal que não existe; há {points} pontos e {normals} normais")
        }
    }
}

fn gltf(lang: Lang, fault: &GltfFault) -> String {
    match fault {
        GltfFault::File { uri, error } => format!("\"{uri}\": {}", unreadable(lang, error)),
        _ if lang == Lang::En => fault.to_string(),
        GltfFault::Container { detail } => format!("o arquivo GLB não é válido ({detail})"),
        GltfFault::Value => "um valor que o glTF não permite".to_owned(),
        GltfFault::Missing => "está faltando".to_owned(),
        GltfFault::Reference => "indica algo que não existe".to_owned(),
        GltfFault::Unsupported { what } => format!("{what} não pode ser lido por este programa"),
        GltfFault::NoBytes => "faltam os bytes do buffer".to_owned(),
        GltfFault::DataUri => "o URI de dados não é um base64 válido".to_owned(),
        GltfFault::OutOfBuffer => "os dados passam do fim do buffer".to_owned(),
        GltfFault::Index { found, vertices } => {
            format!("o índice {found} indica um vértice que não existe; há {vertices}")
        }
        GltfFault::NotFinite => "um número não é finito".to_owned(),
        GltfFault::Tree => "um nó tem dois pais".to_owned(),
    }
}
