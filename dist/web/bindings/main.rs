//! Writes the JavaScript between a WebAssembly program and the browser: `camera-lab-bindings PROGRAM.wasm NAME FOLDER`.

use std::env;
use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [program, name, folder] = arguments.as_slice() else {
        eprintln!("usage: camera-lab-bindings PROGRAM.wasm NAME FOLDER");
        return ExitCode::from(2);
    };
    match write(program, name, folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("camera-lab-bindings: {program}: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn write(program: &str, name: &str, folder: &str) -> Result<(), Box<dyn std::error::Error>> {
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(program)
        .out_name(name)
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        // Not as modules: those cannot stand in a file that opens from disk.
        .no_modules(true)?;
    Ok(bindgen.generate(folder)?)
}
