"""A path refused before the flight, with the smallest that would do; and one that suits a kite."""

from collections.abc import Callable
from math import degrees, isfinite, log, radians, tau
from typing import Literal

import numpy as np
from scipy.optimize import brentq

from kitemj.autopilot.feasibility import AUTHORITY, SLOWEST, STRAY, Feasibility, feasibility
from kitemj.autopilot.glide import STOPPED, glide_ratio
from kitemj.autopilot.paths import curve_of, path_of, place
from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PathSettings, TurnRateLaw
from kitemj.physics.parameters import Parameters

COMFORT = 0.6
"""Of the hands' limits, what a path asks for that is chosen for the kite."""
LOWEST = radians(20.0)
"""Elevation of the lowest place of a usual path, where the lines are long enough for that."""
SMALLEST = 0.4
"""Of the size of `PathSettings()`, a usual path is so large at least: errors count for less."""
SIZES = 1.1 ** np.arange(-24, 25)
"""Of a path, tried in steps of a tenth; from a tenth to ten times as large."""
REFINED = 1e-3
"""Of a size that is named."""
NONE = 1e3
"""What stands for the excess of a path that there is not."""


def check_path(settings: PathSettings, parameters: Parameters, law: TurnRateLaw) -> Feasibility:
    """What the path of `settings` asks for, in the steady wind of the set.

    Raises InputError for one that the kite cannot fly, which names what could be flown.
    """
    found = asked_by(settings, parameters, law)
    fault = _fault(found, settings, parameters)
    if fault:
        raise InputError(f"pilot.path {fault}: {_cure(settings, parameters, law)}")
    return found


def asked_by(settings: PathSettings, parameters: Parameters, law: TurnRateLaw) -> Feasibility:
    """What the path of `settings` asks for, whether the kite can do it or not."""
    return feasibility(path_of(settings, glide_ratio(parameters)), parameters, law)


def usual_path(
    parameters: Parameters,
    law: TurnRateLaw,
    kind: Literal["lemniscate", "circle"] = "lemniscate",
) -> PathSettings:
    """The smallest path of the usual shape that asks for `COMFORT` of the hands' limits or less.

    Its lowest place is at `LOWEST`, or so high that the kite may stray. Where it takes more than
    that, the path that asks for least. Raises InputError where the kite can fly none.
    """

    def sized(size: float) -> PathSettings:
        return _raised(scaled(PathSettings(kind=kind), size), parameters)

    def excess(size: float, share: float = COMFORT) -> float:
        return _excess(lambda: sized(size), parameters, law, share)

    sizes = [float(size) for size in SIZES if size >= SMALLEST]
    size = _nearest(sizes, excess, SMALLEST)
    if size is None:
        tried = {each: excess(each, AUTHORITY) for each in sizes}
        size = min(tried, key=lambda each: tried[each])
        if tried[size] > 0.0:
            raise InputError(
                f"no {kind} suits this kite on {parameters.lines.length:g} m lines in "
                f"{parameters.wind.speed:g} m/s: at best it "
                f"{_fault(asked_by(sized(size), parameters, law), sized(size), parameters)}; "
                f"name other lines, another wind, or quicker hands in [stick]"
            )
    return sized(size)


def scaled(settings: PathSettings, size: float) -> PathSettings:
    """The path `size` times as large about its middle."""
    if settings.kind == "circle":
        return settings._replace(radius=size * settings.radius)
    if settings.kind == "lemniscate":
        return settings._replace(width=size * settings.width, height=size * settings.height)
    middle = np.mean(settings.points, axis=0)
    points = (middle + size * (np.array(settings.points) - middle)).tolist()
    return settings._replace(points=tuple((float(a), float(e)) for a, e in points))


def _raised(settings: PathSettings, parameters: Parameters) -> PathSettings:
    """The path at the elevation at which its lowest place is a usual path's."""
    kite, length = parameters.kite, parameters.lines.length
    low = max(LOWEST, STRAY + float(np.arcsin(min(1.0, (kite.span + kite.chord) / length))))
    for _ in range(4):  # the sides hang lower, the higher the middle is; soon found
        lowest = _lowest(settings)
        settings = settings._replace(elevation=settings.elevation + low - lowest)
    return settings


def _lowest(settings: PathSettings) -> float:
    """The least elevation [rad] on the path."""
    r, *_ = curve_of(settings)(np.linspace(0.0, tau, 361))
    return float(np.arcsin(np.min(r[:, 2] / np.linalg.norm(r, axis=1))))


