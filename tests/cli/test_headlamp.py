"""glare headlamp: a scene's pictures and report, against numbers worked out by hand."""

import json
import math
import unittest

import exr
import images
from headlamps import ADDED, FLOAT, HeadlampTest, toml
from test_tonemap import CONFIG


class Report(HeadlampTest):
    def test_illuminance(self):
        self.scene(lamps=[{"name": "ahead", "position_m": [0, 0, 50]},
                          {"name": "off", "position_m": [3, -1, 40], "flux_factor": 0.5}])
        ahead, off = self.report()
        self.assertAlmostEqual(ahead["illuminance_lux"], 10000 / 50**2, delta=1e-6)
        square = 3**2 + 1 + 40**2
        lux = 5000 / square * 40 / math.sqrt(square)
        self.assertLess(abs(off["illuminance_lux"] / lux - 1), 1e-6)
        self.assertLess(abs(off["distance_m"] / math.sqrt(square) - 1), 1e-6)
        self.assertLess(abs(off["frame_illuminance_lux"] / (4 + lux) - 1), 1e-6)
        # It is on the viewer's right and below: the eye is to the oncoming car's right, and above.
        self.assertAlmostEqual(off["horizontal_deg"], math.degrees(math.atan2(3, 40)), places=9)
        self.assertAlmostEqual(off["vertical_deg"], math.degrees(math.asin(1 / math.sqrt(square))),
                               places=9)

    def test_inverse_square(self):
        self.scene(viewer={"path_m": [[0, 0, 0], [0, 0, 25], [0, 0, 40]], "frames": 9},
                   lamps=[{"position_m": [0, 0, 80]}])
        rows = self.report()
        self.assertEqual([row["frame"] for row in rows], list(range(1, 10)))
        for i, row in enumerate(rows):  # At an even speed along both parts.
            self.assertLess(abs(row["distance_m"] / (80 - 5 * i) - 1), 1e-9)
            self.assertLess(abs(row["illuminance_lux"] * (80 - 5 * i)**2 / 10000 - 1), 1e-9)

    def test_line_of_sight(self):
        self.scene(viewer={"line_of_sight": [1, 0, 1]})
        row, = self.report()
        self.assertAlmostEqual(row["off_axis_deg"], 45, places=9)
        self.assertAlmostEqual(row["illuminance_lux"], 4 * math.sqrt(0.5), places=9)

    def test_glare(self):
        self.scene(viewer={"age_years": 70, "pigment": 1, "adaptation_luminance_cd_m2": 3},
                   lamps=[{"position_m": [0, 0.05 * 50, 50]}])
        row, = self.report("--report-angles", "0.5,3")

        def cie(angle):  # CIE 146:2002.
            return (10 / angle**3 + (5 / angle**2 + 0.1 / angle) * (1 + (70 / 62.5)**4) + 0.0025)
        lux = row["illuminance_lux"]
        for angle, name in ((0.5, "veil_cie_0.5deg_cd_m2"), (3, "veil_cie_3deg_cd_m2")):
            self.assertLess(abs(row[name] / (lux * cie(angle)) - 1), 1e-9)
        veil = lux * cie(math.degrees(math.atan(0.05)))
        self.assertLess(abs(row["veil_on_axis_cd_m2"] / veil - 1), 1e-9)
        self.assertLess(abs(row["threshold_increment_percent"] / (65 * veil / 3**0.8) - 1), 1e-9)
        self.assertEqual(row["veil_template_3deg_cd_m2"], "")  # The template reaches 1 degree.
        self.assertLess(abs(row["veil_template_0.5deg_cd_m2"] / (lux * self.ring(0.5)) - 1), 0.1)

    def ring(self, angle_deg):
        """The template's mean around a circle, from whole pixels: within some percent."""
        width, height = self.template.size
        luminance = self.template.luminance()
        radius = math.sin(math.radians(angle_deg)) / self.pitch()
        near = [luminance[y * width + x] for y in range(height) for x in range(width)
                if abs(math.hypot(x - width // 2, y - height // 2) - radius) < 0.5]
        return sum(near) / len(near) * self.template.attributes["glare:perSteradian"]

    def test_adaptation_is_the_backgrounds_mean(self):
        self.scene()
        row, = self.report()
        self.assertAlmostEqual(row["frame_adaptation_luminance_cd_m2"], 2, places=5)

    def test_json_tells_the_same(self):
        self.scene(lamps=[{"position_m": [1, 0, 50], "name": "one, of \"two\""},
                          {"position_m": [0, 0, -5], "name": "behind"}])
        rows = self.report("--report", "report.json", "--report-angles", "1")
        self.assertEqual(rows[0]["lamp"], "one, of \"two\"")
        told = json.loads(self.path("report.json").read_text(encoding="utf-8"))
        frame, = told["frames"]
        for row, lamp in zip(rows, frame["lamps"]):
            for key in ("illuminance_lux", "intensity_cd", "horizontal_deg", "distance_m"):
                self.assertEqual(row[key], lamp[key])
            self.assertEqual(row["veil_cie_1deg_cd_m2"], lamp["veils"][0]["cie_cd_m2"])
        self.assertEqual(rows[1]["illuminance_lux"], 0)
        self.assertEqual((rows[1]["column_px"], frame["lamps"][1]["column_px"]), ("", None))


class Poses(HeadlampTest):
    def setUp(self):
        super().setUp()
        # 1000 cd straight on, 10 cd more for each degree to the right and 20 for each up.
        self.write("beam.pfm", images.pfm([[1000 + 10 * h + 20 * v for h in range(-50, 51)]
                                           for v in range(15, -16, -1)]))
        self.beam = {"intensity": "beam.pfm", "h_deg": [-50, 50], "v_deg": [-15, 15]}

    def beam_scene(self, lamp, **tables):
        lamps = [{"template": "t.exr"} | self.beam | lamp]
        plain = {"luminance_cd_m2": 2, "size_px": [65, 49], "horizontal_fov_deg": 2}
        self.write("scene.toml", toml(**{"background": plain, "lamps": lamps} | tables))

    def test_turning_a_lamp(self):
        self.beam_scene({"position_m": [0, 0, 50], "yaw_deg": 2, "pitch_deg": 1})
        rows = self.report("--angles", "-30:30:15")
        self.assertEqual([row["turn_deg"] for row in rows], [-30, -15, 0, 15, 30])
        for row in rows:
            # A lamp that looks to its right has the eye on its left.
            yaw = math.radians(row["turn_deg"] + 2)
            pitch = math.radians(1)
            right, forward = -math.sin(yaw), math.cos(yaw)
            h = math.degrees(math.atan2(right, forward * math.cos(pitch)))
            v = math.degrees(math.asin(-forward * math.sin(pitch)))
            self.assertAlmostEqual(row["horizontal_deg"], h, places=6)
            self.assertAlmostEqual(row["vertical_deg"], v, places=6)
            self.assertAlmostEqual(row["intensity_cd"], 1000 + 10 * h + 20 * v, places=3)

    def test_turning_a_vehicle(self):
        self.beam_scene({"vehicle": "car", "position_m": [0.7, 0.6, 1.5]},
                        vehicles=[{"name": "car", "position_m": [-2, -1, 30], "yaw_deg": 5}])
        for row, turn in zip(self.report("--angles", "0,20"), (5, 25)):
            s, c = math.sin(math.radians(turn)), math.cos(math.radians(turn))
            # Its right is the viewer's left; turned to its right, its front goes there too.
            x, y, z = -2 - (0.7 * c + 1.5 * s), -0.4, 30 - (1.5 * c - 0.7 * s)
            self.assertAlmostEqual(row["distance_m"], math.sqrt(x * x + y * y + z * z), places=9)
            h = math.degrees(math.atan2(x, z)) - turn
            self.assertAlmostEqual(row["horizontal_deg"], h, places=9)

    def test_position_in_pixels(self):
        self.beam_scene({"position_px": [10, 40], "distance_m": 20})
        row, = self.report()
        self.assertAlmostEqual(row["column_px"], 10, places=9)
        self.assertAlmostEqual(row["row_px"], 40, places=9)
        self.assertAlmostEqual(row["distance_m"], 20, places=9)
        self.assertLess(row["horizontal_deg"], 0)  # On the viewer's left: the car's right.
        self.assertGreater(row["vertical_deg"], 0)

    def test_lists_of_angles(self):
        self.beam_scene({"position_m": [0, 0, 50]})
        rows = self.report("--angles=-19.5,-10.7,-2.1,6.8,15.5")
        self.assertEqual([row["turn_deg"] for row in rows], [-19.5, -10.7, -2.1, 6.8, 15.5])
        self.assertEqual(len(self.report("--angles", "0:1:0.1")), 11)
        for bad in ("1:0:1", "0:1:0", "0:1", "a", "0:1:1e-9", "1,", "400", "nan", "0:inf:1"):
            self.assert_refused(2, ["--angles"], "headlamp", "scene.toml", "--report", "r.csv",
                                f"--angles={bad}")


class Frame(HeadlampTest):
    def test_added_luminance(self):
        self.aligned_scene()
        picture = self.picture()
        self.assertEqual(picture.attributes["glare:unit"], "cd/m2")
        self.assertIn("glare:horizontalFov_deg", picture.attributes)
        added = self.added(picture)
        for column, row in ((0, 0), (1, 0), (0, -2), (3, 5)):
            self.assert_close(added(32 + column, 24 + row), self.veil(column, row, 4), ADDED)

    def test_lamps_add_up_at_their_places(self):
        self.aligned_scene([{"position_px": [12, 30], "distance_m": 100},
                            {"position_px": [44, 20], "distance_m": 50}])
        added = self.added(self.picture())
        lux = [row["illuminance_lux"] for row in self.report()]
        expected = [a + b for a, b in zip(self.veil(0, 0, lux[0]), self.veil(-32, 10, lux[1]))]
        self.assert_close(added(12, 30), expected, ADDED)

    def test_angular_size(self):
        t = self.template
        for fov in (4, 6):  # The whole template is inside.
            plain = {"luminance_cd_m2": 0, "size_px": [121, 121], "horizontal_fov_deg": fov}
            self.scene(background=plain)
            picture = self.picture()
            pitch = 2 * math.tan(math.radians(fov / 2)) / 121
            light = sum(picture.luminance()) * pitch**2
            # Perspective's pixels are 0.1 % smaller at the rim than on the axis.
            self.assertLess(abs(light / (4 * t.attributes["glare:capturedEnergy"]) - 1), ADDED)

    def test_backgrounds(self):
        values = [0.25 * (i % 7) for i in range(65 * 49)]
        self.write("bg.exr", exr.encode({c: values for c in "RGB"}, 65, 49))
        self.write("white.png", images.png([[255] * 65] * 49))
        dark = [{"position_m": [0, 0, 50], "intensity_cd": 0}]
        for file, scale, expected in (("bg.exr", None, values),
                                      ("bg.exr", 3, [3 * v for v in values]),
                                      ("white.png", None, [100] * len(values)),
                                      ("white.png", 80, [80] * len(values))):
            background = {"file": file, "horizontal_fov_deg": 2}
            if scale:
                background["luminance_scale_cd_m2"] = scale
            self.scene(lamps=dark, background=background)
            picture = self.picture()
            for channel in "RGB":
                self.assert_close(picture.channels[channel], expected, FLOAT)

    def test_sequence_of_backgrounds(self):
        for number in (7, 8, 9):
            channels = {c: [number] * 65 * 49 for c in "RGB"}
            self.write(f"bg_{number:04}.exr", exr.encode(channels, 65, 49))
        dark = [{"position_m": [0, 0, 50], "intensity_cd": 0}]
        background = {"file": "bg_{frame}.exr", "first_frame": 7, "last_frame": 9,
                      "horizontal_fov_deg": 2}
        self.scene(lamps=dark, background=background)
        self.run_headlamp("-o", "f_{frame}.exr")
        for i in (1, 2, 3):
            self.assertEqual(exr.read(self.path(f"f_{i:04}.exr")).channels["G"][100], 6 + i)
        self.assert_refused(3, ["scene.toml", "last_frame"], "headlamp", "scene.toml", "-o",
                            "g_{frame}.exr", "--angles", "0:3:1")

    def test_files_are_relative_to_the_scene(self):
        self.path("sub").mkdir()
        for name in ("t.exr", "pupil.png"):
            self.path(name).rename(self.path("sub/" + name))
        self.write("sub/flat.csv", "".join(f"{nm},1\n" for nm in range(380, 790, 10)))
        self.write("sub/bg.png", images.png([[200] * 65] * 49))
        self.write("sub/beam.pfm", images.pfm([[1000] * 3] * 3))
        beam = {"intensity": "beam.pfm", "h_deg": [-10, 10], "v_deg": [-10, 10]}
        lamp = {"position_m": [0, 0, 50]} | beam
        self.write("sub/s.toml", toml(
            background={"file": "bg.png", "horizontal_fov_deg": 2},
            lamps=[lamp | {"template": "t.exr"}, lamp | {"spectrum": "flat.csv"}],
            eye={"pupil": "pupil.png", "width_mm": 0.5},
            template={"size_px": [64, 64], "fov_deg": 2}))
        rows = self.report("-o", "a.exr", scene="sub/s.toml")
        self.assertEqual([row["intensity_cd"] for row in rows], [1000, 1000])

    def test_pictures_of_xyz(self):
        """A background of CIE XYZ stays one, and gets the same light."""
        self.write("bg.exr", exr.encode({c: [0.5] * 65 * 49 for c in "XYZ"}, 65, 49))
        self.scene(background={"file": "bg.exr", "horizontal_fov_deg": 2})
        xyz = self.picture()
        self.scene(background={"luminance_cd_m2": 0.5, "size_px": [65, 49],
                               "horizontal_fov_deg": 2})
        rgb = self.picture()
        # Luminances of the template's pixels, from float channels: rounding of their matrix.
        self.assert_close(xyz.luminance(), rgb.luminance(), 1e-5)

    def test_display(self):
        """The curve and the view are those of glare tonemap."""
        self.write("config.ocio", CONFIG)
        for tone, options in (({"gamma": 0.9, "exposure_stops": 2},
                               ("--gamma", "0.9", "--exposure-stops", "2",
                                "--adaptation-luminance", "2")),
                              ({"adaptation_luminance": 3, "per_channel": True, "k": 20,
                                "transfer": "none"},
                               ("--adaptation-luminance", "3", "--per-channel", "--k", "20",
                                "--transfer", "none")),
                              ({"curve": "linear", "exposure_stops": -2.5},
                               ("--curve", "linear", "--exposure-stops", "-2.5")),
                              ({"ocio": "config.ocio", "view": "Half", "exposure_stops": -1},
                               ("--ocio", "config.ocio", "--view", "Half",
                                "--exposure-stops=-1"))):
            self.scene(tone_mapping=tone)
            self.run_headlamp("-o", "a.png")
            self.run_headlamp("-o", "linear.exr")
            result = self.glare("tonemap", "linear.exr", "-o", "b.png", *options)
            self.assertEqual((result.status, result.err), (0, ""))
            self.assertEqual(self.path("a.png").read_bytes(), self.path("b.png").read_bytes(), tone)

    def test_same_bytes_for_any_threads(self):
        self.scene(lamps=[{"position_m": [0, 0, 50]}, {"position_m": [0.3, 0, 50]}])
        for ending in ("exr", "png"):
            for threads in (1, 2):
                self.run_headlamp("-o", f"{threads}." + ending, "--threads", threads)
            self.assertEqual(self.path("1." + ending).read_bytes(),
                             self.path("2." + ending).read_bytes())


if __name__ == "__main__":
    unittest.main()
