"""An independent reader of BTLx: raw parts less what their processings take."""

import numpy as np
import shapely
from scipy.spatial import HalfspaceIntersection
from scipy.spatial.transform import Rotation

SPACE = "{https://www.design2machine.com}"


def tag(element):
    return element.tag.removeprefix(SPACE)


def value(element, name):
    return float(element.find(SPACE + name).text)


def point(element):
    return np.array([float(element.get(name)) for name in "XYZ"])


def to_model(element):
    """Origin and axes of a part, one a row."""
    origin, x, y = (
        point(next(element.iter(SPACE + w))) for w in ("ReferencePoint", "XVector", "YVector")
    )
    return origin, np.array([x, y, np.cross(x, y)])


def cut_plane(cut, width):
    """Normal towards what falls off, and a point, in the part: turned as documented."""
    start = cut.find(f"{SPACE}Orientation").text == "start"
    sign = 1 if start else -1
    angle, tilt = (sign * (value(cut, name) - 90) for name in ("Angle", "Inclination"))
    # On reference side 4 x is along, y up and z outwards.
    normal = Rotation.from_euler("z", angle, degrees=True).apply(
        Rotation.from_euler("y", tilt, degrees=True).apply([1.0, 0.0, 0.0])
    )
    place = [value(cut, "StartX"), value(cut, "StartY"), width - value(cut, "StartDepth")]
    return -sign * normal, np.array(place)


def rebuilt(element):
    """(n, 3) corners of a bar in the model: its raw part less what its cuts take."""
    size = np.array([float(element.get(name)) for name in ("Length", "Height", "Width")])
    rows = [[*(-np.eye(3)[k]), 0.0] for k in range(3)]
    rows += [[*np.eye(3)[k], -size[k]] for k in range(3)]
    for cut in element.iter(f"{SPACE}JackRafterCut"):
        normal, place = cut_plane(cut, size[2])
        rows.append([*normal, -normal @ place])
    corners = HalfspaceIntersection(np.array(rows), size / 2).intersections
    origin, axes = to_model(element)
    return origin + corners @ axes


def ring(contour):
    points = [contour.find(f"{SPACE}StartPoint"), *contour.iter(f"{SPACE}EndPoint")]
    return np.array([point(each) for each in points])


def lap_polygon(lap, height):
    """What a lap takes out of a board, on side 4: from its floor on up through all there is."""
    limits = lap.find(f"{SPACE}MachiningLimits")
    assert limits.get("FaceLimitedBack") == "no"
    assert value(lap, "LeadAngle") == value(lap, "Inclination") == 90
    # Between the wall at the start and the part before it.
    turned = np.radians(180 - value(lap, "Angle"))
    up = np.array([np.cos(turned), np.sin(turned)])
    along = value(lap, "Length") * np.array([up[1], -up[0]])
    start = np.array([value(lap, "StartX"), value(lap, "StartY")])
    corners = start + np.array([0 * up, along, along + 2 * height * up, 2 * height * up])
    if lap.get("ReferencePlaneID") == "2":
        corners[:, 1] = height - corners[:, 1]
    return shapely.Polygon(corners)


def plate_of(element):
    """The flat shape that is left of a raw part."""
    length, height = (float(element.get(name)) for name in ("Length", "Height"))
    contours = list(element.iter(f"{SPACE}FreeContour"))
    plate = shapely.box(0, 0, length, height)
    if contours:
        outline = ring(contours[0].find(f"{SPACE}Contour"))
        np.testing.assert_array_equal(outline[0], outline[-1])
        assert contours[0].get("ToolPosition") == "right"
        assert shapely.LinearRing(outline[:, :2]).is_ccw
        plate = shapely.Polygon(outline[:, :2])
    for cut in element.iter(f"{SPACE}JackRafterCut"):
        normal, place = cut_plane(cut, float(element.get("Width")))
        assert abs(normal[2]) < 1e-9
        side = 1e5 * np.array([normal[1], -normal[0]])
        far = 1e5 * normal[:2]
        corners = place[:2] + np.array([side, -side, far - side, far + side])
        plate = plate - shapely.Polygon(corners)
    for lap in element.iter(f"{SPACE}Lap"):
        through = value(lap, "Depth") - float(element.get("Width"))
        assert abs(through) <= 1e-4
        plate = plate - lap_polygon(lap, height)
    for hole in element.iter(f"{SPACE}Drilling"):
        centre = shapely.Point(value(hole, "StartX"), value(hole, "StartY"))
        plate = plate - centre.buffer(value(hole, "Diameter") / 2, quad_segs=256)
    return plate
