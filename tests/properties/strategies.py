"""Where hypothesis looks: states of flight, hands, airs; all finite, within stated bounds."""

from hypothesis import strategies as st

from kitemj.dynamics.motion import State
from kitemj.physics.frames import Angles
from kitemj.physics.steering import Control, Segment
from kitemj.physics.vectors import Vector
from tests.support import KITES, rest


def number(low: float, high: float):
    return st.floats(low, high)


def vectors(size: float):
    return st.builds(Vector, *[number(-size, size)] * 3)


kites = st.sampled_from(list(KITES.values()))

# rad and rad/s; γ keeps off ±90°, where φ has no meaning
states = st.builds(
    State,
    st.builds(Angles, number(-3.1, 3.1), number(-0.8, 1.3), number(-1.0, 1.0), number(-1.5, 1.5)),
    st.builds(Angles, *[number(-1.0, 1.0)] * 4),
)


@st.composite
def hands(draw, parameters):
    """Control at t = 0: ℓ within 20 % of ℓ₀, |ℓ̇| to 2 m/s, |ℓ̈| to 3 m/s², |δ| to 0.5 rad."""
    ell = rest(parameters) * draw(number(0.8, 1.2))
    reel = draw(number(-2.0, 2.0)), draw(number(-3.0, 3.0))
    swing = draw(number(-0.5, 0.5)), draw(number(-0.5, 0.5)), draw(number(-2.0, 2.0))
    return Segment(0.0, Control(ell, *reel, *swing))
