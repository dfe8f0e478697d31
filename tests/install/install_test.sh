#!/usr/bin/env bash
# Tests what `cmake --install` makes. install_test.sh STEP SETTINGS; CMakeLists.txt lists the steps
# and writes the settings.
# shellcheck disable=SC2154  # variables from the settings
set -euo pipefail
export LC_ALL=C
step=$1
# shellcheck disable=SC1090
source "$2"
prefix=$work/moved
libraries=$prefix/$lib_dir
# The development files of what glare::io stands on aren't there.
without_files_libraries=(-DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON
                         -DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON)

fail() { printf 'install_test: %s: %s\n' "$step" "$*" >&2; exit 1; }

# The files as expected_files.txt names them: what depends on machine or version is a @NAME@.
installed_files() {
  (cd "$prefix" && find . ! -type d) | sed -e 's|^\./||' -e "/^${doc_dir//\//\\/}\//d" \
    -e "s|^$python_dir/|@PYTHON@/|" -e "s|\(/_glare\)\.[^/]*\.so$|\1@EXTENSION@|" \
    -e "s|^$lib_dir/|@LIB@/|" -e "s|^$include_dir/|@INCLUDE@/|" -e "s|^$bin_dir/|@BIN@/|" \
    -e "s|^$data_dir/|@DATA@/|" \
    -e "s|^@LIB@/glare-$abi_version/|@LIB@/glare-@ABI@/|" \
    -e "s|\.so\.${version//./\\.}$|.so.@VERSION@|" -e "s|\.so\.${abi_version//./\\.}$|.so.@ABI@|" \
    -e "s|-targets-${build_type,,}\.cmake$|-targets-@TYPE@.cmake|" | sort
}

expected_files() {
  expected_libraries | if [ "$python" = ON ]; then cat; else grep -v '^@PYTHON@/'; fi
}

expected_libraries() {
  if [ "$shared" = ON ]; then cat "$source_dir/tests/install/expected_files.txt"
  else sed -e '/\.so\./d' -e '/glare-@ABI@/d' -e 's/\.so$/.a/' \
         "$source_dir/tests/install/expected_files.txt"
  fi | sort
}

# Two pictures, 400 x 400 and 2 mm wide: a round pupil, and eyelashes as slanted dark lines.
make_pictures() {
  awk 'BEGIN { print "P2 400 400 255"; for (y = 0; y < 400; ++y) for (x = 0; x < 400; ++x)
       print ((x - 200)^2 + (y - 200)^2 < 180^2) ? 255 : 0 }' >"$1/pupil.pgm"
  awk 'BEGIN { print "P2 400 400 255"; for (y = 0; y < 400; ++y) for (x = 0; x < 400; ++x)
       print (y < 200 && (3 * x + y) % 200 < 30) ? 0 : 255 }' >"$1/eyelashes.pgm"
}

# built NAME SOURCE_FOLDER [OPTION...]: configures and builds a project in work/NAME.
built() {
  local build=$work/$1 source=$2
  shift 2
  "$cmake" -S "$source" -B "$build" -G "$generator" -DCMAKE_BUILD_TYPE="$build_type" \
    -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_CXX_COMPILER_LAUNCHER="$cxx_launcher" "$@"
  "$cmake" --build "$build" --config "$build_type"
}

# built_with_package NAME SOURCE_FOLDER [OPTION...]: the same, against the installed package.
built_with_package() {
  local build=$work/$1
  built "$@" -DCMAKE_PREFIX_PATH="$prefix"
  grep -q "^glare_DIR:PATH=$libraries/cmake/glare$" "$build/CMakeCache.txt" ||
    fail "another glare than the installed one was found"
}

require_template() { "$prefix/$bin_dir/glare" info "$1" | grep 'per steradian'; }

require_light() {
  local loaded
  loaded=$(ldd "$1")
  if grep -iE 'not found|OpenImageIO|OpenEXR|OpenColorIO|libglare_io' <<<"$loaded"; then
    fail "$1 uses glare::core only, but loads these (or lacks them)"
  fi
}

