"""What no flight leaves behind is refused in a sentence: headers, columns, rows."""

import json

import numpy as np
import pyarrow as pa
import pytest

from kitemj.errors import InputError
from kitemj.recording.file import read_recording
from tests.recording.flights import SPORT, recorded


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    """Two flights of 20 ticks."""
    path = recorded(tmp_path_factory.mktemp("schema") / "kite.arrows", 20, SPORT, episodes=2)
    return pa.ipc.open_stream(path.read_bytes()).read_all()


@pytest.fixture
def refusal(tmp_path):
    def refused(table):
        path = tmp_path / "bad.arrows"
        with pa.ipc.new_stream(str(path), table.schema) as stream:
            stream.write_table(table)
        with pytest.raises(InputError) as told:
            read_recording(path)
        assert "\n" not in str(told.value)
        return str(told.value)

    return refused


def with_header(table, change):
    header = json.loads(table.schema.metadata[b"kitemj"])
    change(header)
    return table.replace_schema_metadata({b"kitemj": json.dumps(header).encode()})


def with_column(table, name, values):
    column = pa.array(values)
    field = pa.field(name, column.type)
    return table.set_column(table.column_names.index(name), field, column)


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("step", "0.002", "step: Input should be a valid number"),
        ("step", 1e-12, "step: Input should be greater than or equal to 0.000001, got 1e-12"),
        ("tick", float("nan"), "tick: Input should be a finite number"),
        ("tick", 0.02, r"in row 2 t_s is not that of its tick of 20 ms"),
        ("starts", [], "starts: List should have at least 1 item"),
        ("starts", [[[0.0] * 4, [0.0] * 3]], "starts.0.1: List should have at least 4 items"),
        ("parameters", {"kite": []}, "parameters.kite: Input should be an object"),
        ("parameters", {}, "it lacks what its kite is"),
        ("versions", [], "has no header that can be read"),
        ("format", "2", "format must be a whole number"),
        ("seeds", {"a": "b"}, "seeds.a: Input should be a valid integer"),
        ("colour", "red", "colour: Unexpected"),
    ],
)
def test_a_header_of_wrong_values(table, refusal, field, value, says):
    told = refusal(with_header(table, lambda header: header.update({field: value})))
    assert says in told


def test_a_number_that_a_header_lacks_is_not_that_of_another_kite(table, refusal):
    def forget(header):
        del header["parameters"]["kite"]["mass"]

    assert refusal(with_header(table, forget)).endswith("does not say kite.mass: it is damaged")


def test_columns_of_wrong_types_and_numbers(table, refusal):
    tick, x = table["tick"].to_numpy(), table["x_E_m"].to_numpy()
    told = refusal(with_column(table, "tick", tick.astype(str)))
    assert "its column tick holds string, where int32 must be" in told
    assert "holds int64, where int32" in refusal(with_column(table, "tick", tick.astype(np.int64)))
    says = "x_E_m in row 7 is no number that a flight has"
    for number in (np.nan, np.inf, 1e308):
        broken = np.where(np.arange(len(x)) == 6, number, x)
        assert says in refusal(with_column(table, "x_E_m", broken))
    gaps = pa.array(np.append(tick[:-1], 0).astype(np.int32), mask=np.arange(len(tick)) == 3)
    assert "tick in row 4 is no number" in refusal(with_column(table, "tick", gaps))
    twice = table.append_column(table.schema.field("tick"), table["tick"])
    assert "two columns tick" in refusal(twice)
    assert "lacks the column ell_m" in refusal(table.drop_columns(["ell_m"]))
    laws = np.where(tick == 2, 7.0, 0.0)
    assert "row 3 stick_law is none of 0, 1, 2" in refusal(with_column(table, "stick_law", laws))
    hands = np.where(tick == 2, 1.5, np.nan)
    assert "row 3 assist_hand is not in" in refusal(with_column(table, "assist_hand", hands))
    assert "row 1 R_BE is no rotation" in refusal(with_column(table, "R_BE_xx", 2.0 * x))
    assert "ref_R_BE is no rotation" in refusal(with_column(table, "ref_R_BE_xx", 2.0 * x))
    half = np.where(np.arange(len(x)) == 6, np.nan, table["ref_y_E_m"].to_numpy())
    assert "row 7 half a reference stands" in refusal(with_column(table, "ref_y_E_m", half))


def test_rows_that_do_not_follow_one_another(table, refusal):
    rows = np.arange(len(table))
    told = refusal(table.take(rows[5:]))
    assert "goes on from flight 1, which must be an earlier one" in told
    assert "row 4, leg 0, tick 4, does not follow" in refusal(table.take(np.delete(rows, 3)))
    assert "does not follow" in refusal(table.take(rows[::-1]))
    assert "does not follow" in refusal(table.take(np.roll(rows, 21)))
    assert "does not follow" in refusal(table.take(np.random.default_rng(1).permutation(rows)))


@pytest.mark.parametrize("parent", [-1, 1, 2])
def test_a_flight_that_is_its_own_parent(table, refusal, parent):
    on = table.take(np.delete(np.arange(len(table)), np.arange(21, 26)))  # begins at tick 5
    parents = np.where(on["leg"].to_numpy() == 1, parent, 0).astype(np.int32)
    told = refusal(with_column(on, "parent", parents))
    assert f"flight 2 goes on from flight {parent + 1}, which must be an earlier one" in told


def test_a_moment_or_a_start_that_there_is_not(table, refusal):
    on = table.take(np.delete(np.arange(len(table)), [*range(5, 21), *range(21, 31)]))
    parents = np.zeros(len(on), np.int32)
    told = refusal(with_column(on, "parent", parents))
    assert "flight 2 goes on from tick 10 of flight 1, which has ticks 0 to 4" in told
    starts = np.ones(len(table), np.int32)
    assert "row 1 has start 1, the header has starts 0 to 0" in refusal(
        with_column(table, "start", starts)
    )
