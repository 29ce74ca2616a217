#!/bin/sh
# door.sh CASE: one test of ./course, on a toy house in a temporary folder whose name has a space; no network, no root.
# Each function case_NAME is a test of its own for ctest (CMakeLists.txt reads their names from this file).
# shellcheck disable=SC2015,SC2016  # `a && b || fail` is meant; bodies of fakes are expanded by the fakes
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd -P)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
toy="$work/a toy"
mkdir "$toy" "$work/bin" "$work/home"
cp -R "$project/tests/course/toy/." "$project/course" "$project/CMakePresets.json" "$toy"
unset DEBIAN_FRONTEND CI COURSE_PRESET COURSE_INSIDE CXX CMAKE_PREFIX_PATH
export HOME="$work/home"

. "$project/tests/course/machine.sh"

# --- words -----------------------------------------------------------------------------------------------------------
case_usage() {
    course && ends_with 0 && is_silent
    for verb in run test doctor; do says "  $verb "; done
    cp "$work/said" "$work/usage"
    for word in help -h --help; do course $word && ends_with 0 && cmp -s "$work/said" "$work/usage" || fail "$word differs"; done
    there_is_no build
}
case_unknown_verb() {
    for verb in frobnicate runn 'r.n' '.*' 'run|' '' '-x'; do
        course "$verb" && ends_with 2 && in_one_line && complains "unknown verb '$verb'"
    done
    there_is_no build
}
case_unknown_chapter() {
    for verb in run test; do
        for chapter in 9 x 0 1x '' '*' 01_ 02_tw; do
            course $verb "$chapter" && ends_with 2 && in_one_line && complains "no chapter '$chapter'; there are: 01_one 02_two"
        done
    done
    course run 1 2 && ends_with 2 && in_one_line && complains "at most 1"
    course doctor 1 && ends_with 2 && in_one_line && complains "at most 0"
    there_is_no build
}

# --- set up ------------------------------------------------------------------------------------------------------------
case_provisioned_machine_never_meets_apt() {
    for command in apt-get apt-cache apt dpkg sudo su curl wget; do fake $command 'exit 1'; done
    course run && ends_with 0 && is_silent && calls_nothing
    course test && ends_with 0 && calls_nothing
}
case_missing_tool_as_root() {
    debian_without_ninja
    user 0
    course run && ends_with 0 && is_silent && says "ninja  " && says "installing with apt: ninja-build (to download 7 MB)"
    calls "apt-get update"
    calls "apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=300 ninja-build"
    calls "frontend noninteractive"
    says "chapter two has run"
    : >"$work/calls"
    course run && ends_with 0 && calls_nothing
}
case_missing_tool_with_sudo() {
    debian_without_ninja
    user 1000
    fake sudo 'case $1 in -n) exit 0 ;; *) "$@" ;; esac'
    course run && ends_with 0 && is_silent && calls "sudo env DEBIAN_FRONTEND=noninteractive apt-get install" && calls "frontend noninteractive"
}
case_missing_tool_and_a_password() {
    debian_without_ninja
    user 1000
    fake sudo 'exit 1'
    course run && ends_with 3 && in_one_line
    complains "type  sudo apt-get update && sudo apt-get install -y --no-install-recommends ninja-build"
    if grep -q '^apt-get' "$work/calls"; then fail "called apt-get"; fi
}
case_missing_tool_without_sudo() {
    debian_without_ninja
    user 1000
    hide sudo
    for verb in run test doctor; do
        course $verb && ends_with 3 && in_one_line
        complains "type  su - -c 'apt-get update && apt-get install -y --no-install-recommends ninja-build'"
    done
    if grep -q '^apt-get' "$work/calls"; then fail "called apt-get"; fi
}
case_missing_tool_elsewhere_than_debian() {
    hide ninja pandoc apt-get dpkg
    course run && ends_with 3 && in_one_line && says "ninja  " && says "pandoc  " && complains "no Debian or Ubuntu"
    there_is_no build/default
}
case_apt_fails() {
    debian_without_ninja
    user 0
    fake apt-get 'case "$*" in *assume-no*) ;; *install*) echo "E: Unable to locate package ninja-build"; exit 100 ;; esac'
    course run && ends_with 3 && complains "E: Unable to locate package" && complains "build/log/install.txt"
}
case_no_network() {
    debian_without_ninja
    user 0
    fake apt-get 'echo "E: no network"; exit 100'
    course run && ends_with 3 && complains "is there a network?" && complains "E: no network"
}
case_interrupted_installation() {
    debian_without_ninja
    user 0
    fake dpkg 'case $1 in --audit) echo "half configured" ;; esac'
    course run && ends_with 0 && says "was interrupted" && calls "dpkg --configure -a"
    [ "$(grep -n 'dpkg --configure' "$work/calls" | cut -d: -f1)" -lt "$(grep -n 'get install' "$work/calls" | sed -n '1s/:.*//p')" ] ||
        fail "mended after installing"
}
case_without_osmesa_egl_is_asked_for() {
    found=$(find /usr/include/GL/osmesa.h /usr/include/EGL/egl.h 2>/dev/null || :)
    debian_without_ninja
    user 1000
    hide sudo
    # the header cannot be hidden here, so the list of needs is: OpenGL is asked for in ninja's place
    sed -i 's/^ninja|ninja-build/ninja|OPENGL/' "$toy/course"
    course run && ends_with 3 && complains "no-install-recommends libosmesa6-dev'"
    fake apt-cache 'echo "  Candidate: (none)"'
    course run && ends_with 3 && complains "no-install-recommends libegl-dev libopengl-dev libgl1-mesa-dri'"
    [ -n "$found" ] || fail "neither OSMesa nor EGL on this machine"
}
case_old_tools() {
    fake cmake 'echo "cmake version 3.22.1"'
    course run && ends_with 3 && in_one_line && complains "cmake 3.22.1 is too old"
    rm "$work/bin/cmake" && ln -s "$(command -v cmake)" "$work/bin/cmake"
    fake c++ 'echo "#define __GNUC__ 11"'
    course run && ends_with 3 && in_one_line && complains "g++ 11, g++ 12 or newer is needed"
    fake c++ 'echo "#define __GNUC__ 4"; echo "#define __clang_major__ 13"; echo "#define __clang_minor__ 9"'
    course run && ends_with 3 && in_one_line && complains "clang 13, clang 14 or newer is needed"
}
case_doctor() {
    course doctor && ends_with 0 && is_silent && says "Everything needed is here."
    for name in c++ cmake ninja pkg-config Eigen Catch2 OpenGL stb pandoc node KaTeX Lato ccache WebAssembly chromium; do
        [ "$(grep -c "^$name  *[^ ]" "$work/said")" = 1 ] || fail "no row for $name"
    done
    hide chromium
    course doctor && ends_with 0 && says "(optional)"
    hide pandoc
    course doctor && ends_with 3 && says "MISSING" && complains "pandoc"
}

