#!/bin/sh
# Draws the six figures for print, 8 cm wide with letters of 8 points, as PDF: docs/paper.sh FOLDER [CAMERA_LAB [LANG]].
# Holds the names in them against what pdftotext finds, where that is there, and compiles a page with all six, where
# pdflatex is there.
set -eu
to=${1:?the folder to write to is missing}
program=${2:-$(dirname "$0")/../target/release/camera-lab}
lang=${3:-en}
mkdir -p "$to"
to=$(realpath "$to") program=$(realpath "$program")
cd "$(dirname "$0")/figures/paper"
paper="--width-cm 8 --letters 8 --lang $lang"

# (a) the camera with u, v, n and its volume; (b) the canonical volume with what it has deformed
"$program" render camera.toml --view world $paper -o "$to/a-camera.pdf"
"$program" render canonical.toml --view canonical $paper -o "$to/b-canonical.pdf"
# (c) parallel beside perspective; (d) painter beside depth buffer; (e) four angles
"$program" sheet projections.toml --vary camera.projection=parallel,perspective --view image --columns 2 --parts $paper -o "$to/c-projections.pdf"
"$program" sheet painter.toml --vary style.visibility=painter,depth-buffer --view image --columns 2 --parts $paper --faces picture -o "$to/d-visibility.pdf"
"$program" sheet angles.toml --vary camera.view_angle=20,40,60,90 --view image --columns 2 --parts $paper -o "$to/e-angles.pdf"
# (f) clipping with its new vertices
"$program" render clipping.toml --view canonical $paper -o "$to/f-clipping.pdf"

if command -v pdftotext >/dev/null; then
    has() { # FIGURE NAME...
        # A name stands between spaces: "n" is not found in "window".
        text=" $(pdftotext -raw "$to/$1.pdf" - | tr '\n\f' '  ') "
        figure=$1
        shift
        for name; do
            case $text in *" $name "*) ;; *) echo "$figure.pdf lacks \"$name\"" >&2 && exit 1 ;; esac
        done
    }
    # Every name in them; words by the language.
    case $lang in
        pt-BR) window='janela (F)' far='fundo' near='frente' new='criado pelo recorte'
            parallel=paralela perspective=perspectiva painter=pintor buffer=z-buffer ;;
        *) window='window (F)' far='far' near='near' new='made by clipping'
            parallel=parallel perspective=perspective painter=painter buffer='depth buffer' ;;
    esac
    # The corners of the canonical volume that have room for their names.
    low='(−1, −1, −1)' high='(1, 1, 1)'
    has a-camera C PF VUP DOP u v n x y z "$window" "$far (B)"
    has b-canonical xn yn zn "$near (zn = −1)" "$far (zn = 1)" "$low" "$high"
    has c-projections "(a) $parallel" "(b) $perspective"
    has d-visibility "(a) $painter" "(b) $buffer"
    has e-angles '(a) θ = 20°' '(b) θ = 40°' '(c) θ = 60°' '(d) θ = 90°'
    has f-clipping xn yn zn "$near (zn = −1)" "$far (zn = 1)" "$low" "$high" "$new"
fi

if command -v pdflatex >/dev/null; then
    cd "$to"
    {
        printf '%s\n' '\documentclass[a4paper]{article}\usepackage{graphicx}\usepackage[margin=2cm]{geometry}'
        printf '%s\n' '\begin{document}\noindent'
        for figure in a-camera b-canonical c-projections d-visibility e-angles f-clipping; do
            printf '%s\n' "\\includegraphics{$figure.pdf}\\hfill"
        done
        printf '%s\n' '\end{document}'
    } >page.tex
    pdflatex -interaction=batchmode -halt-on-error page.tex >/dev/null
fi
