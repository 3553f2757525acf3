"""One arm in the ways of many programming languages: records, rows, lists and constants. What is
written is made of the arm's numbers, so that the truth needs no reader.
"""

import numpy as np
import pytest

from dhlab import recognise_table
from dhlab.arm import Arm
from dhlab.table import DHTable

ROWS = ((0.0, 0.42, 0.06, -90), (-90, 0.0, 0.31, 0), (0.0, 0.03, 0.045, -90), (0.0, 0.38, 0.0, 90))
RIGHT = Arm(
    DHTable.standard([(np.deg2rad(t), d, a, np.deg2rad(al)) for t, d, a, al in ROWS], angle="rad")
)
SAID = "standard DH, a row for each joint: theta offset, d, a, alpha"

# language: what begins a comment, -90 degrees in it
LANGUAGES = {
    "Rust": ("//", "-FRAC_PI_2"),
    "Rust, with a method": ("//", "(-90.0_f64).to_radians()"),
    "Go": ("//", "-math.Pi / 2"),
    "Java": ("//", "Math.toRadians(-90)"),
    "Kotlin": ("//", "-PI / 2"),
    "Swift": ("//", "-.pi / 2"),
    "C++": ("//", "-M_PI_2"),
    "C++, with a literal": ("//", "-90.0_deg"),
    "C#": ("//", "-90 * Mathf.Deg2Rad"),
    "JavaScript": ("//", "-Math.PI / 2"),
    "Lua": ("--", "math.rad(-90)"),
    "PHP": ("//", "deg2rad(-90)"),
    "Ruby": ("#", "-Math::PI / 2"),
    "R": ("#", "-pi/2"),
    "Fortran": ("!", "-pi/2.0d0"),
    "Lisp": (";", "-1.5707963268"),
    "Elixir": ("#", "-:math.pi() / 2"),
    "Mathematica": ("//", "-Pi/2"),
    "Scilab": ("//", "-%pi/2"),
}
# (language, what is around the rows, a row)
BY_ROWS = (
    ("Rust", "let links = vec![\n@\n];", "    Link {{ theta: {t}, d: {d}, a: {a}, alpha: {al} }},"),
    ("Rust", "let links = vec![\n@\n];", "    Link::new({t}, {d}, {a}, {al}),"),
    ("Rust, with a method", "const DH: [[f64; 4]; 4] = [\n@\n];", "    [{t}, {d}, {a}, {al}],"),
    ("Go", "var dh = [][4]float64{\n@\n}", "\t{{{t}, {d}, {a}, {al}}},"),
    ("Java", "@", "arm.add(new Link().setTheta({t}).setD({d}).setA({a}).setAlpha({al}));"),
    ("Java", "List<double[]> dh = List.of(\n@\n);", "    new double[]{{{t}, {d}, {a}, {al}}},"),
    ("Kotlin", "val dh = arrayOf(\n@\n)", "    doubleArrayOf({t}, {d}, {a}, {al}),"),
    ("Swift", "let dh: [[Double]] = [\n@\n]", "    [{t}, {d}, {a}, {al}],"),
    ("C++", "@", "links_.emplace_back({t}, {d}, {a}, {al});"),
    ("C++, with a literal", "@", "dh.push_back(Row{{{t}, {d}, {a}, {al}}});"),
    ("C#", "links = new[] {\n@\n};", "    new Vector4({t}, {d}f, {a}f, {al}),"),
    ("JavaScript", "const dh = [\n@\n];", "  {{ theta: {t}, d: {d}, a: {a}, alpha: {al} }},"),
    ("Lua", "local dh = {\n@\n}", "  {{ {t}, {d}, {a}, {al} }},"),
    ("PHP", "$dh = [\n@\n];", "  ['theta' => {t}, 'd' => {d}, 'a' => {a}, 'alpha' => {al}],"),
    ("R", "dh <- rbind(\n@\n)", "  c({t}, {d}, {a}, {al}),"),
    ("Lisp", "(setq dh (list\n@))", "  (make-link :theta {t} :d {d} :a {a} :alpha {al})"),
    ("Lisp", "(defparameter *dh* '(\n@))", "  ({t} {d} {a} {al})"),
    ("Elixir", "dh = [\n@\n]", "  %{{theta: {t}, d: {d}, a: {a}, alpha: {al}}},"),
    ("Mathematica", "dh = {\n@};", '<|"theta" -> {t}, "d" -> {d}, "a" -> {a}, "alpha" -> {al}|>,'),
)  # fmt: skip
BY_LISTS = (
    ("Java", "private final List<Double> {n} = Arrays.asList({v});"),
    ("Kotlin", "val {n} = doubleArrayOf({v})"),
    ("Swift", "let {n}: [Double] = [{v}]"),
    ("R", "{n} <- c({v})"),
    ("Fortran", "real(8), parameter :: {n}(4) = (/ {v} /)"),
    ("C++", "const float {n}[] PROGMEM = {{{v}}};"),
    ("Elixir", "@{n} [{v}]"),
    ("Scilab", "{n} = [{v}];"),
)
BY_NAMES = (
    ("Rust", "const {N}{i}: f64 = {v};"),
    ("Go", "{n}{i} := {v}"),
    ("C++", "constexpr double k{C}{i} = {v};"),
    ("Java", "link{i}.set{C}({v});"),
    ("Ruby", "params['{n}{i}'] = {v}"),
    ("Swift", "arm.links[{j}].{n} = {v}"),
)


