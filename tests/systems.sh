#!/bin/bash
# Do the README's two commands work on a bare system? For contributors; takes root, debootstrap and a network.
#   sudo tests/systems.sh [--bases DIR] [--work DIR] [--mirror URL] [--short] [--clang] [--keep] [SUITE...]
#   SUITE     what debootstrap knows, from nothing: bookworm trixie sid if none is named
#   --bases   where the bare systems are kept for the next time, as SUITE.tar (default: not kept)
#   --work    where the systems are built, 4 GB each (default: a temporary folder)
#   --mirror  where packages come from (default: as this machine's apt, if it is Debian; else debootstrap's own)
#   --short   ./course test in the first system, by the user without network, instead of in a second one from nothing
#   --clang   once more the tests with the suite's clang, warnings as errors
#   --keep    leaves the systems where they are, to look into
# For each suite, the committed HEAD is cloned into two fresh systems that have nothing but what `debootstrap
# --variant=minbase` brings. In the first: ./course run as root; then again as a user without root and without network,
# which must build nothing, and change nothing outside the clone. In the second: ./course test. Exit code 0: all is well;
# 1: the course failed somewhere; 3: only systems failed (apt could not install, for reasons outside the course).
set -euo pipefail

if [ "${1:-}" = -h ] || [ "${1:-}" = --help ]; then sed -n '2,/^set /{/^set /!s/^# \{0,1\}//p}' "$0"; exit; fi
[ "$(id -u)" = 0 ] || { echo "systems: only root may build systems: sudo $0 $*" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "systems: debootstrap is missing: apt-get install debootstrap" >&2; exit 2; }
# In namespaces of its own: whatever is mounted or started here ends with this script, however it ends.
[ -n "${SYSTEMS_INSIDE:-}" ] || SYSTEMS_INSIDE=1 exec unshare --mount --pid --fork --kill-child --mount-proc bash "$0" "$@"

project=$(cd "$(dirname "$0")/.." && pwd -P)
bases='' work='' mirror='' short='' clang='' keep='' suites=()
while [ $# -gt 0 ]; do
    case $1 in
    --bases) bases=$2 && shift ;;
    --work) work=$2 && shift ;;
    --mirror) mirror=$2 && shift ;;
    --short) short=yes ;;
    --clang) clang=yes ;;
    --keep) keep=yes ;;
    -*) echo "systems: unknown option $1 (--help)" >&2 && exit 2 ;;
    *) suites+=("$1") ;;
    esac
    shift
