"""Puts the page together: OUT/index.html with its files, and OUT/camera-lab.html, which holds everything.

assemble.py MADE OUT: in MADE are the folders `web` and `no-modules` that wasm-bindgen has written.
"""

import base64
import gzip
import pathlib
import sys

# What people download at most, compressed as web servers do it.
MOST_BYTES = 5_000_000

# Loaded from the server that the page is on, and from nowhere else.
SERVED_POLICY = (
    "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; connect-src 'self'; "
    "style-src 'unsafe-inline'; img-src data: blob:"
)
SERVED = """<script type="module">
  if (cameraLabCanRun()) {
    import('./camera-lab.js')
      .then((program) => program.default({ module_or_path: './camera-lab_bg.wasm' }))
      .catch((why) => cameraLabNote('no-program', String(why)));
  }
</script>"""

# Everything is in the file; where the browser can't unpack, it is too old for the program as well.
ALONE_POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:"
)
ALONE = """<script>
@BINDINGS@
</script>
<script type="application/gzip" id="packed">@PACKED@</script>
<script>
  (async () => {
    if (!cameraLabCanRun()) return;
    const packed = Uint8Array.from(atob(document.getElementById('packed').textContent), (c) => c.charCodeAt(0));
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    await wasm_bindgen({ module_or_path: await new Response(unpacked).arrayBuffer() });
  })().catch((why) => cameraLabNoWindow(String(why)));
</script>"""


def page(policy: str, program: str) -> str:
    template = (pathlib.Path(__file__).parent / "index.html").read_text(encoding="utf-8")
    assert template.count("@POLICY@") == 1 and template.count("@PROGRAM@") == 1
    return template.replace("@POLICY@", policy).replace("@PROGRAM@", program)


def packed(data: bytes) -> bytes:
    # Without a time: the same program gives the same file.
    return gzip.compress(data, 9, mtime=0)


def main(made: pathlib.Path, out: pathlib.Path) -> None:
    files = {
        "index.html": page(SERVED_POLICY, SERVED).encode(),
        "camera-lab.js": (made / "web/camera-lab.js").read_bytes(),
        "camera-lab_bg.wasm": (made / "web/camera-lab_bg.wasm").read_bytes(),
    }
    bindings = (made / "no-modules/camera-lab.js").read_text(encoding="utf-8")
    # A script ends at the first of these, wherever it stands.
    assert "</script" not in bindings
    program = base64.b64encode(packed((made / "no-modules/camera-lab_bg.wasm").read_bytes())).decode()
    alone = page(ALONE_POLICY, ALONE.replace("@BINDINGS@", bindings).replace("@PACKED@", program))
    total = 0
    for name, data in files.items():
        (out / name).write_bytes(data)
        small = len(packed(data))
        total += small
        print(f"{name}: {len(data)} bytes, {small} compressed")
    (out / "camera-lab.html").write_text(alone, encoding="utf-8", newline="\n")
    print(f"index.html and its files: {total} bytes compressed; camera-lab.html: {len(alone.encode())} bytes")
    if total > MOST_BYTES:
        sys.exit(f"more than {MOST_BYTES} bytes to download")


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