def written(value, quarter):
    return {0: "0.0", -90: quarter, 90: quarter.replace("-", "", 1)}[value]


def by_rows(language, around, row):
    mark, quarter = LANGUAGES[language]
    rows = (
        row.format(t=written(t, quarter), d=d, a=a, al=written(al, quarter)) for t, d, a, al in ROWS
    )
    return f"{mark} {SAID}\n" + around.replace("@", "\n".join(rows))


def by_names(language, line, listed):
    mark, quarter = LANGUAGES[language]
    said = [f"{mark} standard DH"]
    for name, column in zip(("theta", "d", "a", "alpha"), zip(*ROWS)):
        values = [written(v, quarter) if name in ("theta", "alpha") else str(v) for v in column]
        said += (
            [line.format(n=name, v=", ".join(values))]
            if listed
            else [
                line.format(n=name, N=name.upper(), C=name.capitalize(), i=i, j=i - 1, v=v)
                for i, v in enumerate(values, 1)
            ]
        )
    return "\n".join(said)


TEXTS = [
    *(by_rows(*one) for one in BY_ROWS),
    *(by_names(*one, listed=True) for one in BY_LISTS),
    *(by_names(*one, listed=False) for one in BY_NAMES),
]


@pytest.mark.parametrize("text", TEXTS)
def test_a_table_is_read_in_any_language(text):
    found = recognise_table(text)
    q = np.random.default_rng(3).uniform(-1.5, 1.5, (3, 4))
    assert len(found.readings) == 1, found
    np.testing.assert_allclose(found.arm.forward(q), RIGHT.forward(q), atol=1e-6)


OF_ONE = (
    "def mm(x):\n    k = 1000\n    return x / k\n",
    "mm = lambda x: x / 1000\n",
    "const mm = (x) => x * 1e-3;\n",
    "double mm(double x) { return x / 1000.0; }\n",
    "mm = @(x) x / 1000;\n",
)


@pytest.mark.parametrize("function", OF_ONE)
def test_a_function_of_the_text_is_taken_for_what_it_computes(function):
    text = f"{function}DH = [[0, mm(420), 0, pi/2],\n [0, 0, mm(310), 0]]\n"
    order = "theta d a alpha"
    found = recognise_table(text, order=order, convention="standard", length="m")
    np.testing.assert_allclose(found.arm.table.d, [0.42, 0], atol=1e-12)
    np.testing.assert_allclose(found.arm.table.a, [0, 0.31], atol=1e-12)
