//! The reasons why files can't be used, in both languages.

use std::path::Path;

use super::figure_files::figure;
use super::unreadable::{read_problem, system_in_portuguese};
use crate::export::format::PictureFormat;
use crate::export::png::{Damage, PngError};
use crate::limits::{
    MAX_CARRIED_BYTES, MAX_FIGURE_BYTES, MAX_HANDED_OUT_BYTES, MAX_LINK_CHARACTERS, MAX_OWN_EXERCISES,
};
use crate::scene::ReadProblem;
use crate::{Grammar, sanitize};
use camera_lab_files::hand_out::PAGE_NAME;
use camera_lab_files::share::{self, Held, ShareError};
use camera_lab_files::{FileError, LeftOut, size_words};

texts!("messages/files");

/// The name of an opened figure: its path, or a phrase for a link, which is long and meaningless to people.
pub fn opened(lang: Lang, path: &Path) -> String {
    let held = share::link_of(path).and_then(share::held_in);
    match held {
        None => sanitize::path(path),
        Some(Held::Figure) => text!(lang, opened_figure).to_owned(),
        Some(Held::Lesson) => text!(lang, opened_lesson).to_owned(),
    }
}

/// The reason why the file called `name` can't be used.
pub fn file(lang: Lang, name: &str, error: &FileError) -> String {
    let after_name = |problem: &ReadProblem| format!("{name} {}", read_problem(lang, problem));
    match (lang.grammar(), error) {
        (_, FileError::Png(error)) => format!("{name}: {}", png(lang, error)),
        (_, FileError::Figure(error)) => format!("{name}, {}", figure(lang, error)),
        // A link is long, and meaningless to people.
        (_, FileError::Link(error)) => link(lang, *error),
        (Grammar::English, error) => format!("{name} {error}"),
        (Grammar::Portuguese, FileError::Read(error)) => after_name(&ReadProblem::system(error)),
        (Grammar::Portuguese, FileError::Write(error)) => {
            format!("{name} não pode ser gravado: {}", system_in_portuguese(error.kind(), error.raw_os_error()))
        }
        (Grammar::Portuguese, FileError::Directory) => after_name(&ReadProblem::Directory),
        (Grammar::Portuguese, FileError::TooManyExercises) => {
            format!("{name} tem exercícios demais; permitido: no máximo {MAX_OWN_EXERCISES}")
        }
        (Grammar::Portuguese, FileError::TooLarge(most)) => {
            format!("{name} é grande demais; permitido: no máximo {}", size_words(*most))
        }
        (Grammar::Portuguese, FileError::OtherPicture(format)) => {
            let names = PictureFormat::names_with_figure("e");
            format!("{name} é um arquivo {format}, que não pode conter a própria figura. {names} podem")
        }
        (Grammar::Portuguese, FileError::Latex) => {
            format!("{name} é um arquivo LaTeX, que não pode conter a própria figura. O PDF ao lado dele a contém")
        }
        (Grammar::Portuguese, FileError::Mesh) => format!(
            "{name} é uma malha, não uma figura. Na janela, adicione-a com Cena ▸ + Adicionar ▸ arquivo de malha…; num arquivo de figura, escreva [[scene.objects]] com shape = \"mesh\" e path"
        ),
        (Grammar::Portuguese, FileError::OtherPage) => format!(
            "{name} não é a página desta versão; permitido: {PAGE_NAME} do Camera Lab {}",
            env!("CARGO_PKG_VERSION")
        ),
        (Grammar::Portuguese, FileError::OwnFile(own)) => format!(
            "{name} não pode conter {own}, um arquivo seu; permitido: arquivos que possam ser lidos e tenham no máximo {} KiB juntos quando compactados",
            MAX_HANDED_OUT_BYTES >> 10
        ),
        (Grammar::Portuguese, FileError::NotRegular) => after_name(&ReadProblem::NotRegular),
        (Grammar::Portuguese, FileError::Network) => after_name(&ReadProblem::Network),
        (Grammar::Portuguese, FileError::ReservedName) => format!(
            "{name} tem um nome que o Windows reserva para si; permitido: nomes sem \":\" que não sejam CON, PRN, AUX, NUL, COM0 a COM9 e LPT0 a LPT9, seja qual for a extensão"
        ),
        (Grammar::Portuguese, FileError::ReadOnly) => format!(
            "{name} é somente de leitura e ficou como estava; permitido: outro nome, ou um arquivo que possa ser gravado"
        ),
    }
}

