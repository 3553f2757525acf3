"""Links of a text's own classes that hold d, a and alpha and no theta, and joint angles that stand
in a list beside such rows.
"""

import numpy as np
import pytest

from dhlab.doctor import recognise_table
from tests.doctor.tables.test_forms import is_the_form

HALF = np.pi / 2
ARM = {
    "convention": "standard",
    "rows": [(0, 0.31, 0, HALF), (0, 0, 0.42, 0), (0, 0, 0.13, HALF)],
    "joints": "RRR",
    "sign": [1, 1, 1],
}
TEXTS = {
    "Python, __init__": """
        class Geometry:
            def __init__(self, a, d, alpha=0.0):
                self.a, self.d, self.alpha = a, d, alpha
        waist = Geometry(0, 0.31, pi/2)
        upper = Geometry(0.42, 0, 0)
        fore = Geometry(0.13, 0, pi/2)
        """,
    "Python, dataclass": """
        @dataclass
        class Geometry:
            alpha: float  # twist, rad
            d: float  # offset
            a: float  # length
        arm = [Geometry(pi/2, 0.31, 0), Geometry(0, 0, 0.42), Geometry(pi/2, 0, 0.13)]
        """,
    "Python, by keyword": """
        @dataclass
        class Geometry:
            alpha: float
            d: float
            a: float
        arm = [Geometry(d=0.31, a=0, alpha=pi/2), Geometry(a=0.42, d=0, alpha=0),
               Geometry(a=0.13, d=0, alpha=pi/2)]
        """,
    "Python, namedtuple": """
        Geometry = namedtuple("Geometry", "a alpha d")
        arm = [Geometry(0, pi/2, 0.31), Geometry(0.42, 0, 0), Geometry(0.13, pi/2, 0)]
        """,
    "C++, constructor": """
        class Axis {
        public:
          Axis(double d, double a, double alpha) : d_(d), a_(a), alpha_(alpha) {}
        };
        std::vector<Axis> arm = {Axis(0.31, 0, M_PI/2), Axis(0, 0.42, 0), Axis(0, 0.13, M_PI/2)};
        """,
    "C#, fields": """
        struct Axis {
            public double alpha;
            public double a;
            public double d;
        }
        var arm = new[] { new Axis(Math.PI/2, 0, 0.31), new Axis(0, 0.42, 0),
                          new Axis(Math.PI/2, 0.13, 0) };
        """,
    "Java, record with a name": """
        record Axis(String name, double d, double a, double alpha) {}
        List<Axis> arm = List.of(new Axis("waist", 0.31, 0, Math.PI/2),
            new Axis("upper", 0, 0.42, 0), new Axis("fore", 0, 0.13, Math.PI/2));
        """,
}


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_a_class_without_theta_takes_its_numbers_in_its_own_order(text):
    found = recognise_table("/* standard rows, metres */\n" + text)
    assert len(found.readings) == 1 and is_the_form(found.arm, ARM), str(found)


DICTS = """# standard rows, metres
dh = [{'alpha': pi/2, 'a': 0, 'd': 0.31},  # 1
      {'alpha': 0, 'a': 0.42, 'd': 0},     # 2
      {'alpha': pi/2, 'a': 0.13, 'd': 0}]  # 3
theta = [%s]
cos_alpha = math.cos(alpha)
sin_alpha = math.sin(alpha)
"""


def test_joint_angles_in_a_list_are_the_column_theta():
    turned = {**ARM, "rows": [(0, 0.31, 0, HALF), (-HALF, 0, 0.42, 0), (0, 0, 0.13, HALF)]}
    assert is_the_form(recognise_table(DICTS % "q1, q2 - pi/2, q3").arm, turned)
    assert is_the_form(recognise_table(DICTS % "t0, t1, t2").arm, ARM)


def test_a_number_among_joint_angles_may_be_a_row_without_a_joint():
    found = recognise_table(DICTS % "q1, 0.0, q3")
    still = {**ARM, "joints": "RFR"}
    assert len(found.readings) > 1 and any(is_the_form(one.arm, still) for one in found.readings)


def test_a_link_matrix_may_hold_products_with_names_of_their_own():
    text = """# metres
    ct, st = 0, 0
    ct = cos(th); st = sin(th); ca = cos(al); sa = sin(al)
    ct_a = ct * a
    st_a = st * a
    T = [[ct, -st*ca, st*sa, ct_a], [st, ct*ca, -ct*sa, st_a], [0, sa, ca, d], [0, 0, 0, 1]]
    dh = [[0, 0.31, 0, pi/2], [0, 0, 0.42, 0], [0, 0, 0.13, pi/2]]  # th, d, a, al
    """
    found = recognise_table(text)
    assert len(found.readings) == 1 and is_the_form(found.arm, ARM), str(found)


BODIES = """dh = [0 pi/2 0.31 0; 0.42 0 0 0; 0.13 0 0 0];
shoulder = rigidBodyJoint('shoulder', 'revolute');
setFixedTransform(shoulder, %s, 'dh');
upper = rigidBody('upper');
upper.Joint = shoulder;
elbow = rigidBodyJoint('elbow', 'revolute');
setFixedTransform(elbow, %s, 'dh');
hand = rigidBody('hand');
%ssetFixedTransform(%s, %s, 'dh');
"""
INLINE = "[0 pi/2 0.31 0]", "[0.42 0 0 0]", "[0.13 0 0 0]"
TAKEN = "dh(1,:)", "dh(2,:)", "dh(3,:)"


@pytest.mark.parametrize(
    "made, third, joints",
    [
        ("", "hand.Joint", "RRF"),
        ("grip = rigidBodyJoint('grip');\nhand.Joint = grip;\n", "hand.Joint", "RRF"),
        ("hand.Joint = rigidBodyJoint('grip', 'revolute');\n", "hand.Joint", "RRR"),
        ("grip = rigidBodyJoint('grip', 'prismatic');\n", "grip", "RRP"),
    ],
)
@pytest.mark.parametrize("rows", [INLINE, TAKEN], ids=["inline", "taken"])
def test_a_body_without_a_joint_of_its_own_is_a_row_without_one(rows, made, third, joints):
    text = BODIES % (rows[0], rows[1], made, third, rows[2])
    text = text if rows is TAKEN else text.partition("\n")[2]
    found = recognise_table(text)
    right = {
        "convention": "standard",
        "rows": [(0, 0.31, 0, HALF), (0, 0, 0.42, 0), (0, 0, 0.13, 0)],
        "joints": joints,
        "sign": [1, 1, 1],
    }
    assert all(is_the_form(one.arm, right) for one in found.readings[:1]), str(found)
