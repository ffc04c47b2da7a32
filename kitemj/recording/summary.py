"""What a recording holds, in lines for people."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.formulation import MODELS
from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, PHASE
from kitemj.flight.limits import left_limits
from kitemj.physics.parameter_files import parameter_set, parameter_tables, set_names
from kitemj.physics.parameters import Limits
from kitemj.recording.file import Recording
from kitemj.recording.header import Header
from kitemj.recording.pilot import pilot_in_words, plain
from kitemj.recording.replay import Replay
from kitemj.recording.table import limit_numbers

BROKEN_OFF = "unknown: the file breaks off (the program was stopped, or the disk was full)"


def facts(recording: Recording) -> dict[str, Any]:
    """What a recording holds, for machines: its header, and what was counted and measured."""
    header = recording.header
    late = recording.columns["lateness_s"][recording.columns["tick"] > 0]
    return {
        "recording": str(recording.path),
        "size_MB": recording.path.stat().st_size / 1e6,
        "header": vars(header),
        "pilot": plain(recording.pilot),
        "piloted_ticks": int((recording.columns[PHASE] > NOBODY).sum()),
        "rows": len(recording),
        "flights": [_flight(recording, episode) for episode in recording.episodes],
        "ticks": len(late),
        "missed_ticks": int((late > header.tick).sum()),
        "lateness_median_s": float(np.median(late)) if len(late) else None,
        "lateness_worst_s": float(late.max()) if len(late) else None,
        "ending": recording.ending or None,
    }


def _flight(recording: Recording, episode: slice) -> dict[str, Any]:
    """How long, how far from the reference, how close to each limit, where it left them."""
    columns = {name: values[episode] for name, values in recording.columns.items()}
    pulls = np.stack(limit_numbers(columns).tensions) + 0.0
    followed = np.isfinite(columns["gap_m"])
    gaps, times = columns["gap_m"][followed], columns["t_s"][followed]
    left = recording.departure(episode)
    return {
        "duration_s": float(columns["t_s"][-1]),
        "gap_m": float(gaps.max()) if len(gaps) else None,
        "followed_until_s": float(times[-1]) if len(gaps) else None,
        "alpha_min_deg": float(columns["alpha_deg"].min()),
        "alpha_max_deg": float(columns["alpha_deg"].max()),
        "beta_min_deg": float(columns["beta_deg"].min()),
        "beta_max_deg": float(columns["beta_deg"].max()),
        "tension_min_N": float(pulls.min()),
        "tension_max_N": float(pulls.max()),
        "departure_s": left.t if left else None,
        "departure": left.limit.name if left else None,
        "departure_reading": left.reading if left else None,
    }


def summary(recording: Recording) -> str:
    """All that `kitemj info` prints."""
    held, header = facts(recording), recording.header
    beside = f"beside {header.reference}" if header.reference else "alone"
    seeds = ", ".join(f"{name} {seed}" for name, seed in header.seeds.items())
    flights = len(held["flights"])
    count = "one flight" if flights == 1 else f"{flights} flights, a restart between each"
    lines = [
        ("recording", f"{recording.path}, {held['size_MB']:.1f} MB, written {header.written}"),
        ("scenario", header.scenario),
        ("model", f"{header.model} {beside}, steps of {1e3 * header.step:g} ms"),
        ("parameters", parameters_in_words(header.parameters)),
        *_autopilot_in_words(recording, held["piloted_ticks"]),
        ("seeds", seeds or "none: nothing in the flight is random"),
        ("versions", ", ".join(f"{name} {number}" for name, number in header.versions.items())),
    ]
    changed = changed_versions(header)
    if changed:
        lines.append(("", f"other than here ({changed}): a replay may differ in its last digits"))
    try:
        header.check(MODELS, header.model, recording.path.name)
    except InputError as error:
        lines.append(("", str(error)))
    lines.append(("held", f"{held['rows']} ticks of {1e3 * header.tick:g} ms, {count}"))
    for number, flight in enumerate(held["flights"], start=1):
        left = left_limits(recording.departure(recording.episodes[number - 1]))
        told = (*_flight_in_words(flight, recording.parameters.limits), left)
        lines += [(f"flight {number}", text) for text in told]
    timekeeping = "no tick was flown"
    if held["ticks"]:
        median, worst = 1e3 * held["lateness_median_s"], 1e3 * held["lateness_worst_s"]
        timekeeping = (
            f"{held['missed_ticks']} of {held['ticks']} ticks missed, lateness median "
            f"{median:.2f} ms, worst {worst:.1f} ms"
        )
    lines += [("real time", timekeeping), ("ended", recording.ending or BROKEN_OFF)]
    return "\n".join(f"{name:<12} {text}" for name, text in lines)


def _autopilot_in_words(recording: Recording, ticks: int) -> list[tuple[str, str]]:
    """The scenario's autopilot, and for how long one flew, if there was one."""
    told = [pilot_in_words(recording.pilot)] if recording.pilot else []
    if ticks or told:
        told.append(f"flew {ticks} ticks of {len(recording)}")
    return [("autopilot", text) for text in told]


