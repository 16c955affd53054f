#!/usr/bin/env bash
# Makes Camera Lab for the browser: OUT/index.html with its files, for a web server, and OUT/camera-lab.html, one file that opens from
# disk too.
#
#   bash dist/web.sh OUT
#
# With rustup's target wasm32-unknown-unknown where it can be had; on Debian else with Debian's own compiler, installed here. Besides,
# python3 is needed.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,8s/^# \?//p' "$0" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
source dist/tools.sh
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
page=$CARGO_TARGET_DIR/page
target=wasm32-unknown-unknown

# Writes the JavaScript between the program and the browser: its version has to be that of the library that the program was built with.
bindings() {
    local version bindgen=$CARGO_TARGET_DIR/tools/bin/wasm-bindgen made=$CARGO_TARGET_DIR/$target
    version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
    if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
        bindgen=wasm-bindgen
    elif [ "$("$bindgen" --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
        # Built without optimisation it is there in a third of the time, and runs for seconds.
        CARGO_TARGET_DIR=$CARGO_TARGET_DIR/tools CARGO_ENCODED_RUSTFLAGS='' \
            cargo install wasm-bindgen-cli --locked --version "$version" --root "$CARGO_TARGET_DIR/tools" --debug
    fi
    rm -rf "${page:?}"
    # Not as modules: those cannot stand in a file that opens from disk.
    bind() {
        "$bindgen" --target no-modules --no-typescript --remove-name-section --remove-producers-section --out-dir "$page" --out-name "$@"
    }
    bind camera-lab "$made/web/camera-lab.wasm"
    bind unpack "$made/release/camera_lab_unpack.wasm"
}

install_packages python3
# Vectors of 128 bits, as browsers have had them since 2023: without them what is drawn in vectors is a third of the program.
export CARGO_ENCODED_RUSTFLAGS=${CARGO_ENCODED_RUSTFLAGS:+$CARGO_ENCODED_RUSTFLAGS$'\x1f'}-Ctarget-feature=+simd128
cargo_for "$target" build --profile web --bin camera-lab
cargo_for "$target" build --release --manifest-path dist/web/unpack/Cargo.toml
bindings
python3 dist/web/assemble.py "$page" "$out"
