"""Camera Lab in a cell of Jupyter or marimo: CameraLab(page="https://lab.example.org/", lesson="basis", step=3)"""

import pathlib

import anywidget
import traitlets


class CameraLab(anywidget.AnyWidget):
    """A figure or a lesson. `figure` is the text of its file and follows every change, `numbers` are those of `camera-lab inspect`,
    and `answers` are the judged answers so far."""

    _esm = pathlib.Path(__file__).parent / "camera_lab.js"
    page = traitlets.Unicode().tag(sync=True)
    figure = traitlets.Unicode("").tag(sync=True)
    lesson = traitlets.Unicode("").tag(sync=True)
    step = traitlets.Int(0).tag(sync=True)
    view = traitlets.Unicode("").tag(sync=True)
    lang = traitlets.Unicode("").tag(sync=True)
    theme = traitlets.Unicode("").tag(sync=True)
    numbers = traitlets.Dict().tag(sync=True)
    answers = traitlets.List().tag(sync=True)
