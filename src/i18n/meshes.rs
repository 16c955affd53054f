//! What is wrong with a mesh file, in both languages.

use super::Lang;
use super::unreadable::unreadable;
use crate::scene::{GltfFault, MeshError, ObjFault};

/// Why a mesh file cannot be used. In English it is the error's own words.
pub(super) fn mesh(lang: Lang, error: &MeshError) -> String {
    match (lang, error) {
        (Lang::En, error) => error.to_string(),
        (Lang::PtBr, MeshError::Unreadable(error)) => unreadable(lang, error),
        (Lang::PtBr, MeshError::Format) => {
            "o formato não é conhecido; permitido: um nome que termine com .obj, .gltf ou .glb".to_owned()
        }
        (Lang::PtBr, MeshError::Empty) => "não há nenhuma face nele".to_owned(),
        (Lang::PtBr, MeshError::TooLarge) => "ele tem vértices demais".to_owned(),
        (Lang::PtBr, MeshError::Obj { line, fault }) => format!("linha {line}: {}", obj_in_portuguese(fault)),
        (Lang::PtBr, MeshError::Json { line, column, detail }) => format!("linha {line}, coluna {column}: {detail}"),
        (Lang::PtBr, MeshError::Gltf { place, fault }) if place.is_empty() => gltf_in_portuguese(fault),
        (Lang::PtBr, MeshError::Gltf { place, fault }) => format!("{place}: {}", gltf_in_portuguese(fault)),
    }
}

fn obj_in_portuguese(fault: &ObjFault) -> String {
    match fault {
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

fn gltf_in_portuguese(fault: &GltfFault) -> String {
    match fault {
        GltfFault::File { uri, error } => format!("\"{uri}\": {}", unreadable(Lang::PtBr, error)),
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
