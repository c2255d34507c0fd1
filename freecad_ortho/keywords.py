"""Settings of the macro API by their names, with their types, as editors and checkers read them.

The tables of options have what each of them does. Lengths are numbers of mm; functions on documents
take quantities and texts such as ``"0.2 m"`` too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypedDict

from solver import Constraints, NetOptions

Length = float | str
# An object of a FreeCAD document, which has no type outside FreeCAD.
Feature = Any
# A value of an option of a source of nets.
Value = float | str | bool | Sequence[Any] | None


class Sizes(TypedDict, total=False):
    """What systems can be told; each of them has some of these."""

    height: Length
    thickness: Length
    offset: Literal["above", "centre", "below"]
    section: str
    section_width: Length
    flange_thickness: Length | None
    ends: Literal[
        "mitred", "hub", "end-plate", "cover-plate", "cone", "lapped", "through-u", "through-v"
    ]
    hub_diameter: Length | None
    bolt: Literal["M12", "M16", "M20", "M24", "M27", "M30"]
    bolts: int
    hub_wall: Length | None
    clearance: Length
    no_boundary_beams: bool
    edge_section: str
    edge_height: Length | None
    edge_width: Length | None
    edge_wall: Length
    node: Literal["hub", "bolted", "star", "ball", "socket"]
    bore: Length
    socket_depth: Length
    panel_thickness: Length | None
    gap: Length
    panel_edge: Literal["square", "bevel"]
    at_hubs: Literal["cut", "lift"]
    least_width: Length
    slivers: Literal["join", "leave-out"]
    frame: Literal["none", "plate", "silicone"]
    frame_width: Length
    edge_cover: Length
    gasket: Length
    bite: Length
    bending: Literal["none", "cold"]
    fold: Length
    bend_radius: Length | None
    k_factor: float
    least_length: Length
    rounded: bool
    through: Literal["u", "v", "both"]
    louvre_axis: Literal["u", "v"]
    tilt: float
    width: Length
    position: Literal["standing", "lying", "tilted"]
    layers: int
    hole: Length
    overhang: Length | None
    strip: Literal["auto", "developable", "twisted"]
    pattern: Literal["auto", "straight", "arc", "free"]
    smooth: bool
    stock: Length | None
    trim: Length
    saw: Length
    border_cut: Literal["square", "along"]
    cutter: Length | None
    cleats: bool
    sheet: str | None
    spacing: Length
    grain: Literal["none", "along"]
    kerf: Length
    distortion: float
    foot_at: str
    foot_height: Length
    post_diameter: Length
    post_wall: Length
    foot_plate: Length
    anchor: Literal["M12", "M16", "M20", "M24", "M27", "M30"]


class StructureSettings(Sizes, total=False):
    """What a Structure of a document can be told."""

    beams: Feature
    family: Literal["u", "v", "both"]
    trimmed: bool
    lines: Sequence[int]
    material: str
    density: float


class WorkshopSettings(TypedDict, total=False):
    """What parts are cut from and with, and how drawings are written."""

    sheet: str | tuple[float, float] | None
    spacing: Length
    grain: Literal["none", "along"]
    nesting: Literal["boxes", "outlines"]
    seed: int
    stock: Length | None
    saw: Length
    trim: Length
    rest: Length
    section_tolerance: float
    kerf: Length
    dxf: Literal["blocks", "flat", "parts"]
    dxf_version: Literal["r2010", "r12"]
    dxf_text: Literal["text", "strokes", "none"]
    step: Literal["one", "systems", "in-place"]
    step_tolerance: Length
    hardware: Literal["list", "solids"]
    equal: Length
    write: str
    site_origin: str
    site_rotation: float
    paper: Literal["a4", "a3", "a2", "a1", "a0"]
    date: str
    prices: str
    stock_lengths: str
    sheet_sizes: str
    label_sheet: str
    rhino_parts: Literal["meshes", "solids"]


class DesignSettings(TypedDict, total=False):
    """Members, supports and loads of a structural check; kN and m, lengths in mm."""

    section: str
    material: str
    supports: str
    joints: str
    position: str
    eccentric: float
    layers: float
    crossings: str
    self_weight: bool
    panels: float
    panel_shear: float
    snow: float
    snow_side: str | Sequence[float]
    wind: str | Sequence[str]
    load: str | Sequence[str]
    modes: int
    pieces: int
    buckling_length: float
    deflection: float
    second_order: bool
    imperfection: float | None


class CheckSettings(DesignSettings, total=False):
    """What a structural check of a document can be told."""

    beams: Feature | None
    cladding: Feature | None
    combinations: Sequence[str]


class PassedSettings(TypedDict, total=False):
    """What the solver is told in one call, and the Net of a document does not keep."""

    max_steps: int
    backend: str | None
    options: NetOptions
    constraints: Constraints


class NetSettings(PassedSettings, total=False):
    """What the Net of a document can be told."""

    net: str
    fix: str | Sequence[int | str]
    supports: str | Sequence[int]
    handles: Mapping[int, Sequence[float]]
    glide: Sequence[Any]
    close_to: Sequence[Any]
    symmetry: str
    diagonal: bool
    flatness: Length | None
    angle: float | None
    tilt_u: float | None
    tilt_v: float | None
    plane: Literal["one", "u", "v", "both"]
    web: Literal["aag", "agg", "gga", "ggg"]
    radius: Length | None
    length: Length | None
    per_family: bool
    reference: Feature
    load: float
    load_area: float
    load_length: float
    forces: Literal["free", "compression", "tension"]
    singular: Literal["exempt", "include"]
    fairness: float | None
    closeness: float | None
    multi: float | None
    multi_patch: tuple[int, int]
    evenness: float | None
    smooth_motion: float | None
    edge_vectors: float | None
    isometry: float | None
    within: float | str | None
    repeat: Literal["none", "panels", "edges", "nodes"]
    kinds: int | None
    alike: Length | None
    alike_angle: float
    tolerance: float
