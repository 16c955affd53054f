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
web=$CARGO_TARGET_DIR/web
target=wasm32-unknown-unknown

# Writes the JavaScript between the program and the browser: its version has to be that of the library that the program was built with.
bindings() {
    local version bindgen=$CARGO_TARGET_DIR/tools/bin/wasm-bindgen kind
    version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
    if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
        bindgen=wasm-bindgen
    elif [ "$("$bindgen" --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
        CARGO_TARGET_DIR=$CARGO_TARGET_DIR/tools CARGO_ENCODED_RUSTFLAGS='' \
            cargo install wasm-bindgen-cli --version "$version" --root "$CARGO_TARGET_DIR/tools"
    fi
    for kind in web no-modules; do
        rm -rf "${web:?}/$kind"
        "$bindgen" --target "$kind" --no-typescript --remove-name-section --remove-producers-section \
            --out-dir "$web/$kind" --out-name camera-lab "$CARGO_TARGET_DIR/$target/web/camera-lab.wasm"
    done
}

install_packages python3
cargo_for "$target" build --profile web --bin camera-lab
bindings
python3 dist/web/assemble.py "$web" "$out"
