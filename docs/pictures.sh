#!/bin/sh
# Draws the pictures of the guides' chapter on the pipeline anew: docs/pictures.sh [CAMERA_LAB]
set -eu
program=${1:-$(dirname "$0")/../target/release/camera-lab}
# The folder changes below.
program=$(realpath "$program")
cd "$(dirname "$0")"

draw() { # FIGURE PICTURE [OPTION]...
    figure=figures/pipeline-$1.toml picture=images/pipeline-$2.png
    shift 2
    "$program" render "$figure" "$@" -o "$picture"
}

for name in wireframe flat gouraud phong painter bsp; do
    draw $name $name
done
sed 's/^divide_first = true/divide_first = false/' figures/pipeline-divide-first.toml >figures/pipeline-right.toml
draw right divide-right
rm figures/pipeline-right.toml
for lang in en pt-BR; do
    "$program" render figures/points.toml --view all --size 960x320 --lang $lang -o images/points.$lang.png
    draw depth depth.$lang --lang $lang
    draw depth-linear depth-linear.$lang --lang $lang
    draw clipping clipping-world.$lang --view world --size 480x360 --lang $lang
    draw clipping clipping-canonical.$lang --view canonical --size 480x360 --lang $lang
    draw divide-first divide-first.$lang --lang $lang
    draw culled culled.$lang --view world --size 640x480 --lang $lang
done
