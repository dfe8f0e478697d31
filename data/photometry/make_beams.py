#!/usr/bin/env python3
"""Makes the headlamp beams of this folder: made up, shaped after UN Regulations 112 and 149.

    python3 make_beams.py [FOLDER]      writes FOLDER/*.ies; FOLDER is this one unless given

Each is an IES LM-63-2002 file of photometric type A: H right and V up positive, in degrees, as seen
from the lamp; candela. README.md has the formulae and the regulations' test points.
"""

import math
import pathlib
import sys
from dataclasses import dataclass, replace

CUT_OFF_DEG = -math.degrees(math.atan(0.01))  # One per cent below the horizontal: -0.573.


def steps(*parts):
    """Ascending angles on both sides of 0, from (end, step) to (end, step)."""
    angles, start = [0.0], 0.0
    for end, step in parts:
        count = round((end - start) / step)
        angles += [start + step * k for k in range(1, count + 1)]
        start = end
    return [-a for a in reversed(angles[1:])] + angles


def falloff(reach, power):
    """1 in the middle, smooth, with a tail like a measured beam's; `reach` is in widths."""
    return (1 + reach) ** -power


@dataclass(frozen=True)
class Part:
    """A smooth part of a beam about (h, v): candela in its middle, half widths in degrees."""
    candela: float
    h: float
    v: float
    width: float
    height_up: float
    height_down: float
    power: float

    def __call__(self, h, v):
        height = self.height_up if v > self.v else self.height_down
        reach = ((h - self.h) / self.width) ** 2 + ((v - self.v) / height) ** 2
        return self.candela * falloff(reach, self.power)


def scattered(candela, h, v):
    """What the lens and the housing scatter into the hemisphere: a tenth of it everywhere."""
    return candela * (0.1 + 0.9 * math.cos(math.radians(h)) * math.cos(math.radians(v)))


def towards_poles(v):
    """Lets the beam end at V = -90 and 90, where every H is the same direction."""
    return math.cos(math.radians(v)) ** 2


@dataclass(frozen=True)
class HighBeam:
    title: str
    lamp: str
    watts: float
    parts: tuple
    scatter: float

    HORIZONTAL = [h for h in steps((6, .25), (12, .5), (20, 1), (40, 2.5), (60, 5), (90, 10))
                  if h >= 0]  # Symmetric: the file has the right side.
    VERTICAL = steps((3, .25), (8, .5), (16, 1), (40, 4), (90, 10))

    def __call__(self, h, v):
        return (sum(part(h, v) for part in self.parts) * towards_poles(v)
                + scattered(self.scatter, h, v))


@dataclass(frozen=True)
class LowBeam:
    title: str
    lamp: str
    watts: float
    parts: tuple      # What there is below the cut-off.
    above: Part       # And above it.
    scatter: float
    slope_deg: float  # The cut-off rises beside the kink, by at most `rise` degrees.
    rise: float
    softness: float   # Of the cut-off, in degrees.
    left_traffic: bool = False

    HORIZONTAL = steps((5, .25), (10, .5), (20, 1), (40, 2.5), (60, 5), (90, 10))
    VERTICAL = steps((2, .1), (4, .25), (10, .5), (20, 1), (40, 4), (90, 10))

    def cut_off(self, h):
        """The V of the cut-off: horizontal to the left, rising to the right, then levelling off."""
        right = (h + math.hypot(h, 0.2)) / 2  # 0 to the left and h to the right, rounded.
        return CUT_OFF_DEG + self.rise * math.tanh(
            right * math.tan(math.radians(self.slope_deg)) / self.rise)

    def __call__(self, h, v):
        if self.left_traffic:
            h = -h
        below = sum(part(h, v) for part in self.parts)
        above = self.above(h, v)
        # From the one to the other in the logarithm, so that the steepest place is the cut-off.
        share = 1 / (1 + math.exp(min((v - self.cut_off(h)) / self.softness, 700)))
        return (above * (below / above) ** share * towards_poles(v)
                + scattered(self.scatter, h, v))