def _excess(
    settings: Callable[[], PathSettings], parameters: Parameters, law: TurnRateLaw, share: float
) -> float:
    """As that of `Feasibility`; large for what is no path at all."""
    try:
        return asked_by(settings(), parameters, law).excess(share)
    except InputError:
        return NONE


def _nearest(sizes: list[float], excess: Callable[[float], float], to: float) -> float | None:
    """The size nearest to `to` with no `excess`, between `sizes`, to `REFINED`; None: none."""
    best = None
    for size in sorted(sizes, key=lambda size: abs(log(size / to))):
        if excess(size) <= 0.0:
            best = size
            break
    if best is None or best == to:
        return best
    toward = best / 1.1 if best > to else best * 1.1
    if (best > to) != (toward > to) or excess(toward) <= 0.0:
        toward = to
    if excess(toward) <= 0.0:
        return toward
    edge = float(brentq(excess, toward, best, rtol=REFINED))
    # on the side that would do
    return edge * (1 + 2 * REFINED) if best > to else edge * (1 - 2 * REFINED)


def _fault(found: Feasibility, settings: PathSettings, parameters: Parameters) -> str:
    """What is wrong with a path, as what it does; "" where nothing is."""
    limits, wind, length = parameters.stick, parameters.wind.speed, parameters.lines.length
    rig = f"on {length:g} m lines in {wind:g} m/s"
    if found.height < 0.0:
        return (
            f"brings the kite's lowest corner to {found.height:.1f} m above ground at "
            f"{place(found.height_at)}, if it strays by {degrees(STRAY):.0f} deg; "
            f"it must stay above 0 m"
        )
    if found.winds < SLOWEST:
        slow = "stops the kite" if found.winds <= STOPPED else f"slows it to {found.speed:.2f} m/s"
        return (
            f"{slow} {rig} at {place(found.speed_at)}, too far out of the wind window for its "
            f"glide ratio of {glide_ratio(parameters):.1f}; it must keep {SLOWEST * wind:.2g} m/s"
        )
    if found.stick > AUTHORITY:
        least = (
            f"{found.least:.1f} m at least" if isfinite(found.least) else "no radius against weight"
        )
        return (
            f"turns the nose on a radius of {found.radius:.1f} m at {place(found.stick_at)}; "
            f"the kite {rig} turns there on {least}, with {AUTHORITY:g} of the stick"
        )
    for name, part, at, most, unit in (
        ("δ̇", found.rate, found.rate_at, limits.delta_dot, "rad/s"),
        ("δ̈", found.acceleration, found.acceleration_at, limits.delta_ddot, "rad/s2"),
    ):
        if part > AUTHORITY:
            return (
                f"asks for {name} = {part * most:.2g} {unit} {rig} at {place(at)}; it may ask "
                f"for {AUTHORITY:g} of the hands' {most:g} {unit}"
            )
    return ""


def _cure(settings: PathSettings, parameters: Parameters, law: TurnRateLaw) -> str:
    """What would do: the path in another size, else the usual one."""

    def excess(size: float) -> float:
        return _excess(lambda: scaled(settings, size), parameters, law, AUTHORITY)

    size = _nearest([float(each) for each in SIZES], excess, 1.0)
    if size is not None:
        could = _sizes(scaled(settings, size))
        return f"{_kind(settings)} {size:.3g} times as large would do ({could})"
    try:
        kind: Literal["lemniscate", "circle"]
        kind = "circle" if settings.kind == "circle" else "lemniscate"
        usual = usual_path(parameters, law, kind)
    except InputError:
        return "no size of it would do, nor any usual path in this wind"
    where = f"elevation {degrees(usual.elevation):.0f} deg"
    return f"no size of it would do there; a {kind} of {_sizes(usual)} at {where} would"


def _kind(settings: PathSettings) -> str:
    return "the same through points" if settings.kind == "points" else f"a {settings.kind}"


def _sizes(settings: PathSettings) -> str:
    """The size of a path, rounded to what would do."""
    if settings.kind == "circle":
        return f"radius {degrees(settings.radius):.1f} deg"
    if settings.kind == "lemniscate":
        return f"width {degrees(settings.width):.1f} deg, height {degrees(settings.height):.1f} deg"
    azimuths, elevations = np.degrees(np.array(settings.points)).T
    return (
        f"azimuth {azimuths.min():.1f} to {azimuths.max():.1f} deg, "
        f"elevation {elevations.min():.1f} to {elevations.max():.1f} deg"
    )
