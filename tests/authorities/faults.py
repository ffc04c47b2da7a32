"""Faults of what all formulations share, each with the authority that must notice it."""

from typing import NamedTuple


class Fault(NamedTuple):
    """What stands in a module, what is put in its place, and who must notice ("file:function")."""

    what: str
    module: str
    right: str
    wrong: str
    test: str


AERO, WIND = "physics.aerodynamics", "physics.wind"
HEIGHTS = "test_wind:test_the_wind_at_every_height_of_a_published_table"
GUSTS = "test_wind:test_gusts_come_at_every_height_at_once"
TURNED = "test_wind:test_the_wind_turns_as_phi_turns"
NAVION = "test_coefficients:test_a_table_has_the_dimensional_derivatives_of_a_published_airplane"
SUMS = "test_coefficients:test_every_number_of_a_table_is_at_its_place"
KITESURF = "test_coefficients:test_forces_and_moments_of_laksa_s_four_line_kite"
TRIANGLES = "test_hands:test_lines_are_sides_of_triangles"
CIRCLES = "test_hands:test_lines_move_as_points_on_circles_do"
THROW = "test_hands:test_a_tick_is_a_throw"
QUICKEST = "test_hands:test_the_quickest_way_has_the_times_of_the_textbook"
LAWS = "test_hands:test_each_law_is_a_motion_of_the_textbook"
HANDS = "test_hands:test_hands_pull_their_own_lines"
CURVE = "test_hands:test_dead_zone_and_curve_by_hand"
LIMITS = "test_limits:test_each_limit_at_the_numbers_of_its_file"
PARTS = "test_limits:test_how_much_of_each_limit_is_taken_up"
CORNER = "test_limits:test_the_kite_touches_with_its_lowest_corner"
BEARINGS = "test_cockpit:test_bearings_of_right_angled_triangles"
WINDOW = "test_cockpit:test_the_wind_window_is_a_protractor"
PINHOLE = "test_cockpit:test_pixels_of_a_pinhole"
VIEWS = "test_cockpit:test_views_show_what_is_left_on_the_left"
ORBIT = "test_cockpit:test_an_orbit_is_a_sphere_about_the_kite"
NOSE = "test_cockpit:test_the_nose_is_a_clock_s_hand"
PANELS = "test_cockpit:test_panels_say_the_numbers_in_the_units_that_they_name"
TOUCH = "test_cockpit:test_a_touch_is_a_thrown_body"
COLUMNS = "test_columns:test_every_column_holds_what_its_name_says"
BEYOND = "test_columns:test_limits_of_columns_are_those_of_the_file"
HALFWAY = "test_columns:test_halfway_between_two_ticks_is_where_a_throw_is"
ENERGY = "test_columns:test_energy_of_a_spinning_plate"
BARS = "test_cockpit:test_bars_of_tensions_show_half_at_a_quarter"
ARROW = "test_cockpit:test_the_arrow_of_the_wind_and_a_slack_line"
READ = "test_columns:test_what_is_read_from_columns_is_what_was_flown"
FIGURES = "test_columns:test_figures_are_in_the_units_of_their_axes"

EYES = "test_scene:test_eyes_turn_to_a_kite_aside"
OSCILLATOR = "test_scene:test_an_eye_is_the_oscillator_of_the_textbook"
PULLED = "test_scene:test_the_hand_whose_line_is_short_is_back"
PORT = "test_scene:test_port_is_red"
BELLIES = "test_scene:test_a_sail_bellies_to_leeward"
GNOMON = "test_scene:test_a_shadow_is_that_of_a_gnomon"
VANE = "test_scene:test_what_the_wind_moves_goes_to_leeward"

