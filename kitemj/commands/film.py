"""`kitemj film`: scenarios and recordings on film, with no screen."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import MODELS, SCENARIO, Parser, add_picture, size
from kitemj.controls.actions import DEPTHS
from kitemj.errors import InputError

HELP = "film a scenario or a recording with no screen; two of them, or two models, side by side"
EXAMPLE = "kitemj film scenarios/loops_20m.toml --output kite.mp4"

MOST = 2
FINEST = 0.01
"""s; between two motions so close a still picture shows what lies between."""
TRAIL = 1000
"""Motions, at most, of which a still picture shows the trail."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("source", type=Path, nargs="+", help=f"a recording, or {SCENARIO}")
    parser.add_argument(
        "--output", type=Path, required=True, metavar="FILE", help=".mp4, .webp or .gif"
    )
    parser.add_argument("--overwrite", action="store_true", help="replace FILE if it exists")
    says = f"one or two of {', '.join(MODELS)}; a recording's input is flown again through it"
    parser.add_argument("--model", metavar="A[,B]", help=says)
    parser.add_argument("--rate", type=int, help="frames/s, default 30; WebP: 20, GIF: 12")
    parser.add_argument("--speed", type=float, default=1.0, help="2: twice as fast as it was")
    parser.add_argument("--from", dest="start", type=float, default=0.0, metavar="S")
    parser.add_argument("--to", dest="end", type=float, metavar="S")
    parser.add_argument("--still", type=float, metavar="T", help="one picture at T s, as a PNG")
    says = "over the first 3 s"
    parser.add_argument("--title", default="", metavar="TEXT", help=says)
    says = "with --view orbit: degrees/s that it goes round the kite, positive to the right"
    parser.add_argument("--turn", type=float, default=0.0, metavar="DEG", help=says)
    says = "how much is shown over the view, default pilot"
    parser.add_argument("--instruments", choices=DEPTHS, default=DEPTHS[0], help=says)
    add_picture(parser, usual="1280x720; WebP: 640x360, GIF: 480x270")
    parser.add_argument("--step", type=float, metavar="S", help="longest step [s], default 0.002")


def run(args: argparse.Namespace) -> None:
    """Makes the film, or the still picture."""
    from kitemj.cockpit.film_sources import film_source
    from kitemj.cockpit.filming import check_output, film, still, usual_for

    usual = usual_for(args.output)
    style = usual._replace(
        size=size(args.size) if args.size else usual.size,
        view=args.view,
        instruments=args.instruments,
        rate=usual.rate if args.rate is None else args.rate,
        speed=args.speed,
        turn=args.turn,
        title=args.title,
    )
    is_still = args.still is not None
    check_output(args.output, style, is_still, args.overwrite)
    models: list[str | None] = args.model.split(",") if args.model else [None]
    if len(args.source) * len(models) > MOST:
        raise InputError(f"at most {MOST} flights stand side by side: two files, or two models")
    interval = style.speed / style.rate
    if is_still:
        interval = max((args.still or 1.0) / TRAIL, min(args.still or 1.0, interval), FINEST)
    sources = [
        film_source(path, model, args.step, interval) for path in args.source for model in models
    ]
    if is_still:
        print(still(sources, args.output, style, args.still, args.overwrite))
    else:
        print(film(sources, args.output, style, args.start, args.end, args.overwrite))
