"""The examples run and draw what the documentation shows."""
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"
PLOTS = ("airy", "chromaticity", "encircled_energy", "eye_and_cie", "lamps")


def test_physics_plots(tmp_path):
    pytest.importorskip("matplotlib")
    subprocess.run([sys.executable, "-B", EXAMPLES / "physics_plots.py", tmp_path, "--quick"],
                   check=True, stdin=subprocess.DEVNULL)
    assert sorted(path.stem for path in tmp_path.glob("*.png")) == list(PLOTS)
    import matplotlib.image
    for name in PLOTS:
        picture = matplotlib.image.imread(tmp_path / f"{name}.png")
        assert picture.shape[0] > 250 and picture.std() > 0.05, name  # Neither small nor blank.
