//! What keeps a file from being read, in both languages.

use std::io;

use super::Lang;
use crate::limits::MAX_FILE_BYTES;
use crate::scene::{ReadError, ReadProblem};

/// Why a file that a scene names cannot be read.
pub(super) fn unreadable(lang: Lang, error: &ReadError) -> String {
    let name = &error.file;
    match &error.problem {
        ReadProblem::System { kind, detail } => {
            let why = system(lang, *kind, detail);
            match lang {
                Lang::En => format!("{name} cannot be read: {why}"),
                Lang::PtBr => format!("{name} não pode ser lido: {why}"),
            }
        }
        ReadProblem::Directory => directory(lang, name),
        ReadProblem::TooLarge => too_large(lang, name),
        ReadProblem::NotRegular => not_regular(lang, name),
        ReadProblem::Network => network(lang, name),
    }
}

pub(super) fn directory(lang: Lang, name: &str) -> String {
    match lang {
        Lang::En => format!("{name} is a directory; allowed: a file"),
        Lang::PtBr => format!("{name} é um diretório; permitido: um arquivo"),
    }
}

pub(super) fn too_large(lang: Lang, name: &str) -> String {
    let gib = MAX_FILE_BYTES >> 30;
    match lang {
        Lang::En => format!("{name} is larger than any figure or picture; allowed: at most {gib} GiB"),
        Lang::PtBr => format!("{name} é maior que qualquer figura ou imagem; permitido: no máximo {gib} GiB"),
    }
}

pub(super) fn not_regular(lang: Lang, name: &str) -> String {
    match lang {
        Lang::En => format!("{name} is a device, a pipe or a socket; allowed: a regular file"),
        Lang::PtBr => format!("{name} é um dispositivo, um pipe ou um socket; permitido: um arquivo comum"),
    }
}

pub(super) fn network(lang: Lang, name: &str) -> String {
    match lang {
        Lang::En => format!("{name} is on another machine; allowed: files of this one"),
        Lang::PtBr => format!("{name} está em outra máquina; permitido: arquivos desta"),
    }
}

/// What the system said, in our words where the case is common.
pub(super) fn system(lang: Lang, kind: io::ErrorKind, detail: &str) -> String {
    match kind {
        io::ErrorKind::NotFound => match lang {
            Lang::En => "there is no such file or directory".to_owned(),
            Lang::PtBr => "o arquivo ou diretório não existe".to_owned(),
        },
        io::ErrorKind::PermissionDenied => match lang {
            Lang::En => "permission denied".to_owned(),
            Lang::PtBr => "permissão negada".to_owned(),
        },
        io::ErrorKind::IsADirectory => match lang {
            Lang::En => "it is a directory".to_owned(),
            Lang::PtBr => "é um diretório".to_owned(),
        },
        io::ErrorKind::NotADirectory => match lang {
            Lang::En => "a part of the path is not a directory".to_owned(),
            Lang::PtBr => "uma parte do caminho não é um diretório".to_owned(),
        },
        io::ErrorKind::StorageFull => match lang {
            Lang::En => "the disk is full".to_owned(),
            Lang::PtBr => "o disco está cheio".to_owned(),
        },
        io::ErrorKind::ReadOnlyFilesystem => match lang {
            Lang::En => "the disk is read-only".to_owned(),
            Lang::PtBr => "o disco é somente de leitura".to_owned(),
        },
        _ => detail.to_owned(),
    }
}