# --- build and run -------------------------------------------------------------------------------------------------------
case_run_from_anywhere() {
    cd / && course run && ends_with 0 && is_silent
    says "chapter one has run"
    says "chapter two has run"
    says "$toy/out/01_one"
    there_is out/02_two/numbers.csv
    ln -s "$toy/course" "$work/link"
    cd "$work" && ./link run 2 >"$work/said" || fail "not through a link"
    says "chapter two has run"
    if grep -q "chapter one" "$work/said"; then fail "run 2 ran chapter 1"; fi
    [ -z "$(ls -A "$work/home")" ] || fail "wrote to the home folder"
}
case_chapter_names() {
    for name in 2 02 02_two; do
        course run $name && ends_with 0 && says "chapter two has run"
        if grep -q "chapter one" "$work/said"; then fail "run $name ran chapter 1"; fi
    done
    there_is_no build/default/bin/01_one
}
case_second_run_does_nothing_needless() {
    course test && ends_with 0
    touch "$work/mark"
    course test && ends_with 0
    grep -q 'no work to do' "$toy/build/log/build.txt" || fail "built again"
    [ -z "$(find "$toy/build" -newer "$work/mark" \( -path '*/bin/*' -o -name '*.o' -o -name CMakeCache.txt -o -name configure.txt \))" ] ||
        fail "made again: $(find "$toy/build" -newer "$work/mark")"
}
case_a_package_installed_later_is_looked_for() {
    hide chromium
    course run 1
    ends_with 0
    rm "$toy/build/log/configure.txt"
    course run 1
    there_is_no build/log/configure.txt
    ln -s "$(command -v true)" "$work/bin/chromium"
    course run 1
    ends_with 0
    there_is build/log/configure.txt
}
case_moved_folder() {
    course run 1 && ends_with 0
    mv "$toy" "$work/another toy"
    toy="$work/another toy"
    course run 1 && ends_with 0 && is_silent && says "building anew" && says "$work/another toy/out/01_one"
}
case_tests_of_one_chapter() {
    course test 2 && ends_with 0 && says "100% tests passed, 0 tests failed out of 1" && says "02_two runs"
    course test && ends_with 0 && says "100% tests passed, 0 tests failed out of 2"
    there_is_no build/strict
    CI=true course test 1 && ends_with 0 && there_is build/strict/bin/test_01_one
}
case_does_not_compile() {
    echo 'int main() { return planet; }' >"$toy/chapters/02_two/main.cpp"
    for verb in run test; do
        course $verb && ends_with 1 && complains "error: " && complains "was not declared in this scope" && complains "$toy/build/log/build.txt"
    done
}
case_cmake_fails() {
    echo 'find_package(NoSuchLibrary REQUIRED)' >>"$toy/CMakeLists.txt"
    course run && ends_with 1 && complains "CMake Error" && complains "NoSuchLibrary" && complains "$toy/build/log/configure.txt"
}
case_chapter_fails() {
    echo 'int main() { return 7; }' >"$toy/chapters/01_one/main.cpp"
    course run && ends_with 1 && in_one_line && complains "chapter 01_one failed (exit code 7)"
    if grep -q "chapter two" "$work/said"; then fail "went on"; fi
    course test && ends_with 1 && says "1 tests failed out of 2" && complains "LastTest.log"
}
# The container file installs what ./course would: each package of its table but the browser of the tests; Debian 12 draws by OSMesa.
case_the_container_has_every_package() {
    wanted=$(sed -n "/^needs='/,/^'/p" "$project/course" | grep -v '^chromium|' | awk -F'|' 'NF == 4 { print $2 }' | sed 's/OPENGL/libosmesa6-dev/')
    [ "$(echo "$wanted" | wc -w)" -gt 12 ] || fail "the table of packages was not found"
    for package in $wanted; do
        tr -s ' ' '\n' <"$project/Containerfile" | grep -qxF -- "$package" || fail "the Containerfile lacks $package"
    done
}
case_nowhere_to_write() {
    : >"$toy/out"
    for verb in run test; do course $verb && ends_with 1 && in_one_line && complains "cannot write"; done
    rm "$toy/out"
    [ "$(id -u)" = 0 ] || { chmod a-w "$toy" && course run && chmod u+w "$toy" && ends_with 1 && in_one_line && complains "cannot write"; }
}

