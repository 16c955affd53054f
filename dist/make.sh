#!/usr/bin/env bash
# Makes what people without Rust can use:  bash dist/make.sh windows|web|deb|tar|macos|all OUT
#   windows  camera-lab.exe, and camera-lab.com for consoles
#   web      index.html with its files, lessons.html, and camera-lab.html, one file that opens from disk
#   deb      a package for Debian and its kin
#   tar      the program for Linux, with its manual, icon and completions
#   macos    Camera Lab.app (on a Mac)
#   all      windows, web, deb and tar, with SHA256SUMS
# QUICK=1 makes windows with the profile `quick`, in half the time: to be tried, not to be handed out.
# On Debian it installs what it needs (as root, or by sudo); elsewhere it names what is missing. The same sources give the same bytes
# (camera-lab.exe: from the same folder, by whose name the linker orders the imports).
set -euo pipefail
usage() { sed -n '2,11s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
[ $# -eq 2 ] || usage
case $1 in
    windows | web | deb | tar | macos | all) ;;
    *) usage ;;
esac
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
source dist/tools.sh

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
# The time of the last change to the sources, not of the build.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date -r CHANGELOG.md +%s)}
export SOURCE_DATE_EPOCH
# The path of the sources must not be in the program.
export CARGO_ENCODED_RUSTFLAGS="--remap-path-prefix=$PWD=camera-lab"$'\x1f'"--remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo"

# Profile of the program for Windows, and the folder that Cargo gives it.
profile=release
[ -z "${QUICK:-}" ] || profile=quick

make_windows() {
    install_packages gcc gcc-mingw-w64-x86-64 binutils-mingw-w64-x86-64
    local target=x86_64-pc-windows-gnu resource=$CARGO_TARGET_DIR/camera-lab-resource.o numbers=${version//./,},0
    mkdir -p "$CARGO_TARGET_DIR"
    x86_64-w64-mingw32-windres --include-dir dist/windows -D "VERSION=\\\"$version\\\"" -D "NUMBERS=$numbers" \
        dist/windows/camera-lab.rc -O coff -o "$resource"
    # The linker would write the time of the build into the program.
    local unchanging=(-C link-arg=-Wl,--no-insert-timestamp -C strip=symbols)
    cargo_for "$target" rustc --profile "$profile" --package camera-lab --bin camera-lab -- -C "link-arg=$resource" "${unchanging[@]}"
    cargo_for "$target" rustc --profile "$profile" --package camera-lab-console -- "${unchanging[@]}"
    cp "$CARGO_TARGET_DIR/$target/$profile/camera-lab.exe" "$out/camera-lab.exe"
    cp "$CARGO_TARGET_DIR/$target/$profile/camera-lab-console.exe" "$out/camera-lab.com"
    cp THIRD-PARTY.md "$out"
}

make_web() (
    install_packages python3
    page=$CARGO_TARGET_DIR/page
    target=wasm32-unknown-unknown
    # Vectors of 128 bits, as browsers have had them since 2023. Without them the code drawn in vectors is a third of the program.
    export CARGO_ENCODED_RUSTFLAGS+=$'\x1f'-Ctarget-feature=+simd128
    cargo_for "$target" build --profile web --bin camera-lab
    bindings
    python3 dist/web/assemble.py "$page" "$out"
    cp THIRD-PARTY.md "$out"
    # Its pictures need the program for this machine, which need not be fast.
    CARGO_ENCODED_RUSTFLAGS='' cargo build --locked
    python3 dist/web/lessons.py "$CARGO_TARGET_DIR/debug/camera-lab" "$out"
)

# Writes the JavaScript between the program and the browser, by a package of our own.
bindings() {
    local made=$CARGO_TARGET_DIR/$target/web
    # It runs for seconds: built without optimisation it is there sooner.
    CARGO_ENCODED_RUSTFLAGS='' cargo build --locked --package camera-lab-bindings
    rm -rf "${page:?}"
    mkdir -p "$page"
    "$CARGO_TARGET_DIR/debug/camera-lab-bindings" "$made/camera-lab.wasm" camera-lab "$page"
}

# The program for this machine, once for all packages.
build_program() {
    # Without names of functions: some depend on the folder of the build.
    cargo rustc --locked --release --package camera-lab --bin camera-lab -- -C strip=symbols
    program=$CARGO_TARGET_DIR/release/camera-lab
    manual=$CARGO_TARGET_DIR/manual
    rm -rf "$manual"
    "$program" manual "$manual"
}

make_tar() {
    build_program
    local name=camera-lab-$version-$(uname -m)-linux folder
    folder=$(mktemp -d)
    mkdir -p "$folder/$name"
    cp "$program" README.md CHANGELOG.md LICENSE-* THIRD-PARTY.md dist/icon.svg dist/linux/camera-lab.desktop dist/linux/camera-lab.xml "$folder/$name"
    cp -r "$manual" "$folder/$name/manual"
    # As they lie in the sources: the README names them.
    mkdir -p "$folder/$name/docs" "$folder/$name/assets"
    cp -r docs/*.md docs/images "$folder/$name/docs"
    cp -r assets/figures "$folder/$name/assets"
    # The window hands it out if it lies beside the program.
    [ ! -f "$out/camera-lab.html" ] || cp "$out/camera-lab.html" "$folder/$name"
    tar --sort=name --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX --mtime="@$SOURCE_DATE_EPOCH" \
        -C "$folder" -cf - "$name" | gzip -9n >"$out/$name.tar.gz"
    rm -rf "$folder"
}

make_deb() {
    command -v cargo-deb >/dev/null || CARGO_TARGET_DIR=$CARGO_TARGET_DIR/tools CARGO_ENCODED_RUSTFLAGS='' install_tool cargo-deb '^3'
    build_program
    # Cargo.toml names the packed files as they lie in the folder that cargo takes by default.
    [ "$manual" -ef target/manual ] || { mkdir -p target && ln -sfn "$manual" target/manual; }
    cargo deb --locked --no-build --no-strip --output "$out/"
}

make_macos() {
    [ "$(uname -s)" = Darwin ] || fail 'the bundle for macOS is made on a Mac: its linker is needed'
    build_program
    local contents="$out/Camera Lab.app/Contents"
    mkdir -p "$contents/MacOS" "$contents/Resources"
    cp "$program" "$contents/MacOS/camera-lab"
    cp dist/icon.icns LICENSE-* THIRD-PARTY.md "$contents/Resources"
    sed "s/@VERSION@/$version/g" dist/macos/Info.plist >"$contents/Info.plist"
}

make_all() {
    make_windows
    make_web
    make_tar
    make_deb
    (cd "$out" && sha256sum THIRD-PARTY.md camera-lab.exe camera-lab.com index.html unpack.js camera-lab.js camera-lab-element.js lessons.html camera-lab.wasm.lzma \
        camera-lab.html "camera-lab-$version-$(uname -m)-linux.tar.gz" camera-lab_*.deb >SHA256SUMS)
}

# The linker of the programs that compilers run.
install_packages gcc libc6-dev
"make_$1"
ls -l "$out"
