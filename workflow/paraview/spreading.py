"""The picture of the animations in ParaView 5.12 or later: spheres coloured by their velocity along x, with walls and blade.

    pvpython workflow/paraview/spreading.py RUN [FILM]

RUN is the folder of a run with trajectory.vtkhdf and walls.vtkhdf, and FILM an .avi or .png file to write, of which .png
becomes one file a state. Within ParaView: set the environment variable RECOAT_RUN to the folder before it is started and
choose this file in File > Load State, of the kind "Python state file".
"""

import os
import sys
from pathlib import Path

from paraview import simple

SIZE = [1600, 480]  # pixels


def spheres(run):
    """The particles at their true size; returns the reader."""
    particles = simple.OpenDataFile(str(run / "trajectory.vtkhdf"))
    ball = simple.Glyph(particles, GlyphType="Sphere", GlyphMode="All Points")
    ball.ScaleArray = ["POINTS", "Radius"]
    ball.ScaleFactor = 2.0  # the sphere of a glyph has the radius 1/2
    ball.GlyphType.ThetaResolution = ball.GlyphType.PhiResolution = 16
    shown = simple.Show(ball)
    simple.ColorBy(shown, ("POINTS", "Velocity", "X"))
    colours = simple.GetColorTransferFunction("Velocity")
    colours.VectorMode, colours.VectorComponent = "Component", 0
    colours.ApplyPreset("Viridis (matplotlib)", True)
    shown.RescaleTransferFunctionToDataRangeOverTime()
    shown.SetScalarBarVisibility(simple.GetActiveView(), True)
    bar = simple.GetScalarBar(colours)
    bar.Title, bar.ComponentTitle = "Velocity along x [m/s]", ""
    bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    return particles


def walls(run):
    """Walls and blade, through which the powder can be seen."""
    shown = simple.Show(simple.OpenDataFile(str(run / "walls.vtkhdf")))
    shown.ColorArrayName = ["POINTS", ""]  # one colour
    shown.AmbientColor = shown.DiffuseColor = [0.6, 0.6, 0.6]
    shown.Opacity = 0.3


def look_along_y(view, particles):
    """From the side, x to the right and z up, without perspective; all that the particles reach in the first and last state."""
    boxes = []
    for time in (view.ViewTime, *simple.GetAnimationScene().TimeKeeper.TimestepValues[-1:]):
        particles.UpdatePipeline(time)
        boxes.append(particles.GetDataInformation().GetBounds())
    left, right, top = min(box[0] for box in boxes), max(box[1] for box in boxes), max(box[5] for box in boxes)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0.5 * (left + right), 0, 0.5 * top]
    view.CameraPosition, view.CameraViewUp = [0.5 * (left + right), left - right, 0.5 * top], [0, 0, 1]
    view.CameraParallelScale = 0.55 * max(1.6 * top, (right - left) * SIZE[1] / SIZE[0])
    view.ViewSize, view.OrientationAxesVisibility = SIZE, 0
    view.UseColorPaletteForBackground, view.Background = 0, [1, 1, 1]


def film(run, output=None):
    """Build the picture of a run and, where asked for, write all its states."""
    simple._DisableFirstRenderCameraReset()  # as in the states that ParaView saves itself
    view = simple.GetActiveViewOrCreate("RenderView")
    particles = spheres(run)
    walls(run)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    look_along_y(view, particles)
    simple.Render(view)
    if output:
        simple.SaveAnimation(output, view, ImageResolution=SIZE)


arguments = sys.argv[1:] or [os.environ.get("RECOAT_RUN", ".")]
film(Path(arguments[0]).resolve(), *arguments[1:2])
