"""The readable report: one page that needs nothing else, with pictures and plots."""

from freecad_ortho.fabrication.report.page import report_page
from freecad_ortho.fabrication.report.pictures import overview

__all__ = ["overview", "report_page"]
