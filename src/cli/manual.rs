//! `camera-lab manual`: its manual pages, and the completions for shells, from the same definitions as its arguments.

use std::path::Path;

use clap::CommandFactory as _;
use clap_complete::Shell;

use super::args::words::LangArg;
use super::args::{CommandLine, ManualArgs};
use super::{Asked, Failure, print};
use crate::export::format::PictureFormat;
use crate::sanitize;
use camera_lab_files::{self as files, FileError, Overwrite};
use camera_lab_words::{Lang, class, messages};

pub(super) fn run(args: &ManualArgs, lang: Lang) -> Result<Option<Asked>, Failure> {
    let Some(folder) = &args.folder else {
        let output = args.output.clone();
        if let Some(output) = output.as_ref().filter(|output| PictureFormat::of(output) != Some(PictureFormat::Pdf)) {
            return Err(Failure::BadInput(class::ending(lang, &sanitize::path(output))));
        }
        return Ok(Some(Asked::Keys { lang: args.lang.map_or(lang, LangArg::lang), output }));
    };
    let mut command = CommandLine::command();
    command.build();
    write_pages(&folder.join("man1"), &command, lang)?;
    for (shell, name) in [
        (Shell::Bash, "completions/bash/camera-lab"),
        (Shell::Zsh, "completions/zsh/_camera-lab"),
        (Shell::Fish, "completions/fish/camera-lab.fish"),
        (Shell::PowerShell, "completions/powershell/camera-lab.ps1"),
    ] {
        let mut text = Vec::new();
        clap_complete::generate(shell, &mut command, "camera-lab", &mut text);
        write(&folder.join(name), &text, lang)?;
    }
    print(format!("{}\n", sanitize::path(folder)).as_bytes(), lang)?;
    Ok(None)
}

/// A page of the command and one of each subcommand, under the names that `man` looks for.
fn write_pages(folder: &Path, command: &clap::Command, lang: Lang) -> Result<(), Failure> {
    // A built command knows its full name: `camera-lab-exercise-list`.
    let path = folder.join(format!("{}.1", command.get_display_name().unwrap_or(command.get_name())));
    let mut text = Vec::new();
    let page = clap_mangen::Man::new(command.clone());
    page.render(&mut text).map_err(|error| refused(&path, FileError::Write(error), lang))?;
    write(&path, &text, lang)?;
    for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
        write_pages(folder, below, lang)?;
    }
    Ok(())
}

fn write(path: &Path, text: &[u8], lang: Lang) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(folder).map_err(|error| refused(folder, FileError::Write(error), lang))?;
    files::save(path, text, Overwrite::Writable).map_err(|error| refused(path, error, lang))
}

fn refused(path: &Path, error: FileError, lang: Lang) -> Failure {
    Failure::Failed(messages::file(lang, &sanitize::path(path), &error))
}
