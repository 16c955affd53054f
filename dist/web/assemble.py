"""Puts the page together: OUT/index.html with its files, and OUT/camera-lab.html, which holds everything.

assemble.py MADE OUT: in MADE is the program as wasm-bindgen has written it.
"""

import base64
import gzip
import lzma
import pathlib
import re
import sys

# The most that people download.
MOST_BYTES = 3_200_000

# As `camera-lab lesson package` looks for it.
VERSION = re.search(r'^version = "(.*)"', (pathlib.Path(__file__).parents[2] / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]

# Loaded from the server that the page is on, and from nowhere else.
SERVED_POLICY = (
    "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; connect-src 'self'; "
    "style-src 'unsafe-inline'; img-src data: blob:"
)
SERVED = """<script src="./unpack.js"></script>
<script src="./camera-lab.js"></script>
<script>
  const whole = async (name) => {
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    return answer.arrayBuffer();
  };
  function cameraLabThirdParty() {
    return whole('./THIRD-PARTY.md').then((bytes) => new TextDecoder().decode(bytes), String);
  }
  if (cameraLabCanRun()) {
    // Asynchronous even where the scripts did not come, whose names are unknown then.
    (async () => cameraLabStart(whole('./camera-lab.wasm.lzma')))()
      .catch((why) => why instanceof WebAssembly.CompileError ? cameraLabNoWindow(String(why)) : cameraLabNote('no-program', String(why)));
  }
</script>"""

# Everything is in the file.
ALONE_POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:"
)
ALONE = """<script>
@UNPACK_JS@
</script>
<script>
@PROGRAM_JS@
</script>
<script type="application/octet-stream" id="packed">@PACKED@</script>
<script type="text/plain" id="third-party">@THIRD_PARTY@</script>
<script>
  async function cameraLabThirdParty() { return document.getElementById('third-party').textContent; }
  if (cameraLabCanRun()) {
    const held = async () => Uint8Array.from(atob(document.getElementById('packed').textContent), (c) => c.charCodeAt(0)).buffer;
    cameraLabStart(held()).catch((why) => cameraLabNoWindow(String(why)));
  }
</script>"""


def page(policy: str, program: str) -> str:
    template = (pathlib.Path(__file__).parent / "index.html").read_text(encoding="utf-8")
    assert template.count("@POLICY@") == 1 and template.count("@PROGRAM@") == 1
    return template.replace("@VERSION@", VERSION).replace("@POLICY@", policy).replace("@PROGRAM@", program)


def packed(program: bytes) -> bytes:
    # Code has no unit of two or four bytes: `pb` = 0. The dictionary holds the whole program.
    how = {"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "dict_size": 1 << 24, "lc": 4, "lp": 0, "pb": 0, "nice_len": 273}
    packed = lzma.compress(program, format=lzma.FORMAT_ALONE, filters=[how])
    # Python leaves the size out, and unpack.js needs it.
    return packed[:5] + len(program).to_bytes(8, "little") + packed[13:]


def base64_of(data: bytes) -> str:
    return base64.b64encode(data).decode()


def main(made: pathlib.Path, out: pathlib.Path) -> None:
    program_js = (made / "camera-lab.js").read_text(encoding="utf-8")
    unpack_js = (pathlib.Path(__file__).parent / "unpack.js").read_text(encoding="utf-8")
    third_party = (pathlib.Path(__file__).parents[2] / "THIRD-PARTY.md").read_text(encoding="utf-8")
    # A script ends at the first of these, wherever it stands.
    assert not any(mark in program_js + unpack_js + third_party for mark in ("</script", "<!--"))
    program = packed((made / "camera-lab_bg.wasm").read_bytes())
    files = {
        "index.html": page(SERVED_POLICY, SERVED).encode(),
        "camera-lab.js": program_js.encode(),
        "camera-lab.wasm.lzma": program,
        "unpack.js": unpack_js.encode(),
    }
    alone = page(
        ALONE_POLICY,
        ALONE.replace("@UNPACK_JS@", unpack_js)
        .replace("@PROGRAM_JS@", program_js)
        .replace("@PACKED@", base64_of(program))
        .replace("@THIRD_PARTY@", third_party),
    )
    # Of pages that show this one, which have room to themselves.
    element = (pathlib.Path(__file__).parent / "camera-lab-element.js").read_bytes()
    if len(element) > 8000:
        sys.exit(f"camera-lab-element.js: {len(element)} bytes, more than 8000")
    (out / "camera-lab-element.js").write_bytes(element)
    total = 0
    for name, data in files.items():
        (out / name).write_bytes(data)
        # As web servers pack a file that is not packed yet.
        small = len(data) if name.endswith(".lzma") else len(gzip.compress(data, 9, mtime=0))
        total += small
        print(f"{name}: {len(data)} bytes, {small} compressed")
    (out / "camera-lab.html").write_text(alone, encoding="utf-8", newline="\n")
    print(f"index.html and its files: {total} bytes compressed; camera-lab.html: {len(alone.encode())} bytes")
    if total > MOST_BYTES:
        sys.exit(f"more than {MOST_BYTES} bytes to download")
    wrong = wrong_sizes(total, len(alone.encode()))
    if wrong:
        sys.exit("\n".join(wrong))


def wrong_sizes(total: int, alone: int) -> list[str]:
    """The sizes in the guides that aren't those of this page: each number of MB on a line about it has to be one of three, to 3 %."""
    root = pathlib.Path(__file__).parents[2]
    wrong = []
    for path in [*root.glob("docs/*.md"), *root.glob("README*.md")]:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if "camera-lab.html" not in line and "assemble.py" not in line:
                continue
            for claimed in re.findall(r"(\d+[.,]\d+) MB", line):
                size = float(claimed.replace(",", ".")) * 1e6
                if all(abs(size - of) > 0.03 * of for of in (total, alone, MOST_BYTES)):
                    wrong.append(f"{path.relative_to(root)}:{number}: {claimed} MB; the page has {total / 1e6:.2f}, camera-lab.html {alone / 1e6:.2f} MB")
    return wrong


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
