#!/usr/bin/env bash
# Figure 6: one eye, six lamps of one luminance, in figure6.png:
#   HID              halogen              LED
#   fluorescent      sodium               daylight (D65)
#   figure6.sh FOLDER [BUILD_FOLDER]
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

pictures=()
for lamp in hid halogen led FL11 HP1 D65; do
  cat > "$out/figure6_$lamp.toml" <<SCENE
mode = "paper"

[background]
size_px = [400, 400]
horizontal_fov_deg = 8

[template]
size_px = [500, 500]
fov_deg = 9

[[lamps]]
position_m = [0, 0, 25]
intensity_cd = 30000
spectrum = "$lamp"

[paper]
reference_intensity_cd = 10

[tone_mapping]
per_channel = false
transfer = "srgb"
adaptation_luminance = 3e-4
SCENE
  headlamp "$out/figure6_$lamp.toml" -o "$out/figure6_$lamp.png" --report "$out/figure6_$lamp.csv"
  pictures+=("$out/figure6_$lamp.png")
done
"$programs/contact_sheet" "$out/figure6.png" 3 2 "${pictures[@]}"
