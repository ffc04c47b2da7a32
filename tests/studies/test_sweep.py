"""Flights by the thousand, in small: none lost, none twice, the same on any executor."""

import errno
import gc
import json
import os
from concurrent.futures import BrokenExecutor, Future
from multiprocessing import active_children

import pyarrow.parquet as pq
import pytest

from kitemj.cli import main
from kitemj.errors import InputError
from kitemj.flight.compare import compare
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate
from kitemj.metadata import about_columns
from kitemj.studies import executors
from kitemj.studies import sweep as sweeping
from kitemj.studies.executors import dask_executor, local_executor
from kitemj.studies.flights import fly, fly_all
from kitemj.studies.journal import Journal
from kitemj.studies.study import read_study
from kitemj.studies.sweep import StudyStopped, sweep, tried_together

STUDY = """
reference = "newton-euler"
step = 0.01

[scenario]
duration = 3.0
output_interval = 0.1
steering = { programme = "sine", delta_frequency = 0.2 }

[grid]
model = ["mujoco", "lagrange"]
"wind.speed" = [0.0, 6.0, 8.0]
"steering.delta_amplitude_deg" = [2.0, 4.0, 6.0]
"""
FLIGHTS = 18
SMALL_COST = 0.2
"""s; makes batches of two flights."""


class HereExecutor:
    """Flies at once, in this process; dies of the flights it is told to."""

    workers, name, deaths = 1, "here", (BrokenExecutor,)

    def __init__(self, deadly=()):
        self.deadly, self.flown, self.renewed = set(deadly), [], 0

    def submit(self, base, flights):
        future = Future()
        numbers = [flight for flight, _ in flights]
        if self.deadly & set(numbers):
            future.set_exception(BrokenExecutor("gone"))
        else:
            self.flown += numbers
            future.set_result(fly_all(base, flights))
        return future

    def renew(self):
        self.renewed += 1


@pytest.fixture
def study(tmp_path):
    (tmp_path / "study.toml").write_text(STUDY)
    return read_study(tmp_path / "study.toml")


def flown(study, table, executor, tell=lambda done: None):
    """The rows of the finished table, without what they cost."""
    with Journal(table, study) as journal:
        sweep(journal, executor, SMALL_COST, tell)
        journal.write_table(table, overwrite=True)
    rows = pq.read_table(table).to_pylist()
    return [{k: v for k, v in row.items() if k != "cost_s"} for row in rows]


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    """The study flown with nothing in the way."""
    folder = tmp_path_factory.mktemp("plain")
    (folder / "study.toml").write_text(STUDY)
    return flown(read_study(folder / "study.toml"), folder / "a.parquet", HereExecutor())


def test_a_row_says_what_simulate_and_compare_say(study, plain):
    row = plain[8]
    tables, settings = study.base.at(study.design.point(8))
    scenario = scenario_of(tables, "x")
    flight = simulate(scenario, "mujoco", settings.step)
    reference = simulate(scenario, "newton-euler")
    pulls = [motion.tensions[0] for motion in flight.motions]
    betas = [motion.air.beta for motion in flight.motions]
    assert (row["wind.speed"], row["steering.delta_amplitude_deg"]) == (8.0, 6.0)
    assert row["ending"] == "finished"
    assert (row["tension_plus_min_N"], row["tension_plus_max_N"]) == (min(pulls), max(pulls))
    assert row["beta_max_deg"] == pytest.approx(max(betas) * 57.29577951308232)
    gap = compare(flight, reference).position.value
    assert row["gap_max_m"] == pytest.approx(gap, rel=1e-3)
    assert 0 < row["gap_max_m"] < 1e-4
    if flight.departure:
        assert row["departure_t_s"] == flight.departure.t
        assert row["departure"] == flight.departure.limit.name
    else:
        assert row["departure"] is None


