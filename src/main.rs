//! Hands the arguments to the command line, which opens the window when there is no subcommand.

fn main() -> std::process::ExitCode {
    camera_lab::cli::run(std::env::args_os())
}
