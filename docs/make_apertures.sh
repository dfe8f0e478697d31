#!/usr/bin/env bash
# Makes the pictures of docs/apertures.md with the built program.
#   docs/make_apertures.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
glare=${1:-build/release}/tools/glare/glare
"$glare" aperture eye -o docs/images/eye.png --size 512 --quiet
"$glare" aperture diaphragm -o docs/images/diaphragm.png --size 512 --blades 7 --roundness 0.4 \
         --dust 30 --scratches 6 --quiet
"$glare" template -o "$(mktemp -d)/halo.exr" --fov-deg 10 --size 512 --preview docs/images/halo.png