FAULTS = [
    Fault(
        "shear clamped below the reference height",
        WIND,
        "max(height, 0.0)",
        "max(height, wind.reference_height)",
        HEIGHTS,
    ),
    Fault(
        "shear with the inverse exponent",
        WIND,
        "wind.exponent)",
        "-wind.exponent)",
        HEIGHTS,
    ),
    Fault(
        "the gust's phase multiplied by the shear",
        WIND,
        "sin(wind.gust_frequency * t)",
        "sin(wind.gust_frequency * t * shear)",
        GUSTS,
    ),
    Fault(
        "the gust's frequency taken for hertz",
        WIND,
        "sin(wind.gust_frequency * t)",
        "sin(6.283185307179586 * wind.gust_frequency * t)",
        GUSTS,
    ),
    Fault(
        "gusts that do not grow with height",
        WIND,
        "shear * (1 + wind.gust_amplitude * sin(wind.gust_frequency * t))",
        "(shear + wind.gust_amplitude * sin(wind.gust_frequency * t))",
        GUSTS,
    ),
    Fault(
        "the wind turned the wrong way",
        WIND,
        "-V * sin(wind.azimuth)",
        "V * sin(wind.azimuth)",
        TURNED,
    ),
    Fault(
        "q̂ of a table without its ½",
        AERO,
        "kite.chord * omega_B.y / (2 * airspeed)",
        "kite.chord * omega_B.y / airspeed",
        NAVION,
    ),
    Fault(
        "p̂ of a table by the chord",
        AERO,
        "p_hat = kite.span * omega_B.x / (2 * airspeed)",
        "p_hat = kite.chord * omega_B.x / (2 * airspeed)",
        NAVION,
    ),
    Fault(
        "r̂ of a table of the wrong rate",
        AERO,
        "r_hat = kite.span * omega_B.z / (2 * airspeed)",
        "r_hat = kite.span * omega_B.x / (2 * airspeed)",
        NAVION,
    ),
    Fault(
        "α² of a table taken for α",
        AERO,
        "row[i][1] + alpha * row[i][2]",
        "row[i][1] + row[i][2]",
        SUMS,
    ),
    Fault(
        "control surfaces in the wrong order",
        AERO,
        "*aero.surfaces",
        "*aero.surfaces[::-1]",
        SUMS,
    ),
    Fault(
        "q̂ of the linear law with a ½",
        AERO,
        "kite.chord * omega_B.y / aero.V_ref",
        "kite.chord * omega_B.y / (2 * aero.V_ref)",
        KITESURF,
    ),
    Fault(
        "r̂ of the linear law by the airspeed",
        AERO,
        "omega_B.z / (2 * aero.V_ref)",
        "omega_B.z / (2 * airspeed)",
        KITESURF,
    ),
    Fault(
        "C_nβ and C_lβ exchanged",
        AERO,
        "aero.Cl_beta * beta + aero.Cl_p",
        "aero.Cn_beta * beta + aero.Cl_p",
        KITESURF,
    ),
    Fault(
        "the moment of yaw by the chord",
        "physics.loads",
        "qS * size.span * C.n",
        "qS * size.chord * C.n",
        NAVION,
    ),
    Fault(
        "β against the air from ahead alone",
        "physics.loads",
        "asin(max(-1.0, min(1.0, v_B.y / speed)))",
        "atan2(v_B.y, v_B.x)",
        KITESURF,
    ),
    Fault(
        "the cosine rule without its 2",
        "physics.steering",
        "2 * y * c.ell * s)",
        "y * c.ell * s)",
        TRIANGLES,
    ),
    Fault(
        "δ of half the difference",
        "physics.steering",
        "(4 * sqrt(max(ell_squared, 1e-300)) * y_A)",
        "(8 * sqrt(max(ell_squared, 1e-300)) * y_A)",
        TRIANGLES,
    ),
    Fault(
        "the pull inwards of a turning attachment dropped",
        "physics.steering",
        "c.delta_ddot * k - c.delta_dot * c.delta_dot * s",
        "c.delta_ddot * k",
        CIRCLES,
    ),
    Fault(
        "a tick without the ½ of ½ a t²",
        "physics.steering",
        "c.ell + s * (c.ell_dot + 0.5 * s * c.ell_ddot)",
        "c.ell + s * (c.ell_dot + s * c.ell_ddot)",
        THROW,
    ),
    Fault(
        "reeling pushed as fast as δ may be",
        "physics.shaping",
        "wish.max_acceleration = [limits.delta_ddot, limits.ell_ddot]\n    try",
        "wish.max_acceleration = [limits.delta_ddot, limits.delta_ddot]\n    try",
        QUICKEST,
    ),
    Fault(
        "twice the way of ℓ allowed",
        "physics.shaping",
        "_within(ell - ell_rest, limits.ell)",
        "_within(ell - ell_rest, 2 * limits.ell)",
        QUICKEST,
    ),
    Fault(
        "the stick's rate in parts of δ",
        "physics.shaping",
        "rate = stick * limits.delta_dot",
        "rate = stick * limits.delta",
        LAWS,
    ),
    Fault(
        "the stick's acceleration twice as large",
        "physics.shaping",
        "stick * limits.delta_ddot * tick",
        "stick * limits.delta_ddot * 2 * tick",
        LAWS,
    ),
    Fault(
        "the left hand on the right line",
        "controls.stick_mapping",
        "length - limits.arm * left, length - limits.arm * right",
        "length - limits.arm * right, length - limits.arm * left",
        HANDS,
    ),
    Fault(
        "what remains beside the dead zone not stretched",
        "controls.stick_mapping",
        "/ (1 - dead_zone)",
        "/ 1",
        CURVE,
    ),
    Fault(
        "a right line that may carry anything",
        "flight.limits",
        "pull <= limits.tension_max for pull in now.tensions",
        "pull <= limits.tension_max for pull in now.tensions[:1]",
        LIMITS,
    ),
    Fault(
        "stall in degrees of a limit in rad",
        "flight.limits",
        "(now.alpha < limits.alpha_stall)",
        "(degrees(now.alpha) < limits.alpha_stall)",
        LIMITS,
    ),
    Fault(
        "sideslip to one side only",
        "flight.limits",
        "abs(now.beta) < limits.beta_max",
        "now.beta < limits.beta_max",
        LIMITS,
    ),
    Fault(
        "turns of the lines told in rad",
        "flight.limits",
        "{abs(now.twist) / tau:.1f} turns",
        "{abs(now.twist):.1f} turns",
        LIMITS,
    ),
    Fault(
        "the least pull in place of the largest",
        "flight.limits",
        "np.max(now.tensions, axis=0)",
        "np.min(now.tensions, axis=0)",
        PARTS,
    ),
    Fault(
        "a steep kite not looked for on the ground",
        "flight.limits",
        "-p.z < kite.span + kite.chord",
        "-p.z < kite.chord",
        CORNER,
    ),
    Fault(
        "span and chord of the hull exchanged",
        "dynamics.ground",
        "Vector(a * chord, b * span, c)",
        "Vector(a * span, b * chord, c)",
        CORNER,
    ),
    Fault(
        "the product of inertia with the wrong sign in the energy",
        "dynamics.motion",
        "- 2 * kite.inertia_xz",
        "+ 2 * kite.inertia_xz",
        ENERGY,
    ),
    Fault(
        "azimuth positive to the right",
        "drawing.wind_window",
        "degrees(np.arctan2(left, ahead))",
        "degrees(np.arctan2(-left, ahead))",
        BEARINGS,
    ),
    Fault(
        "elevation above the way downwind",
        "drawing.wind_window",
        "np.arctan2(-p_E.z, hypot(ahead, left))",
        "np.arctan2(-p_E.z, ahead)",
        BEARINGS,
    ),
    Fault(
        "left and right of the wind window exchanged",
        "drawing.wind_window",
        "return x - RADIUS * away * left / flat",
        "return x + RADIUS * away * left / flat",
        WINDOW,
    ),
    Fault(
        "the window's rim at 180°",
        "drawing.wind_window",
        "acos(min(max(ahead, -1.0), 1.0)) / (pi / 2)",
        "acos(min(max(ahead, -1.0), 1.0)) / pi",
        WINDOW,
    ),
    Fault(
        "the angle of view across",
        "scene.views",
        "height / 2 / tan(camera.field / 2)",
        "width / 2 / tan(camera.field / 2)",
        PINHOLE,
    ),
    Fault(
        "pictures half a pixel aside",
        "scene.views",
        "column = width / 2 - 0.5",
        "column = width / 2",
        PINHOLE,
    ),
    Fault(
        "cameras that turn against the wind",
        "scene.views",
        "Vector(-cos(azimuth), -sin(azimuth), 0.0)",
        "Vector(-cos(azimuth), sin(azimuth), 0.0)",
        BEARINGS,
    ),
    Fault(
        "the side view from the left",
        "scene.views",
        "times(1.5 * L, cross(wind, UP))",
        "times(1.5 * L, cross(UP, wind))",
        VIEWS,
    ),
    Fault(
        "the orbit goes round to the left",
        "scene.views",
        "times(sin(orbit.azimuth), right)",
        "times(-sin(orbit.azimuth), right)",
        ORBIT,
    ),
    Fault(
        "turning with the sign of z_B",
        "pilots.sight",
        "-motion.body.omega_B.z)",
        "motion.body.omega_B.z)",
        NOSE,
    ),
    Fault(
        "the pilot's elevation above the way downwind",
        "pilots.sight",
        "atan2(-p.z, hypot(p.x, p.y))",
        "atan2(-p.z, -p.x)",
        NOSE,
    ),
    Fault(
        "twist of the lines backwards",
        "drawing.history",
        "atan2(dot(cross(reference, across), u)",
        "atan2(-dot(cross(reference, across), u)",
        NOSE,
    ),
    Fault(
        "an angle of the air told in rad",
        "drawing.flight_panels",
        'f"{degrees(angle):.1f}°"',
        'f"{angle:.1f}°"',
        PANELS,
    ),
    Fault(
        "the height told as z_E",
        "drawing.flight_panels",
        'f"{-motion.body.p_G_E.z:.1f} m"',
        'f"{motion.body.p_G_E.z:.1f} m"',
        PANELS,
    ),
    Fault(
        "δ told in rad",
        "drawing.knob",
        "δ {degrees(delta):+.2f}°",
        "δ {delta:+.2f}°",
        PANELS,
    ),
    Fault(
        "twist to the left told as right",
        "drawing.flight_panels",
        "{'right' if turns > 0 else 'left'}",
        "{'left' if turns > 0 else 'right'}",
        PANELS,
    ),
    Fault(
        "half of the energy in the hardness of a touch",
        "pilots.crash",
        "sqrt(2 * moving / kite.mass)",
        "sqrt(moving / kite.mass)",
        TOUCH,
    ),
    Fault(
        "height counted as energy of motion",
        "pilots.crash",
        "energy(parameters, free) + weight * free.p_G_E.z",
        "energy(parameters, free) - weight * free.p_G_E.z",
        TOUCH,
    ),
    Fault(
        "a sinking kite that rises",
        "pilots.crash",
        "        velocity.z,\n",
        "        -velocity.z,\n",
        TOUCH,
    ),
    Fault(
        "the place of a touch turned against the wind",
        "pilots.crash",
        "s, c = sin(parameters.wind.azimuth)",
        "s, c = -sin(parameters.wind.azimuth)",
        TOUCH,
    ),
    Fault(
        "β in rad in the column of degrees",
        "flight.motion_table",
        "degrees(motion.air.beta)]",
        "motion.air.beta]",
        COLUMNS,
    ),
    Fault(
        "tensions of left and right exchanged in tables",
        "flight.motion_table",
        "*motion.tensions, *motion.lengths",
        "*motion.tensions[::-1], *motion.lengths",
        COLUMNS,
    ),
    Fault(
        "velocity and rates exchanged in recordings",
        "recording.table",
        "*R.z, *v, *omega, motion",
        "*R.z, *omega, *v, motion",
        COLUMNS,
    ),
    Fault(
        "β of a recording decided in degrees",
        "recording.table",
        'np.radians(columns["beta_deg"])',
        'columns["beta_deg"]',
        BEYOND,
    ),
    Fault(
        "the cubic between ticks bent the wrong way",
        "recording.track",
        "(1 - s) * v - s * w",
        "(1 - s) * v + s * w",
        HALFWAY,
    ),
    Fault(
        "δ drawn in rad",
        "plots.series",
        "(np.degrees(delta), ell)",
        "(delta, ell)",
        FIGURES,
    ),
    Fault(
        "α_stall drawn in rad",
        "plots.series",
        "degrees(limits.alpha_stall)",
        "limits.alpha_stall",
        FIGURES,
    ),
    Fault(
        "figures with azimuth to the left",
        "plots.window",
        "np.arctan2(right, ahead)",
        "np.arctan2(-right, ahead)",
        FIGURES,
    ),
    Fault(
        "degrees of a file read as rad",
        "physics.checked",
        "return radians(value) if",
        "return value if",
        LIMITS,
    ),
    Fault(
        "α of a recording read as rad",
        "recording.track",
        "Air(radians(alpha), radians(beta), speed)",
        "Air(alpha, radians(beta), speed)",
        READ,
    ),
    Fault(
        "lines drawn as at the start of their tick",
        "recording.track",
        "self._control(row, 1.0 if self._ticks[row] else 0.0)",
        "self._control(row, 0.0)",
        READ,
    ),
    Fault(
        "the place of a touch told in rad",
        "pilots.crash",
        "round(abs(degrees(self.azimuth)))",
        "round(abs(self.azimuth))",
        TOUCH,
    ),
    Fault(
        "names of the tensions exchanged",
        "drawing.tensions",
        'names = ("left", "right",',
        'names = ("right", "left",',
        PANELS,
    ),
    Fault(
        "lateness told in seconds",
        "drawing.strip_chart",
        "{1e3 * lateness:.1f} ms",
        "{lateness:.1f} ms",
        PANELS,
    ),
    Fault(
        "an arrow against the wind",
        "scene.scene",
        "return tail, plus(tail, times(1.2 * span, wind))",
        "return tail, plus(tail, times(-1.2 * span, wind))",
        ARROW,
    ),
    Fault(
        "a slack line that hangs by too little",
        "scene.lines",
        "sqrt(max(0.375 * distance * (length - distance), 0.0))",
        "sqrt(max(0.0375 * distance * (length - distance), 0.0))",
        ARROW,
    ),
    Fault(
        "bars that grow with the tension",
        "drawing.tensions",
        "sqrt(max(tension, 0.0) / self.full)",
        "max(tension, 0.0) / self.full",
        BARS,
    ),
    Fault(
        "reeling as fast as δ may be",
        "physics.shaping",
        "wish.max_velocity = [fastest, reel]",
        "wish.max_velocity = [fastest, limits.delta_dot]",
        QUICKEST,
    ),
    Fault(
        "the airspeed in km/h",
        "drawing.flight_panels",
        'f"{motion.air.speed:.1f} m/s"',
        'f"{3.6 * motion.air.speed:.1f} m/s"',
        PANELS,
    ),
    Fault(
        "eyes that turn away from the kite",
        "scene.views",
        "dot(p_E, cross(wind, UP)) / size",
        "dot(p_E, cross(UP, wind)) / size",
        EYES,
    ),
    Fault(
        "an eye with half its lag",
        "scene.eye",
        "lag = 2 * (1 - lead)",
        "lag = (1 - lead)",
        OSCILLATOR,
    ),
    Fault(
        "an eye that is not critically damped",
        "scene.eye",
        "pull, fade = closing + rate * gap",
        "pull, fade = closing + 0.5 * rate * gap",
        OSCILLATOR,
    ),
    Fault(
        "the hand goes out to pull",
        "scene.figure",
        "tanh((length - parameters.lines.length) / ARM)",
        "tanh((parameters.lines.length - length) / ARM)",
        PULLED,
    ),
    Fault(
        "a stunt kite with its colours exchanged",
        "scene.stunt",
        "np.where(left[..., None], RED, BLUE)",
        "np.where(left[..., None], BLUE, RED)",
        PORT,
    ),
    Fault(
        "a parafoil with its colours exchanged",
        "scene.foil",
        "np.where((number > 0)[..., None], RED, BLUE)",
        "np.where((number > 0)[..., None], BLUE, RED)",
        PORT,
    ),
    Fault(
        "a sail that bellies into the wind",
        "scene.stunt",
        "points[:, 2] -= plan.span",
        "points[:, 2] += plan.span",
        BELLIES,
    ),
    Fault(
        "left and right exchanged before a pilot's eyes",
        "drawing.head_up",
        '"LR"[side]',
        '"RL"[side]',
        PANELS,
    ),
    Fault(
        "a pilot's airspeed told in km/h",
        "drawing.head_up",
        'f"{motion.air.speed:.1f}"',
        'f"{3.6 * motion.air.speed:.1f}"',
        PANELS,
    ),
    Fault(
        "a shadow on the side of the sun",
        "scene.shadow",
        "points[:, :2] - way",
        "points[:, :2] + way",
        GNOMON,
    ),
    Fault(
        "a land that turns against the wind",
        "scene.sun",
        "-cos(a) * x - sin(a) * y",
        "-cos(a) * x + sin(a) * y",
        GNOMON,
    ),
    Fault(
        "a sock that streams into the wind",
        "scene.wind_signs",
        "Vector(v.x / size, v.y / size, 0.0)",
        "Vector(-v.x / size, -v.y / size, 0.0)",
        VANE,
    ),
    Fault(
        "gusts that come back",
        "scene.gusts_and_grass",
        "ahead = first + share * (last - first)",
        "ahead = last - share * (last - first)",
        VANE,
    ),
]
