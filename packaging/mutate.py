"""Measure which changes of the program its tests detect.

    python3 packaging/bootstrap.py mutate [-- --most 70 --keys EARLIER.json --survivors]

Changes one place at a time with the operators of cosmic-ray, and runs the tests. A hash of each
change selects the sample, so that a later run tries the same changes again, even if the program or
its tests have changed elsewhere. `mutate.toml` lists the packages to change, and the tests that
must detect the changes.
"""

import argparse
import hashlib
import json
import os
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from cosmic_ray.ast import ast_nodes, get_ast_from_path
from cosmic_ray.ast.ast_query import ASTQuery
from cosmic_ray.mutating import mutate_code
from cosmic_ray.plugins import get_operator

ROOT = Path(__file__).resolve().parent.parent
CONFIGURATION = Path(__file__).with_suffix(".toml")
COPIED = ("trex_gui", "tests", "resources", "packaging", "pyproject.toml", "README.md")


@dataclass(frozen=True)
class Mutant:
    """Change of the program in one place.

    Attributes:
        key: hash of the change. Does not depend on other lines of the file.
        line: line number in the file, from 1.
        nth: index of the place among all places in the file that the operator can change.
        text: the line before the change.
    """

    key: str
    package: str
    path: str
    line: int
    operator: str
    nth: int
    text: str


@dataclass
class Package:
    """Part of the program, with the tests that must detect its changes."""

    name: str
    paths: list[str]
    tests: list[str]


def mutants_of(root: Path, package: Package, operators: Sequence[str]) -> Iterator[Mutant]:
    """Yield every possible change of a package."""
    files = [
        file
        for path in package.paths
        for file in sorted((root / path).rglob("*.py")) or [root / path]
    ]
    for file in files:
        lines = file.read_text(encoding="utf-8").splitlines()
        tree = get_ast_from_path(file)
        path = str(file.relative_to(root))
        for name in operators:
            operator = get_operator(name)()
            places = (
                (node, start)
                for node in ast_nodes(tree)
                for start, _ in operator.mutation_positions(node)
            )
            repetitions: Counter[str] = Counter()
            for nth, (node, (line, _)) in enumerate(places):
                text = lines[line - 1].strip()
                where = f"{path}|{ASTQuery(node).get_definition_name()}|{name}|{text}"
                repetitions[where] += 1
                key = hashlib.sha256(f"{where}|{repetitions[where]}".encode()).hexdigest()[:16]
                yield Mutant(key, package.name, path, line, name, nth, text)


def sample(mutants: Sequence[Mutant], size: int) -> list[Mutant]:
    """Return a sample of at most one mutant per line.

    The mutants with the lowest keys are selected.
    """
    selected: dict[tuple[str, int], Mutant] = {}
    for mutant in sorted(mutants, key=lambda mutant: mutant.key):
        selected.setdefault((mutant.path, mutant.line), mutant)
    return sorted(selected.values(), key=lambda mutant: mutant.key)[:size]


