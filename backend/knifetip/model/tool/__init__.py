"""Classes of tools: the dimensions that manufacturers state, and the behaviour of each tool.

The fields ``feed`` and ``plunge`` of all tools are in mm/min.
"""

from knifetip.model.tool.base import Footprint, Reversal, Switching, TipCircle, Tool
from knifetip.model.tool.crease_wheel import CreaseWheel
from knifetip.model.tool.cutter import Cutter
from knifetip.model.tool.disc import DiscTool
from knifetip.model.tool.kinds import KINDS, Engine, Kind, Planner, kind_of
from knifetip.model.tool.knife import Knife
from knifetip.model.tool.laser import Laser
from knifetip.model.tool.v_cutter import VCutter

__all__ = [
    "KINDS",
    "CreaseWheel",
    "Cutter",
    "DiscTool",
    "Engine",
    "Footprint",
    "Kind",
    "Knife",
    "Laser",
    "Planner",
    "Reversal",
    "Switching",
    "TipCircle",
    "Tool",
    "VCutter",
    "kind_of",
]
