#!/usr/bin/env bash
# Frames of the window with OpenGL in software: benches/window.sh [PROGRAM]
# The window fills a display of Xvfb of 1920 × 1080, and the pointer moves thirty times a second: over a panel, with the
# world held, or with θ held. For each it prints frames a second, milliseconds of a processor a frame, with those of Xvfb, and by
# perf which part they go to: "shading" is code that llvmpipe has made, "driver" the rest of it. Needs Xvfb, xdotool,
# gdb, perf, and Mesa's llvmpipe.
set -euo pipefail
program=$(realpath "${1:-$(dirname "$0")/../target/release/camera-lab}")
seconds=6
scratch=$(mktemp -d)
export HOME=$scratch XDG_CONFIG_HOME=$scratch/config XDG_DATA_HOME=$scratch/data DISPLAY=:77 WAYLAND_DISPLAY=
started=()
trap 'kill "${started[@]}" 2>/dev/null; wait 2>/dev/null; rm -r "$scratch"' EXIT

Xvfb "$DISPLAY" -screen 0 1920x1080x24 +extension GLX 2>"$scratch/xvfb.log" &
display=$!
started+=("$display")
sleep 2
"$program" 2>"$scratch/window.log" &
window=$!
started+=("$window")
sleep 5
id=$(xdotool search --pid "$window" | tail -1)
xdotool windowsize "$id" 1920 1080 windowmove "$id" 0 0
sleep 3

# To and fro about a place, until it is killed.
move() { # X Y
    local i steps=()
    for i in 1 2 3 4 5 6 7 8 9 10 9 8 7 6 5 4 3 2; do
        steps+=(mousemove $(($1 + 3 * i)) "$2" sleep 0.033)
    done
    while true; do
        xdotool "${steps[@]}"
    done
}

# Of a process, in hundredths of a second.
used() {
    awk '{ print $14 + $15 }' "/proc/$1/stat"
}

# The library of the dispatch and the one of the driver have a function of this name each: one of them is counted.
frames() {
    local debugger
    printf '%s\n' 'set pagination off' 'handle SIGINT stop nopass' 'break glXSwapBuffers' 'disable 1.2' 'ignore 1 1000000' \
        "shell touch $scratch/ready" continue 'info breakpoints' detach >"$scratch/count"
    gdb -q -batch -p "$window" -x "$scratch/count" >"$scratch/counted" 2>&1 &
    debugger=$!
    until [ -e "$scratch/ready" ]; do sleep 0.1; done
    rm "$scratch/ready"
    sleep "$seconds"
    kill -INT "$window"
    wait "$debugger"
    sed -n 's/.*already hit \([0-9]*\) times.*/\1/p' "$scratch/counted"
}

row() { # NAME X Y
    local mover before of_display count
    move "$2" "$3" &
    mover=$!
    sleep 1
    before=$(used "$window") of_display=$(used "$display")
    count=$(frames)
    before=$(($(used "$window") - before)) of_display=$(($(used "$display") - of_display))
    perf record -q -e cpu-clock -F 2000 -p "$window" -o "$scratch/perf" -- sleep 4
    kill "$mover"
    wait "$mover" 2>/dev/null || true
    perf report -i "$scratch/perf" --sort dso 2>/dev/null | awk -v program="$(basename "$program")" -v name="$1" -v count="$count" \
        -v seconds="$seconds" -v window="$before" -v display="$of_display" '
        /^ / { share = $1; sub("%", "", share)
            part = $2 == "[JIT]" ? "shading" : $2 ~ /swrast|gallium/ ? "driver" : $2 == program ? "program" : "rest"
            of[part] += share }
        END { printf "%-16s %5.1f frames/s %6.1f ms a frame, Xvfb %4.1f; shading %2.0f %%, driver %2.0f %%, program %2.0f %%, rest %2.0f %%\n", name,
            count / seconds, 10 * window / count, 10 * display / count, of["shading"], of["driver"], of["program"], of["rest"] }'
}

xdotool mousemove 60 900
row 'over a panel' 60 900
xdotool mousemove 330 900 mousedown 1
row 'world held' 330 900
xdotool mouseup 1 mousemove 200 323 mousedown 1
row 'θ held' 200 323
xdotool mouseup 1
