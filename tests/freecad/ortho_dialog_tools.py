"""Answers to the dialogs that stop FreeCAD until someone answers them."""

import sys

from PySide import QtCore, QtGui


class Answers:
    """Types into file dialogs and input fields one text after the other, and presses their button.

    FreeCAD's question which module is to read a file is answered with the one for quads; anything
    else that is asked with no.

    Args:
        texts: what to type, in the order of the dialogs.
        look: called with each dialog when its text stands in it.
    """

    def __init__(self, *texts, look=lambda dialog: None):
        self._texts, self._look = list(texts), look
        self._timer = QtCore.QTimer()
        self._timer.setInterval(100)
        self._timer.timeout.connect(self._answer)

    def __enter__(self):
        self._timer.start()
        return self

    def __exit__(self, *_):
        self._timer.stop()
        if self._texts and sys.exc_info()[0] is None:
            raise AssertionError(f"nobody asked for {self._texts}")

    def _answer(self):
        dialog = QtGui.QApplication.activeModalWidget()
        if isinstance(dialog, QtGui.QFileDialog) and self._texts:
            self._type(dialog.findChild(QtGui.QLineEdit), dialog)
            # Open, Choose or Save: whichever it has.
            buttons = dialog.findChild(QtGui.QDialogButtonBox).buttons()
            role = QtGui.QDialogButtonBox.AcceptRole
            box = dialog.findChild(QtGui.QDialogButtonBox)
            next(button for button in buttons if box.buttonRole(button) == role).click()
        elif isinstance(dialog, QtGui.QInputDialog) and self._texts:
            self._type(dialog.findChild(QtGui.QLineEdit), dialog)
            dialog.accept()
        elif dialog is not None:
            choices = dialog.findChildren(QtGui.QRadioButton)
            for choice in [each for each in choices if "Quad mesh" in each.text()]:
                choice.click()
            # The one button of the question.
            (dialog.findChild(QtGui.QPushButton).click if choices else dialog.reject)()

    def _type(self, line, dialog):
        line.setText(self._texts.pop(0))
        self._look(dialog)
