"""What is done to the pages once Sphinx has made them: landmarks, pictures in files of their own,
descriptions, and the whole site as one file.
"""

import base64
import hashlib
import io
import os
import re
import zipfile
from functools import cache
from html import escape, unescape
from pathlib import Path

from PIL import Image

__all__ = ["accessible", "finish"]

ARCHIVE = "dhlab-site.zip"
# what furo leaves to be named, so that somebody who listens to the page can tell its parts
LANDMARKS = [
    (r'<aside class="sidebar-drawer">', '<aside class="sidebar-drawer" aria-label="Site">'),
    (
        r'<aside class="toc-drawer( no-toc)?">',
        r'<aside class="toc-drawer\1" aria-label="This page">',
    ),
    (
        r'<div class="content-icon-container">',
        '<div class="content-icon-container" role="navigation" aria-label="View">',
    ),
    (r'(<a href="#" class="back-to-top.*?</a>)', r'<nav aria-label="Top">\1</nav>'),
    (r'<p class="caption" role="heading">', '<p class="caption" role="heading" aria-level="2">'),
    (r"<pre\b", '<pre tabindex="0"'),
    (r'<div class="table-wrapper', '<div tabindex="0" class="table-wrapper'),
    (r'<div id="search-results">', '<h1>Search</h1><div id="search-results">'),
    (r'<th class="head"><p></p></th>', '<td class="head"></td>'),  # a corner is no heading
    (r'<a href="([\w-]+)\.ipynb">', r'<a href="\1.html">'),  # the map on top of a lesson
]
STILL = re.compile(r'src="data:image/png;base64,([^"]+)" width="(\d+)"')
NARROW = re.compile(r'srcset="data:image/png;base64,([^"]+)" width="(\d+)" height="\d+"')
DESIGN = re.compile(
    r"<link [^>]*sphinx-design\.min\.css[^>]*>|<script [^>]*design-tabs\.js.*?</script>"
)
SHOT = re.compile(r'src="[./]*_images/([\w-]+\.png)"')
COLOURS, NEARLY_WHITE = 128, 252
BOXES = re.compile(r'<div class="admonition.*?</div>', re.DOTALL)
LONGEST = 200  # letters of a description
HEAD = (
    '<meta name="description" content="{words}"><meta property="og:title" content="{title}">'
    '<meta property="og:description" content="{words}"><meta property="og:type" content="article">'
    '<meta property="og:image" content="{home}_static/card.png">'
    '<meta name="twitter:card" content="summary_large_image">'
)


def finish(html):
    """Every page in the folder ``html``, and the archive.

    A picture for who is sent a link (``og:image``) needs a whole address: ``DHLAB_SITE`` in the
    environment says where the site will stand, such as ``https://example.org/dhlab/``. Without it
    the address is relative, and most programs show no picture.
    """
    host = os.environ.get("DHLAB_SITE", "")
    if host and not host.startswith(("http://", "https://")):
        raise SystemExit(
            f"DHLAB_SITE: expected an address such as https://example.org/dhlab/, found {host!r}"
        )
    for path in sorted(html.rglob("*.html")):
        root = "../" * (len(path.relative_to(html).parts) - 1)
        text = accessible(_lightened(path.read_text(encoding="utf-8")))
        home = f"{host.rstrip('/')}/" if host else root
        text = _described(_with_stills(text, html, root), home)
        path.write_text(text, encoding="utf-8", newline="\n")
    _archive(html)


def _lightened(text):
    """A page that does not load what sphinx-design has for cards and tabs, where it has none."""
    return text if re.search(r'class="[^"]*\bsd-', text) else DESIGN.sub("", text)


def accessible(html):
    """A page with furo's landmarks named, what scrolls within reach of the keyboard, a heading on
    the search page, and lessons that lead to each other's pages.
    """
    for found, wanted in LANDMARKS:
        html = re.sub(found, wanted, html, flags=re.DOTALL)
    return html


def _with_stills(text, html, root):
    """A page whose pictures are files, fetched when they come into sight, no larger than the
    screen that shows them has use for.
    """

    def still(found):
        return _sources(base64.b64decode(found[1]), int(found[2]), html, root)

    def narrow(found):
        return re.sub(r'^src="(\S+)"(?: srcset="(.*?)")?|loading.*', _as_set, still(found)).strip()

    def shot(found):
        return _sources((html / "_images" / found[1]).read_bytes(), None, html, root)

    return SHOT.sub(shot, STILL.sub(still, NARROW.sub(narrow, text)))


def _as_set(found):
    """What a ``<source>`` has of the attributes of an ``<img>``."""
    return f'srcset="{", ".join(filter(None, found.groups()))}"' if found[1] else ""


def _sources(picture, width, html, root):
    """The attributes of a picture shown ``width`` pixels wide, or in its own width: a file for
    screens of one point to the pixel, and the whole one for finer ones.
    """
    (across, up), (whole, *plain) = _files(picture, width)
    for name, content in (whole, *plain):
        (html / name).parent.mkdir(exist_ok=True)
        (html / name).write_bytes(content)
    width = width or across
    size = f'width="{width}" height="{round(width * up / across)}" loading="lazy" decoding="async"'
    if not plain:
        return f'src="{root}{whole[0]}" {size}'
    return f'src="{root}{plain[0][0]}" srcset="{root}{whole[0]} {across / width:.3g}x" {size}'


@cache  # the class edition shows the same pictures
def _files(picture, width):
    """The size of a picture, and its files: the whole one, and a smaller one where it is shown
    smaller.
    """
    image = Image.open(io.BytesIO(picture)).convert("RGB")
    files = [_file(image)]
    if width and width < image.width:
        shown = width, round(width * image.height / image.width)
        files.append(_file(image.resize(shown, Image.Resampling.LANCZOS)))
    return image.size, files


def _file(image):
    """A picture's name, by its content, and its bytes; in few colours, white among them."""
    few = image.quantize(COLOURS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    image = few.convert("RGB").point(lambda value: 255 if value >= NEARLY_WHITE else value)
    content = io.BytesIO()
    image.save(content, format="WEBP", lossless=True, method=3, quality=50)  # smaller and sooner
    name = hashlib.sha256(image.tobytes()).hexdigest()[:16]
    return f"_images/{name}.webp", content.getvalue()


def _described(text, home):
    """A page with what it is about, for those who find it in a list or are sent its link; ``home``
    is where its picture lies.
    """
    title = re.search(r"<h1>(.*?)<a|<h1>(.*?)</h1>", text, re.DOTALL)
    body = BOXES.sub("", text[title.end() :]) if title else ""
    first = re.search(r"<p>(.*?)</p>", body, re.DOTALL)
    if first is None:
        return text
    words = " ".join(unescape(re.sub(r"<[^>]+>", "", first[1])).split())
    if len(words) > LONGEST:
        words = words[:LONGEST].rpartition(" ")[0] + " …"
    name = unescape(re.sub(r"<[^>]+>", "", title[1] or title[2]))
    head = HEAD.format(words=escape(words), title=escape(name), home=home)
    return text.replace("</head>", f"{head}</head>", 1)


def _archive(html):
    """The site in one file, to be read without a network; the same pages give the same bytes."""
    target = html / ARCHIVE
    target.unlink(missing_ok=True)
    files = sorted(path for path in html.rglob("*") if path.is_file() and "live" not in path.parts)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in files:
            name = Path("dhlab", path.relative_to(html)).as_posix()
            archive.writestr(zipfile.ZipInfo(name), path.read_bytes(), zipfile.ZIP_DEFLATED)
