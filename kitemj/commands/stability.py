"""`kitemj stability`: whether the kite stays where it stands, and what it does if not."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import MODELS, SCENARIO, Parser, number
from kitemj.commands.results import add_results, check_results, give_results

if TYPE_CHECKING:
    from kitemj.flight.scenario import Scenario

HELP = "linearise about the equilibrium; where stability is lost; the cycle beyond"
EXAMPLE = "kitemj stability scenarios/rest_200m.toml --vary aero.Cl_beta --range -0.6 0.0"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, help=SCENARIO)
    parser.add_argument("--model", default="lagrange", help=f"one of {', '.join(MODELS)}")
    parser.add_argument("--vary", metavar="NAME", help="find where this parameter loses stability")
    parser.add_argument("--range", nargs=2, type=float, metavar=("A", "B"), help="its range")
    axes, says = ("NAME", "A", "B", "NAME2", "A2", "B2"), "the growth rate over two parameters"
    parser.add_argument("--map", nargs=6, metavar=axes, help=says)
    parser.add_argument("--points", type=int, default=100, help="points of a map's side (100)")
    parser.add_argument("--cycle", action="store_true", help="the cycle that the kite flies")
    add_results(parser)


def run(args: argparse.Namespace) -> None:
    """Prints, writes and draws what is asked for."""
    from kitemj.errors import InputError
    from kitemj.flight.scenario import read_scenario

    asked = [bool(args.vary), bool(args.map), args.cycle]
    if sum(asked) > 1:
        raise InputError("--vary, --map and --cycle are questions of their own: ask one at a time")
    if bool(args.vary) != bool(args.range):
        raise InputError("--vary NAME and --range A B go together: give both")
    if args.map and not (args.save or args.output or args.json):
        raise InputError("a map needs --save FIGURE, --output FILE or --json, to be kept in")
    check_results(args)
    scenario = read_scenario(args.scenario)
    if args.vary:
        _vary(args, scenario)
    elif args.map:
        _map(args, scenario)
    elif args.cycle:
        _cycle(args, scenario)
    else:
        _modes(args, scenario)


def _modes(args: argparse.Namespace, scenario: "Scenario") -> None:
    from kitemj.api import stability
    from kitemj.equilibria import plots, tables

    found = stability(scenario, args.model)
    notes = [tables.v_ref_note(found.V_ref), found.in_words]
    linear: dict[str, object] = {"linear system": tables.matrices(found.linear)}
    if args.json:
        linear["stable"] = found.stable
    give_results(args, found.tables(), linear, lambda: plots.modes_figure(found), notes)


def _vary(args: argparse.Namespace, scenario: "Scenario") -> None:
    from kitemj.api import stability
    from kitemj.equilibria import plots, tables
    from kitemj.equilibria.modes import crossings
    from kitemj.equilibria.trim import lines_held

    parameters, (low, high) = scenario.parameters, args.range
    ell, delta = lines_held(parameters, scenario.programme)
    found = crossings(parameters, args.vary, low, high, ell, delta, args.model)
    here = stability(scenario, args.model)
    shown, notes = [tables.crossing_table(found)], [_note(scenario)]
    give_results(args, shown, {}, lambda: plots.modes_figure(here), notes)


def _map(args: argparse.Namespace, scenario: "Scenario") -> None:
    from kitemj.equilibria import plots, tables
    from kitemj.equilibria.maps import stability_map
    from kitemj.equilibria.trim import lines_held

    x, a, b, y, c, d = args.map
    x_axis = (x, number(a, "--map A"), number(b, "--map B"))
    y_axis = (y, number(c, "--map A2"), number(d, "--map B2"))
    ell, delta = lines_held(scenario.parameters, scenario.programme)
    found = stability_map(scenario.parameters, x_axis, y_axis, args.points, ell=ell, delta=delta)
    table, notes = tables.map_table(found), [_note(scenario)]
    if not args.json:
        notes.append(f"{len(table.rows)} points")
    give_results(args, [table], {}, lambda: plots.map_figure(found), notes, show=False)


def _cycle(args: argparse.Namespace, scenario: "Scenario") -> None:
    from kitemj.api import cycle
    from kitemj.equilibria import plots

    found = cycle(scenario, args.model)
    notes = [_note(scenario), f"period {found.period:.7g} s"]
    if found.departure:
        notes.append(f"leaves the limits of validity at {found.departure}")
    period = {"period_s": found.period}
    give_results(args, found.tables(), period, lambda: plots.cycle_figure(found), notes)


def _note(scenario: "Scenario") -> str:
    from kitemj.equilibria.tables import v_ref_note

    return v_ref_note(getattr(scenario.parameters.aero, "V_ref", None))
