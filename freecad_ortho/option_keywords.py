"""Options by name and with their types, as editors, checkers and ``help`` show them.

Written by ``scripts/option_keywords.py`` from the tables of options, which say what each of them
does. Lengths are numbers of mm; functions on documents take quantities and texts such as
``"0.2 m"`` too, and ``"30 deg"`` of angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, TypedDict

Length = float | str
Angle = float | str
Area = float | str
Pressure = float | str
# A force, or one by mm or mm2; a text such as "1.5 kN/m2" too.
Load = float | str
# An object of a FreeCAD document, and where something stands: they have no type outside FreeCAD.
Feature = Any
Placement = Any
# Options that are one of a few words.
OffsetWord = Literal["above", "centre", "below"]
EndsWord = Literal[
    "mitred",
    "hub",
    "end-plate",
    "cover-plate",
    "cone",
    "lapped",
    "through-u",
    "through-v",
    "coped-u",
    "coped-v",
    "spliced-u",
    "spliced-v",
]
BoltWord = Literal["M12", "M16", "M20", "M24", "M27", "M30"]
NodeWord = Literal["hub", "bolted", "star", "ball", "through", "socket"]
ThroughWord = Literal["u", "v", "both"]
PanelEdgeWord = Literal["square", "bevel"]
AtHubsWord = Literal["cut", "lift"]
SliversWord = Literal["join", "leave-out"]
FrameWord = Literal["none", "plate", "silicone"]
BendingWord = Literal["none", "cold"]
LouvreAxisWord = Literal["u", "v"]
PositionWord = Literal["standing", "lying", "tilted"]
StripWord = Literal["auto", "developable", "twisted"]
PatternWord = Literal["auto", "straight", "arc", "free"]
BorderCutWord = Literal["square", "along"]
DiagonalsWord = Literal["none", "auto", "first", "second"]
GrainWord = Literal["none", "along"]
AnchorWord = Literal["M12", "M16", "M20", "M24", "M27", "M30"]
NestingWord = Literal["boxes", "outlines"]
DxfWord = Literal["blocks", "flat", "parts"]
DxfVersionWord = Literal["r2010", "r12"]
DxfTextWord = Literal["text", "strokes", "none"]
StepWord = Literal["one", "systems", "in-place"]
HardwareWord = Literal["list", "solids"]
PaperWord = Literal["a4", "a3", "a2", "a1", "a0"]
IfcAssembliesWord = Literal["systems", "lines", "rings"]
IfcPartsWord = Literal["facets", "exact"]
RhinoPartsWord = Literal["meshes", "solids"]
MovingWord = Literal["lambda", "mu", "nu"]
FamilyWord = Literal["u", "v", "both"]


class Sizes(TypedDict, total=False):
    """Options of systems; each of them has some of these."""

    edge_section: str
    edge_height: Length | None
    edge_width: Length | None
    edge_wall: Length
    height: Length
    thickness: Length
    offset: Literal["above", "centre", "below"]
    clearance: Length | None
    stock: Length | None
    rounded: bool
    section: str
    section_width: Length
    flange_thickness: Length | None
    ends: Literal[
        "mitred",
        "hub",
        "end-plate",
        "cover-plate",
        "cone",
        "lapped",
        "through-u",
        "through-v",
        "coped-u",
        "coped-v",
        "spliced-u",
        "spliced-v",
    ]
    splice_every: int
    hub_diameter: Length | None
    bolt: Literal["M12", "M16", "M20", "M24", "M27", "M30"]
    bolts: int
    hub_wall: Length | None
    no_boundary_beams: bool
    least_length: Length
    node: Literal["hub", "bolted", "star", "ball", "through", "socket"]
    bore: Length
    socket_depth: Length
    overhang: Length | None
    through: Literal["u", "v", "both"]
    panel_thickness: Length | None
    gap: Length
    panel_edge: Literal["square", "bevel"]
    at_hubs: Literal["cut", "lift"]
    least_width: Length
    slivers: Literal["join", "leave-out"]
    frame: Literal["none", "plate", "silicone"]
    frame_width: Length | None
    edge_cover: Length | None
    gasket: Length
    bite: Length
    bending: Literal["none", "cold"]
    fold: Length
    bend_radius: Length | None
    k_factor: float
    louvre_axis: Literal["u", "v"]
    tilt: Angle
    width: Length
    position: Literal["standing", "lying", "tilted"]
    layers: int
    hole: Length
    strip: Literal["auto", "developable", "twisted"]
    pattern: Literal["auto", "straight", "arc", "free"]
    smooth: bool
    trim: Length
    saw: Length
    border_cut: Literal["square", "along"]
    cutter: Length | None
    cleats: bool
    diagonals: Literal["none", "auto", "first", "second"]
    sheet: str | tuple[float, float] | None
    spacing: Length
    grain: Literal["none", "along"]
    kerf: Length
    piece_length: Length | None
    distortion: float
    foot_at: str | Sequence[int]
    foot_height: Length
    post_diameter: Length
    post_wall: Length
    foot_plate: Length
    anchor: Literal["M12", "M16", "M20", "M24", "M27", "M30"]


class WorkshopSettings(TypedDict, total=False):
    """What parts are cut from, and how drawings are written."""

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
    site_rotation: Angle
    paper: Literal["a4", "a3", "a2", "a1", "a0"]
    date: str
    prices: str
    stock_lengths: str
    sheet_sizes: str
    label_sheet: str
    ifc_assemblies: Literal["systems", "lines", "rings"]
    ifc_parts: Literal["facets", "exact"]
    rhino_parts: Literal["meshes", "solids"]


class DesignOptions(TypedDict, total=False):
    """Members and loads of a structural check; kN and m, lengths in mm."""

    section: str
    material: str
    supports: str | Sequence[int]
    joints: str
    position: Literal["beams", "standing", "lying", "tilted"]
    eccentric: Length
    layers: Length
    crossings: str
    slots: float
    self_weight: bool
    panels: Pressure
    panel_shear: float
    snow: Pressure
    snow_side: str | Sequence[float]
    modes: int
    pieces: int
    buckling_length: float
    deflection: float
    second_order: bool
    imperfection: Length | None


class NetChoices(TypedDict, total=False):
    """What a net is asked for, by guides and of its parts."""

    supports: str | Sequence[int]
    diagonal: bool
    flatness: Length | None
    angle: Angle | None
    tilt_u: Angle | None
    tilt_v: Angle | None
    plane: Literal["one", "u", "v", "both"]
    web: Literal["aag", "agg", "gga", "ggg"]
    radius: Length | None
    length: Length | None
    per_family: bool
    reference: Feature | None
    load: Load
    load_area: Load
    load_length: Load
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
    tolerance: float
    within: Length | None
    repeat: Literal["none", "panels", "edges", "nodes"]
    kinds: int | None
    alike: Length | None
    alike_angle: Angle


class PrimitiveOptions(TypedDict, total=False):
    """Options of exact surfaces."""

    sampling: tuple[int, int]
    lines: Literal["principal", "asymptotic", "cmc"]
    waist: Length
    height: Length
    angles: Sequence[Angle]
    placement: Placement
    radius: Length
    top_radius: Length
    semi_axes: Sequence[Length]
    t_range: Sequence[Area]
    clear: float
    first: Length
    second: Length
    reach: float
    size: Length
    pitch: Length
    length: Length
    width: Length
    profile: Sequence[Any]
    latitudes: Sequence[Angle]
    spine: Sequence[Any]
    angle: Angle
    rise: Length
    cross_rise: Length
    widest: Length
    narrowest: Length
    periods: float


class MultiNetOptions(TypedDict, total=False):
    """Options of multi-nets of a polyline on a quadric."""

    quadric: Literal["ellipsoid", "one-sheeted hyperboloid", "two-sheeted hyperboloid"]
    semi_axes: Sequence[Length]
    sampling: tuple[int, int]
    t_range: Sequence[Area]
    spacing: Literal["length", "parameter"]
    closed: bool
    reflect: str
    placement: Placement


class EllipticNetOptions(TypedDict, total=False):
    """Options of multi-nets in elliptic coordinates."""

    semi_axes: Sequence[Length]
    curve: Literal["straight", "wave", "quarter", "arch", "ring", "loop", "formulas"]
    first_formula: str
    second_formula: str
    points: Sequence[Any]
    coordinates: Sequence[Any]
    closed: bool
    sampling: tuple[int, int]
    t_range: Sequence[Area]
    spacing: Literal["length", "parameter"]
    reflect: str
    placement: Placement


class FaceOptions(TypedDict, total=False):
    """Options of nets sampled from CAD faces."""

    sampling: tuple[int, int]
    edge: Length
    spacing: Literal["length", "parameter"]
    outside: Literal["snap", "drop"]
    u_part: Sequence[float]
    v_part: Sequence[float]


class CurvatureOptions(TypedDict, total=False):
    """Options of nets along lines of curvature."""

    net: Literal["principal", "developable", "asymptotic", "asymptotic-angle", "cmc", "stress"]
    edge: Length
    ratio: float
    border: Literal["trim", "follow"]
    stands_on: Literal["boundary", "corners"]
    singularities: str | Sequence[Any] | None
    symmetry: Literal["none", "auto", "x", "y", "z", "x,y", "x,y,xy"]
    drawn_strokes: Sequence[Any]


class FormOptions(TypedDict, total=False):
    """Options of membranes and cable nets."""

    kind: Literal["cables", "membrane"]
    supports: str | Sequence[int]
    lift: str | Sequence[int]
    density: float
    border_density: float
    stress: float
    border_force: float
    vertex_load: Sequence[float]
    area_load: Sequence[float]
    edge_load: Sequence[float]
    pressure: float


class ChangeOptions(TypedDict, total=False):
    """Options of changes of a net; each has some of these."""

    which: Literal["first", "second"]
    border: Literal["drop", "fill"]
    levels: int
    rule: Literal["plain", "catmull-clark"]
    every: tuple[int, int]
    keep_border: bool
    rings: int
    rows: tuple[int, int, int, int]
    scale: float
    turn: Sequence[Angle]
    move: Sequence[Length]
    centre: Sequence[Length]
    normal: str | Sequence[float]
    point: Sequence[Length]
    image_only: bool
    strength: float
    radius: Length
    reverse: bool
    swap: bool
    distance: Length
    kind: Literal["parallel", "vertex", "edge", "face"]
    tolerance: Length


class SourceOptions(TypedDict, total=False):
    """Options of all sources of nets; each has some of these."""

    sampling: tuple[int, int]
    lines: Literal["principal", "asymptotic", "cmc"]
    waist: Length
    height: Length
    angles: Sequence[Angle]
    placement: Placement
    radius: Length
    top_radius: Length
    semi_axes: Sequence[Length]
    t_range: Sequence[Area]
    clear: float
    first: Length
    second: Length
    reach: float
    size: Length
    pitch: Length
    length: Length
    width: Length
    profile: Sequence[Any]
    latitudes: Sequence[Angle]
    spine: Sequence[Any]
    angle: Angle
    rise: Length
    cross_rise: Length
    widest: Length
    narrowest: Length
    periods: float
    quadric: Literal["ellipsoid", "one-sheeted hyperboloid", "two-sheeted hyperboloid"]
    spacing: Literal["length", "parameter"]
    closed: bool
    reflect: str
    points: Sequence[Any]
    moving: Literal["lambda", "mu", "nu"]
    curve: Literal["straight", "wave", "quarter", "arch", "ring", "loop", "formulas"]
    first_formula: str
    second_formula: str
    coordinates: Sequence[Any]
    edge: Length
    outside: Literal["snap", "drop"]
    u_part: Sequence[float]
    v_part: Sequence[float]
    net: Literal["principal", "developable", "asymptotic", "asymptotic-angle", "cmc", "stress"]
    ratio: float
    border: Literal["trim", "follow", "drop", "fill"]
    stands_on: Literal["boundary", "corners"]
    singularities: str | Sequence[Any] | None
    symmetry: Literal["none", "auto", "x", "y", "z", "x,y", "x,y,xy"]
    drawn_strokes: Sequence[Any]
    kind: Literal["cables", "membrane", "parallel", "vertex", "edge", "face"]
    supports: str | Sequence[int]
    lift: str | Sequence[int]
    density: float
    border_density: float
    stress: float
    border_force: float
    vertex_load: Sequence[float]
    area_load: Sequence[float]
    edge_load: Sequence[float]
    pressure: float
    distance: Length
    which: Literal["first", "second"]
    levels: int
    rule: Literal["plain", "catmull-clark"]
    every: tuple[int, int]
    keep_border: bool
    rings: int
    rows: tuple[int, int, int, int]
    normal: str | Sequence[float]
    point: Sequence[Length]
    image_only: bool
    reverse: bool
    swap: bool
    scale: float
    turn: Sequence[Angle]
    move: Sequence[Length]
    centre: Sequence[Length]
    strength: float
    tolerance: Length
