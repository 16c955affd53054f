//! Unpacks the program that a page loads. LZMA makes it a quarter smaller than the packing of servers and browsers
//! does, and many a server in a classroom packs nothing.

use std::io::Read;

use lzma_rust2::LzmaReader;
use wasm_bindgen::prelude::wasm_bindgen;

/// The memory it may need beside the result, in KiB: the dictionary that it was packed with (16 MiB) and its tables.
const MEMORY_KIB: u32 = 64 * 1024;

/// The bytes that were packed (`.lzma`).
///
/// # Errors
/// Not an LZMA file, or a damaged one: the error names the fault.
#[wasm_bindgen]
pub fn unpack(packed: &[u8]) -> Result<Vec<u8>, String> {
    let mut program = Vec::new();
    LzmaReader::new_mem_limit(packed, MEMORY_KIB, None)
        .and_then(|mut reader| reader.read_to_end(&mut program))
        .map_err(|error| error.to_string())?;
    Ok(program)
}
