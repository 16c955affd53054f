//! Faults of a mesh file, in both languages.

use super::unreadable::{read_problem, unreadable};
use crate::Lang;

use crate::limits::{MAX_HALVED_TEXELS, MAX_OBJECTS, MAX_TEXELS, MAX_TEXTURE_SIDE};
use crate::scene::import::mesh_endings;
use crate::scene::{GlbFault, GltfFault, JsonFault, MeshError, MeshFault, MeshNotice, TextureError, TextureFault};

/// The reason why a mesh file can't be used. In English, the error's own words.
pub(crate) fn mesh(lang: Lang, error: &MeshError) -> String {
    translated! { lang, error;
        MeshError::Unreadable(error) => "{}" (unreadable(lang, error));
        MeshError::Format => "o formato não é conhecido; permitido: um nome que termine com um destes: {}" (mesh_endings());
        MeshError::Cancelled => "a leitura foi cancelada";
        MeshError::Empty => "não há nenhuma face nele";
        MeshError::TooLarge => "ele tem vértices demais";
        MeshError::TooManyObjects => "ele tem objetos demais; permitido: no máximo {MAX_OBJECTS}";
        MeshError::Line { line, fault } => "linha {line}: {}" (fault_in_portuguese(fault));
        MeshError::Byte { byte, fault } => "byte {byte}: {}" (fault_in_portuguese(fault));
        MeshError::Json { line, column, fault } => "linha {line}, coluna {column}: {}" (json_in_portuguese(fault));
        MeshError::Gltf { place, fault } if place.is_empty() => "{}" (gltf_in_portuguese(fault));
        MeshError::Gltf { place, fault } => "{place}: {}" (gltf_in_portuguese(fault));
    }
}

/// A part of a mesh file that was left out. In English, the notice's own words.
pub fn notice(lang: Lang, notice: &MeshNotice) -> String {
    translated! { lang, notice;
        MeshNotice::IndexIgnored { line, found } =>
            "linha {line}: \"{found}\" indica uma normal ou coordenada de textura que não existe, e índices assim são ignorados";
        MeshNotice::LeftOut { entries } => "fica de fora, pois este programa não usa isso: {entries}";
        MeshNotice::NoMaterial { material, count } =>
            "nenhuma biblioteca do arquivo tem {count} dos materiais usados, como \"{material}\", e suas faces têm a cor do objeto";
        MeshNotice::FacesSkipped { line, found, count: 1 } =>
            "linha {line}: uma face com {found} vértices; ela fica de fora";
        MeshNotice::FacesSkipped { line, found, count } =>
            "linha {line}: uma face com {found} vértices; ela e outras {} ficam de fora" (count - 1);
        MeshNotice::CutAsConvex { count } =>
            "faces côncavas com vértices demais: {count}. São preenchidas como se fossem convexas, o que mostra áreas erradas";
        MeshNotice::Texture(error) =>
            "o arquivo da textura {}, e a cor do objeto aparece em seu lugar" (texture_in_portuguese(error));
        MeshNotice::Photograph(error) =>
            "o arquivo da fotografia {}, e a imagem aparece sem ela" (texture_in_portuguese(error));
        MeshNotice::NoCoordinates => "a malha não tem coordenadas de textura, e a cor dela aparece em lugar da textura";
        MeshNotice::Invisible { material } =>
            "o material \"{material}\" é inteiramente transparente (Tr 1 ou d 0), e é desenhado opaco";
    }
}

fn texture_in_portuguese(TextureError { file, fault }: &TextureError) -> String {
    let why = match fault {
        TextureFault::Unreadable(error) => read_problem(Lang::PtBr, &error.problem),
        TextureFault::Format => "não é uma imagem conhecida; permitido: PNG, JPEG e WebP".to_owned(),
        TextureFault::Damaged => "está danificada ou incompleta".to_owned(),
        TextureFault::TooLarge { width, height } => format!(
            "tem {width} × {height} pixels; permitido: no máximo {MAX_TEXTURE_SIDE} de cada lado e {MAX_TEXELS} ao todo, ou {MAX_HALVED_TEXELS} em um arquivo JPEG que não seja progressivo e em um PNG de 8 bits sem transparência, que são reduzidos à metade"
        ),
        TextureFault::Budget => {
            format!("ficou de fora, pois com ela as texturas desta figura teriam mais de {MAX_TEXELS} pixels")
        }
        other => other.to_string(),
    };
    format!("{file} {why}")
}

