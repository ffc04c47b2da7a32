"""A path refused before the flight, with the smallest that would do; and one that suits a kite."""

from collections.abc import Callable
from math import degrees, isfinite, log, radians, tau
from typing import Literal

import numpy as np
from scipy.optimize import brentq

from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PathSettings, TurnRateLaw
from kitemj.paths.feasibility import AUTHORITY, SLOWEST, STRAY, Feasibility, feasibility
from kitemj.paths.glide import STOPPED, glide_ratio
from kitemj.paths.path import curve_of, path_of, place
from kitemj.physics.parameters import Parameters

COMFORT = 0.6
"""Of the hands' limits, what a path that is chosen for the kite asks for."""
BRISK = 1.0
"""winds over the ground, at least, on such a path: slower kites fly it less exactly."""
LOWEST = radians(20.0)
"""Elevation of the lowest place of a usual path, where the lines are long enough for that."""
SMALLEST = 0.4
"""Of a usual path, of which errors would else be too large a part."""
LARGEST = 1.6
"""Of one; larger, its sides are outside any window."""
USUAL = PathSettings(width=radians(80.0), height=radians(26.0), radius=radians(22.0))
"""A usual path of size 1. A height of a third of the width asks for the least of the stick; more
for quicker hands, less for more of its way."""
STEP = 1.1
"""From one size that is tried to the next."""
TINIEST = STEP**-24
"""Of the size that was asked for, to a tenth or to ten times of which another is looked for."""
REFINED = 1e-3
"""Of a size that is named."""
NONE = 1e3
"""What stands for the excess of a path that there is not."""


def check_path(settings: PathSettings, parameters: Parameters, law: TurnRateLaw) -> Feasibility:
    """What the path of `settings` asks for, in the steady wind of the set.

    Raises InputError for one that the kite cannot fly, which names what could be flown.
    """
    found = asked_by(settings, parameters, law)
    fault = _fault(found, parameters)
    if fault:
        raise InputError(f"pilot.path {fault}: {_cure(settings, parameters, law)}")
    return found


def asked_by(settings: PathSettings, parameters: Parameters, law: TurnRateLaw) -> Feasibility:
    """What the path of `settings` asks for, whether the kite can do it or not.

    Raises InputError for what is no path, and where there is no wind or no turning.
    """
    if parameters.wind.speed <= 0.0:
        raise InputError(f"a path needs wind.speed > 0 m/s, got {parameters.wind.speed:g} m/s")
    if law.c1 <= 0.0:
        raise InputError(
            f"a path needs a kite that turns to the hand that pulls, pilot.law.c1 > 0 1/(m rad), "
            f"got {law.c1:g} 1/(m rad): let it hold or land"
        )
    return feasibility(path_of(settings, glide_ratio(parameters)), parameters, law)


def usual_path(
    parameters: Parameters,
    law: TurnRateLaw,
    kind: Literal["lemniscate", "circle"] = "lemniscate",
) -> PathSettings:
    """The smallest path of the usual shape that asks for `COMFORT` or less and stays `BRISK`.

    In the steady wind of the set. Its lowest place is at `LOWEST`, or so high that the kite may
    stray. Where there is none, the path that comes nearest. Raises InputError where the kite can
    fly none of them.
    """

    def sized(size: float) -> PathSettings:
        return _raised(scaled(USUAL._replace(kind=kind), size), parameters)

    def excess(size: float) -> float:
        return _excess(sized(size), parameters, law, COMFORT, BRISK)

    size = _nearest(excess, SMALLEST, SMALLEST, LARGEST)
    if size is None:
        sizes = _sizes_between(SMALLEST, LARGEST)
        can = [each for each in sizes if _excess(sized(each), parameters, law) <= 0.0]
        size = min(can or sizes, key=excess)
    fault = _fault(asked_by(sized(size), parameters, law), parameters)
    if fault:
        raise InputError(
            f"no {kind} suits this kite, law and wind: even one of {_told(sized(size))} {fault}; "
            f"name longer lines, another wind, or quicker hands in [stick]"
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
    for _ in range(4):  # the sides hang lower the higher the middle is; soon found
        lowest = _lowest(settings)
        settings = settings._replace(elevation=settings.elevation + low - lowest)
    return settings


def _lowest(settings: PathSettings) -> float:
    """The least elevation [rad] on the path."""
    r, *_ = curve_of(settings)(np.linspace(0.0, tau, 361))
    return float(np.arcsin(np.min(r[:, 2] / np.linalg.norm(r, axis=1))))


def _excess(
    settings: PathSettings,
    parameters: Parameters,
    law: TurnRateLaw,
    share: float = AUTHORITY,
    slowest: float = SLOWEST,
) -> float:
    """As that of `Feasibility`; `NONE` for what is no path at all."""
    try:
        return asked_by(settings, parameters, law).excess(share, slowest)
    except InputError:
        return NONE


def _sizes_between(least: float, most: float) -> list[float]:
    """Sizes, a `STEP` apart."""
    return [least * STEP**i for i in range(round(log(most / least) / log(STEP)) + 1)]


def _nearest(
    excess: Callable[[float], float], to: float, least: float, most: float
) -> float | None:
    """The size nearest `to`, from `least` to `most`, which has no `excess`; None: there is none.

    To `REFINED`, on the side that would do.
    """
    last = {-1: to, 1: to}  # the nearest on each side that would not do
    for size in sorted(_sizes_between(least, most), key=lambda size: (abs(log(size / to)), size)):
        side = 1 if size > to else -1
        if excess(size) > 0.0:
            last[side] = size
            continue
        if last[side] == size or excess(to) <= 0.0:
            return to
        edge = float(brentq(excess, last[side], size, rtol=REFINED))
        return edge * (1 + 2 * side * REFINED)
    return None


def _fault(found: Feasibility, parameters: Parameters) -> str:
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
        return _excess(scaled(settings, size), parameters, law)

    size = _nearest(excess, 1.0, TINIEST, 1 / TINIEST)
    if size is not None:
        could = _told(scaled(settings, size))
        return f"{_kind(settings)} {size:.3g} times as large would do ({could})"
    try:
        kind: Literal["lemniscate", "circle"]
        kind = "circle" if settings.kind == "circle" else "lemniscate"
        usual = usual_path(parameters, law, kind)
    except InputError:
        return "no size of it would do, nor a usual path: try longer lines or another wind"
    where = f"elevation {degrees(usual.elevation):.0f} deg"
    return f"no size of it would do there; a {kind} of {_told(usual)} at {where} would"


def _kind(settings: PathSettings) -> str:
    return "the same through points" if settings.kind == "points" else f"a {settings.kind}"


def _told(settings: PathSettings) -> str:
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
