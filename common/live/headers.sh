#!/bin/sh
# headers.sh LIST FIGURE...: writes a header that includes what the figures do, if it is not that already.
set -eu
list=$1
shift
folder=$(dirname "$1")
{
    cat "$@" | sed -n 's/^#include </&/p' | sort -u
    cat "$@" | sed -n "s|^#include \"|&$folder/|p" | sort -u
} >"$list.new"
if cmp -s "$list.new" "$list"; then rm "$list.new"; else mv "$list.new" "$list"; fi
