#!/bin/sh
# Weaves the book: pages, code, numbers, pictures and charts into static HTML that opens from disk.
#   book/build.sh [--out DIR] [--results DIR] [--pages DIR] [--root DIR]
#   --out      where the book goes                        (out/book)
#   --results  where the chapters' programs have written  (out)
#   --pages    where the pages and errata.csv are         (book)
#   --live     where the figures that move were built     (build/default/live; without them the stills)
#   --root     where the quoted sources are               (the project)
#   --claims   print what stands behind each number and comparison of the text
#   --unquoted print the numbers that no page quotes and no chart shows
# Two editions: the learner's, and DIR/open with every body and answer shown, for print and for teachers.
# A page that quotes something unknown stops the build: every complaint has a file, a line and what to do.
# The old book stays in place until the new one is complete. How to write a page: book/HOWTO.md.
set -eu
export LC_ALL=C.UTF-8
here=$(CDPATH= cd "$(dirname "$0")" && pwd)
root=$(dirname "$here"); pages=$here; out=; results=; live=; claims=; unquoted=
usage() { sed -n '2,10s/^# \{0,1\}//p' "$0"; }
while [ $# -gt 0 ]; do
    case $1 in
        --out|--results|--pages|--root|--live)
            [ $# -ge 2 ] || { echo "book: $1 wants a folder" >&2; exit 2; }
            case $1 in --out) out=$2;; --results) results=$2;; --pages) pages=$2;; --root) root=$2;; --live) live=$2;; esac
            shift 2;;
        --claims) claims=yes; shift;;
        --unquoted) unquoted=yes; shift;;
        -h|--help) usage; exit 0;;
        *) echo "book: unknown argument '$1'" >&2; usage >&2; exit 2;;
    esac
done
: "${results:=$root/out}" "${out:=$root/out/book}" "${live:=$root/build/${COURSE_PRESET:-default}/live}"

# --- what is needed ----------------------------------------------------------------------------------------------
for tool in pandoc node; do
    command -v $tool >/dev/null || { echo "book: $tool is missing: apt-get install pandoc nodejs libjs-katex fonts-lato" >&2; exit 3; }
done
for katex in ${KATEX_DIR:-} /usr/share/javascript/katex /usr/share/nodejs/katex/dist; do
    if [ -f "$katex/katex.js" ] && [ -f "$katex/katex.css" ]; then break; fi
    katex=
done
[ -n "$katex" ] || { echo "book: KaTeX is missing: apt-get install libjs-katex" >&2; exit 3; }

# --- weave into a folder beside the goal, then swap --------------------------------------------------------------
mkdir -p "$(dirname "$out")" && next=$(mktemp -d "$out.next.XXXXXX") || { echo "book: cannot write $out" >&2; exit 1; }
trap 'rm -rf "$next"' EXIT
trap 'exit 130' INT TERM
list=
for page in "$pages"/index.md "$pages"/[0-9][0-9]*_*.md "$pages"/notation.md "$pages"/errata.md; do
    [ -f "$page" ] && list="$list $(basename "$page" .md)"
done
[ -n "$list" ] || { echo "book: no pages in $pages" >&2; exit 1; }

case $pages in "$root"/*) prefix=${pages#"$root"/}/;; *) prefix=$pages/;; esac
bad=0
BOOK_LIST=$list BOOK_PREFIX=$prefix BOOK_PAGES=$pages BOOK_ROOT=$root BOOK_RESULTS=$results BOOK_LIVE=$live BOOK_OUT=$next BOOK_HERE=$here \
    pandoc --from markdown --to plain --lua-filter "$here/weave/book.lua" --output /dev/null /dev/null || bad=1
node "$here/weave/katex.cjs" "$katex" "$next" || bad=1
[ $bad = 0 ] || { echo "book: the complaints above stop the build; nothing was written to $out" >&2; exit 1; }
cat "$here/style/book.css" "$here/style/pictures.css" "$here/../common/live/live.css" > "$next/book.css"
if [ -d "$next/live" ]; then
    {
        printf "'use strict';\n(() => {\n"
        for part in gl parts figure page; do cat "$here/../common/live/script/$part.js"; done
        echo '})();'
    } > "$next/live/live.js"
fi
mkdir -p "$next/fonts"
for face in Lato-Regular Lato-Bold Lato-Italic; do
    font=$(find -L /usr/share/fonts -name "$face.ttf" 2>/dev/null | head -n 1)
    if [ -n "$font" ]; then cp -L "$font" "$next/fonts/"; else echo "book: $face.ttf is missing (fonts-lato)" >&2; exit 3; fi
done

cp "$here/style/book.js" "$next/"
chmod 755 "$next"
if [ -e "$out" ]; then rm -rf "$out.old" && mv "$out" "$out.old"; fi
mv "$next" "$out"
rm -rf "$out.old"
trap - EXIT
[ -z "$claims" ] || cat "$out/claims.csv"
[ -z "$unquoted" ] || cat "$out/unquoted.txt"
echo "book: $out/index.html"
