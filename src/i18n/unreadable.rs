//! What keeps a file from being read, in both languages. In English it is the error's own words.

use std::io;

use super::Lang;
use crate::limits::MAX_FILE_BYTES;
use crate::scene::{ReadError, ReadProblem, system_words};

/// Why a file that a scene names cannot be read.
pub(super) fn unreadable(lang: Lang, error: &ReadError) -> String {
    format!("{} {}", error.file, read_problem(lang, &error.problem))
}

/// What keeps a file from being read, after its name.
pub(super) fn read_problem(lang: Lang, problem: &ReadProblem) -> String {
    match (lang, problem) {
        (Lang::En, problem) => problem.to_string(),
        (Lang::PtBr, ReadProblem::System { kind, detail }) => {
            format!("não pode ser lido: {}", system_in_portuguese(*kind, detail))
        }
        (Lang::PtBr, ReadProblem::Directory) => "é um diretório; permitido: um arquivo".to_owned(),
        (Lang::PtBr, ReadProblem::TooLarge) => {
            let gib = MAX_FILE_BYTES >> 30;
            format!("é maior que qualquer figura ou imagem; permitido: no máximo {gib} GiB")
        }
        (Lang::PtBr, ReadProblem::NotRegular) => {
            "é um dispositivo, um pipe ou um socket; permitido: um arquivo comum".to_owned()
        }
        (Lang::PtBr, ReadProblem::Network) => "está em outra máquina; permitido: arquivos desta".to_owned(),
    }
}

/// What the system said, in our words where the case is common.
pub(super) fn system_in_portuguese(kind: io::ErrorKind, detail: &str) -> &str {
    match kind {
        io::ErrorKind::NotFound => "o arquivo ou diretório não existe",
        io::ErrorKind::PermissionDenied => "permissão negada",
        io::ErrorKind::IsADirectory => "é um diretório",
        io::ErrorKind::NotADirectory => "uma parte do caminho não é um diretório",
        io::ErrorKind::StorageFull => "o disco está cheio",
        io::ErrorKind::ReadOnlyFilesystem => "o disco é somente de leitura",
        _ => system_words(kind, detail),
    }
}
