#!/bin/sh
# whittle.sh — from a fresh Debian 12 to a picture, or to passed tests, by one command.
#
#   sh whittle.sh demo     install what the program needs, build it, render a scene
#   sh whittle.sh test     install what the tests need too, build everything, run the tests
#   sh whittle.sh packages print what those two install
#
# Only missing packages are asked of apt, only changed files are compiled: a second run costs nothing.
set -eu
cd "$(dirname "$0")"

build=build/release
program_packages="g++ cmake ninja-build libfmt-dev libglm-dev libexpected-dev libsleef-dev libtbb-dev libhwy-dev libgmp-dev libpolyclipping-dev
    libcli11-dev nlohmann-json3-dev libopenimageio-dev libpugixml-dev zlib1g-dev libfreetype-dev libharfbuzz-dev libfontconfig-dev fonts-liberation2"
test_packages="libcgal-dev libmpfr-dev libopenmesh-dev lib3mf-dev catch2 openscad fonts-dejavu-core fonts-urw-base35"

say() { printf '\n== %s\n' "$*"; }

# The words of "$@" that dpkg does not know as installed.
missing_of() {
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || printf '%s ' "$package"
    done
}

install_packages() {
    if ! command -v dpkg-query >/dev/null 2>&1; then
        echo "whittle.sh installs with apt; this system has none. Install by hand what 'sh whittle.sh packages' prints." >&2
        return 0
    fi
    missing=$(missing_of "$@")
    [ -n "$missing" ] || return 0
    root=
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null 2>&1 || { echo "Run this once as root: apt-get install $missing" >&2; exit 3; }
        root=sudo
    fi
    say "Installing $missing"
    $root env DEBIAN_FRONTEND=noninteractive apt-get update
    # shellcheck disable=SC2086  # a list of words on purpose
    $root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

# Configures once; later runs leave it to the build, which configures again by itself when a CMakeLists.txt changed.
configured_with() { grep -q "^$1:BOOL=ON" "$build/CMakeCache.txt" 2>/dev/null; }

demo() {
    # shellcheck disable=SC2086
    install_packages $program_packages
    if [ ! -e "$build/build.ninja" ]; then
        say "Configuring $build"
        cmake --preset release -DWHITTLE_TESTS=OFF -DWHITTLE_CGAL=OFF
    fi
    say "Building the program"
    cmake --build "$build" --target whittle whittle_image whittle_font
    scene=examples/carved_cube.scad
    picture=$build/carved_cube.png
    say "Rendering $scene"
    "$build/whittle" render "$scene" -o "$picture"
    cat <<END

The picture: $PWD/$picture

Next:
  $build/whittle render examples/bearing.scad -o bearing.png --imgsize 1024,768
  $build/whittle spans examples/carved_cube.scad --ray=-100,1,2,1,0,0
  $build/whittle mesh examples/carved_cube.scad -o carved_cube.stl
END
}

run_tests() {
    # shellcheck disable=SC2086
    install_packages $program_packages $test_packages
    if ! configured_with WHITTLE_TESTS || ! configured_with WHITTLE_CGAL; then
        say "Configuring $build"
        cmake --preset release -DWHITTLE_TESTS=ON -DWHITTLE_CGAL=ON -DWHITTLE_BENCH=ON
    fi
    say "Building everything"
    cmake --build "$build"
    say "Testing"
    ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)"
}

case "${1:-}" in
    demo) demo ;;
    test) run_tests ;;
    packages) echo $program_packages $test_packages ;;
    *)
        sed -n '2,8s/^# \{0,1\}//p' "$0"
        exit 2
        ;;
esac
