#!/bin/sh
# Measures all studies and draws the charts of docs/numerics.*.md anew: docs/numerics.sh [CAMERA_LAB]
# The numbers that the pages quote are those of the table that it prints, and of docs/numerics.csv.
set -eu
program=${1:-$(dirname "$0")/../target/release/camera-lab}
program=$(realpath "$program")
cd "$(dirname "$0")"

"$program" accuracy --format csv >numerics.csv
for study in vertex-transform basis repeated-operations depth-buffer visibility shading antialiasing grid clipping texture-filter shadows; do
    for lang in en pt-BR; do
        "$program" accuracy --study $study --seconds 4 --lang $lang --plot images/numerics-$study.$lang.svg >/dev/null
    done
done
"$program" accuracy