# --- interruptions ---------------------------------------------------------------------------------------------------------
until_true() {
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ $tries -lt 300 ] || fail "waited in vain for: $*"
        sleep 0.1
    done
}
# begin: starts ./course run in a session of its own and comes back when the compiler is at work (and hangs)
begin() {
    real=$(command -v c++)
    hide c++
    printf '#!/bin/sh\ncase "$*" in *main.cpp*) if [ -e "%s/slow" ]; then : >"%s/busy"; sleep 60; fi ;; esac\nexec %s "$@"\n' \
        "$work" "$work" "$real" >"$work/bin/c++"
    chmod +x "$work/bin/c++"
    : >"$work/slow"
    PATH="$path" setsid env --default-signal=INT "$toy/course" run >"$work/said" 2>"$work/complained" </dev/null &
    leader=$!
    until_true test -e "$work/busy"
    rm "$work/slow"
}
interrupted_by() {
    begin
    if [ "$1" = KILL ]; then pkill -KILL -s "$leader"; else kill -s "$1" -- "-$leader"; fi
    code=0
    wait "$leader" 2>/dev/null || code=$?
    [ "$code" != 0 ] || fail "ended as if all were well"
    there_is_no out/01_one/numbers.csv
}
case_interrupted_by_the_keyboard() {
    interrupted_by INT
    ends_with 130
    complains "interrupted: the same command goes on from here"
    course run && ends_with 0 && is_silent && says "chapter two has run"
}
case_interrupted_by_a_power_cut() {
    interrupted_by KILL
    course run && ends_with 0 && is_silent && says "chapter two has run"
}
case_two_at_once() {
    command -v flock >/dev/null || skip "no flock here: no lock"
    begin
    PATH="$path" "$toy/course" run 2 >"$work/second" 2>&1 </dev/null &
    second=$!
    until_true grep -q "another ./course is at work" "$work/second"
    pkill -s "$leader" -f '^sleep 60$' || fail "no compiler to hurry"
    wait "$leader" || fail "the first one failed"
    wait "$second" || fail "the second one failed"
    grep -q "chapter two has run" "$work/second" || fail "the second one did not run"
}
case_on_a_terminal() {
    command -v script >/dev/null || skip "no script(1) here"
    script -qec true /dev/null >/dev/null 2>&1 </dev/null || skip "this system gives no pseudo-terminal"
    code=0
    TERM=xterm script -qec "'$toy/course' run" /dev/null >"$work/said" </dev/null || code=$?
    ends_with 0
    says "chapter two has run"
    grep -q "$(printf '\r')" "$work/said" || fail "no progress line"
}

case $(command -v "case_$1" || :) in case_*) "case_$1" && echo "as it should be" ;; *) echo "no case $1" && exit 2 ;; esac