def test_a_flight_that_fails_is_a_row_with_its_reason(plain):
    assert [row["flight"] for row in plain] == list(range(FLIGHTS))
    for row in plain:
        if row["wind.speed"] == 0.0:  # nothing holds the kite up, so there is no start
            assert row["ending"] == "failed"
            assert "wind" in row["reason"]
        else:
            assert row["ending"] == "finished"
            assert row["reason"] is None


def test_two_processes_make_the_same_table_though_one_is_killed(study, plain, tmp_path):
    killed = []

    def kill_one(done):
        if not killed:
            killed.append(active_children()[0])
            killed[0].kill()

    with local_executor(2) as executor:
        assert flown(study, tmp_path / "b.parquet", executor, kill_one) == plain
    assert killed


def test_dask_makes_the_same_table(study, plain, tmp_path):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None
        ) as cluster,
        dask_executor(cluster.scheduler_address) as executor,
    ):
        assert executor.workers == 2
        assert flown(study, tmp_path / "b.parquet", executor) == plain


@pytest.mark.parametrize("after", [1, 7, 13])
def test_an_interrupted_study_goes_on_where_it_was(study, plain, tmp_path, after):
    def interrupt(done):
        if done >= after:
            raise KeyboardInterrupt

    first, second = HereExecutor(), HereExecutor()
    with pytest.raises(KeyboardInterrupt):
        flown(study, tmp_path / "b.parquet", first, interrupt)
    assert not (tmp_path / "b.parquet").exists()
    assert flown(study, tmp_path / "b.parquet", second) == plain
    assert sorted(first.flown + second.flown) == list(range(FLIGHTS))


def test_a_line_cut_short_is_flown_again(study, plain, tmp_path):
    table = tmp_path / "b.parquet"
    with Journal(table, study) as journal:
        sweep(journal, HereExecutor(), SMALL_COST)
    lines = journal.path.read_bytes().splitlines(keepends=True)
    journal.path.write_bytes(b"".join(lines[:10]) + lines[10][:25])
    kept = [json.loads(line.rpartition(b" ")[0])["flight"] for line in lines[1:10]]
    executor = HereExecutor()
    assert flown(study, table, executor) == plain
    assert sorted(kept + executor.flown) == list(range(FLIGHTS))


DAMAGED = (
    *(bytes(512) + b"\n", b"what is this?\n", b"\n", b'{"flight": -1}\n', b'{"flight": 3}\n'),
    *(b'{"flight": 99, "ending": "finished"}\n', b"[" * 100_000 + b"\n", b"\xff\xfe\n"),
    b'{"flight": 3, "ending": "finished"} 00000000\n',
)


def test_a_damaged_line_is_passed_over_and_its_flight_flown_again(study, plain, tmp_path):
    table, executor, count = tmp_path / "b.parquet", HereExecutor(), len(DAMAGED) + 1
    with Journal(table, study) as journal:
        sweep(journal, HereExecutor(), SMALL_COST)
    first, *lines = journal.path.read_bytes().splitlines(keepends=True)
    changed = lines[0].replace(b'"flight": ', b'"flight": 1')
    journal.path.write_bytes(b"".join([first, *DAMAGED, changed, *lines[count:], lines[-1]]))
    with Journal(table, study) as again:
        assert (again.count, again.damaged) == (FLIGHTS - count, count)
    assert flown(study, table, executor) == plain
    assert len(executor.flown) == count


@pytest.mark.parametrize("content", [b"my notes\n", b"my notes", bytes(600), b"\x89PNG\r\n"])
def test_what_is_no_journal_is_a_persons_own(study, tmp_path, content):
    path = tmp_path / "b.parquet.journal"
    path.write_bytes(content)
    for anew in (False, True):
        with (
            pytest.raises(InputError, match="not a journal"),
            Journal(path.with_suffix(""), study, anew),
        ):
            pass
        assert path.read_bytes() == content


def test_a_link_in_the_journals_place_is_not_followed(study, tmp_path):
    (tmp_path / "mine").touch()
    (tmp_path / "b.parquet.journal").symlink_to("mine")
    with pytest.raises(InputError, match="not a journal"), Journal(tmp_path / "b.parquet", study):
        pass
    assert (tmp_path / "mine").read_bytes() == b""