class Worker(threading.Thread):
    """Thread that tries mutants in a copy of the project."""

    def __init__(
        self,
        todo: "queue.SimpleQueue[Mutant]",
        done: "queue.SimpleQueue[tuple[Mutant, dict[str, object]]]",
        root: Path,
        packages: dict[str, Package],
        timeout: float,
        *,
        folder: Path,
    ) -> None:
        super().__init__(daemon=True)
        self._todo, self._done, self._packages, self._timeout = todo, done, packages, timeout
        self._folder = folder
        folder.mkdir()
        for name in COPIED:
            source = root / name
            if source.is_dir():
                ignored = shutil.ignore_patterns("__pycache__", ".venv")
                shutil.copytree(source, self._folder / name, ignore=ignored)
            else:
                shutil.copy(source, self._folder / name)

    def run(self) -> None:
        while True:
            try:
                mutant = self._todo.get_nowait()
            except queue.Empty:
                return
            self._done.put((mutant, self._try(mutant)))

    def _try(self, mutant: Mutant) -> dict[str, object]:
        file = self._folder / mutant.path
        source = file.read_text(encoding="utf-8")
        changed = mutate_code(source, get_operator(mutant.operator)(), mutant.nth)
        line = changed.splitlines()[mutant.line - 1].strip()
        try:
            compile(changed, mutant.path, "exec")
        except SyntaxError:
            return {"outcome": "invalid", "by": "", "changed": line, "seconds": 0.0}
        file.write_text(changed, encoding="utf-8")
        start = time.monotonic()
        try:
            outcome, by = self._test(self._packages[mutant.package].tests)
        finally:
            file.write_text(source, encoding="utf-8")
        seconds = round(time.monotonic() - start, 1)
        return {"outcome": outcome, "by": by, "changed": line, "seconds": seconds}

    def _test(self, tests: Sequence[str]) -> tuple[str, str]:
        command = [sys.executable, "-m", "pytest", "-x", "-q", "--no-header", "-p", "no:randomly"]
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONDONTWRITEBYTECODE": "1"}
        with subprocess.Popen(
            [*command, *tests],
            cwd=self._folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
        ) as process:
            try:
                output, _ = process.communicate(timeout=self._timeout)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, 9)
                process.communicate()
                return "timeout", ""
        if process.returncode == 0:
            return "survived", ""
        failed = [line for line in output.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return "caught", failed[0].split(" - ")[0] if failed else output[-200:]


def run(
    root: Path, packages: Sequence[Package], mutants: Sequence[Mutant], timeout: float, workers: int
) -> dict[str, dict[str, object]]:
    """Try every mutant and return the results, by key."""
    todo: queue.SimpleQueue[Mutant] = queue.SimpleQueue()
    done: queue.SimpleQueue[tuple[Mutant, dict[str, object]]] = queue.SimpleQueue()
    for mutant in mutants:
        todo.put(mutant)
    by_name = {package.name: package for package in packages}
    results: dict[str, dict[str, object]] = {}
    with tempfile.TemporaryDirectory(prefix="mutants-", ignore_cleanup_errors=True) as folder:
        for number in range(workers):
            Worker(todo, done, root, by_name, timeout, folder=Path(folder) / str(number)).start()
        for count in range(1, len(mutants) + 1):
            mutant, result = done.get()
            results[mutant.key] = {**asdict(mutant), **result}
            print(
                f"{count:4}/{len(mutants)} {result['outcome']:9}{mutant.path}:{mutant.line} "
                f"{mutant.text!r} -> {result['changed']!r} {result['by']}",
                flush=True,
            )
    return results


def table(results: Sequence[dict[str, object]]) -> str:
    """Return a table of tried, caught and surviving mutants by package.

    Mutants with invalid syntax are not counted.
    """
    counts: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for result in (result for result in results if result["outcome"] != "invalid"):
        counts[str(result["package"])][str(result["outcome"])] += 1
        counts["all"][str(result["outcome"])] += 1
    rows = [f"{'package':16}{'tried':>6}{'caught':>8}{'survived':>10}{'share':>8}"]
    for name, count in counts.items():
        tried, survived = count.total(), count["survived"]
        share = (tried - survived) / tried
        rows.append(f"{name:16}{tried:6}{tried - survived:8}{survived:10}{share:8.1%}")
    return "\n".join(rows)


def main() -> int:
    parser = argparse.ArgumentParser(description="Change the program and list what the tests miss.")
    parser.add_argument("--root", type=Path, default=ROOT, help="the checkout to change")
    parser.add_argument("--most", type=int, default=70, help="mutants per package")
    parser.add_argument("--only", help="this package only")
    parser.add_argument("--keys", type=Path, help="only the mutants in this result")
    parser.add_argument("--survivors", action="store_true", help="with --keys: only survivors")
    parser.add_argument("--beside", type=int, default=2, help="number of parallel processes")
    parser.add_argument("--results", type=Path, default=ROOT / "mutants.json")
    options = parser.parse_args()

    configuration = tomllib.loads(CONFIGURATION.read_text(encoding="utf-8"))
    packages = [
        Package(name, **fields)
        for name, fields in configuration["packages"].items()
        if options.only in {None, name}
    ]
    root = options.root.resolve()
    mutants: list[Mutant] = []
    for package in packages:
        possible = list(mutants_of(root, package, configuration["operators"]))
        if options.keys is None:
            mutants += sample(possible, options.most)
        else:
            earlier = json.loads(options.keys.read_text(encoding="utf-8"))
            if options.survivors:
                earlier = {k: v for k, v in earlier.items() if v["outcome"] == "survived"}
            mutants += [mutant for mutant in possible if mutant.key in earlier]
    results = run(root, packages, mutants, configuration["limit"], options.beside)
    options.results.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print(table(list(results.values())))
    return 0


if __name__ == "__main__":
    sys.exit(main())
