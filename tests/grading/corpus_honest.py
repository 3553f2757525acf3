"""Honest notebooks that do what attacks do too, each for a reason: they keep all their marks."""

from corpus import closed, first
from corpus_making import RIGHT_FORM

FORM = "".join(f"    {line}\n" for line in RIGHT_FORM.splitlines())
LATER = f"def form(theta, d, a, alpha):\n{FORM}"
HONEST = [
    (
        "keeps its results",
        closed(
            "return np.array(form(theta, d, a, alpha))",
            f"from functools import lru_cache\n@lru_cache(maxsize=None)\n{LATER}",
        ),
    ),
    (
        "works in threads",
        closed(
            "with ThreadPoolExecutor(2) as pool:\n"
            "    return list(pool.map(form, [theta], [d], [a], [alpha]))[0]",
            f"from concurrent.futures import ThreadPoolExecutor\n{LATER}",
        ),
    ),
    (
        "uses files for a while",
        first(
            "import os, tempfile\nwith tempfile.TemporaryDirectory() as folder:\n"
            "    path = os.path.join(folder, 'table.csv')\n"
            "    np.savetxt(path, np.eye(4)); assert np.loadtxt(path).shape == (4, 4)\n"
            "os.makedirs('data/raw', exist_ok=True)\nnp.save('data/raw/x.npy', np.zeros(1000))"
        ),
    ),
    (
        "an object that can be called",
        closed(
            "return link(theta, d, a, alpha)",
            "class Link:\n    def __call__(self, theta, d, a, alpha):\n"
            + "".join(f"    {line}\n" for line in FORM.splitlines())
            + "\n    def __array__(self, *a, **k): return np.zeros(3)\nlink = Link()",
        ),
    ),
    (
        "prints, warns and draws at random",
        closed(
            "print('x' * 100_000); warnings.warn('slow'); np.random.seed(3); random.random()\n"
            "T = form(theta, d, a, alpha)\nassert np.allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3))\n"
            "return T",
            f"import random, warnings\n{LATER}",
        ),
    ),
    (
        "measures itself",
        closed(
            "seen = []\nsys.settrace(lambda *a: seen.append(a[1]))\n"
            "try: T = form(theta, d, a, alpha)\nfinally: sys.settrace(None)\n"
            "gc.collect(); copy.deepcopy(T); signal.getsignal(signal.SIGINT)\nreturn T",
            f"import copy, gc, signal, sys\n{LATER}",
        ),
    ),
]