def _flight_in_words(flight: dict[str, Any], limits: Limits) -> list[str]:
    reference = "not followed by the reference"
    if flight["gap_m"] is not None:
        reference = (
            f"at most {1e6 * flight['gap_m']:.3g} µm from the reference "
            f"(followed to {flight['followed_until_s']:.2f} s)"
        )
    return [
        f"{flight['duration_s']:.2f} s, {reference}",
        f"α {flight['alpha_min_deg']:.2f}° to {flight['alpha_max_deg']:.2f}° "
        f"(0° to {np.degrees(limits.alpha_stall):g}°), "
        f"β {flight['beta_min_deg']:.2f}° to {flight['beta_max_deg']:.2f}° "
        f"(±{np.degrees(limits.beta_max):g}°), lines {flight['tension_min_N']:.1f} N to "
        f"{flight['tension_max_N']:.1f} N (0 N to {limits.tension_max:g} N)",
    ]


def parameters_in_words(tables: dict[str, Any]) -> str:
    """The named set that comes nearest, and what differs from it."""
    differences = {}
    for name in set_names():
        named = parameter_tables(parameter_set(name))
        differences[name] = [
            f"{section}.{key} = {_number(value)}"
            for section, table in tables.items()
            for key, value in table.items()
            if value != named[section].get(key)
        ]
    nearest = min(differences, key=lambda name: len(differences[name]))
    changes = differences[nearest]
    return nearest if not changes else f"{nearest} with {', '.join(changes)}"


def changed_versions(header: Header) -> str:
    """What is here in another version than that of the recording."""
    versions, here = header.versions, header.present_versions()
    return ", ".join(f"{name} {here[name]}" for name in here if versions.get(name) != here[name])


def _number(value: Any) -> str:
    if isinstance(value, str):
        return value
    return f"{value:g}" if isinstance(value, float) else "another table"


def comparison(again: Replay) -> str:
    """What is to be told of a recording flown again."""
    recording, rows = again.recording, len(again.recording)
    lines = [f"flown again  {again.model}, steps of {1e3 * again.step:g} ms, {rows} ticks"]
    if again.model == recording.header.model and again.step == recording.header.step:
        changed = changed_versions(recording.header)
        same = "identical to the last bit" if again.identical else "NOT identical"
        lines.append(f"replay       {same}{f' (here: {changed})' if changed else ''}")
    valid, comparable = again.valid, again.comparable
    lines.append(f"largest gap  {_gap(again, valid)}, within the limits of validity")
    if (comparable & ~valid).any():
        lines.append(f"beyond them  {_gap(again, comparable & ~valid)}")
    if not comparable.all():
        ticks = rows - int(comparable.sum())
        lines.append(f"not compared {ticks} ticks after a slack line or the ground")
    if again.note:
        lines.append(f"broke off    {again.note}")
    if not recording.ending:
        lines.append(f"recorded end {BROKEN_OFF}")
    return "\n".join(lines)


def _gap(again: Replay, rows: NDArray[np.bool_]) -> str:
    found = again.largest_gap(rows)
    if found is None:
        return "none: no tick was flown"
    gap, row = found
    return f"{1e6 * gap:.3g} µm at {again.recording.columns['t_s'][row]:.2f} s"
