//! The files that a picture carries for its figure: meshes, the files that these name, textures, the photograph. Each
//! is a comment after the text of the figure, `#camera-lab-file "NAME" BYTES`, packed and in Base64, so that every
//! format that holds a figure carries them alike.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::core::{CompressorOxide, TDEFLFlush, TDEFLStatus, compress_to_output};
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};

use crate::scene::ReadProblem;
use crate::share;

/// The start of a comment with a file.
pub(super) const MARK: &str = "#camera-lab-file ";

/// Files by the names that the figure, or a mesh, has for them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Carried(pub(super) Arc<BTreeMap<String, Vec<u8>>>);

impl Carried {
    /// True if there are no files.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The bytes of a file, at most `most`. `None` if it isn't there.
    pub(super) fn read(&self, name: &str, most: usize) -> Option<Result<Vec<u8>, ReadProblem>> {
        // A few packed bytes can hold gigabytes, so a file longer than the limit is never unpacked.
        let unpacked = decompress_to_vec_with_limit(self.0.get(name)?, most);
        Some(unpacked.map_err(|error| match error.status {
            TINFLStatus::HasMoreOutput => ReadProblem::Budget,
            _ => ReadProblem::system(&std::io::ErrorKind::InvalidData.into()),
        }))
    }

    /// The text of a figure, and the files after it. A damaged file is left out, so that it's missed where it's needed.
    pub fn from_text(mut text: Vec<u8>) -> (Vec<u8>, Self) {
        let mut files = BTreeMap::new();
        loop {
            let end = text.trim_ascii_end().len();
            let start = text[..end].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
            let Some(line) = text[start..end].strip_prefix(MARK.as_bytes()) else { return (text, Self(files.into())) };
            let mut parts = serde_json::Deserializer::from_slice(line).into_iter::<String>();
            let name = parts.next().and_then(Result::ok);
            let packed = STANDARD.decode(line[parts.byte_offset()..].trim_ascii());
            files.extend(name.zip(packed.ok()));
            text.truncate(start);
        }
    }

    /// The files of a link to a lesson. None for a path.
    pub fn of_lesson(path: Option<&Path>) -> Self {
        let text = path.and_then(share::link_of).and_then(share::text_in);
        text.and_then(Result::ok).map(|text| Self::from_text(text).1).unwrap_or_default()
    }

    /// These files and others, which come before those of the same names.
    #[must_use]
    pub fn and(&self, others: &Self) -> Self {
        let both = self.0.iter().chain(&*others.0).map(|(name, packed)| (name.clone(), packed.clone()));
        Self(Arc::new(both.collect()))
    }

    /// The text of a figure with the files after it.
    pub fn join(&self, text: &str) -> String {
        // Such comments in the text itself would be taken for files.
        let mut text = String::from_utf8(Self::from_text(text.into()).0).unwrap_or_default();
        if !text.is_empty() && !text.ends_with('\n') && !self.is_empty() {
            text.push('\n');
        }
        for (name, packed) in &*self.0 {
            let name = serde_json::Value::from(name.as_str());
            text.push_str(&format!("{MARK}{name} {}\n", STANDARD.encode(packed)));
        }
        text
    }
}

/// Packed bytes. `None` if there are more than `most` of them.
pub(super) fn packed(bytes: &[u8], most: usize) -> Option<Vec<u8>> {
    let mut packed = Vec::new();
    let mut compressor = CompressorOxide::default();
    // Raw, without the header and the checksum of zlib.
    compressor.set_format_and_level(miniz_oxide::DataFormat::Raw, 6);
    let (status, _) = compress_to_output(&mut compressor, bytes, TDEFLFlush::Finish, |part| {
        packed.extend_from_slice(part);
        packed.len() <= most
    });
    (status == TDEFLStatus::Done && packed.len() <= most).then_some(packed)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::limits::MAX_CARRIED_BYTES;

    fn carried(files: &[(&str, &[u8])]) -> Carried {
        let packed = |bytes: &[u8]| packed(bytes, MAX_CARRIED_BYTES).unwrap();
        Carried(Arc::new(files.iter().map(|(name, bytes)| ((*name).to_owned(), packed(bytes))).collect()))
    }

    #[test]
    fn a_text_and_its_files_come_apart_as_they_were_put_together() {
        let noise: Vec<u8> = (0..5000_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        let files = [("a.obj", &b"v 0 0 0\n"[..]), ("meshes/\"b\"\n.png", &noise), ("ç \u{202e}.mtl", b"")];
        let all = carried(&files);
        for text in ["", "[camera]\nnear = 2\n", "near = 2 # no end", "a\r\n"] {
            let joined = all.join(text);
            let (apart, found) = Carried::from_text(joined.clone().into());
            assert_eq!(String::from_utf8(apart).unwrap().trim_end(), text.trim_end());
            assert_eq!(found, all);
            assert!(joined.lines().skip(text.lines().count()).all(|line| line.starts_with('#')), "still a figure file");
        }
        for (name, bytes) in files {
            assert_eq!(all.read(name, 5000), Some(Ok(bytes.to_vec())), "{name}");
        }
        assert_eq!(Carried::default().join("near = 2"), "near = 2");
        // Such comments in the middle are the author's own, and at the end they never count twice.
        let own = format!("{}[camera]\n", all.join(""));
        assert_eq!(Carried::from_text(own.clone().into()), (own.into_bytes(), Carried::default()));
        assert_eq!(Carried::from_text(all.join(&all.join("x = 1\n")).into()).0, b"x = 1\n");
    }

    #[test]
    fn damaged_files_are_missing_and_too_long_ones_are_not_unpacked() {
        let all = carried(&[("bomb", &vec![0; 1 << 20]), ("good", b"x")]);
        assert_eq!(all.read("bomb", (1 << 20) - 1), Some(Err(ReadProblem::Budget)));
        assert_eq!(all.read("good", 1), Some(Ok(b"x".to_vec())));
        assert_eq!(all.read("other", 1), None);
        let joined = all.join("");
        for (from, to) in [("\"bomb\" ", "\"bomb "), ("\"bomb\" ", "\"bomb\" !"), ("\"bomb\" ", "bomb ")] {
            let (_, found) = Carried::from_text(joined.replace(from, to).into());
            assert_eq!((found.read("bomb", 1 << 20), found.read("good", 1).is_some()), (None, true), "{to}");
        }
        let changed = Carried(Arc::new([("bomb".to_owned(), vec![0xff; 10])].into()));
        assert!(matches!(changed.read("bomb", 100), Some(Err(ReadProblem::System { .. }))));
    }
}
