"""What a recording holds, in lines for people."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.parameter_files import parameter_set, set_names
from kitemj.recording.file import Recording
from kitemj.recording.header import parameter_tables, present_versions
from kitemj.recording.replay import Replay

BROKEN_OFF = "unknown: the file breaks off (the program was stopped, or the disk was full)"


def summary(recording: Recording) -> str:
    """All that `kitemj info` prints."""
    header = recording.header
    rows, size = len(recording), recording.path.stat().st_size / 1e6
    beside = f"beside {header.reference}" if header.reference else "alone"
    seeds = ", ".join(f"{name} {seed}" for name, seed in header.seeds.items())
    lines = [
        ("recording", f"{recording.path}, {size:.1f} MB, written {header.written}"),
        ("scenario", header.scenario),
        ("model", f"{header.model} {beside}, steps of {1e3 * header.step:g} ms"),
        ("parameters", parameters_in_words(header.parameters)),
        ("seeds", seeds or "none: nothing in the flight is random"),
        ("versions", ", ".join(f"{name} {number}" for name, number in header.versions.items())),
    ]
    changed = changed_versions(header.versions)
    if changed:
        lines.append(("", f"other than here ({changed}): a replay may differ in its last digits"))
    lines.append(("held", f"{rows} ticks of {1e3 * header.tick:g} ms, {_count(recording)}"))
    for number, episode in enumerate(recording.episodes, start=1):
        lines += [(f"flight {number}", text) for text in _episode(recording, episode)]
    lines.append(("real time", _timekeeping(recording)))
    lines.append(("ended", recording.ending or BROKEN_OFF))
    return "\n".join(f"{name:<12} {text}" for name, text in lines)


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


def changed_versions(versions: dict[str, str]) -> str:
    """What is installed here in another version than that of the recording."""
    here = present_versions()
    return ", ".join(f"{name} {here[name]}" for name in here if versions.get(name) != here[name])


def _count(recording: Recording) -> str:
    flights = len(recording.episodes)
    return "one flight" if flights == 1 else f"{flights} flights, a restart between each"


def _episode(recording: Recording, episode: slice) -> list[str]:
    """How long, how far from the reference, how close to each limit, where it left them."""
    columns = {name: values[episode] for name, values in recording.columns.items()}
    limits = recording.parameters.limits
    alpha, beta = columns["alpha_deg"], columns["beta_deg"]
    pulls = np.stack([columns["tension_plus_N"], columns["tension_minus_N"]]) + 0.0
    followed = np.isfinite(columns["gap_m"])
    reference = "not followed by the reference"
    if followed.any():
        gap, until = np.nanmax(columns["gap_m"]), columns["t_s"][followed][-1]
        reference = f"at most {1e6 * gap:.3g} µm from the reference (followed to {until:.2f} s)"
    departure = recording.departure(episode)
    left = "within all limits of validity throughout"
    if departure:
        row, reason = departure
        left = f"left the limits of validity at {recording.columns['t_s'][row]:.2f} s: {reason}"
    return [
        f"{columns['t_s'][-1]:.2f} s, {reference}",
        f"α {alpha.min():.2f}° to {alpha.max():.2f}° (0° to {np.degrees(limits.alpha_stall):g}°), "
        f"β {beta.min():.2f}° to {beta.max():.2f}° (±{np.degrees(limits.beta_max):g}°), lines "
        f"{pulls.min():.1f} N to {pulls.max():.1f} N (0 N to {limits.tension_max:g} N)",
        left,
    ]


def _timekeeping(recording: Recording) -> str:
    flown = recording.columns["tick"] > 0
    late = recording.columns["lateness_s"][flown]
    if not len(late):
        return "no tick was flown"
    missed = int((late > recording.header.tick).sum())
    return (
        f"{missed} of {len(late)} ticks missed, lateness median {1e3 * np.median(late):.2f} ms, "
        f"worst {1e3 * late.max():.1f} ms"
    )


def _number(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else "another table"


def comparison(again: Replay) -> str:
    """What is to be told of a recording flown again."""
    recording, rows = again.recording, len(again.recording)
    lines = [f"flown again  {again.model}, steps of {1e3 * again.step:g} ms, {rows} ticks"]
    if again.model == recording.header.model and again.step == recording.header.step:
        changed = changed_versions(recording.header.versions)
        same = "identical to the last bit" if again.identical else "NOT identical"
        lines.append(f"replay       {same}{f' (here: {changed})' if changed else ''}")
    valid, comparable = again.valid, again.comparable
    lines.append(f"largest gap  {_gap(again, valid)}, within the limits of validity")
    if (comparable & ~valid).any():
        lines.append(f"beyond them  {_gap(again, comparable & ~valid)}")
    if not comparable.all():
        ticks = rows - int(comparable.sum())
        lines.append(f"not compared {ticks} ticks after a slack line or the ground (kitemj info)")
    if again.note:
        lines.append(f"broke off    {again.note}")
    return "\n".join(lines)


def _gap(again: Replay, rows: NDArray[np.bool_]) -> str:
    found = again.largest_gap(rows)
    if found is None:
        return "none: no tick was flown"
    gap, row = found
    return f"{1e6 * gap:.3g} µm at {again.recording.columns['t_s'][row]:.2f} s"