case $step in
  tree)
    rm -rf "$work/installed" "$prefix"
    "$cmake" --install "$build_dir" --config "$build_type" --prefix "$work/installed" >/dev/null
    mv "$work/installed" "$prefix"
    ;;
  files)
    diff -u --label expected_files.txt --label installed <(expected_files) <(installed_files) ||
      fail "other files are installed than tests/install/expected_files.txt lists; if that is meant, edit it"
    for file in LICENSE README.md; do
      [ ! -e "$source_dir/$file" ] || cmp "$source_dir/$file" "$prefix/$doc_dir/$file"
    done
    ;;
  relocation)
    found=$(grep -rlIF -e "$work" -e "$source_dir" -e "$build_dir" "$prefix" \
              --include='*.cmake' --include='*.pc' --include='*.h' || true)
    [ -z "$found" ] || fail "these name a folder of the build: $found"
    ;;
  program)
    out=$work/program
    mkdir -p "$out"
    rm -f "$out"/*.exr
    env -u LD_LIBRARY_PATH "$prefix/$bin_dir/glare" template --size 64 -o "$out/eye.exr"
    require_template "$out/eye.exr"
    make_pictures "$out"
    env -u LD_LIBRARY_PATH "$prefix/$bin_dir/glare" template --size 64 -o "$out/pupil.exr" \
      --pupil "$out/pupil.pgm" --width-mm 2 --fov-deg 2 --ocio "$source_dir/data/color/glare.ocio" \
      --colorspace aces_interchange
    require_template "$out/pupil.exr"
    ;;
  python)
    # From the installed tree alone: its own libraries, and an io module.
    out=$work/python
    mkdir -p "$out"
    make_pictures "$out"
    env -u LD_LIBRARY_PATH PYTHONPATH="$prefix/$python_dir" "$python_program" -B - "$out" <<'END'
import sys
import glare
out = sys.argv[1]
made = glare.template(pupil=out + "/pupil.pgm", width_mm=2, size=64, fov_deg=2)
made.save(out + "/python.exr")
assert glare.read_template(out + "/python.exr").rgb.shape == (64, 64, 3)
libraries = {line.split()[-1] for line in open("/proc/self/maps") if "libglare_" in line}
root = glare.__file__.rsplit("/lib/", 1)[0]
assert libraries and all(library.startswith(root) for library in libraries), libraries
END
    require_template "$out/python.exr"
    ;;
  cmake_package)
    options=()
    [ "$shared" != ON ] || options=("${without_files_libraries[@]}")
    built_with_package examples "$source_dir/examples" "${options[@]}"
    out=$work/examples
    make_pictures "$out"
    rm -f "$out"/*.exr
    "$out/make_template" "$out/pupil.pgm" "$out/eyelashes.pgm" 2 D65 "$out/template.exr"
    require_template "$out/template.exr"
    "$out/make_template" "$out/pupil.pgm" "$out/eyelashes.pgm" 2 \
      "$source_dir/data/lamps/cie_a.csv" "$out/template_a.exr"
    if cmp -s "$out/template.exr" "$out/template_a.exr"; then fail "two lamps, one template"; fi
    "$out/night_scene" "$out/scene.png" "$out/aperture.png" 64
    [ "$(head -c 4 "$out/scene.png" | tail -c 3)" = PNG ] || fail "night_scene made no PNG"
    "$out/render_car" "$out/car.exr" --size 32x24 --samples 1 --outline "$out/outline.exr" |
      grep -q '^position_m = \[0, -1.2, 25\]$' || fail "render_car doesn't tell the car's place"
    [ "$("$out/spill" "$out/outline.exr" "$out/car.exr" 0 "$out/car.exr")" = 0.0000 ] ||
      fail "a car without light has glare"
    "$out/contact_sheet" "$out/sheet.png" 2 2 "$out/car.exr" "$out/outline.exr"
    [ "$(head -c 4 "$out/sheet.png" | tail -c 3)" = PNG ] || fail "contact_sheet made no PNG"
    "$out/render_terrace" "$out/terrace" --frames 2 --size 48x27 --samples 1 \
      --template "$out/template.exr"
    for frame in "$out"/terrace_000{1,2}; do
      for channel in glare.R glare.G glare.B; do
        grep -aqF "$channel" <(head -c 400 "$frame.exr") || fail "a frame has no channel $channel"
      done
      "$prefix/$bin_dir/glare" tonemap "$frame.exr" -o "$out/beauty.png"  # R, G and B are there too
      [ "$(head -c 4 "$frame.png" | tail -c 3)" = PNG ] || fail "render_terrace made no PNG"
    done
    if cmp -s "$out"/terrace_000{1,2}.exr; then fail "two frames of the terrace, one picture"; fi
    for scene in night_street sun_glint christmas_tree; do
      "$out/make_scene" "$scene" "$out/$scene.exr" 48
      "$prefix/$bin_dir/glare" tonemap "$out/$scene.exr" -o "$out/$scene.png"
    done
    # Fails unless low beams' glare stays within the car's outline where high beams' doesn't.
    GLARE_PREFIX=$prefix GLARE_EXAMPLES=$out GLARE_FIGURE_WIDTH=120 \
      "$source_dir/examples/headlamp/figure8.sh" "$out/figure8" "$build_dir"
    ;;
  core_only)
    built_with_package core_only "$source_dir/tests/install/core_only" \
      "${without_files_libraries[@]}"
    "$work/core_only/core_only"
    require_light "$work/core_only/core_only"
    ;;
  pkg_config)
    export PKG_CONFIG_PATH=$libraries/pkgconfig LD_LIBRARY_PATH=$libraries
    mkdir -p "$work/pkg_config"
    program=$work/pkg_config/core_only
    # shellcheck disable=SC2046
    $cxx_launcher "$cxx" -std=c++20 -c "$source_dir/tests/install/core_only/core_only.cpp" \
      -o "$program.o" $("$pkg_config" --cflags glare-core)
    # shellcheck disable=SC2046
    "$cxx" -o "$program" "$program.o" $("$pkg_config" --libs glare-core)
    "$program"
    require_light "$program"
    [ "$("$pkg_config" --modversion glare)" = "$version" ] || fail "glare.pc has another version"
    "$pkg_config" --libs glare | grep -- -lglare_io
    ;;
  c_interface)
    # A C compiler alone; then the program under sanitizers, with the plain library; then ctypes.
    export PKG_CONFIG_PATH=$libraries/pkgconfig LD_LIBRARY_PATH=$libraries
    out=$work/c_interface
    mkdir -p "$out"
    built_with_package c_program "$source_dir/examples/c_program" "${without_files_libraries[@]}"
    "$work/c_program/street_lamp" "$out/eye.exr" | grep '^0.50 degrees'
    require_template "$out/eye.exr"
    strict=(-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Werror)
    source=$source_dir/tests/install/c_only/c_only.c
    # shellcheck disable=SC2046
    "$cc" "${strict[@]}" -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all "$source" \
      -o "$out/c_only" $("$pkg_config" --cflags --libs glare-c) -lm
    ASAN_OPTIONS=detect_leaks=1 "$out/c_only" "$out"
    require_template "$out/c_only.exr"
    [ ! -x /usr/bin/python3 ] ||
      /usr/bin/python3 -B "$source_dir/tests/install/c_interface.py" "$libraries/libglare_c.so"
    # shellcheck disable=SC2016  # a fence of Markdown
    diff -u --label docs/c-interface.md --label street_lamp.c \
      <(sed -n '/^```c$/,/^```$/p' "$source_dir/docs/c-interface.md" | sed '1d;$d') \
      "$source_dir/examples/c_program/street_lamp.c" || fail "the page has another program"
    other=$(nm -D --defined-only "$libraries/libglare_c.so" | grep -v ' glare_' || true)
    [ -z "$other" ] || fail "libglare_c.so shows more than the C interface: $other"
    ;;
  static)
    prefix=$work/static_installed
    libraries=$prefix/$lib_dir
    built static "$source_dir" -DBUILD_SHARED_LIBS=OFF -DGLARE_BUILD_TESTS=OFF \
      -DGLARE_BUILD_TOOLS=OFF -DCMAKE_INSTALL_LIBDIR="$lib_dir"
    rm -rf "$prefix"
    "$cmake" --install "$work/static" --config "$build_type" --prefix "$prefix" >/dev/null
    built_with_package static_examples "$source_dir/examples"
    built_with_package static_core_only "$source_dir/tests/install/core_only" \
      "${without_files_libraries[@]}"
    "$work/static_core_only/core_only"
    require_light "$work/static_core_only/core_only"
    built_with_package static_c_only "$source_dir/tests/install/c_only"
    mkdir -p "$work/static_c_out"
    "$work/static_c_only/c_only" "$work/static_c_out"
    out=$work/static_examples
    make_pictures "$out"
    "$out/make_template" "$out/pupil.pgm" "$out/eyelashes.pgm" 2 D65 "$out/template.exr"
    ;;
  *) fail "no such step" ;;
esac
