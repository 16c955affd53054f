"""Says what the page's program holds, by crate and by section: contents.py CAMERA_LAB.wasm

The program is the one that Cargo has built, with the names of its functions: target/wasm32-unknown-unknown/web/camera-lab.wasm. For each part
it prints its bytes and how much smaller the packed program is without them.
"""

import collections
import lzma
import pathlib
import re
import sys

SECTIONS = {1: "types", 2: "imports", 3: "functions", 4: "table", 6: "globals", 7: "exports", 9: "elements", 10: "code", 11: "data", 12: "data count"}
OURS = {"camera_lab": "window", "camera_lab_desk": "desk", "camera_lab_engine": "engine", "camera_lab_figures": "figures", "camera_lab_files": "files", "camera_lab_teaching": "teaching", "camera_lab_words": "words"}
STD = {"core", "alloc", "std", "hashbrown", "compiler_builtins", "memchr", "dlmalloc"}


def number(data: bytes, at: int) -> tuple[int, int]:
    """An unsigned LEB128 and the place after it."""
    value = shift = 0
    while True:
        byte = data[at]
        value, shift, at = value | (byte & 127) << shift, shift + 7, at + 1
        if byte < 128:
            return value, at


def sections(data: bytes) -> list[tuple[str, int, int]]:
    at, found = 8, []
    while at < len(data):
        kind = data[at]
        size, start = number(data, at + 1)
        name = SECTIONS.get(kind, "other")
        if kind == 0:
            length, text = number(data, start)
            name = data[text : text + length].decode()
        found.append((name, start, start + size))
        at = start + size
    return found


def function_names(data: bytes, start: int, end: int) -> dict[int, str]:
    _, at = number(data, start)
    at = start + 1 + data[start]
    names = {}
    while at < end:
        kind = data[at]
        size, at = number(data, at + 1)
        after = at + size
        if kind == 1:
            count, at = number(data, at)
            for _ in range(count):
                index, at = number(data, at)
                length, at = number(data, at)
                names[index] = data[at : at + length].decode(errors="replace")
                at += length
        at = after
    return names


def crate(name: str) -> str:
    """The crate whose code a function is, by its mangled name. Generic code of the standard library is that library's."""
    mangled = re.match(r"_ZN(\d+)", name)
    if not mangled:
        return "bindings"
    first = name[mangled.end() :][: int(mangled.group(1))]
    # An implementation is that of its type: `_$LT$egui..ui..Ui$u20$as$u20$…`.
    found = re.search(r"([a-z_][a-z_0-9]*)\.\.", first) if first.startswith("_$LT$") else None
    first = found.group(1) if found else first
    return OURS.get(first, "std" if first in STD or first.startswith("_") else first)


def packed(data: bytes) -> int:
    how = {"id": lzma.FILTER_LZMA1, "preset": 6, "dict_size": 1 << 24, "lc": 4, "lp": 0, "pb": 0}
    return len(lzma.compress(data, format=lzma.FORMAT_ALONE, filters=[how]))


def main(path: pathlib.Path) -> None:
    data = path.read_bytes()
    found = {name: (start, end) for name, start, end in sections(data)}
    names = function_names(data, *found["name"])
    count, at = number(data, found["code"][0])
    # Imported functions come first.
    first = max(names) + 1 - count
    pieces = collections.defaultdict(list)
    for index in range(first, first + count):
        size, start = number(data, at)
        pieces[crate(names.get(index, ""))].append((start, start + size))
        at = start + size
    # Functions that wasm-bindgen and the page don't keep aren't counted.
    start, end = found["code"][0], found["data"][1]
    pieces["data: texts, fonts, tables"].append(found["data"])
    whole = packed(data[start:end])
    print(f"{end - start} bytes, packed {whole}\n\n| part | bytes | packed |\n| --- | ---: | ---: |")
    largest = sorted(pieces.items(), key=lambda piece: -sum(end - start for start, end in piece[1]))
    for name, places in largest[:24]:
        rest, at = [], start
        for begin, after in sorted(places):
            rest.append(data[at:begin])
            at = after
        rest.append(data[at:end])
        size = sum(after - begin for begin, after in places)
        print(f"| {name} | {size:,} | {whole - packed(b''.join(rest)):,} |", flush=True)


main(pathlib.Path(sys.argv[1]))
