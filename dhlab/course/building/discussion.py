"""What to discuss in class: the question of each teacher's sheet, kept where every installation has
it; of the sheets' answers it holds none.
"""

import json
import re

from . import reading

__all__ = ["discussion"]

HEAD = "# What to discuss in class, by lesson; made from the sheets in solutions/teacher.\n"
ASKED = re.compile(r"^## To discuss\n+(.+?)(?=\n\n|\n## |\Z)", re.MULTILINE | re.DOTALL)


def discussion() -> str:
    """The questions by lesson, as YAML: the first paragraph below "To discuss" of each sheet."""
    found: dict[str, str] = {}
    for path in sorted((reading.SOLUTIONS / "teacher").glob("[0-9][0-9]*-*.md")):
        asked = ASKED.search(path.read_text(encoding="utf-8"))
        if asked:
            said = found.get(path.name[:2], "")  # by another sitting of the lesson
            found[path.name[:2]] = " ".join([said, *asked[1].split()]).strip()
    return HEAD + "".join(
        f'"{lesson}": {json.dumps(question, ensure_ascii=False)}\n'
        for lesson, question in found.items()
    )
