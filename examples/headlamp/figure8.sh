#!/usr/bin/env bash
# Figure 8: a car's front turned to its right by -19.5, -10.7, -2.1, 6.8 and 15.5 degrees, from left
# to right; with HID high beams, halogen high beams and halogen low beams, in figure8_hid_high.png,
# figure8_halogen_high.png and figure8_halogen_low.png. figure8.md has their light, and how far
# their glare spills beyond the car's outline.
#   figure8.sh FOLDER [BUILD_FOLDER]
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

width=${GLARE_FIGURE_WIDTH:-480}  # Of a picture, in pixels.
angles=(-19.5 -10.7 -2.1 6.8 15.5)
least_cd_m2=4  # Of a veil that counts; the adaptation luminance below.

# The car from each angle, without light: car_0001.exr, ...
frame=0
for angle in "${angles[@]}"; do
  frame=$((frame + 1))
  "$programs/render_car" "$out/car_000$frame.exr" --yaw-deg "$angle" \
    --size "${width}x$((width * 3 / 4))" --distance-m 25 --eye-height-m 1.2 --fov-deg 9 \
    --outline "$out/outline_000$frame.exr" > "$out/car.txt"
done

# scene NAME INTENSITY SPECTRUM high|low: the lamps are where render_car tells.
scene() {
  cat > "$out/$1.toml" <<SCENE
[background]
file = "car_{frame}.exr"
last_frame = ${#angles[@]}
horizontal_fov_deg = 9

[viewer]
adaptation_luminance_cd_m2 = 1  # of the road

[eye]
pupil_mm = 4.5

[template]
size_px = [$((width * 8 / 3)), $((width * 2))]
fov_deg = 18

[[vehicles]]
name = "car"
position_m = [0, -1.2, 25]

[tone_mapping]
adaptation_luminance = 4
SCENE
  for side in right left; do
    cat >> "$out/$1.toml" <<LAMP

[[lamps]]
name = "$side"
vehicle = "car"
$(grep -A 1 "^# $4 beam, $side" "$out/car.txt" | tail -n 1)
intensity = "$2"
spectrum = "$3"
LAMP
  done
}

scene hid_high "$beams/hid_high.ies" hid high
scene halogen_high "$beams/halogen_high.ies" halogen high
scene halogen_low "$beams/halogen_low_right_hand_traffic.ies" halogen low

turns=$(IFS=,; echo "${angles[*]}")
columns=${#angles[@]}

# spilled BEAMS FRAME: the share of what is beside the car to which the glare adds more than that.
spilled() {
  "$programs/spill" "$out/outline_000$2.exr" "$out/car_000$2.exr" "$least_cd_m2" \
                    "$out/$1_000$2.exr"
}

# row BEAMS FRAME ANGLE: of the table, from the report; its rows are a frame's right and left lamp.
row() {
  {
    echo "${1//_/ }" "$3"
    column intensity_cd "$out/$1.csv" | sed -n "$((2 * $2 - 1)),$((2 * $2))p"
    for field in frame_illuminance_lux veil_template_1deg_cd_m2 frame_veil_on_axis_cd_m2 \
                 frame_threshold_increment_percent; do
      column "$field" "$out/$1.csv" | sed -n "$((2 * $2))p"
    done
    spilled "$1" "$2"
  } | paste -sd' ' | awk '{
    printf "| %s %s | %s° | %.0f | %.0f | %.2f | %.1f | %.1f | %.0f %% | %.1f %% |\n",
           $1, $2, $3, $4, $5, $6, $7, $8, $9, 100 * $10 }'
}

{
  echo "| beams | turned | right lamp, cd | left lamp, cd | both at the eye, lx |" \
       "veil 1° from the left one, cd/m² | veil ahead, cd/m² | threshold increment | spilled |"
  echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
} > "$out/figure8.md"
for beams_name in hid_high halogen_high halogen_low; do
  for kind in png exr; do
    headlamp "$out/$beams_name.toml" --angles="$turns" -o "$out/${beams_name}_{frame}.$kind" \
             --report "$out/$beams_name.csv"
  done
  "$programs/contact_sheet" "$out/figure8_$beams_name.png" "$columns" 2 \
                              "$out/${beams_name}"_????.png
  for ((frame = 1; frame <= columns; ++frame)); do
    row "$beams_name" "$frame" "${angles[frame - 1]}" >> "$out/figure8.md"
  done
done
cat "$out/figure8.md"

# At an oncoming driver's angles the low beams' glare has to stay within the car, and the high
# beams' not: less than a twentieth of what is beside the car against more than a fifth.
for frame in 4 5; do
  awk -v low="$(spilled halogen_low $frame)" -v high="$(spilled halogen_high $frame)" \
      -v hid="$(spilled hid_high $frame)" \
      'BEGIN { exit !(low < 0.05 && high > 0.2 && hid > 0.2) }' ||
    { echo "figure8.sh: the glare's spilled shares aren't as expected" >&2; exit 1; }
done
