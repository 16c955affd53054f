//! A zip whose files are stored as they are. The page, nearly all of it, is packed already.
//!
//! Source: PKWARE, *APPNOTE.TXT – .ZIP File Format Specification*, version 2.0 of its features.

/// 1 January 1980, the first day that a zip can name: the same files give the same bytes.
const DAY: u16 = 1 << 5 | 1;
/// Names are UTF-8.
const FLAGS: u16 = 1 << 11;

/// A zip with these names and files. `None` if it would be too long for a plain zip, 4 GB.
pub(super) fn stored(files: &[(&str, Vec<u8>)]) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    let mut central = Vec::new();
    for (name, bytes) in files {
        let at = u32::try_from(out.len()).ok()?;
        let length = u32::try_from(bytes.len()).ok()?;
        let mut common = Vec::new();
        // Version 2.0, the flags, no packing, the time.
        [20, FLAGS, 0, 0, DAY].iter().for_each(|word: &u16| common.extend(word.to_le_bytes()));
        [checksum(bytes), length, length].iter().for_each(|word| common.extend(word.to_le_bytes()));
        common.extend(u16::try_from(name.len()).ok()?.to_le_bytes());
        common.extend([0; 2]);
        out.extend(b"PK\x03\x04");
        out.extend(&common);
        out.extend(name.as_bytes());
        out.extend(bytes);
        // Made by version 2.0; no comment, one disk, no attributes.
        central.extend(b"PK\x01\x02\x14\x00");
        central.extend(&common);
        central.extend([0; 10]);
        central.extend(at.to_le_bytes());
        central.extend(name.as_bytes());
    }
    let (count, at) = (u16::try_from(files.len()).ok()?, u32::try_from(out.len()).ok()?);
    let length = u32::try_from(central.len()).ok()?;
    out.extend(central);
    out.extend(b"PK\x05\x06\0\0\0\0");
    [count, count].iter().for_each(|word| out.extend(word.to_le_bytes()));
    [length, at].iter().for_each(|word| out.extend(word.to_le_bytes()));
    out.extend([0; 2]);
    Some(out)
}

/// CRC-32 of ISO 3309, as in PNG.
fn checksum(bytes: &[u8]) -> u32 {
    let mut table = [0_u32; 256];
    for (value, entry) in (0..).zip(&mut table) {
        *entry = (0..8).fold(value, |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 });
    }
    !bytes.iter().fold(!0, |crc: u32, byte| crc >> 8 ^ table[usize::from(crc.to_le_bytes()[0] ^ byte)])
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_checksum_is_the_known_one() {
        assert_eq!(super::checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(super::checksum(b""), 0);
    }
}
