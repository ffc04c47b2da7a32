"""The engineer's panels of numbers: the flight, the angles of the air, the model, the arrows."""

from math import degrees, isfinite

from kitemj.drawing.colours import CALL, DIM, GOOD, LEFT, RIGHT, TROUGH, WHITE
from kitemj.drawing.panel import EDGE, LARGE, NAME, NUMBER, Panel
from kitemj.drawing.plates import NOW
from kitemj.drawing.readings import Readings
from kitemj.drawing.wind_window import bearing
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import SIDESLIP, STALL, TWIST, Numbers
from kitemj.physics.parameters import Parameters
from kitemj.scene.forces import newtons_per_metre

GAP_UNITS = ((1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (0.0, "nm"))  # from this on, in metres


def paint_flight(
    panel: Panel, parameters: Parameters, motion: Motion, readings: Readings, alarm: int
) -> None:
    """Paints when and where the kite is, and how fast; how fast time runs, and the assist."""
    azimuth, elevation = bearing(parameters, motion.body.p_G_E)
    who = "AUTO" if readings.wished else "ASSIST" if readings.assist else "time"
    told = f"{who} ×{readings.speed:.3g}"
    panel.row(told, f"{motion.t:.1f} s", 26, LARGE)
    rows = (
        ("elevation", f"{elevation:.1f}°"),
        ("azimuth", _sided(azimuth)),
        ("height, min 0", f"{-motion.body.p_G_E.z:.1f} m"),
        ("airspeed", f"{motion.air.speed:.1f} m/s"),
    )
    for i, (name, value) in enumerate(rows):
        grave, row = alarm == NOW and name.startswith("height"), 70 + 36 * i
        size, colour = (LARGE, CALL) if grave else (NUMBER, WHITE)
        panel.row(name, value, row, size, colour, WHITE if alarm == NOW else DIM)


def paint_air(panel: Panel, parameters: Parameters, motion: Motion, alarm: int) -> None:
    """Paints α and β as marks between their limits."""
    limits, air = parameters.limits, motion.air
    alpha = ("angle of attack", "α, 0° to ", air.alpha, limits.alpha_stall, STALL)
    beta = ("sideslip", "β, at most ±", air.beta, limits.beta_max, SIDESLIP)
    left, wide = EDGE, panel.width - 2 * EDGE
    for i, (name, within, angle, most, limit) in enumerate((alpha, beta)):
        row, middle = 22 + 76 * i, left + wide / 2
        beyond = not limit.kept(limits, Numbers((), *air))
        size, colour = (LARGE, CALL) if beyond else (NUMBER, WHITE)
        quiet = WHITE if alarm == NOW else DIM
        panel.row(name, f"{degrees(angle):.1f}°", row, size, colour, quiet)
        panel.bar(left, row + 20, wide, 9, TROUGH)
        share = min(max(angle / most, -1.0), 1.0)
        start, end = sorted((middle, middle + share * wide / 2))
        panel.bar(start, row + 20, max(end - start, 3), 9, CALL if beyond else GOOD)
        panel.bar(middle - 1, row + 17, 2, 15, WHITE)
        panel.text(f"{within}{degrees(most):.0f}°", left, row + 44)


def paint_model(panel: Panel, parameters: Parameters, readings: Readings, alarm: int) -> None:
    """Paints the model, who steers, how far the reference is, how the lines are twisted."""
    twist = readings.traces.twist if readings.traces else 0.0
    turns = round(degrees(twist) / 360)
    told = f"{abs(turns)} {'right' if turns > 0 else 'left'}" if turns else "0"
    beyond = not TWIST.kept(parameters.limits, Numbers(twist=twist))
    most = f"twist, at most {degrees(parameters.limits.twist_max) / 360:g}"
    gap = "none" if readings.gap is None else length(readings.gap)
    rows = (
        ("model", readings.model),
        ("steered by", readings.stick),
        ("gap to reference", gap),
        (most, told),
    )
    for i, (name, value) in enumerate(rows):
        grave, row = beyond and name == most, 22 + 28 * i
        size, colour = (LARGE, CALL) if grave else (NAME + 1, WHITE)
        panel.row(name, value, row, size, colour, WHITE if alarm == NOW else DIM)


def window_title(readings: Readings) -> str:
    """What stands over the wind window: what it is, or how an autopilot follows its path."""
    guided = readings.wished and readings.wished.guided
    if not guided:
        return "wind window, rim 90°"
    told: str = guided.phase
    if isfinite(guided.error):
        told += f", {abs(degrees(guided.error)):.1f}° {'R' if guided.error > 0 else 'L'}"
    return f"{told}, lap {guided.lap:.3g}" if isfinite(guided.lap) else told


def paint_arrows(panel: Panel, parameters: Parameters) -> None:
    """Paints what the arrows at the kite mean."""
    panel.text(f"arrows: 1 m = {newtons_per_metre(parameters):g} N", EDGE, 20)
    x = EDGE
    for text, colour in (("air", CALL), ("weight", WHITE), ("left", LEFT), ("right", RIGHT)):
        panel.bar(x, 40, 10, 10, colour)
        panel.text(text, x + 14, 45, NAME, WHITE)
        x += 14 + panel.wide(text) + 9


def _sided(azimuth: float) -> str:
    """An azimuth [deg] from downwind as text; positive is +y_E, the pilot's left."""
    side = "left" if azimuth > 0.05 else "right" if azimuth < -0.05 else ""
    digits = 0 if abs(azimuth) >= 9.95 else 1
    return f"{abs(azimuth):.{digits}f}° {side}".rstrip()


def length(metres: float) -> str:
    """A length [m] as text, in the unit that suits it."""
    if 0.0 < metres < 1e-10:
        return "< 0.1 nm"
    for least, unit in GAP_UNITS:
        if metres >= least:
            number = metres / (least or 1e-9)
            return f"{number:.0f} {unit}" if number >= 100 else f"{number:.3g} {unit}"
    return "no number"
