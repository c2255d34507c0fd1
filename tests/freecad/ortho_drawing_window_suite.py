"""Drawing a multi-net on its quadric with the mouse in FreeCAD's window. Run by FreeCAD."""

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_mouse_tools import Hand
from ortho_suite_cases import PanelCase
from ortho_suite_tools import press, wait
from pivy import coin

from freecad_ortho import api, convert
from freecad_ortho.commands import sources
from freecad_ortho.panels import multi_net_panel
from solver.multinet import multi_net_residual


class TestDrawing(PanelCase):
    def setUp(self):
        super().setUp()
        self.watch_panel(multi_net_panel, "MultiNetPanel")
        self.document = FreeCAD.newDocument("Drawing")
        wait()

    def pixel(self, place):
        return self.hand.pixels([place])[0]

    def click(self, place):
        self.hand.click(self.pixel(place))

    def front(self, count=4):
        """Points of the ellipsoid that face the viewer."""
        look = -np.array(self.panel.view.getViewDirection())
        across = np.cross(look, [0, 0, 1])
        across /= np.linalg.norm(across)
        up = np.cross(across, look)
        places = [look + 0.35 * (k - 1.5) * across + 0.2 * np.sin(k) * up for k in range(count)]
        return self.panel.quadric.normalised(6000.0 * np.array(places))

    def drawn(self):
        panel = self.opened("MultiNet")
        self.hand = Hand(self.document)
        panel.draw_button.click()
        for place in self.front():
            self.click(place)
        return panel

    def test_clicks_become_points_on_the_quadric_and_a_net(self):
        panel = self.drawn()
        quadric, points = panel.quadric, panel.drawing.points
        self.assertEqual(points.shape, (4, 3))
        self.assertLess(quadric.distance(points).max(), 1e-6)
        # As near as the pixels of the view.
        self.assertLess(np.linalg.norm(points - self.front(), axis=1).max(), 200.0)
        self.assertEqual(len(self.previewed()), 24 * 12)
        right = coin.SoMouseButtonEvent.BUTTON2
        self.hand.press(self.pixel([0, 0, 0]), which=right)
        self.assertFalse(panel.drawing.adding)
        press("Ok")
        net = self.document.MultiNet
        self.assertEqual(len(net.Points), 4)
        mesh = convert.quad_mesh(net)
        self.assertLess(multi_net_residual(mesh).bound, 1e-12)
        self.assertEqual(self.document.UndoCount, 1)
        self.replay()
        again = self.document.Objects[-1]
        self.assertEqual(tools.vertices(again).tobytes(), tools.vertices(net).tobytes())
        self.assertEqual(self.errors, [])

    def test_a_dragged_point_takes_the_net_along(self):
        panel = self.drawn()
        self.hand.key(coin.SoKeyboardEvent.ESCAPE)
        self.assertFalse(panel.drawing.adding)
        before, shown = panel.drawing.points.copy(), self.previewed()
        target = panel.quadric.normalised(before[1] * [1.0, 1.0, 0.4])
        self.assertTrue(self.hand.press(self.pixel(before[1])))
        for share in (0.3, 0.7, 1.0):
            place = panel.quadric.normalised((1 - share) * before[1] + share * target)
            self.assertTrue(self.hand.move(self.pixel(place)))
        self.hand.release(self.pixel(target))
        after = panel.drawing.points
        self.assertLess(np.linalg.norm(after[1] - target), 200.0)
        np.testing.assert_array_equal(np.delete(after, 1, axis=0), np.delete(before, 1, axis=0))
        self.assertGreater(np.abs(self.previewed() - shown).max(), 100.0)
        # Nothing is held any more: a move does nothing, a click beside points neither.
        self.assertFalse(self.hand.move(self.pixel(target)))
        self.click(self.front(7)[6])
        self.assertEqual(len(panel.drawing.points), 4)
        press("Cancel")
        self.assertEqual(len(self.document.Objects), 0)
        self.assertLess(panel.view.getSceneGraph().findChild(panel.drawing.root), 0)

    def test_beside_the_quadric_a_click_does_nothing_and_a_drag_stays_on_it(self):
        panel = self.drawn()
        look = -np.array(panel.view.getViewDirection())
        beside = 20000.0 * np.cross(look, [0, 0, 1])
        self.click(beside)
        self.assertEqual(len(panel.drawing.points), 4)
        panel.add_button.click()
        self.assertFalse(panel.drawing.adding)
        self.hand.press(self.pixel(panel.drawing.points[3]))
        self.hand.move(self.pixel(beside))
        self.hand.release(self.pixel(beside))
        self.assertLess(panel.quadric.distance(panel.drawing.points).max(), 1e-6)
        press("Cancel")

    def test_the_range_of_t_is_automatic_until_it_is_given(self):
        panel = self.opened("MultiNet")
        boxes = panel.fields["t_range"]._widgets
        wait()
        self.assertEqual([box.text() for box in boxes], ["automatic"] * 2)
        # Zero is a place like others where only one of both is zero.
        panel.fields["t_range"].value = (0.0, 4e6)
        wait()
        self.assertEqual([box.text() for box in boxes], ["0.00 mm^2", "4.00 m^2"])
        self.assertEqual(panel.fields["t_range"].value, (0.0, 4e6))
        panel.fields["t_range"].value = (0.0, 0.0)
        wait()
        self.assertEqual([box.text() for box in boxes], ["automatic"] * 2)
        press("Cancel")

    def test_the_range_is_said_in_the_users_language_and_units(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        for language, words in (("German", "zulässig ab"), ("French", "admissible à partir de")):
            FreeCADGui.setLocale(language)
            FreeCAD.Units.setSchema(1)
            wait()
            panel = self.opened("MultiNet")
            said = panel.message.text()
            self.assertIn(words, said)
            self.assertIn("m^2", said.replace("m²", "m^2").replace("mm^2", "?"))
            self.assertNotIn("mm2", said)
            self.assertNotIn("admissible from", said)
            press("Cancel")

    def test_backspace_takes_the_last_point(self):
        panel = self.drawn()
        self.hand.key(coin.SoKeyboardEvent.BACKSPACE)
        self.assertEqual(len(panel.drawing.points), 3)
        press("Cancel")

    def test_points_follow_the_quadric(self):
        panel = self.drawn()
        for name, value in (
            ("semi_axes", (12000.0, 6000.0, 5000.0)),
            ("quadric", "one-sheeted hyperboloid"),
            ("quadric", "two-sheeted hyperboloid"),
        ):
            panel.fields[name].value = value
            panel.look()
            self.assertIsNotNone(panel.made, panel.message.text())
            self.assertLess(panel.quadric.distance(panel.drawing.points).max(), 1e-6)
            self.assertIn("admissible", panel.message.text())
        panel.fields["t_range"].value = (-1e12, 1e6)
        panel.look()
        self.assertIn("t: expected", panel.message.text())
        press("Cancel")

    def test_it_is_drawn_on_when_opened_again(self):
        net = api.add_multi_net()
        points = convert.array(net.Points)
        sources.edit_source(net)
        self.hand = Hand(self.document)
        self.assertEqual(len(self.panel.drawing.points), 4 if not len(points) else len(points))
        self.hand.press(self.pixel(self.panel.drawing.points[1]))
        place = self.panel.quadric.normalised(self.panel.drawing.points[1] * [1, 1, 0.5])
        self.hand.move(self.pixel(place))
        self.hand.release(self.pixel(place))
        before = tools.vertices(net)
        press("Ok")
        self.assertGreater(np.abs(tools.vertices(net) - before).max(), 10.0)
        self.document.undo()
        self.assertEqual(tools.vertices(net).tobytes(), before.tobytes())

    def test_picture(self):
        panel = self.drawn()
        path = str(tools.SCRATCH / "drawing.png")
        panel.view.saveImage(path, 900, 600, "White")
        press("Ok")
        api.save_picture(str(tools.SCRATCH / "multinet.png"), width=900, height=600)
