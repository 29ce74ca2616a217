#!/bin/sh
# pack.sh NAME MODULE OUT: a WebAssembly module as a script that a page opened from disk can load (fetch cannot).
set -eu
{
    printf 'live_modules["%s"]="' "$1"
    gzip -9nc "$2" | base64 | tr -d '\n'
    printf '";\n'
} >"$3.part"
mv "$3.part" "$3"
