# SPDX-License-Identifier: BSD-3-Clause
"""Simplify the shape of a 3D object by pruning its medial axis, and get a closed surface back.

The classes are VTK filters; `simplify` runs all of them, from numpy to numpy if wanted.
"""

from .vtkFiltersMedial import *
from .measuring import morphometry
from .simplification import (
    Doubt, MedialAxisWarning, Simplified, Stopped, Verdict, arrays, doubts_of, simplify, verdict_of)