fn fault_in_portuguese(fault: &MeshFault) -> String {
    match fault {
        MeshFault::Number { found } => format!("\"{found}\" não é um número finito"),
        MeshFault::Coordinates { found } => format!("há {found} coordenadas, e são necessárias 3"),
        MeshFault::Corner { found } => {
            format!("\"{found}\" não é um vértice de face. Escreva v, v/vt, v//vn ou v/vt/vn com números inteiros")
        }
        MeshFault::Word { found, allowed } => format!("\"{found}\" não pode estar aqui; permitido: {allowed}"),
        MeshFault::Missing { word } => format!("falta \"{word}\""),
        MeshFault::End => "o arquivo termina aqui, antes do fim".to_owned(),
        MeshFault::Length { triangles, needed, found } => {
            format!("{triangles} triângulos precisam de {needed} bytes, mas o arquivo tem {found}")
        }
        MeshFault::Index { found, points } => {
            format!("\"{found}\" indica um ponto que não existe. Há {points} pontos")
        }
        other => other.to_string(),
    }
}

fn json_in_portuguese(fault: &JsonFault) -> String {
    match fault {
        JsonFault::Syntax => "isto não é JSON".to_owned(),
        JsonFault::End => "o JSON termina antes do fim".to_owned(),
        JsonFault::MissingKey { key } => format!("falta a chave \"{key}\" no que termina aqui"),
        JsonFault::Value => "um valor que o glTF não permite".to_owned(),
        other => other.to_string(),
    }
}

fn glb_in_portuguese(fault: GlbFault) -> String {
    match fault {
        GlbFault::Header => "seu cabeçalho está cortado ou dá um comprimento errado".to_owned(),
        GlbFault::End => "termina antes do fim".to_owned(),
        GlbFault::Parts => "suas partes não são as de um arquivo GLB".to_owned(),
        other => other.to_string(),
    }
}

fn gltf_in_portuguese(fault: &GltfFault) -> String {
    match fault {
        GltfFault::File { uri, error } => format!("\"{uri}\": {}", unreadable(Lang::PtBr, error)),
        GltfFault::Container { fault } => format!("o arquivo GLB não é válido: {}", glb_in_portuguese(*fault)),
        GltfFault::Version { found } => format!("isto é glTF {found}; permitido: 2.0"),
        GltfFault::Extension { found } => {
            format!("o arquivo precisa de {found}, que este programa não lê; salve-o sem isso")
        }
        GltfFault::Value => "um valor que o glTF não permite".to_owned(),
        GltfFault::Missing => "está faltando".to_owned(),
        GltfFault::Reference => "indica algo que não existe".to_owned(),
        GltfFault::Unsupported { what } => format!("{what} não pode ser lido por este programa"),
        GltfFault::NoBytes => "faltam os bytes do buffer".to_owned(),
        GltfFault::DataUri => "o URI de dados não é um base64 válido".to_owned(),
        GltfFault::OutOfBuffer => "os dados passam do fim do buffer".to_owned(),
        GltfFault::Index { found, vertices } => {
            format!("o índice {found} indica um vértice que não existe. Há {vertices}")
        }
        GltfFault::SparseIndex { found, count } => {
            format!("o índice {found} de um acessor esparso não está entre seus {count} itens, ou não cresce")
        }
        GltfFault::OverBudget => "seus acessores contêm mais do que qualquer malha".to_owned(),
        GltfFault::NotFinite => "um número não é finito".to_owned(),
        GltfFault::Tree => "um nó tem dois pais".to_owned(),
        other => other.to_string(),
    }
}
