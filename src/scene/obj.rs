//! Wavefront OBJ, through `tobj`.
//!
//! `tobj` reads the numbers and sorts faces into objects and materials. What it does not say or do is done on the way to it,
//! line by line ([`Lines`]): the number of a faulty line, lines continued by `\`, comments behind values, texts that are not
//! UTF-8, polylines, corners that name what does not exist. Texture coordinates are left out.

use std::cell::RefCell;
use std::collections::HashMap;
use std::io::{self, BufRead, Read};
use std::path::Path;
use std::sync::Arc;

use glam::{DMat4, DVec3};
use tobj::{LoadError, LoadOptions};

use super::ReadFile;
use super::import::{MeshError, ObjFault, Part};
use super::soup::Soup;
use crate::appearance::Rgba;

/// The objects of an OBJ file; one that has several materials comes in several parts.
///
/// # Errors
/// [`MeshError::Obj`] with the line.
pub(super) fn read(bytes: &[u8], read_file: &mut ReadFile<'_>) -> Result<Vec<Part>, MeshError> {
    let mut lines = Lines::new(bytes);
    let read_file = RefCell::new(read_file);
    let options = LoadOptions::default();
    let loaded = tobj::load_obj_buf(&mut lines, &options, |path| materials(path, &mut **read_file.borrow_mut()));
    if let Some((line, fault)) = lines.fault.take().or_else(|| lines.missing()) {
        return Err(MeshError::Obj { line, fault });
    }
    let (models, materials) = loaded.map_err(|error: LoadError| MeshError::Obj {
        line: lines.line,
        fault: ObjFault::Other { detail: error.to_string() },
    })?;
    let materials = materials.unwrap_or_default();
    let mut parts = Vec::new();
    for model in models {
        let color = model.mesh.material_id.and_then(|id| materials.get(id)).map(color);
        let mesh = soup(model.mesh, lines.all_have_normals).into_mesh()?;
        if mesh.triangles.is_empty() {
            continue;
        }
        parts.push(Part {
            name: if model.name == "unnamed_object" { String::new() } else { model.name },
            two_sided: !mesh.closed,
            mesh: Arc::new(mesh),
            file_from_part: DMat4::IDENTITY,
            color,
        });
    }
    Ok(parts)
}

fn soup(mesh: tobj::Mesh, with_normals: bool) -> Soup {
    let vectors = |flat: &[f64]| flat.chunks_exact(3).map(DVec3::from_slice).collect();
    Soup {
        positions: vectors(&mesh.positions),
        normals: if with_normals { vectors(&mesh.normals) } else { Vec::new() },
        corners: mesh.indices,
        arities: mesh.face_arities,
        corner_normals: mesh.normal_indices,
    }
}

fn color(material: &tobj::Material) -> Rgba {
    let byte = |share: f64| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
        let byte = (share.clamp(0.0, 1.0) * 255.0).round() as u8;
        byte
    };
    let [r, g, b] = material.diffuse.unwrap_or([0.8; 3]).map(byte);
    Rgba::rgba(r, g, b, byte(material.dissolve.unwrap_or(1.0)))
}

/// Reads a material library. Only names, diffuse colours and opacities are handed on, and only if they are whole: `tobj`
/// panics on a colour with two numbers.
fn materials(path: &Path, read_file: &mut ReadFile<'_>) -> tobj::MTLLoadResult {
    let Ok(bytes) = read_file(&path.to_string_lossy()) else { return Ok((Vec::new(), HashMap::new())) };
    let text = String::from_utf8_lossy(&bytes);
    let mut clean = String::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let keyword = words.next().unwrap_or_default();
        let numbers: Vec<f64> = words.clone().map_while(|w| w.parse().ok()).collect();
        match (keyword, &numbers[..]) {
            ("newmtl", _) if words.next().is_some() => clean.push_str(line.trim()),
            ("Kd", [r, g, b, ..]) => clean.push_str(&format!("Kd {r} {g} {b}")),
            ("d", [d, ..]) => clean.push_str(&format!("d {d}")),
            ("Tr", [t, ..]) => clean.push_str(&format!("d {}", 1.0 - t)),
            _ => continue,
        }
        clean.push('\n');
    }
    tobj::load_mtl_buf(&mut clean.as_bytes())
}

