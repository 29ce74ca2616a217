#!/bin/sh
# results.sh BIN OUT NAME...: runs the chapters' programs BIN/NAME into OUT/NAME, those that are newer than their results.
set -eu
bin=$1 out=$2
shift 2
for name; do
    [ -x "$bin/$name" ] || { echo "$bin/$name is not built: build everything before testing the book" >&2; exit 1; }
    if [ ! -f "$out/$name/numbers.csv" ] || [ "$bin/$name" -nt "$out/$name/numbers.csv" ]; then
        "$bin/$name" --out "$out/$name"
    else
        echo "$name: its results are newer than the program"
    fi
done
