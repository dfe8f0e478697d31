#!/usr/bin/env bash
# Figure 7: one lamp at the intensities of a grid of directions of a HID high beam, in figure7.png:
# H = -20, -10, -5, 0, 5, 10, 20 degrees from left to right, V = 5, 2, 0, -2, -5 degrees from the
# top down. Their candelas are in figure7.md, what the unit is in figure7.txt.
#   figure7.sh FOLDER [BUILD_FOLDER]
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

# The yaw and pitch of a lamp that turn its direction (H, V) to the viewer.
turn() {
  awk -v h="$1" -v v="$2" 'BEGIN { d = atan2(0, -1) / 180; h *= d; v *= d
    x = sin(h) * cos(v); y = sin(v); z = cos(h) * cos(v)
    printf "yaw_deg = %.9f\npitch_deg = %.9f\n", atan2(-x, sqrt(y * y + z * z)) / d,
           atan2(-y, z) / d }'
}

pictures=()
{
  echo "| V, ° | H = -20° | -10° | -5° | 0° | 5° | 10° | 20° |"
  echo "| --- | --- | --- | --- | --- | --- | --- | --- |"
} > "$out/figure7.md"
for v in 5 2 0 -2 -5; do
  row="| $v |"
  for h in -20 -10 -5 0 5 10 20; do
    name=$out/figure7_${h}_$v
    cat > "$name.toml" <<SCENE
mode = "paper"

[background]
size_px = [330, 330]
horizontal_fov_deg = 8

[template]
size_px = [500, 500]
fov_deg = 9

[[lamps]]
position_m = [0, 0, 25]
intensity = "$beams/hid_high.ies"
spectrum = "hid"
$(turn "$h" "$v")

[paper]
reference_intensity_cd = 10

[tone_mapping]
adaptation_luminance = 3e-4
SCENE
    headlamp "$name.toml" -o "$name.png" --report "$name.csv"
    pictures+=("$name.png")
    row+=$(printf ' %.0f |' "$(column intensity_cd "$name.csv")")
  done
  echo "$row" >> "$out/figure7.md"
done
"$programs/contact_sheet" "$out/figure7.png" 7 3 "${pictures[@]}"

# What the paper's unit is: its 1 is the template's brightest pixel for the reference intensity.
"$prefix/bin/glare" template --lamp hid --size 500 --fov-deg 9 --quiet -o "$out/figure7.exr"
per_steradian=$("$prefix/bin/glare" info "$out/figure7.exr" |
                awk '/^1 is per steradian/ { print $5 }')
awk -v p="$per_steradian" 'BEGIN {
  printf "1 is the brightest pixel of the template, %.3g per steradian, for 10 cd:\n", p
  printf "%.3g cd/m2 at 25 m; L_wa = 3e-4 is %.3g cd/m2\n", p * 10 / 625, 3e-4 * p * 10 / 625 }' |
  tee "$out/figure7.txt"
