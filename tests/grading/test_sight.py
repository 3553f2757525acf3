"""What a cage may see is worked out from what packages say of themselves, read in part."""

import re
from importlib import metadata

from dhlab.grading.cage import sight


def test_packages_are_read_as_importlib_reads_them():
    for name, path in sight._installed().items():
        one = metadata.Distribution.at(path)
        assert sorted(sight._requires(one)) == sorted(one.requires or ()), name
        record = one.read_text("RECORD")
        if record is not None:
            tops = set(re.findall(r'^"?([^/,"\n]+)', record, re.MULTILINE))
            assert sight._tops(one, path) == tops, name