def test_a_study_begun_anew_waits_for_nobody_and_takes_from_nobody(study, tmp_path):
    table = tmp_path / "b.parquet"
    row = fly(study.base, 0, study.design.point(0))
    with Journal(table, study) as first:
        first.add([row])
        with pytest.raises(InputError, match="another command is writing"):
            Journal(table, study, anew=True).__enter__()
        assert first.path.stat().st_size > 100
    with Journal(table, study, anew=True) as anew:
        assert anew.count == 0
    assert not anew.path.exists()


def test_a_disk_that_ends_keeps_the_flights_before(study, tmp_path, monkeypatch):
    rows = [fly(study.base, i, study.design.point(i)) for i in (0, 1)]
    write, room = os.write, iter([20])

    def full(file, data):
        for part in room:
            return write(file, data[:part])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with Journal(tmp_path / "b.parquet", study) as journal:
        journal.add(rows[:1])
        size = journal.path.stat().st_size
        monkeypatch.setattr(os, "write", full)
        with pytest.raises(OSError, match="No space left") as refused:
            journal.add(rows[1:])
        monkeypatch.undo()
    assert refused.value.filename == str(journal.path)
    assert (journal.count, journal.path.stat().st_size) == (1, size)
    with Journal(tmp_path / "b.parquet", study) as again:
        assert (again.count, again.damaged) == (1, 0)


def test_the_announced_time_is_of_workers_that_are_warm(study, tmp_path, monkeypatch):
    """The first flight of each worker takes long; what is announced does not count it."""
    clock = [0.0]

    class Slow(HereExecutor):
        workers = 2

        def submit(self, base, flights):
            clock[0] += 10.0 if len(self.flown) < self.workers else 0.5  # s
            return super().submit(base, flights)

    monkeypatch.setattr(sweeping, "perf_counter", lambda: clock[0])
    with Journal(tmp_path / "b.parquet", study) as journal:
        assert tried_together(journal, Slow()) == 0.5 * Slow.workers
        assert journal.count == 3 * Slow.workers


def test_a_flight_that_ends_its_process_is_found_and_named(study, plain, tmp_path):
    executor = HereExecutor(deadly=[7])
    rows = flown(study, tmp_path / "b.parquet", executor)
    assert rows[7]["ending"] == "failed"
    assert "died" in rows[7]["reason"]
    assert rows[:7] + rows[8:] == plain[:7] + plain[8:]
    assert executor.renewed == 2


def test_workers_that_cannot_work_end_the_study_with_a_sentence(study, tmp_path):
    class Useless(HereExecutor):
        def submit(self, base, flights):
            future = Future()
            future.set_exception(ModuleNotFoundError("No module named 'kitemj'"))
            return future

    with pytest.raises(StudyStopped, match=r"ModuleNotFoundError.*the same kitemj"):
        flown(study, tmp_path / "b.parquet", Useless())


def test_another_study_does_not_go_on_with_this_one_s_journal(study, tmp_path, capsys):
    with Journal(tmp_path / "b.parquet", study) as journal:
        journal.add([fly(study.base, 0, study.design.point(0))])
    (tmp_path / "other.toml").write_text(STUDY.replace("6.0, 8.0", "6.0, 9.0"))
    assert main(["sweep", str(tmp_path / "other.toml"), "--output", f"{tmp_path}/b.parquet"]) == 2
    assert "begun by another study" in capsys.readouterr().err


def test_two_commands_do_not_fly_one_study_at_once(study, tmp_path):
    with (
        Journal(tmp_path / "b.parquet", study),
        pytest.raises(InputError, match="another command is writing"),
        Journal(tmp_path / "b.parquet", study),
    ):
        pass


SHORT = '[scenario]\nduration = 0.2\n[grid]\n"wind.speed" = [6.0, 7.0, 8.0]\nmodel = ["lagrange"]\n'


