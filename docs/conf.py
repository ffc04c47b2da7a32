"""How the manual is built: ``sphinx-build -n -W docs build/manual``. Nothing is downloaded."""

import os
import sys
from html import escape
from pathlib import Path
from typing import Any

os.environ["PYGAME_HIDE_SUPPORT_PROMPT"] = "1"
os.environ["NUMBA_DISABLE_JIT"] = "1"  # formulas stay functions, which is what autodoc reads
sys.path.insert(0, str(Path(__file__).parent))

import from_program
import ziamath
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.logging import getLogger

logger = getLogger(__name__)

project = "kitemj"
author = "the kitemj authors"
copyright = "2026, the kitemj authors"
version = release = from_program.version()

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx_argparse_cli"]
exclude_patterns = ["benchmark.md", "tables"]  # parts of other pages

html_theme = "furo"
html_title = f"kitemj {version}"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_show_sourcelink = False
html_copy_source = False

myst_enable_extensions = ["deflist", "dollarmath", "substitution"]
myst_heading_anchors = 3
myst_substitutions = {
    "keys": from_program.keys(),
    "replay_keys": from_program.replay_keys(),
    "toggles": from_program.toggles(),
    "parameters": from_program.parameters(),
    "kites": from_program.kites(),
    "faults": from_program.faults(),
    "counted": from_program.counted_faults(),
    "shared": str(len(from_program.SHARED)),
    "shared_faults": from_program.shared_faults(),
}

default_role = "code"
autodoc_member_order = "bysource"
autodoc_class_signature = "mixed"
python_maximum_signature_line_length = 88
# what pages refer to must be there; types in signatures may be other packages' or our own insides
nitpick_ignore_regex = [("py:class", ".*"), ("py:.*", r"(?!kitemj\.).*")]


def drawn(node: nodes.math | nodes.math_block, inline: bool) -> tuple[str, float]:
    """A formula as a picture of vectors, read aloud as LaTeX, and how far [px] it hangs down."""
    text = node.astext()
    try:
        formula = ziamath.Latex(text, size=18, color="currentColor", inline=inline)
        picture = formula.svg()
    except Exception as error:  # whatever a formula that is none makes of the library
        logger.warning("no formula: %s (%r)", text, error, location=node)
        return "", 0.0
    named = f'<svg role="img" aria-label="{escape(text.strip())}" '
    return picture.replace("<svg ", named, 1), formula.getyofst()


def inline_math(page: Any, node: nodes.math) -> None:
    """A formula in a line."""
    picture, low = drawn(node, inline=True)
    page.body.append(f'<span class="formula" style="vertical-align:{low:.1f}px">{picture}</span>')
    raise nodes.SkipNode


def display_math(page: Any, node: nodes.math_block) -> None:
    """A formula on a line of its own."""
    page.body.append(f'<div class="formula">{drawn(node, inline=False)[0]}</div>\n')
    raise nodes.SkipNode


def setup(app: Sphinx) -> None:
    """Formulas without a script from elsewhere; ``NamedTuple``s with units in place of types."""
    app.add_html_math_renderer("drawn", (inline_math, None), (display_math, None))
    app.connect("autodoc-process-signature", from_program.short_signature)
    app.connect("autodoc-process-docstring", from_program.with_units)
    app.connect("autodoc-skip-member", from_program.skipped)


html_math_renderer = "drawn"  # no script, no font of the reader's is needed
ziamath.config.svg2, ziamath.config.precision = False, 2
