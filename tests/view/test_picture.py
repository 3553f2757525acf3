"""What every picture can do: be shown, read aloud, saved; and be told apart in black and white."""

import base64
import re

import numpy as np
import pytest
from matplotlib.colors import to_rgb

import dhlab as dh
from dhlab import transform, view
from dhlab.view.drawing.style import AXES, INK, JOINT, LINK, POSES, QUIET
from dhlab.view.picture import IN_THE_DARK

COLORS = (INK, QUIET, LINK, JOINT)  # what is written, and what is drawn of metal


@pytest.fixture(scope="module")
def picture():
    return view.frames(
        [np.eye(4), transform.trans([0.4, 0.1, 0.2]) @ transform.rot_x(0.5)], title="a < b & c"
    )


def luminance(color):
    """Relative luminance as WCAG 2.1 defines it."""
    rgb = np.array(to_rgb(color))
    return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4) @ [
        0.2126,
        0.7152,
        0.0722,
    ]


@pytest.mark.parametrize("color", [style.color for style in AXES] + [color for color, _ in POSES])
def test_contrast_with_paper(color):
    assert 1.05 / (luminance(color) + 0.05) >= 4.5


def turned(color):
    """A colour (3,) as CSS shows it under ``invert(.91) hue-rotate(180deg)``, by the matrices of
    the W3C's Filter Effects.
    """
    rgb = 0.91 - 0.82 * np.array(to_rgb(color))
    grey = np.array([0.213, 0.715, 0.072])
    return np.clip(2 * grey @ rgb - rgb, 0, 1)


@pytest.mark.parametrize("color", [*COLORS, *[style.color for style in AXES], *dict(POSES)])
def test_contrast_is_no_less_on_a_dark_page(color):
    ground = luminance(turned("white")) + 0.05
    assert (luminance(turned(color)) + 0.05) / ground >= min(4.5, 1.05 / (luminance(color) + 0.05))


def test_a_picture_follows_the_theme_of_the_page(new_page, picture):
    page = new_page()
    for body, scheme, dark in (
        ('data-jp-theme-light="false"', "light", True),
        ('data-jp-theme-light="true"', "dark", False),
        ('data-theme="dark"', "light", True),
        ('data-theme="light"', "dark", False),
        ('data-theme="auto"', "dark", True),
        ('class="vscode-light"', "dark", False),
        ("", "dark", True),
        ("", "light", False),
    ):
        page.emulate_media(color_scheme=scheme)
        page.set_content(f"<body {body}>{picture._repr_mimebundle_()['text/html']}</body>")
        shown = page.locator("img").evaluate("image => getComputedStyle(image).filter")
        wanted = "invert(0.91) hue-rotate(180deg)" if dark else "none"
        assert shown == wanted, (body, scheme)


def test_axes_differ_without_colour():
    assert len({(style.width, str(style.dash)) for style in AXES}) == 3
    assert AXES[0].dash != AXES[1].dash and AXES[2].width > 1.5 * AXES[0].width


def test_notebook_sees_image_words_and_table(picture):
    bundle = picture._repr_mimebundle_()
    html = bundle["text/html"]
    assert html.startswith('<figure class="dhlab-picture"><img alt="2 frames in space.')
    assert "<summary>The frames as a table</summary><table" in html and html.endswith(
        f"</details>{IN_THE_DARK}</figure>"
    )
    data = base64.b64decode(re.search(r"data:image/png;base64,([^\"]+)", html)[1])
    assert data.startswith(b"\x89PNG") and b"Software" not in data
    assert bundle["text/plain"] == picture.alt + "\n" + picture.table


def test_html_is_escaped():
    named = view.frames(np.eye(4), ['<b> & "c"'])
    html = named._repr_mimebundle_()["text/html"]
    assert "<b>" not in html and "&lt;b&gt; &amp; &quot;c&quot;" in html


@pytest.mark.parametrize("name", ["{0}", "$x^", "a_b", "100 %", "x\\y", ""])
def test_any_name_can_be_drawn(name):
    view.frames(np.eye(4), [name], title=name)._repr_mimebundle_()


@pytest.mark.parametrize(
    "suffix, start", [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")]
)
def test_save(picture, tmp_path, suffix, start):
    path = tmp_path / f"one{suffix}"
    picture.save(path)
    first = path.read_bytes()
    assert first.startswith(start)
    with pytest.raises(ValueError, match="found one that exists"):
        picture.save(path)
    picture.save(path, overwrite=True)
    assert path.read_bytes() == first  # nothing in it varies
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


@pytest.mark.slow
def test_same_arguments_give_the_same_bytes():
    arm = dh.load("article-6r")
    assert view.arm(arm)._repr_mimebundle_() == view.arm(arm)._repr_mimebundle_()


def test_save_says_what_is_wrong(picture, tmp_path):
    with pytest.raises(ValueError, match="ends in .png, .svg or .pdf"):
        picture.save(tmp_path / "one.jpg")
    with pytest.raises(ValueError, match="cannot be done"):
        picture.save(tmp_path / "none" / "one.png")


def test_users_settings_do_not_matter(picture):
    import matplotlib

    before = picture._repr_mimebundle_()
    with matplotlib.rc_context(
        {
            "axes.facecolor": "black",
            "text.color": "white",
            "lines.linewidth": 9,
            "font.family": "serif",
            "savefig.dpi": 30,
        }
    ):
        again = view.frames(
            [np.eye(4), transform.trans([0.4, 0.1, 0.2]) @ transform.rot_x(0.5)], title="a < b & c"
        )
        assert again._repr_mimebundle_() == before


def test_frames_share_labels_where_they_coincide():
    picture = view.frames(
        [
            np.eye(4),
            transform.trans([0.3, 0, 0]),
            transform.trans([0.3, 0, 0]) @ transform.rot_x(np.pi / 2),
        ]
    )
    texts = [text.get_text() for text in picture.figure.axes[0].texts]
    assert "{1}, {2}" in texts and any("x_{1}" in text and "x_{2}" in text for text in texts)
    assert any("y_{1}" in text and "z_{2}" not in text for text in texts)
    assert "{1} and {2} share one origin" in picture.alt


def test_a_letter_shared_by_two_axes_has_the_colour_of_neither():
    picture = view.frames([np.eye(4), transform.rot_z(np.pi / 2)], ["wanted", "reached"])
    shades = {text.get_text(): text.get_color() for text in picture.figure.axes[0].texts}
    (mixed,) = [text for text in shades if "y" in text and "x" in text]
    (both_z,) = [text for text in shades if text.count("z_") == 2]
    assert shades[mixed] == INK and shades[both_z] == AXES[2].color


def test_far_from_the_world_origin():
    picture = view.frames([transform.trans([100, 50, 20]), transform.trans([100.2, 50, 20.1])])
    axes = picture.figure.axes[0]
    assert axes.get_xlim()[1] - axes.get_xlim()[0] < 1


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: view.frames([]), "expected one pose"),
        (lambda: view.frames([[1, 2], [3]]), "expected one pose"),
        (lambda: view.frames(np.zeros((3, 3))), "expected one pose"),
        (lambda: view.frames(np.diag([1.0, 1, -1, 1])), "mirror"),
        (lambda: view.frames(np.eye(4), ["a", "b"]), "expected 1"),
        (lambda: view.frames(np.eye(4), [None]), "expected texts"),
    ],
)
def test_errors_are_sentences(call, words):
    with pytest.raises(ValueError, match=words):
        call()
