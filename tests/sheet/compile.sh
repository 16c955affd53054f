#!/bin/sh
# Compiles a sheet of all exercises in both languages, with and without answers: tests/sheet/compile.sh [CAMERA_LAB [FOLDER]]
# Prints the number of pages of each, and fails if LaTeX does, or if a line is wider than the page.
set -eu
program=$(realpath "${1:-$(dirname "$0")/../../target/debug/camera-lab}")
if ! command -v pdflatex >/dev/null; then
    echo "pdflatex is not installed: no sheet was compiled"
    exit 0
fi
folder=${2:-$(mktemp -d)}
mkdir -p "$folder"
cd "$folder"
ids=$("$program" exercise list --format json | sed -n 's/.*"id": "\([^"]*\)".*/\1/p' | paste -sd, -)
wide=0
for lang in en pt-BR; do
    for answers in "" --answers; do
        name=sheet.$lang$answers
        # shellcheck disable=SC2086 # nothing, or an option
        "$program" exercise sheet --ids "$ids" --seed 1 --lang $lang $answers -o "$name.tex"
        pdflatex -interaction=nonstopmode -halt-on-error "$name.tex" >"$name.out" || { tail -n 20 "$name.out"; exit 1; }
        pages=$(sed -n 's/.*(\([0-9]*\) pages\{0,1\}.*/\1/p' "$name.out")
        overfull=$(grep -c '^Overfull .hbox' "$name.out" || true)
        echo "$name.pdf: $pages pages, $overfull lines too wide"
        wide=$((wide + overfull))
    done
done
echo "in $folder"
test "$wide" -eq 0
