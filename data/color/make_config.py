#!/usr/bin/env python3
"""Prints glare.ocio, the OpenColorIO config of the built-in colour spaces:

    python3 make_config.py > glare.ocio

Every matrix is worked out in exact fractions from the primaries and whites below, and rounded once,
to the nearest double.
"""

from fractions import Fraction


def chromaticities(text):
    return [Fraction(number) for number in text.split()]


def xyz_from_chromaticity(x, y):
    """The colour of this chromaticity with luminance 1."""
    return [x / y, Fraction(1), (1 - x - y) / y]


# SMPTE ST 2065-1 and Academy S-2014-004 give this white for both ACES spaces.
ACES_WHITE = xyz_from_chromaticity(*chromaticities("0.32168 0.33767"))
# ITU-R BT.709-6, item 1.4; ITU-R BT.2020-2, table 3; SMPTE EG 432-1.
D65 = xyz_from_chromaticity(*chromaticities("0.3127 0.3290"))
# CIE illuminant C as in Kakimoto et al. 2010, whose printed matrix it reproduces to every decimal.
KAKIMOTO_WHITE = [Fraction(number) for number in ("0.9804", "1", "1.1812")]

AP0 = "0.7347 0.2653  0.0000 1.0000  0.0001 -0.0770"

# Name, primaries (x and y of red, green, blue), XYZ of white, and a description with the source.
SPACES = [
    ("lin_rec709", "0.64 0.33  0.30 0.60  0.15 0.06", D65,
     "Linear light, primaries and white of ITU-R BT.709-6 and of sRGB (IEC 61966-2-1)."),
    ("lin_rec2020", "0.708 0.292  0.170 0.797  0.131 0.046", D65,
     "Linear light, primaries and white of ITU-R BT.2020-2."),
    ("lin_p3d65", "0.680 0.320  0.265 0.690  0.150 0.060", D65,
     "Linear light, primaries of SMPTE RP 431-2 with a D65 white (SMPTE EG 432-1)."),
    ("acescg", "0.713 0.293  0.165 0.830  0.128 0.044", ACES_WHITE,
     "ACEScg, AP1 primaries (Academy S-2014-004); white isn't adapted."),
    ("aces2065-1", AP0, ACES_WHITE,
     "ACES2065-1, AP0 primaries (SMPTE ST 2065-1); white isn't adapted."),
    ("ntsc1953", "0.67 0.33  0.21 0.71  0.14 0.08", KAKIMOTO_WHITE,
     "NTSC primaries of 1953 (FCC; ITU-R BT.470-6, system M), white of Kakimoto et al. 2010."),
]

# Bradford cone responses (Lam 1985; ICC.1:2010, annex E).
BRADFORD = [[Fraction(number) for number in row.split()] for row in (
    "0.8951 0.2664 -0.1614", "-0.7502 1.7135 0.0367", "0.0389 -0.0685 1.0296")]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def times_vector(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def diagonal(d):
    return [[d[i] if i == j else Fraction(0) for j in range(3)] for i in range(3)]


def inverse(m):
    def cofactor(i, j):
        a, b, c, d = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
        return m[a][c] * m[b][d] - m[a][d] * m[b][c]

    determinant = sum(m[0][j] * cofactor(0, j) for j in range(3))
    return [[cofactor(j, i) / determinant for j in range(3)] for i in range(3)]


def xyz_from_rgb(primaries, white):
    """SMPTE RP 177-1993: RGB (1, 1, 1) is `white`."""
    c = chromaticities(primaries)
    xyz = [[c[2 * k], c[2 * k + 1], 1 - c[2 * k] - c[2 * k + 1]] for k in range(3)]
    columns = [[xyz[k][row] for k in range(3)] for row in range(3)]
    return product(columns, diagonal(times_vector(inverse(columns), white)))


def bradford_adaptation(from_white, to_white):
    scale = [t / f for t, f in zip(times_vector(BRADFORD, to_white),
                                   times_vector(BRADFORD, from_white))]
    return product(inverse(BRADFORD), product(diagonal(scale), BRADFORD))


HEADER = """\
# Made by make_config.py: change that, not this.
ocio_profile_version: 2

name: glare
description: |
  The colour spaces that are built into Glare (category built_in). The reference space is CIE XYZ,
  and white isn't adapted: RGB = inverse(primaries, white) * XYZ.
environment: {}
search_path: ""
strictparsing: true

roles:
  aces_interchange: aces2065-1_bradford_d65
  cie_xyz_d65_interchange: xyz
  default: lin_rec709
  scene_linear: lin_rec709

displays:
  none:
    - !<View> {name: Raw, colorspace: xyz}

colorspaces:
"""


def print_space(name, description, matrix=None, built_in=True):
    print("\n  - !<ColorSpace>")
    print(f"    name: {name}")
    print("    description: |")
    print(f"      {description}")
    print("    encoding: scene-linear")
    if built_in:
        print("    categories: [built_in]")
    if matrix:
        rows = ["{!r}, {!r}, {!r}, 0".format(*map(float, row)) for row in matrix] + ["0, 0, 0, 1"]
        print("    to_scene_reference: !<MatrixTransform>")
        print("      matrix: [" + (",\n" + " " * 15).join(rows) + "]")


def main():
    print(HEADER, end="")
    print_space("xyz", "CIE XYZ, not adapted to any white.")
    for name, primaries, white, description in SPACES:
        print_space(name, description, xyz_from_rgb(primaries, white))
    print_space("aces2065-1_bradford_d65",
                "ACES2065-1 with white adapted to D65 (UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD): "
                "what the\n      aces_interchange role means in other configs.",
                product(bradford_adaptation(ACES_WHITE, D65), xyz_from_rgb(AP0, ACES_WHITE)),
                built_in=False)


if __name__ == "__main__":
    main()
