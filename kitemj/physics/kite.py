"""The rigid kite and its two lines, in numbers."""

from typing import Annotated, NamedTuple

from kitemj.physics.quantity import Quantity


class Kite(NamedTuple):
    """The rigid kite about its centre of mass G, in the body frame B."""

    mass: Annotated[float, Quantity("kg", "mass of the kite", gt=0)]
    inertia_x: Annotated[float, Quantity("kg m²", "I_x about G", gt=0)]
    inertia_y: Annotated[float, Quantity("kg m²", "I_y about G", gt=0)]
    inertia_z: Annotated[float, Quantity("kg m²", "I_z about G", gt=0)]
    inertia_xz: Annotated[float, Quantity("kg m²", "I_xz; the tensor holds -I_xz")]
    chord: Annotated[float, Quantity("m", "mean chord, c", gt=0)]
    span: Annotated[float, Quantity("m", "span, b", gt=0)]
    area: Annotated[float, Quantity("m²", "reference area, S", gt=0)]
    x_A: Annotated[float, Quantity("m", "attachments ahead of G, X_A")]
    y_A: Annotated[float, Quantity("m", "half the distance between attachments, Y_A", gt=0)]
    z_A: Annotated[float, Quantity("m", "attachments below G, Z_A")]


class Lines(NamedTuple):
    """The two lines: massless, straight, inextensible; they only pull, unless `rigid`.

    Models in minimal coordinates always have rigid lines; the flag makes the MuJoCo kite's
    push as well, to be held against such models where a line would be slack.
    """

    length: Annotated[float, Quantity("m", "length of each line at δ = 0, L₀", gt=0)]
    rigid: Annotated[bool, Quantity("", "true: lines that push as well as pull")] = False