def swept(tmp_path, text, *words):
    (tmp_path / "study.toml").write_text(text)
    return main(["sweep", f"{tmp_path}/study.toml", "--output", f"{tmp_path}/b.parquet", *words])


def test_the_command_flies_a_study_once(tmp_path, capsys):
    assert swept(tmp_path, SHORT, "--processes", "1") == 0
    assert "3 flights" in capsys.readouterr().out
    assert not (tmp_path / "b.parquet.journal").exists()
    told = about_columns(pq.read_schema(tmp_path / "b.parquet").metadata)
    assert told["holds"] == "flights of a study"
    assert told["scenario"] == {"set": "laksa", "duration": 0.2}
    assert swept(tmp_path, SHORT) == 0
    assert "is complete" in capsys.readouterr().out
    assert swept(tmp_path, SHORT.replace("8.0", "9.0")) == 2
    assert "exists" in capsys.readouterr().err


def test_a_full_disk_is_a_sentence(tmp_path, monkeypatch, capsys):
    def full(descriptor):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    assert swept(tmp_path, SHORT, "--processes", "1") == 74
    said = capsys.readouterr().err
    assert "b.parquet.journal: No space left" in said
    assert "nothing is left" in said
    assert [file.name for file in tmp_path.iterdir()] == ["study.toml"]
    monkeypatch.undo()
    assert swept(tmp_path, SHORT, "--processes", "1") == 0


def test_a_million_flights_are_asked_about(tmp_path, capsys):
    many = SHORT.replace("[6.0, 7.0, 8.0]", "{ from = 6.0, to = 8.0, count = 1000000 }")
    assert swept(tmp_path, many, "--processes", "1") == 2
    said = capsys.readouterr().err
    assert "999997 flights: about" in said
    assert "--yes" in said
    assert not (tmp_path / "b.parquet.journal").exists()


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("model", "modell", "modell is not known: did you mean 'model'?"),
        ("wind.speed", "wind.sped", "wind.sped is not known: did you mean 'speed'?"),
        ("wind.speed", "winde.speed", "winde is not known: did you mean 'wind'?"),
        ('["lagrange"]', '["lagrangian"]', "there is no model 'lagrangian'"),
        ("[6.0, 7.0, 8.0]", "[]", "grid.wind.speed is empty"),
        ("[6.0, 7.0, 8.0]", '["strong"]', "wind.speed must be a number in m/s, got 'strong'"),
        ("[scenario]", "step = 3.0\n[scenario]", "step must be <= 0.1 s, got 3.0 s"),
        ("[scenario]\n", 'scenario = "no.toml"\n#', "cannot read"),
    ],
)
def test_bad_studies_are_a_sentence_each(tmp_path, capsys, old, new, says):
    assert swept(tmp_path, SHORT.replace(old, new).replace("#duration = 0.2", "")) == 2
    said = capsys.readouterr().err
    assert says in said
    assert said.count("\n") == 1
    assert list(tmp_path.glob("b.parquet*")) == []


def test_a_scheduler_that_does_not_answer_is_a_sentence(tmp_path, monkeypatch, capsys):
    client = pytest.importorskip("distributed").Client
    monkeypatch.setattr(executors, "PATIENCE", 1)
    for address in ("tcp://127.0.0.1:9", "nonsense", "tls://127.0.0.1:9", "http://127.0.0.1:9"):
        assert swept(tmp_path, SHORT, "--scheduler", address) == 2
        said = capsys.readouterr().err
        assert f"no Dask scheduler answers at {address}" in said
        assert said.count("\n") == 1
    assert [file.name for file in tmp_path.iterdir()] == ["study.toml"]
    clients = [each for each in gc.get_objects() if type(each) is client]
    # one that is half there cries when the program ends
    assert [each for each in clients if each.status != "closed"] == []


def test_rows_keep_every_digit_on_their_way_through_the_journal(study):
    row = fly(study.base, 16, study.design.point(16))
    assert json.loads(json.dumps(row)) == row
