# machine.sh, read by door.sh: what a case says, and the machine that it happens on.
# shellcheck shell=sh disable=SC2015,SC2034,SC2154  # `a && b || fail` is meant; door.sh sets and reads the variables

# --- what a case says ----------------------------------------------------------------------------------------------
# course ARGUMENT...: runs it, output to $work/said and $work/complained, exit code to $code
course() {
    code=0
    PATH="${path:-$PATH}" "$toy/course" "$@" >"$work/said" 2>"$work/complained" </dev/null || code=$?
}
fail() {
    echo "FAILED: $*"
    for file in "$work/said" "$work/complained" "$work/calls"; do
        [ ! -f "$file" ] || { echo "--- $(basename "$file")" && cat "$file"; }
    done
    exit 1
}
skip() { echo "skipped: $*" && exit 77; }
ends_with() { [ "$code" = "$1" ] || fail "exit code $code instead of $1"; }
says() { grep -qF -- "$1" "$work/said" || fail "does not say: $1"; }
complains() { grep -qF -- "$1" "$work/complained" || fail "does not complain: $1"; }
in_one_line() { [ "$(wc -l <"$work/complained")" = 1 ] || fail "the complaint is not one line"; }
is_silent() { [ ! -s "$work/complained" ] || fail "complains"; }
calls() { grep -q -- "$1" "$work/calls" || fail "was not called: $1"; }
calls_nothing() { [ ! -s "$work/calls" ] || fail "called what it should leave alone"; }
there_is() { [ -e "$toy/$1" ] || fail "there is no $1"; }
there_is_no() { [ ! -e "$toy/$1" ] || fail "there is $1"; }

# --- a machine of our own: $path holds every command of this machine but those hidden or faked -------------------------
hide() {
    if [ -z "${path:-}" ]; then
        path="$work/bin"
        : >"$work/calls"
        (IFS=:; for folder in $PATH; do [ ! -d "$folder" ] || ln -s "$folder"/* "$work/bin/" 2>/dev/null || :; done)
    fi
    for command; do rm -f "$work/bin/$command"; done
}
fake() {                # fake COMMAND 'BODY': writes its arguments to $work/calls, then does BODY
    hide "$1"
    printf '#!/bin/sh\necho "%s $*" >>"%s"\n%s\n' "$1" "$work/calls" "${2:-}" >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}
user() { hide id && printf '#!/bin/sh\necho %s\n' "$1" >"$work/bin/id" && chmod +x "$work/bin/id"; }
debian_without_ninja() {    # where apt-get install brings it
    ninja=$(command -v ninja)
    hide ninja
    fake dpkg
    fake apt-cache 'echo "  Candidate: 1"'
    fake apt-get 'case "$*" in *assume-no*) echo "Need to get 7 MB of archives." ;;
        *install*ninja-build*) echo "frontend ${DEBIAN_FRONTEND:-}" >>'"'$work/calls'; ln -s '$ninja' '$work/bin/ninja' ;; esac"
}
