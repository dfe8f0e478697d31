#!/usr/bin/env bash
# Makes the pictures of headlamps.md, and prints its tables.
#   docs/make_headlamps.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for figure in 6 7 8; do examples/headlamp/figure$figure.sh "$work" "$build" > /dev/null; done
for picture in figure6 figure7 figure8_hid_high figure8_halogen_high figure8_halogen_low; do
  cp "$work/$picture.png" "docs/images/headlamp_$picture.png"
done
cp "$work/hid_high_0004.png" docs/images/headlamp_oncoming_high.png
cp "$work/halogen_low_0004.png" docs/images/headlamp_oncoming_low.png
cat "$work/figure7.md" "$work/figure7.txt" "$work/figure8.md"
