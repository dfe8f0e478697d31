#!/usr/bin/env bash
# Makes the pictures of README.md with the built program and the example night_scene.
#   docs/make_pictures.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" > /dev/null
cmake -S examples -B "$work/examples" -DCMAKE_PREFIX_PATH="$work/prefix" \
      -DCMAKE_BUILD_TYPE=Release > /dev/null
cmake --build "$work/examples" > /dev/null
mkdir -p docs/images
"$work/prefix/bin/glare" template -o "$work/hid.exr" --lamp hid --size 360 \
                         --preview docs/images/template.png
"$work/examples/night_scene" docs/images/scene.png docs/images/aperture.png