/// The files of a figure that a picture doesn't carry.
pub fn left_out(lang: Lang, LeftOut(names): &LeftOut) -> String {
    let (names, most) = (named(names), size_words(MAX_CARRIED_BYTES as u64));
    text!(lang, left_out, names, most)
}

/// The files that a picture carries, and that the text of its figure doesn't.
pub fn not_printed(lang: Lang, LeftOut(names): &LeftOut) -> String {
    let names = named(names);
    text!(lang, not_printed, names)
}

/// The files of a step that its lesson can't reach.
pub fn out_of_reach(lang: Lang, LeftOut(names): &LeftOut) -> String {
    let names = named(names);
    text!(lang, out_of_reach, names)
}

/// The files of a link that aren't beside the copy of its lesson.
pub fn not_beside(lang: Lang, LeftOut(names): &LeftOut) -> String {
    let names = named(names);
    text!(lang, not_beside, names)
}

/// Names of files in a sentence.
fn named(names: &[String]) -> String {
    sanitize::within(&names.iter().map(|name| sanitize::path_text(name)).collect::<Vec<_>>().join(", "), 200)
}

/// The reason why there is no link to a figure, or no figure in a link.
pub fn link(lang: Lang, error: ShareError) -> String {
    translated! { lang, error;
        ShareError::TooLong(length) =>
            "o link teria {length} caracteres; permitido: no máximo {MAX_LINK_CHARACTERS}, que programas de e-mail e de conversa entregam inteiros. Salve e envie o arquivo";
        ShareError::Damaged =>
            "o link não contém uma figura ou lição inteira, pois uma parte falta ou foi mudada no caminho";
        ShareError::TooLarge =>
            "a figura ou lição no link é longa demais; permitido: no máximo {MAX_FIGURE_BYTES} bytes";
    }
}

/// The reason why a picture can't be written in a format.
pub fn encoder(lang: Lang, format: &str, why: &str) -> String {
    text!(lang, encoder, format, why)
}

/// The reason why a picture can't be written or read.
pub fn png(lang: Lang, error: &PngError) -> String {
    translated! { lang, error;
        PngError::Encode(why) => "a imagem não pode ser gravada como PNG ({why})";
        PngError::Damaged(damage) => "o PNG está danificado: {}" (damage_in_portuguese(*damage));
        PngError::TooLong { limit } => "a figura neste PNG é longa demais; permitido: no máximo {limit} bytes";
        PngError::NoFigure =>
            "esta imagem não contém uma figura; permitido: um arquivo de figura, ou uma imagem gravada por camera-lab";
    }
}

const fn damage_in_portuguese(damage: Damage) -> &'static str {
    match damage {
        Damage::Truncated => "termina antes do fim",
        Damage::Checksum => "uma soma de verificação não confere",
        Damage::Text => "o texto nele não pode ser descompactado",
        Damage::Format => "suas partes contradizem o formato",
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::*;

    #[test]
    fn files_are_named() {
        let missing = FileError::Read(io::ErrorKind::NotFound.into());
        assert_eq!(file(Lang::En, "a.toml", &missing), "a.toml cannot be read: there is no such file or directory");
        assert_eq!(file(Lang::PtBr, "a.toml", &missing), "a.toml não pode ser lido: o arquivo ou diretório não existe");
    }
}
