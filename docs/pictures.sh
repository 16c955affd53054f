#!/bin/sh
# Draws every figure of the guides anew: docs/pictures.sh [CAMERA_LAB [FOLDER [PICTURE]...]]
# Lines and faces of one colour are vectors, with letters as outlines, so that a page that shows them needs no font.
# Colours that vary over faces, and depths, are pixels; so are windows, which the window's own tests draw. With a FOLDER,
# figures go there, all or those with these names, and windows are not drawn. The charts of numerics.*.md are measured,
# and numerics.sh draws them.
set -eu
program=${1:-$(dirname "$0")/../target/release/camera-lab}
to=${2:-$(dirname "$0")/images}
[ $# -gt 1 ] && windows= || windows=yes
[ $# -lt 2 ] || shift 2
only=$*
# The folder changes below.
program=$(realpath "$program") to=$(realpath "$to")
cd "$(dirname "$0")"
figures=../assets/figures/pipeline
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT

draw() { # FIGURE PICTURE [OPTION]...
    figure=$1 picture=$2
    shift 2
    case " ${only:-$picture} " in *" $picture "*) ;; *) return ;; esac
    "$program" render "$figure" "$@" --outlines -o "$to/$picture"
}

for name in wireframe flat painter bsp; do
    draw $figures/$name.toml pipeline-$name.svg
done
for name in gouraud phong; do
    draw $figures/$name.toml pipeline-$name.png
done
sed 's/^divide_first = true/divide_first = false/' $figures/divide-first.toml >"$scratch/right.toml"
draw "$scratch/right.toml" pipeline-divide-right.svg
for lang in en pt-BR; do
    draw figures/points.toml points.$lang.svg --view all --size 960x320 --lang $lang
    for name in depth depth-linear; do
        draw $figures/$name.toml pipeline-$name.$lang.png --lang $lang
    done
    for view in world canonical; do
        draw $figures/clipping.toml pipeline-clipping-$view.$lang.svg --view $view --size 480x360 --lang $lang
    done
    draw $figures/divide-first.toml pipeline-divide-first.$lang.svg --lang $lang
    draw $figures/culled.toml pipeline-culled.$lang.svg --view world --size 640x480 --lang $lang
done

# A sheet with its solutions, as pdftoppm (Poppler) shows its first page.
for lang in en pt-BR; do
    case " ${only:-sheet.$lang.png} " in *" sheet.$lang.png "*)
        "$program" exercise sheet --ids view-matrix --answers --lang $lang -o "$scratch/sheet.pdf"
        pdftoppm -singlefile -r 80 -y 105 -H 775 -png "$scratch/sheet.pdf" "$to/sheet.$lang" ;;
    esac
done

case " ${only:-drag.gif} " in *" drag.gif "*)
    "$program" animate figures/drag.toml --vary azimuth=-30..30:16,26..-26:14 --view all --size 320x260 --seconds 3 -o "$to/drag.gif" ;;
esac

if [ "$windows" ]; then
    cargo test --locked --test gui guide_pictures -- --ignored
fi
