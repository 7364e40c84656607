"""What a user meets first: the import, the README, the types."""

import pathlib
import re
import subprocess
import sys

import robovac

ROOT = pathlib.Path(__file__).parents[3]


def test_the_readmes_lines_work():
    readme = (ROOT / "README.md").read_text()
    section = readme.split("\n## Python\n", 1)[1].split("\n## ", 1)[0]
    (code,) = re.findall(r"```python\n(.*?)```", section, re.S)
    assert len(code.strip().splitlines()) <= 10
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)


def test_the_lines_of_the_documentation_work(tmp_path):
    text = (ROOT / "docs/python.md").read_text()
    for code in re.findall(r"```python\n(.*?)```", text, re.S):
        subprocess.run([sys.executable, "-c", code], check=True, cwd=tmp_path)


def test_the_environment_is_there_whichever_is_imported_first():
    for imports in ("import robovac, gymnasium", "import gymnasium, robovac", "import gymnasium, robovac.gym"):
        code = f"{imports}; assert gymnasium.spec('robovac/Clean-v0').vector_entry_point"
        subprocess.run([sys.executable, "-c", code], check=True)
    code = "import robovac; robovac.gym.RewardWeights(bump=-1); robovac.study.run"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_importing_loads_neither_numpy_nor_gymnasium():
    code = "import sys, robovac; assert not {'numpy', 'gymnasium'} & set(sys.modules), 'loaded'"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_everything_public_is_documented_and_typed():
    folder = pathlib.Path(robovac.__file__).parent
    assert (folder / "py.typed").exists() and (folder / "_native.pyi").exists()
    stub = (folder / "_native.pyi").read_text()
    for name in (name for name in vars(robovac._native) if not name.startswith("__")):
        assert f"def {name}(" in stub or f"class {name}:" in stub, name
    for name in robovac.__all__:
        assert name == "__version__" or getattr(robovac, name).__doc__, name
    assert re.fullmatch(r"\d+\.\d+\.\d+", robovac.__version__)
