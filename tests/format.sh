#!/bin/sh
# Is the code as clang-format leaves it, no line over 110 columns, no file over 300 lines?   tests/format.sh PROJECT
# clang-format's versions differ in small things: Debian 12's (14) decides. Exit code 77: it is not here.
cd "$1" || exit 2
files() { find common chapters tests -name '*.hpp' -o -name '*.cpp' | grep -v '^tests/judge/answers/' | sort; }
# Lines with a string, and the two files that are texts of another language, are as long as that is.
wide=$(files | grep -v -e 'picture/shaders.hpp$' -e 'book/weave_test.cpp$' | LC_ALL=C.UTF-8 xargs grep -nE '^[^"]{111,}$')
[ -z "$wide" ] || { echo "$wide"; echo "format: lines over 110 columns"; exit 1; }
long=$(files | xargs wc -l | awk '$2 != "total" && $1 > 300')
[ -z "$long" ] || { echo "$long"; echo "format: files over 300 lines"; exit 1; }
for tool in clang-format-14 clang-format; do
    case $("$tool" --version 2>/dev/null) in *'version 14.'*) break ;; esac
    tool=
done
[ -n "$tool" ] || { echo "format: skipped, clang-format 14 (Debian 12's package clang-format) is not here"; exit 77; }
files | xargs "$tool" --dry-run -Werror || { echo "format: run clang-format -i on the files above"; exit 1; }
