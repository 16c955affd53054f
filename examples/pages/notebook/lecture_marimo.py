import marimo

app = marimo.App()


@app.cell
def _():
    import marimo as mo
    from camera_lab import CameraLab

    lab = mo.ui.anywidget(CameraLab(page="https://lab.example.org/", view="image"))
    lab
    return (lab,)


@app.cell
def _(lab):
    # Runs again whenever the camera moves.
    lab.numbers["camera"]["position"] if lab.numbers else None
    return
