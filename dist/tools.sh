# Functions that the scripts of this project share, read by them with `source`.

steps_took=()

# Begins a step, and says how long the one before took: on the clock, and of processors, as all of it counts that has ended.
step() {
    end_step
    printf '\n== %s\n' "$*"
    count_processor
    step_name=$* step_began=$SECONDS step_processor=$processor
}

end_step() {
    [ -n "${step_name:-}" ] || return 0
    count_processor
    steps_took+=("$(printf '%5d s, of processors %5d s: %s' $((SECONDS - step_began)) $((processor - step_processor)) "$step_name")")
    printf -- '-- took%s\n' "${steps_took[-1]}"
    step_name=
}

# all_steps FILE: prints the time of every step at the end of a run. RECORD=1 writes it into FILE, which git keeps.
all_steps() {
    end_step
    count_processor
    steps_took+=("$(printf '%5d s, of processors %5d s: all' "$SECONDS" "$processor")")
    printf '%s\n' "${steps_took[@]}"
    [ -z "${RECORD:-}" ] || {
        mkdir -p "${1%/*}"
        printf '%s\n' "$(date +%F), $(nproc) processors" "${steps_took[@]}" >"$1"
    }
}

# User and system time of this shell and of the programs it has waited for, in whole seconds.
count_processor() {
    local file
    file=$(mktemp)
    # By way of a file: a shell of its own would count its own time.
    times >"$file"
    processor=$(awk '{ for (i = 1; i <= NF; i++) { split($i, t, /[ms]/); sum += t[1] * 60 + t[2] } } END { printf "%d", sum }' "$file")
    rm -f "$file"
}

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

# Installs missing packages of Debian. On other systems it names them, so that the user can.
install_packages() {
    if ! command -v dpkg-query >/dev/null; then
        printf 'needed here, by their names in Debian: %s\n' "$*"
        return
    fi
    local missing=() package
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        echo 'all there'
        return
    fi
    local root=()
    [ "$(id -u)" -eq 0 ] || root=(sudo)
    # One at a time: two scripts may run beside each other.
    "${root[@]}" flock /tmp/camera-lab-packages.lock env DEBIAN_FRONTEND=noninteractive \
        sh -c 'apt-get update -q && apt-get install -q -y --no-install-recommends "$@"' sh "${missing[@]}"
}

# install_tool CRATE VERSION [ARGUMENT...]: has cargo build a program of others. First as its own lock file says. If a registry doesn't have those versions, then
# the newest versions are taken that this compiler can build. Without optimisation: a program that runs for seconds is built in a third of the time.
install_tool() {
    local crate=$1 version=$2
    shift 2
    cargo install "$crate" --version "$version" --locked --debug "$@" && return
    printf '%s %s cannot be built as its lock file says: the newest versions of what it needs are taken.\n' "$crate" "$version" >&2
    CARGO_RESOLVER_INCOMPATIBLE_RUST_VERSIONS=fallback cargo install "$crate" --version "$version" --debug "$@" && return
    printf '%s %s cannot be built: the newest version is taken.\n' "$crate" "$version" >&2
    cargo install "$crate" --debug "$@"
}

# cargo_for TARGET COMMAND [ARGUMENT...]: cargo for another system. With rustup's standard library if that is installed or can
# be had, and else with Debian's compiler, which brings its sources.
cargo_for() {
    local target=$1 command=$2
    shift 2
    export CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=x86_64-w64-mingw32-gcc
    if has_target "$target"; then
        cargo "$command" --locked --target "$target" "$@"
    else
        command -v dpkg-query >/dev/null || fail "the standard library for $target is missing: rustup target add $target"
        install_packages rustc-web cargo-web rust-web-src
        local panic=panic_unwind
        if [[ $target = wasm32-* ]]; then
            panic=panic_abort
            # That compiler brings no linker for the browser.
            install_packages lld
            export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld
        fi
        env PATH=/usr/bin:/bin RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 \
            /usr/bin/cargo "$command" --locked --target "$target" "-Zbuild-std=std,$panic" "$@"
    fi
}

has_target() {
    command -v rustup >/dev/null || return 1
    rustup target list --installed 2>/dev/null | grep -qx "$1" && return
    # Without a network it says so at once, but a proxy that never answers is not waited for. (Macs have no timeout.)
    if command -v timeout >/dev/null; then
        timeout 120 rustup target add "$1"
    else
        rustup target add "$1"
    fi
}
