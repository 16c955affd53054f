//! Reasons why a file can't be read, in both languages. In English, the error's own words.

use std::borrow::Cow;
use std::io;

use crate::limits::MAX_SCENE_BYTES;
use crate::scene::{NamedBy, ReadError, ReadProblem, is_loop, system_kind};

texts!("messages/unreadable");

/// The reason why a file named by a scene can't be read.
pub(crate) fn unreadable(lang: Lang, error: &ReadError) -> String {
    format!("{} {}", error.file, read_problem(lang, &error.problem))
}

/// The reason why a file can't be read, after its name.
pub(crate) fn read_problem(lang: Lang, problem: &ReadProblem) -> String {
    translated! { lang, problem;
        ReadProblem::System { kind, code } => "não pode ser lido: {}" (system_in_portuguese(*kind, *code));
        ReadProblem::Directory => "é um diretório; permitido: um arquivo";
        ReadProblem::NotRegular => "é um dispositivo, um pipe ou um socket; permitido: um arquivo comum";
        ReadProblem::Outside { folder, named_by } =>
            "não foi lido, porque {} o indica e ele está em outro lugar; permitido: arquivos em {folder} e abaixo, ou quaisquer com --allow-files (na janela: o botão ao lado do caminho)" (named_by_in_portuguese(*named_by));
        ReadProblem::NoFolder =>
            "não foi lido, porque o indica uma figura sem pasta, como num link; permitido: malhas do programa, ou qualquer arquivo com --allow-files (na janela: o botão ao lado do caminho)";
        ReadProblem::Budget =>
            "não foi lido, porque com ele os arquivos desta figura passam de {} MiB; permitido: menos que isso em todos juntos" (MAX_SCENE_BYTES >> 20);
        ReadProblem::Network => "está em outra máquina; permitido: arquivos desta";
    }
}

const fn named_by_in_portuguese(named_by: NamedBy) -> &'static str {
    match named_by {
        NamedBy::Mesh => "uma malha",
        NamedBy::Picture => "uma figura dentro de uma imagem",
        NamedBy::Lesson => "uma lição",
    }
}

/// A material library or a picture that a mesh names and that can't be read.
pub fn without_file(lang: Lang, error: &ReadError) -> String {
    let why = unreadable(lang, error);
    text!(lang, without_file, why)
}

/// The error of the system, in our words. An unusual one by its number.
pub(crate) fn system_in_portuguese(kind: io::ErrorKind, code: Option<i32>) -> Cow<'static, str> {
    let words = match system_kind(kind, code) {
        io::ErrorKind::NotFound => "o arquivo ou diretório não existe",
        io::ErrorKind::PermissionDenied => "permissão negada",
        io::ErrorKind::IsADirectory => "é um diretório",
        io::ErrorKind::NotADirectory => "uma parte do caminho não é um diretório",
        io::ErrorKind::AlreadyExists => "já existe algo com este nome",
        io::ErrorKind::InvalidInput | io::ErrorKind::InvalidFilename => "nenhum arquivo pode ter este nome",
        io::ErrorKind::StorageFull => "o disco está cheio",
        io::ErrorKind::QuotaExceeded => "sua cota de disco está esgotada",
        io::ErrorKind::FileTooLarge => "o disco não aceita um arquivo tão grande",
        io::ErrorKind::ReadOnlyFilesystem => "o disco é somente de leitura",
        io::ErrorKind::ResourceBusy | io::ErrorKind::ExecutableFileBusy => "outro programa o está usando",
        io::ErrorKind::CrossesDevices => "está em outro disco",
        io::ErrorKind::OutOfMemory => "não há memória suficiente",
        io::ErrorKind::BrokenPipe => "o leitor o fechou",
        io::ErrorKind::TimedOut => "demorou demais",
        io::ErrorKind::UnexpectedEof | io::ErrorKind::WriteZero => "terminou antes do fim",
        io::ErrorKind::InvalidData => "contém dados inválidos",
        io::ErrorKind::Unsupported => {
            "uma página no navegador não lê pastas. Escolha o arquivo nela, ou solte-o sobre a página"
        }
        _ if is_loop(code) => "seus links formam um ciclo",
        _ => match code {
            Some(code) => return format!("o sistema recusa, com o erro {code}").into(),
            None => "o sistema recusa",
        },
    };
    words.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::system_words;

    #[test]
    fn the_systems_words_are_ours_in_both_languages() {
        let words = |error: &io::Error| {
            let (kind, code) = (error.kind(), error.raw_os_error());
            [system_words(kind, code), system_in_portuguese(kind, code)]
        };
        let nul = std::fs::File::open("a\0b").expect_err("no file can be called so");
        assert_eq!(words(&nul), ["no file can have this name", "nenhum arquivo pode ter este nome"]);
        let unusual = io::Error::from_raw_os_error(112);
        assert_eq!(words(&unusual), ["the system refuses, with its error 112", "o sistema recusa, com o erro 112"]);
    }
}