done
[ ${#suites[@]} -gt 0 ] || suites=(bookworm trixie sid)
[ -n "$work" ] || work=$(mktemp -d)
mkdir -p "$work"
# shellcheck disable=SC2016  # apt expands it
if [ -z "$mirror" ] && grep -qx 'ID=debian' /etc/os-release; then
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null | grep -v security | head -n 1 || :)
fi

say() { printf 'systems: %s\n' "$*"; }

# fresh SUITE FOLDER: a bare system with the clone in /home/learner/course, and this machine's way to the network
fresh() {
    local suite=$1 root=$2
    if [ -n "$bases" ] && [ -f "$bases/$suite.tar" ]; then
        mkdir -p "$root" && tar -C "$root" -xf "$bases/$suite.tar"
    else
        debootstrap --variant=minbase "$suite" "$root" ${mirror:+"$mirror"} >"$work/$suite.debootstrap.txt" 2>&1 || return 3
        if [ -n "$bases" ]; then
            mkdir -p "$bases" && tar -C "$root" -cf "$bases/$suite.tar.new" . && mv "$bases/$suite.tar.new" "$bases/$suite.tar"
        fi
    fi
    cp /etc/resolv.conf /etc/hosts "$root/etc/"
    apt-config dump | grep -E '^Acquire::(https?|Check|Retries|ForceIPv)' >"$root/etc/apt/apt.conf.d/00host" || :
    if [[ $mirror == https:* ]]; then mkdir -p "$root/etc/ssl" && cp -RL /etc/ssl/certs "$root/etc/ssl/"; fi
    mount --bind "$root" "$root"
    mount -t proc proc "$root/proc"
    mount -t tmpfs tmpfs "$root/dev"
    for node in null zero full random urandom tty; do : >"$root/dev/$node" && mount --bind "/dev/$node" "$root/dev/$node"; done
    mkdir "$root/dev/shm" "$root/dev/pts" && chmod 1777 "$root/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
    ln -s pts/ptmx "$root/dev/ptmx" && ln -s /proc/self/fd "$root/dev/fd"
    inside "$root" useradd -m learner
    git -c safe.directory='*' clone -q --no-hardlinks "$project" "$root/home/learner/course"
    [ -x "$root/home/learner/course/course" ]
}
discard() { umount -R "$1" && { [ -n "$keep" ] || rm -rf "$1"; }; }

# inside ROOT COMMAND...: not chroot, in which a user may not make namespaces as on a real system
inside() {
    # shellcheck disable=SC2016  # expanded inside
    unshare --mount "${offline[@]}" sh -c 'cd "$0" && pivot_root . . && umount -l . && exec "$@"' "$1" \
        env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${@:2}"
}
offline=()
as_root() { inside "$1" HOME=/root sh -c "cd /home/learner/course && $2"; }
as_learner_offline() {
    local offline=(--net)
    inside "$1" HOME=/home/learner setpriv --reuid=learner --regid=learner --init-groups sh -c "cd / && $2"
}

# try SUITE TITLE COMMAND...: runs it with its output in a log, sets $took and $code
try() {
    local title="$1: $2" log="$work/$1.${2// /_}.txt" begin=$SECONDS
    shift 2
    code=0
    "$@" >"$log" 2>&1 </dev/null || code=$?
    took=$((SECONDS - begin))
    say "$title: $([ $code = 0 ] && echo "well, $took s" || echo "exit code $code after $took s, see $log")"
    if [ $code != 0 ]; then tail -n 15 "$log" | sed 's/^/    /'; fi
    return $code
}

row() { printf '%-10s %-8s %-8s %-8s %-8s %8s %10s %8s %8s  %s\n' "$@" >>"$work/table.txt"; }
: >"$work/table.txt"
row suite g++ Eigen Catch2 draws "run [s]" "again [s]" "test [s]" warnings verdict

one() {
    local suite=$1 root="$work/$1" run='' again='' test='' warnings='' verdict tests changed tested
    local compiler='' eigen='' catch2='' draws=''
    finish() {
        row "$suite" "$compiler" "$eigen" "$catch2" "$draws" "$run" "$again" "$test" "$warnings" "$1"
        for r in "$root.run" "$root.test"; do [ ! -d "$r/home/learner" ] || discard "$r"; done
    }
    outside() { finish "OUTSIDE the course: $1"; worst=$((worst == 1 ? 1 : 3)); }
    failed() { if [ "$code" = 3 ]; then outside "the system could not be provided with what is needed"; else finish "FAILED: $1" && worst=1; fi; }

    say "$suite: making bare systems"
    fresh "$suite" "$root.run" || { outside "debootstrap failed, see $work/$suite.debootstrap.txt"; return; }
    try "$suite" "run" as_root "$root.run" "./course run" || { failed "./course run"; return; }
    run=$took
    # shellcheck disable=SC2016  # dpkg-query expands it
    version() { inside "$root.run" dpkg-query -W -f='${Version}' "$1" 2>/dev/null | sed 's/^[0-9]*://; s/[-+~].*//'; }
    compiler=$(inside "$root.run" g++ -dumpfullversion) eigen=$(version libeigen3-dev) catch2=$(version catch2)
    draws=$([ -e "$root.run/usr/include/GL/osmesa.h" ] && echo OSMesa || echo EGL)
    [ -f "$root.run/home/learner/course/out/01_newton/numbers.csv" ] || { code=1 && failed "no numbers of chapter 1"; return; }

    inside "$root.run" chown -R learner: /home/learner/course
    touch "$work/mark" && sleep 1
    try "$suite" "run again" as_learner_offline "$root.run" "/home/learner/course/course run" || { failed "second ./course run"; return; }
    again=$took
    grep -q 'no work to do' "$root.run/home/learner/course/build/log/build.txt" || { failed "the second run built again"; return; }
    changed=$(find "$root.run" -xdev -newer "$work/mark" -not -path "$root.run/home/learner/course/*" -not -path "$root.run/tmp" -not -path "$root.run/dev/*")
    [ -z "$changed" ] || { failed "changed outside the clone: $changed"; return; }

    if [ -n "$short" ]; then
        tested="$root.run"
        try "$suite" "test" as_learner_offline "$tested" "/home/learner/course/course test" || { failed "./course test"; return; }
    else
        tested="$root.test"
        fresh "$suite" "$tested" || { outside "debootstrap failed"; return; }
        try "$suite" "test" as_root "$tested" "./course test" || { failed "./course test"; return; }
    fi
    test=$took
    tests=$(sed -n 's/^100% tests passed.* out of \([0-9]*\)$/\1/p' "$work/$suite.test.txt")
    [ -n "$tests" ] || { code=1 && failed "no closing line of ctest"; return; }
    warnings=$(grep -c 'warning:' "$tested/home/learner/course/build/log/build.txt" || :)
    verdict="well: $tests tests pass"
    if [ -n "$clang" ]; then
        try "$suite" "clang from apt" as_root "$tested" "apt-get install -y --no-install-recommends clang" || { outside "apt could not install clang"; return; }
        try "$suite" "test with clang" as_root "$tested" "COURSE_PRESET=clang ./course test" || { failed "./course test with clang"; return; }
        verdict+=", with clang $(inside "$tested" clang++ -dumpversion) in $took s too"
    fi
    finish "$verdict"
}

worst=0
{   # read whole before it begins, so that the script may be edited meanwhile
    for suite in "${suites[@]}"; do one "$suite"; done
    echo
    cat "$work/table.txt"
    [ -n "$keep" ] || rmdir "$work" 2>/dev/null || say "logs: $work"
    exit "$worst"
}
