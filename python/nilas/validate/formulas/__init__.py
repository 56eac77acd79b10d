"""Published formulas for ice loads: functions with source, range and slopes."""

from nilas.validate.formulas.formula import Formula, FormulaError, Input
from nilas.validate.formulas.level_ice import LEVEL_ICE
from nilas.validate.formulas.limits import LIMITS
from nilas.validate.formulas.pack_ice import PACK_ICE
from nilas.validate.formulas.plates import PLATES
from nilas.validate.formulas.structures import STRUCTURES

FORMULAS = {one.name: one for one in (*PACK_ICE, *LEVEL_ICE, *STRUCTURES, *LIMITS, *PLATES)}

__all__ = ["FORMULAS", "Formula", "FormulaError", "Input"]