HALOGEN_LOW = LowBeam(
    "Halogen low beam, right-hand traffic", "tungsten halogen (H7)", 58,
    (Part(16500, 1.5, -1.0, 5, 1.5, 1.4, 1.8), Part(5600, 0, -1.6, 17, 3, 3, 2),
     Part(600, 0, -8, 26, 6, 6, 2)),
    Part(265, 0, 0.5, 9, 4.5, 4.5, 0.8), 30, slope_deg=15, rise=2.2, softness=0.155)
HID_LOW = LowBeam(
    "HID low beam, right-hand traffic", "gas discharge (D2S)", 42,
    (Part(22500, 1.8, -0.9, 5.2, 1.5, 1.4, 1.8), Part(9800, 0, -1.5, 21, 3, 3.2, 2),
     Part(1100, 0, -7, 32, 6, 6, 2)),
    Part(260, 0, 0.5, 10, 5, 5, 0.8), 35, slope_deg=45, rise=0.5, softness=0.13)
LED_LOW = LowBeam(
    "LED low beam, right-hand traffic", "white LEDs", 35,
    (Part(24000, 1.4, -0.9, 4.2, 1.5, 1.3, 1.8), Part(8800, 0, -1.4, 24, 3, 2.8, 2),
     Part(800, 0, -7, 36, 6, 5, 2)),
    Part(230, 0, 0.5, 10, 5, 5, 0.75), 25, slope_deg=15, rise=1.2, softness=0.13)

BEAMS = {
    "halogen_high": HighBeam(
        "Halogen high beam", "tungsten halogen (H7)", 58,
        (Part(67000, 0, 0, 3.4, 2, 2.1, 2), Part(6200, 0, -0.5, 15, 3.5, 4, 2),
         Part(300, 0, -4, 28, 7, 7, 2)), 30),
    "hid_high": HighBeam(
        "HID high beam", "gas discharge (D2S)", 42,
        (Part(84000, 0, 0, 3.8, 2, 2.2, 2), Part(11500, 0, -0.6, 18, 3.5, 4.5, 2),
         Part(600, 0, -5, 32, 7, 8, 2)), 40),
}
for _name, _beam in (("halogen", HALOGEN_LOW), ("hid", HID_LOW), ("led", LED_LOW)):
    BEAMS[_name + "_low_right_hand_traffic"] = _beam
    BEAMS[_name + "_low_left_hand_traffic"] = replace(
        _beam, title=_beam.title.replace("right-hand", "left-hand"), left_traffic=True)


def number(value):
    """Four significant digits, and at most two after the point."""
    digits = min(max(3 - math.floor(math.log10(value)), 0), 2)
    text = f"{value:.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def angle(value):
    return f"{value:.2f}".rstrip("0").rstrip(".") if value else "0"


def wrapped(words, width=100):
    lines, line = [], ""
    for word in words:
        if line and len(line) + 1 + len(word) > width:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}" if line else word
    return lines + [line]


def ies(beam):
    lines = ["IESNA:LM-63-2002", "[TEST] none: made up by data/photometry/make_beams.py",
             "[TESTLAB] none", "[ISSUEDATE] 2026-11-22", "[MANUFAC] none: Glare's example",
             f"[LUMINAIRE] {beam.title}", f"[LAMP] {beam.lamp}",
             "[OTHER] Shaped after UN Regulations 112 and 149, class B; no lamp was measured.",
             "TILT=NONE",
             f"1 -1 1 {len(beam.VERTICAL)} {len(beam.HORIZONTAL)} 3 2 0.15 0 0.1",
             f"1 1 {beam.watts}"]
    lines += wrapped(map(angle, beam.VERTICAL)) + wrapped(map(angle, beam.HORIZONTAL))
    for h in beam.HORIZONTAL:
        lines += wrapped([number(beam(h, v)) for v in beam.VERTICAL])
    return "\n".join(lines) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    for name, beam in BEAMS.items():
        (folder / f"{name}.ies").write_text(ies(beam), encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
