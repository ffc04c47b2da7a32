"""`kitemj stability`: whether the kite stays where it stands, and what it does if not."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import MODELS, Parser, command, number
from kitemj.commands.results import add_results, check_results, give_results

if TYPE_CHECKING:
    from kitemj.flight.scenario import Scenario


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "stability",
        "linearise about the equilibrium; where stability is lost; the cycle beyond",
        "kitemj stability scenarios/rest_200m.toml --vary aero.Cl_beta --range -0.6 0.0",
    )
    parser.add_argument("scenario", type=Path, help="a scenario file (TOML)")
    parser.add_argument("--model", default="lagrange", help=f"one of {', '.join(MODELS)}")
    parser.add_argument("--vary", metavar="NAME", help="find where this parameter loses stability")
    parser.add_argument("--range", nargs=2, type=float, metavar=("A", "B"), help="its range")
    parser.add_argument(
        "--map",
        nargs=6,
        metavar=("NAME", "A", "B", "NAME2", "A2", "B2"),
        help="the growth rate over two parameters",
    )
    parser.add_argument("--points", type=int, default=100, help="points of a map's side (100)")
    parser.add_argument("--cycle", action="store_true", help="the cycle that the kite flies")
    add_results(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.errors import InputError
    from kitemj.flight.scenario import read_scenario

    asked = [bool(args.vary), bool(args.map), args.cycle]
    if sum(asked) > 1:
        raise InputError("--vary, --map and --cycle are questions of their own: ask one at a time")
    if bool(args.vary) != bool(args.range):
        raise InputError("--vary NAME and --range A B go together: give both")
    check_results(args)
    scenario = read_scenario(args.scenario)
    if args.vary:
        return _vary(args, scenario)
    if args.map:
        return _map(args, scenario)
    return _cycle(args, scenario) if args.cycle else _modes(args, scenario)


def _modes(args: argparse.Namespace, scenario: "Scenario") -> int:
    from kitemj.api import stability
    from kitemj.equilibria import plots, tables

    found = stability(scenario, args.model)
    print("stable" if found.stable else "not stable", tables.v_ref_note(found.V_ref), sep="; ")
    linear = {"linear system": tables.matrices(found.linear)}
    give_results(args, found.tables(), linear, lambda: plots.modes_figure(found))
    return 0


def _vary(args: argparse.Namespace, scenario: "Scenario") -> int:
    from kitemj.api import stability
    from kitemj.equilibria import plots, tables
    from kitemj.equilibria.modes import crossings
    from kitemj.equilibria.trim import lines_held

    parameters, (low, high) = scenario.parameters, args.range
    ell, delta = lines_held(parameters, scenario.programme)
    found = crossings(parameters, args.vary, low, high, ell, delta, args.model)
    print(tables.v_ref_note(getattr(scenario.parameters.aero, "V_ref", None)))
    here = stability(scenario, args.model)
    give_results(args, [tables.crossing_table(found)], {}, lambda: plots.modes_figure(here))
    return 0


def _map(args: argparse.Namespace, scenario: "Scenario") -> int:
    from kitemj.equilibria import plots, tables
    from kitemj.equilibria.maps import stability_map
    from kitemj.equilibria.trim import lines_held

    x, a, b, y, c, d = args.map
    axes = (
        (x, number(a, "--map A"), number(b, "--map B")),
        (
            y,
            number(c, "--map A2"),
            number(d, "--map B2"),
        ),
    )
    ell, delta = lines_held(scenario.parameters, scenario.programme)
    found = stability_map(scenario.parameters, *axes, args.points, ell=ell, delta=delta)
    print(tables.v_ref_note(getattr(scenario.parameters.aero, "V_ref", None)))
    table = tables.map_table(found)
    short = table if args.output else None
    print(f"{len(table.rows)} points; write them with --output, draw them with --save")
    give_results(args, [table] if short else [], {}, lambda: plots.map_figure(found), show=False)
    return 0


def _cycle(args: argparse.Namespace, scenario: "Scenario") -> int:
    from kitemj.api import cycle
    from kitemj.equilibria import plots, tables

    found = cycle(scenario, args.model)
    print(tables.v_ref_note(getattr(scenario.parameters.aero, "V_ref", None)))
    print(f"period {found.period:.7g} s")
    if found.departure:
        print(f"leaves the limits of validity at {found.departure}")
    give_results(
        args, found.tables(), {"period_s": found.period}, lambda: plots.cycle_figure(found)
    )
    return 0
