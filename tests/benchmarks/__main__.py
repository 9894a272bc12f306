"""Benchmarks: `python -m tests.benchmarks [NAME ...]` runs those, or all there are.

Each is a module here with a `main` that prints a table. Times drift from machine to machine and
from minute to minute; what counts are the ratios to peers that took turns in the same run.
"""

import importlib
import pkgutil
import sys

from tests import benchmarks


def main(names: list[str]) -> int:
    """Run the benchmarks of those names; 2 if there is no such one."""
    there = sorted(m.name for m in pkgutil.iter_modules(benchmarks.__path__) if m.name[0] != "_")
    for name in names:
        if name not in there:
            print(f"no benchmark {name!r}; there are: {', '.join(there)}", file=sys.stderr)
            return 2
    for name in names or there:
        module = importlib.import_module(f"tests.benchmarks.{name}")
        print(f"== {name}: {(module.__doc__ or name).splitlines()[0]}", flush=True)
        module.main()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
