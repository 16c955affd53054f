#!/usr/bin/env python3
"""Makes the icons of all systems from icon.svg; run it after a change there (needs rsvg-convert)."""
import pathlib
import struct
import subprocess

HERE = pathlib.Path(__file__).parent


def png(side):
    """The bytes of a picture of `side` pixels."""
    return subprocess.run(
        ["rsvg-convert", "-w", str(side), "-h", str(side), HERE / "icon.svg"], check=True, capture_output=True
    ).stdout


def ico(sides):
    """Windows: a directory, then the pictures."""
    pictures = [png(side) for side in sides]
    offset = 6 + 16 * len(sides)
    directory = struct.pack("<HHH", 0, 1, len(sides))
    for side, picture in zip(sides, pictures):
        directory += struct.pack("<BBBBHHII", side % 256, side % 256, 0, 0, 1, 32, len(picture), offset)
        offset += len(picture)
    return directory + b"".join(pictures)


def icns(kinds):
    """macOS: each picture under the four letters of its size."""
    parts = [kind + struct.pack(">I", 8 + len(picture)) + picture for kind, picture in kinds]
    return b"icns" + struct.pack(">I", 8 + sum(map(len, parts))) + b"".join(parts)


(HERE / "icon.png").write_bytes(png(256))
(HERE / "icon.ico").write_bytes(ico([16, 24, 32, 48, 64, 256]))
(HERE / "icon.icns").write_bytes(icns([(b"ic07", png(128)), (b"ic08", png(256)), (b"ic09", png(512))]))
