//! The command line.

use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with the arguments of a process (the program's name first).
pub fn run(_args: impl IntoIterator<Item = OsString>) -> ExitCode {
    ExitCode::SUCCESS
}
