#!/usr/bin/env bash
# Makes Camera Lab for the browser: OUT/index.html with its files, for a web server, and OUT/camera-lab.html, one file that opens from
# disk too.
#
#   bash dist/web.sh OUT
#
# With rustup: rustup target add wasm32-unknown-unknown. On Debian, Debian's own compiler for the browser is used where that target is
# not there; as root, the packages that are missing are installed. Besides, only python3 is needed.
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: bash dist/web.sh OUT" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
folder=${CARGO_TARGET_DIR:-target}/web

install_packages() {
    local missing=() package root=()
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    [ "$(id -u)" -eq 0 ] || root=(sudo)
    "${root[@]}" apt-get update -q
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# What links programs for the browser: that of the toolchain, else Debian's.
linker() {
    local found
    found=$(find "$(rustc --print sysroot 2>/dev/null || echo /nowhere)" -name rust-lld -type f 2>/dev/null | head -n 1)
    if [ -z "$found" ]; then
        command -v wasm-ld >/dev/null || install_packages lld >&2
        found=$(command -v wasm-ld)
    fi
    echo "$found"
}

build() {
    local arguments=(build --locked --profile web --bin camera-lab --target wasm32-unknown-unknown --target-dir "$folder")
    if rustup target list --installed 2>/dev/null | grep -q wasm32-unknown-unknown; then
        cargo "${arguments[@]}"
    else
        install_packages rustc-web cargo-web rust-web-src
        CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$(linker)
        export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER
        env PATH=/usr/bin:/bin RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 \
            /usr/bin/cargo "${arguments[@]}" -Zbuild-std=std,panic_abort
    fi
}

# Writes the JavaScript between the program and the browser; it has to be of the version that the program was built with.
bindings() {
    local version bindgen=$folder/tools/bin/wasm-bindgen
    version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
    if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
        bindgen=wasm-bindgen
    elif [ "$("$bindgen" --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
        cargo install wasm-bindgen-cli --version "$version" --root "$folder/tools" --target-dir "$folder/tools/target"
        rm -rf "$folder/tools/target"
    fi
    local program=$folder/wasm32-unknown-unknown/web/camera-lab.wasm target
    for target in web no-modules; do
        rm -rf "${folder:?}/$target"
        "$bindgen" --target "$target" --no-typescript --remove-name-section --remove-producers-section \
            --out-dir "$folder/$target" --out-name camera-lab "$program"
    done
}

build
bindings
python3 dist/web/assemble.py "$folder" "$out"
