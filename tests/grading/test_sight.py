"""What a cage may see is worked out from what packages say of themselves, read in part."""

import os
import re
from importlib import metadata

from dhlab.grading.cage import sight


def test_packages_are_read_as_importlib_reads_them():
    for name, path in sight._installed().items():
        one = metadata.Distribution.at(path)
        assert sorted(sight._requires(path)) == sorted(one.requires or ()), name
        record = one.read_text("RECORD")
        if record is not None:
            tops = set(re.findall(r'^"?([^/,"\n]+)', record, re.MULTILINE))
            assert sight._tops(path) == tops, name


OTHERS = {  # where pip, Debian, conda, pipx, and a program with a Python of its own put packages
    "lib/python3.9/site-packages": "",
    "lib/python3/dist-packages": "",
    "local/lib/python3.12/dist-packages": "",
    "pkgs/kinematics-1.0-pyhd8ed1ab_0/site-packages": "pkgs",
    "pkgs/numpy-2.0-py312/lib/python3.12/site-packages": "pkgs",
    "envs/robots/lib/python3.12/site-packages": "",
    "pipx/venvs/tool/lib/python3.11/site-packages": "",
    "lib/sdk/platform/python/lib/python3.12/site-packages": "",
    "Lib/site-packages": "",
    "src/kinematics": "",
}  # and what is covered instead, where they are many
NONE_OF_THEM = ("lib/python3.9/json", "share/doc/site-packages", "share/site-packages.txt")


def test_packages_of_other_pythons_are_found_wherever_they_stand(tmp_path, monkeypatch):
    top = tmp_path / "root"
    own = top / "envs/mine/lib/python3.11/site-packages"
    for folder in (*OTHERS, *NONE_OF_THEM, own / "inner-packages"):
        (top / folder).mkdir(parents=True)
    (top / "share" / "again").symlink_to(top / "envs")
    (top / "round").symlink_to(top)
    monkeypatch.setattr(sight, "packages", lambda: [str(own)])
    monkeypatch.setattr(sight, "readable", lambda: [str(top), str(top / "lib"), str(top / "gone")])
    found = {os.path.relpath(path, top) for path in sight.packages_of_others.__wrapped__()}
    assert found == {covered or folder for folder, covered in OTHERS.items()}
