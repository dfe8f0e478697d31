"""The Python of the documentation runs."""
import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"


def test_python_page(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.M | re.S)
    assert len(blocks) == 3
    names = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)
    assert "hid" in capsys.readouterr().out
    assert names["veil"].pixel_pitch_deg == 4 / 256 and len(names["stars"]) == 3
    assert names["seen"].shape == names["image"].shape and (tmp_path / "hid.exr").exists()
