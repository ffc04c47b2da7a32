"""How the kites that ship turn, identified in 5, 6.5 and 8 m/s: a table for each.

.venv/bin/python scripts/identification.py sport
.venv/bin/python scripts/identification.py --markdown docs/tables/identification.md --overwrite
"""

import argparse
import sys
from math import isnan
from pathlib import Path

from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.flight.scenario import parameters_named
from kitemj.progress_bar import with_progress
from kitemj.tables import Cell, Table, print_table, titled_markdown
from kitemj.turning.identification import Identification
from kitemj.turning.identify import identify
from kitemj.turning.turning_fit import Fit

WINDS = (5.0, 6.5, 8.0)
"""m/s."""
KITES = ("sport", "trainer", "laksa", "thesis")


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("kite", nargs="*", default=KITES, help="sets, or TOML files")
    parser.add_argument("--model", default="lagrange", help="that flies the test signal")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        tables = [table_of(kite, args.model) for kite in args.kite]
        for table in tables:
            print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"identification: {error}", file=sys.stderr)
        return 2
    return 0


def table_of(kite: str, model: str) -> Table:
    """A row for each number, a column for each wind."""
    given, columns = parameters_named(kite), list[dict[str, str]]()
    for speed in with_progress("flying", WINDS, len(WINDS)):
        parameters = given._replace(wind=given.wind._replace(speed=speed))
        columns.append(told(identify(parameters, model, kite)))
    rows: list[tuple[Cell, ...]] = [
        (name, *(column.get(name, "-") for column in columns)) for name in columns[0]
    ]
    return Table(kite, ("what", *(f"{speed:g} m/s" for speed in WINDS)), rows)


def told(found: Identification) -> dict[str, str]:
    """The numbers of an identification, in words."""
    linear, rest = found.linear, found.linear.law
    beside = fitted(found.plain, "n = 1, a constant delay: ", "delay [s]")
    beside |= fitted(found.swing, "a small swing about rest: ", "delay [s]")
    return {
        "the law of turning": "holds" if found.holds else "does not hold",
        "flown": "on eights" if found.eights else "about rest",
        **fitted(found.fit, "", "lag [m]"),
        **(beside if found.eights else {}),
        "the linear system: c₁ [1/(m rad)]": f"{rest.c1:.3f}",
        "the linear system: delay [s]": f"{rest.delay(rest.airspeed):.3f}",
        "the linear system: c₂ [m/s²]": f"{rest.c2:.2f}",
        "the linear system: explained": f"{100 * linear.explained:.1f} %",
    }


def fitted(fit: Fit | None, who: str, late: str) -> dict[str, str]:
    """The rows of a fit; dashes where there is none."""
    names = ["median airspeed [m/s]", "c₁ [1/(m rad)]", late, "c₂ [m/s²]", "explained"]
    names[2:2] = [] if who else ["exponent n"]
    if fit is None:
        return {f"{who}{name}": "-" for name in names}
    by_lag = late.startswith("lag")
    found, errors = fit.numbers, fit.errors
    delay = (found.lag, errors.lag) if by_lag else (found.delay, errors.delay)
    share = fit.fitted if isnan(fit.explained) else fit.explained
    cells = [
        f"{fit.airspeed:.1f}",
        unsure(found.c1, errors.c1, 3),
        *([] if who else [unsure(found.exponent, errors.exponent, 2)]),
        unsure(*delay, 2 if by_lag else 3),
        unsure(found.c2, errors.c2, 2),
        f"{100 * share:.1f} %",
    ]
    return {f"{who}{name}": cell for name, cell in zip(names, cells, strict=True)}


def unsure(number: float, error: float, digits: int) -> str:
    """A number with its standard uncertainty; the number alone where it was not fitted."""
    told = f"{number:.{digits}f}"
    return told if isnan(error) else f"{told} ± {error:.{digits}f}"


if __name__ == "__main__":
    sys.exit(main())
