#!/bin/sh
# mine.sh JUDGE BOOK MODULE NATIVE: ./course live 1 --mine: the page has the learner's own Euler; an answer that does not
# compile, or does not end, keeps the last that worked and says why.
set -eu
judge=$1 book=$2 module=$3 native=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; cat "$work/said"; exit 1; }
"$judge" start --answers "$work/answers" >/dev/null
answer=$work/answers/01_newton/nutshell/newton.hpp
cp "$answer" "$work/unanswered"
live() { "$judge" live 1 --mine --once --answers "$work/answers" --work "$work/work" --book "$book" --out "$work/page" >"$work/said" 2>&1; }
euler() { sed "s|throw Unanswered{\"1.3\"};|$1|" "$work/unanswered" >"$answer"; }
numbers() { node "$here/same.cjs" "$module" "$native" >"$work/numbers"; }

live || fail "the unanswered course does not move"
numbers || fail "without an answer it is not the reference's"
# a kick that is twice too strong: the judge says it is wrong, and the page shows what it does
euler 'const auto push = forces(state, t); drift(state, dt); kick(state, push, 2 * dt); return state;'
live || fail "a wrong answer does not move"
! numbers || fail "the page does not have the learner's Euler"
grep -q '^throw, state euler' "$work/numbers" || fail "the throw does not follow the learner's Euler"
cp "$work/page/live/01_newton.js" "$work/last.js"
kept() { cmp -s "$work/last.js" "$work/page/live/01_newton.js"; }
euler 'return stat;'
! live || fail "what does not compile is no failure"
kept || fail "the last that worked is gone from the page"
grep -q 'stat' "$work/page/live/mine.js" || fail "no sentence about what does not compile"
euler 'for (;;) dt += 0; return state;'
! live || fail "what does not end is no failure"
grep -q '1.3' "$work/page/live/mine.js" || fail "no sentence about what does not end"
kept || fail "the last that worked is gone from the page"
echo "the page follows the answer, and keeps the last that worked"
