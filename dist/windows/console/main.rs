//! `camera-lab.com`: the program that a console of Windows runs when you type `camera-lab`.
//!
//! `camera-lab.exe` is a program with a window and has no console, so that a double click opens none, but its output
//! would be lost. Consoles take an ending `.com` before `.exe`, so this program runs the other one beside it and hands
//! on its output, its errors and its exit status.

use std::io::{self, Read, Write};
use std::process::{Command, ExitCode, Stdio};
use std::thread;

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        // If even this fails, there is nowhere left to report it.
        let _ = writeln!(io::stderr(), "camera-lab: camera-lab.exe, which belongs beside camera-lab.com: {error}");
        ExitCode::from(1)
    })
}

fn run() -> io::Result<ExitCode> {
    let program = std::env::current_exe()?.with_file_name("camera-lab.exe");
    let mut child = Command::new(program)
        .args(std::env::args_os().skip(1))
        // Somebody reads the output: no box is wanted.
        .env("CAMERA_LAB_CONSOLE", "1")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let (output, errors) = (child.stdout.take(), child.stderr.take());
    let output = thread::spawn(move || output.map(|from| hand_on(from, io::stdout().lock())));
    let errors = thread::spawn(move || errors.map(|from| hand_on(from, io::stderr().lock())));
    let status = child.wait()?;
    // Its last words come before the console's next line.
    let _ = (output.join(), errors.join());
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}

/// Copies until the other program ends or no one reads any more. Then that program's next write fails.
fn hand_on(mut from: impl Read, mut to: impl Write) {
    let mut buffer = [0; 1 << 14];
    while let Ok(count @ 1..) = from.read(&mut buffer) {
        if to.write_all(&buffer[..count]).and_then(|()| to.flush()).is_err() {
            break;
        }
    }
}
