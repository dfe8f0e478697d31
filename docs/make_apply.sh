#!/usr/bin/env bash
# Makes the scenes of apply.md, before and after, and prints the numbers told there.
#   docs/make_apply.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" > /dev/null
cmake -S examples -B "$work/examples" -DCMAKE_PREFIX_PATH="$work/prefix" \
      -DCMAKE_BUILD_TYPE=Release > /dev/null
cmake --build "$work/examples" --target make_scene contact_sheet render_terrace > /dev/null
glare=$work/prefix/bin/glare

"$glare" template -o "$work/eye.exr" --fov-deg 20 --size 1024
# before_and_after NAME ADAPTATION_LUMINANCE
before_and_after() {
  "$work/examples/make_scene" "$1" "$work/$1.exr" 560
  "$glare" apply "$work/$1.exr" --template "$work/eye.exr" --roll-off 0.6 -o "$work/$1_glare.exr" \
           --verbose
  for picture in "$1" "${1}_glare"; do
    "$glare" tonemap "$work/$picture.exr" --adaptation-luminance "$2" -o "$work/$picture.png"
  done
  "$work/examples/contact_sheet" "docs/images/apply_$1.png" 2 1 "$work/$1.png" "$work/$1_glare.png"
}
before_and_after night_street 0.6
before_and_after sun_glint 2500
before_and_after christmas_tree 0.5
"$work/examples/render_terrace" "$work/terrace" --size 640x360
cp "$work/terrace_0001.png" docs/images/renderer_terrace.png