/// The lines of an OBJ file as `tobj` wants them.
struct Lines<'a> {
    rest: &'a [u8],
    /// The number of the last line that was read, from 1.
    line: usize,
    /// The line that is being handed over, and how much of it has been.
    out: Vec<u8>,
    at: usize,
    points: usize,
    normals: usize,
    /// No corner came without a normal.
    all_have_normals: bool,
    /// The corner that names the point or normal farthest behind what was there: index (from 1), line, corner.
    ahead: [Option<(usize, usize, String)>; 2],
    fault: Option<(usize, ObjFault)>,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self {
            rest: bytes,
            line: 0,
            out: Vec::new(),
            at: 0,
            points: 0,
            normals: 0,
            all_have_normals: true,
            ahead: [None, None],
            fault: None,
        }
    }

    /// A corner that names what did not come until the end of the file.
    fn missing(&self) -> Option<(usize, ObjFault)> {
        let there = [self.points, self.normals];
        self.ahead.iter().zip(there).find_map(|(ahead, there)| {
            let (index, line, corner) = ahead.as_ref().filter(|a| a.0 > there)?;
            debug_assert!(*index > there);
            Some((*line, self.no_such_index(corner)))
        })
    }

    fn no_such_index(&self, corner: &str) -> ObjFault {
        ObjFault::Index { found: corner.to_owned(), points: self.points, normals: self.normals }
    }

    /// Reads lines until there is one to hand over; false at the end.
    fn next_line(&mut self) -> Result<bool, ObjFault> {
        self.out.clear();
        self.at = 0;
        while self.out.is_empty() {
            if self.rest.is_empty() {
                return Ok(false);
            }
            let mut logical = Vec::new();
            loop {
                let end = self.rest.iter().position(|&b| b == b'\n').map_or(self.rest.len(), |n| n + 1);
                let (line, rest) = self.rest.split_at(end);
                self.rest = rest;
                self.line += 1;
                let line = line.trim_ascii_end();
                match line.strip_suffix(b"\\") {
                    Some(begun) if !rest.is_empty() => {
                        logical.extend_from_slice(begun);
                        logical.push(b' ');
                    }
                    begun => {
                        logical.extend_from_slice(begun.unwrap_or(line));
                        break;
                    }
                }
            }
            self.clean(&String::from_utf8_lossy(&logical))?;
        }
        Ok(true)
    }

    /// Puts into `out` what `tobj` is to see of a line.
    fn clean(&mut self, line: &str) -> Result<(), ObjFault> {
        let line = line.trim_start();
        let (keyword, values) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let values_only = values.split('#').next().unwrap_or_default();
        match keyword {
            "v" => {
                self.points += 1;
                self.numbers("v", values_only)?;
            }
            "vn" => {
                self.normals += 1;
                self.numbers("vn", values_only)?;
            }
            "f" => self.face(values_only)?,
            "o" | "g" | "mtllib" | "usemtl" if !values.trim().is_empty() => {
                self.out.extend_from_slice(line.as_bytes());
                self.out.push(b'\n');
            }
            _ => {}
        }
        Ok(())
    }

    /// Hands on three coordinates, and the weight of a point that has four numbers. More are the colour of the vertex.
    fn numbers(&mut self, keyword: &str, values: &str) -> Result<(), ObjFault> {
        let words: Vec<&str> = values.split_whitespace().collect();
        let used = if keyword == "v" && words.len() == 4 { &words[..] } else { &words[..words.len().min(3)] };
        if used.len() < 3 {
            return Err(ObjFault::Coordinates { found: used.len() });
        }
        self.out.extend_from_slice(keyword.as_bytes());
        for (k, word) in used.iter().enumerate() {
            let is_good = word.parse().is_ok_and(|x: f64| x.is_finite() && (k < 3 || x != 0.0));
            if !is_good {
                return Err(ObjFault::Number { found: (*word).to_owned() });
            }
            self.out.push(b' ');
            self.out.extend_from_slice(word.as_bytes());
        }
        self.out.push(b'\n');
        Ok(())
    }

    /// Hands on a face as `v//vn` or `v`, with indices from 1.
    fn face(&mut self, values: &str) -> Result<(), ObjFault> {
        let found = values.split_whitespace().count();
        if found < 3 {
            return Err(ObjFault::Corners { found });
        }
        self.out.push(b'f');
        for corner in values.split_whitespace() {
            let not_a_corner = || ObjFault::Corner { found: corner.to_owned() };
            let fields: Vec<&str> = corner.split('/').collect();
            let index = |field: &str| field.parse::<i64>().map_err(|_| not_a_corner());
            let (point, normal) = match fields[..] {
                [v] => (index(v)?, None),
                [v, vt] => (index(v)?, index(vt).map(|_| None)?),
                [v, "", vn] => (index(v)?, Some(index(vn)?)),
                [v, vt, vn] => {
                    index(vt)?;
                    (index(v)?, Some(index(vn)?))
                }
                _ => return Err(not_a_corner()),
            };
            let point = self.absolute(0, point, corner)?;
            match normal.map(|n| self.absolute(1, n, corner)).transpose()? {
                Some(normal) => self.out.extend_from_slice(format!(" {point}//{normal}").as_bytes()),
                None => {
                    self.all_have_normals = false;
                    self.out.extend_from_slice(format!(" {point}").as_bytes());
                }
            }
        }
        self.out.push(b'\n');
        Ok(())
    }

    /// An index of a point (`which` = 0) or normal (1), counted from 1; negative ones count back from the last one so far.
    fn absolute(&mut self, which: usize, index: i64, corner: &str) -> Result<usize, ObjFault> {
        let so_far = [self.points, self.normals][which];
        let found = if index < 0 {
            usize::try_from(index.unsigned_abs()).ok().and_then(|back| (so_far + 1).checked_sub(back))
        } else {
            usize::try_from(index).ok()
        };
        let found = found.filter(|&i| i > 0).ok_or_else(|| self.no_such_index(corner))?;
        if found > so_far && self.ahead[which].as_ref().is_none_or(|a| found > a.0) {
            self.ahead[which] = Some((found, self.line, corner.to_owned()));
        }
        Ok(found)
    }
}

impl Read for Lines<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let n = self.fill_buf()?.read(into)?;
        self.consume(n);
        Ok(n)
    }
}

impl BufRead for Lines<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.at == self.out.len()
            && let Err(fault) = self.next_line()
        {
            self.fault = Some((self.line, fault));
            return Err(io::ErrorKind::InvalidData.into());
        }
        Ok(&self.out[self.at..])
    }

    fn consume(&mut self, n: usize) {
        self.at += n;
    }
}
