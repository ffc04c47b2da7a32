"""``python -m kitemj``."""

import sys

from kitemj.cli import main

sys.exit(main())
