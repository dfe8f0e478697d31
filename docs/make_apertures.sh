#!/usr/bin/env bash
# Makes the pictures of docs/apertures.md with the built program; with a photograph, also the one
# from it (ImageMagick multiplies pupil and lashes).
#   docs/make_apertures.sh [BUILD_FOLDER [PHOTOGRAPH]]
set -euo pipefail
cd "$(dirname "$0")/.."
glare=${1:-build/release}/tools/glare/glare
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$glare" aperture eye -o docs/images/eye.png --size 512 --quiet
"$glare" aperture eye -o docs/images/eye_small.png --size 512 --pupil-mm 4.5 --clear-media --quiet
"$glare" aperture diaphragm -o docs/images/diaphragm.png --size 512 --blades 7 --roundness 0.4 \
         --dust 30 --scratches 6 --quiet
"$glare" template -o "$work/halo.exr" --fov-deg 10 --size 512 --preview docs/images/halo.png
[ $# -gt 1 ] || exit 0
"$glare" aperture photo "$2" --pupil-out "$work/pupil.png" --eyelashes-out "$work/lashes.png" \
         --size 512 --width-mm 5 --lashes-region 220,395,260,80 --lashes-flip --lashes-shift-mm 0,-9
convert "$work/pupil.png" "$work/lashes.png" -compose multiply -composite -depth 8 \
        docs/images/eye_from_photo.png
