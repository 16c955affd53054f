//! Why files cannot be used, in both languages.

use super::Lang;
use super::figure_files::figure;
use super::unreadable::{directory, network, not_regular, system, too_large};
use crate::export::png::{Damage, PngError};
use crate::files::FileError;

/// Why the file called `name` cannot be used.
#[must_use]
pub fn file(lang: Lang, name: &str, error: &FileError) -> String {
    match error {
        FileError::Read(error) => {
            let why = system(lang, error.kind(), &error.to_string());
            match lang {
                Lang::En => format!("{name} cannot be read: {why}"),
                Lang::PtBr => format!("{name} não pode ser lido: {why}"),
            }
        }
        FileError::Write(error) => {
            let why = system(lang, error.kind(), &error.to_string());
            match lang {
                Lang::En => format!("{name} cannot be written: {why}"),
                Lang::PtBr => format!("{name} não pode ser gravado: {why}"),
            }
        }
        FileError::Directory => directory(lang, name),
        FileError::TooLarge => too_large(lang, name),
        FileError::NotRegular => not_regular(lang, name),
        FileError::Network => network(lang, name),
        FileError::ReadOnly => match lang {
            Lang::En => {
                format!(
                    "{name} is read-only and was left as it is; allowed: another name, or a file that may be written"
                )
            }
            Lang::PtBr => format!(
                "{name} é somente de leitura e ficou como estava; permitido: outro nome, ou um arquivo que possa ser gravado"
            ),
        },
        FileError::Png(error) => format!("{name}: {}", png(lang, error)),
        FileError::Figure(error) => format!("{name}, {}", figure(lang, error)),
    }
}

/// Why a picture cannot be written or read.
#[must_use]
pub fn png(lang: Lang, error: &PngError) -> String {
    match error {
        PngError::Encode(why) => match lang {
            Lang::En => format!("the picture cannot be written as PNG ({why})"),
            Lang::PtBr => format!("a imagem não pode ser gravada como PNG ({why})"),
        },
        PngError::Damaged(damage) => match lang {
            Lang::En => format!("the PNG is damaged: {damage}"),
            Lang::PtBr => {
                let why = match damage {
                    Damage::Truncated => "termina antes do fim",
                    Damage::Checksum => "uma soma de verificação não confere",
                    Damage::Text => "o texto nele não pode ser descompactado",
                    Damage::Format => "suas partes contradizem o formato",
                };
                format!("o PNG está danificado: {why}")
            }
        },
        PngError::TooLong { limit } => match lang {
            Lang::En => format!("the figure in this PNG is too long; allowed: at most {limit} bytes"),
            Lang::PtBr => format!("a figura neste PNG é longa demais; permitido: no máximo {limit} bytes"),
        },
        PngError::NoFigure => match lang {
            Lang::En => {
                "this PNG holds no figure; allowed: a figure file, or a picture that camera-lab wrote".to_owned()
            }
            Lang::PtBr => {
                "este PNG não contém uma figura; permitido: um arquivo de figura, ou uma imagem gravada por camera-lab"
                    .to_owned()
            }
        },
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
