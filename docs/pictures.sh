#!/bin/sh
# Draws the pictures of the guides' chapter on the pipeline anew: docs/pictures.sh [CAMERA_LAB]
set -eu
program=${1:-$(dirname "$0")/../target/release/camera-lab}
# The folder changes below.
program=$(realpath "$program")
cd "$(dirname "$0")"

draw() { # FIGURE PICTURE [OPTION]...
    figure=../assets/figures/pipeline/$1.toml picture=images/pipeline-$2.png
    shift 2
    "$program" render "$figure" "$@" -o "$picture"
}

for name in wireframe flat gouraud phong painter bsp; do
    draw $name $name
done
sed 's/^divide_first = true/divide_first = false/' ../assets/figures/pipeline/divide-first.toml >figures/right.toml
"$program" render figures/right.toml -o images/pipeline-divide-right.png
rm figures/right.toml
for lang in en pt-BR; do
    "$program" render figures/points.toml --view all --size 960x320 --lang $lang -o images/points.$lang.png
    draw depth depth.$lang --lang $lang
    draw depth-linear depth-linear.$lang --lang $lang
    draw clipping clipping-world.$lang --view world --size 480x360 --lang $lang
    draw clipping clipping-canonical.$lang --view canonical --size 480x360 --lang $lang
    draw divide-first divide-first.$lang --lang $lang
    draw culled culled.$lang --view world --size 640x480 --lang $lang
done
