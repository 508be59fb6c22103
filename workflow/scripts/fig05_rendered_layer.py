"""The spread layer in three dimensions: spheres coloured by coordination number, with the blade."""

import numpy
import vtk
import yaml
from vtk.util.numpy_support import numpy_to_vtk

from layers import load_layers
from reporting import Implausible, logged
from states import length
from style import WIDTH, bond_label, coordination_colours, coordination_ticks, pyplot, save

LENGTH = 45  # of the layer that is shown, measured back from the front of the blade [d_p]
PIXELS = (4200, 1800)  # twice what is printed: averaged, it is smooth


def spheres(centres, radii, colours):
    """Actor of spheres; lengths in d_p, colours as 8-bit RGB."""
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(centres), deep=True))
    data.SetPoints(points)
    scale = numpy_to_vtk(numpy.ascontiguousarray(2 * radii), deep=True)
    scale.SetName("Diameter")
    data.GetPointData().AddArray(scale)
    hue = numpy_to_vtk(numpy.ascontiguousarray(colours), deep=True, array_type=vtk.VTK_UNSIGNED_CHAR)
    hue.SetName("Colour")
    data.GetPointData().AddArray(hue)
    shape = vtk.vtkSphereSource()
    shape.SetThetaResolution(24)
    shape.SetPhiResolution(16)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(shape.GetOutputPort())
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.SetScaleArray("Diameter")
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Colour")
    mapper.SetColorModeToDirectScalars()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetSpecular(0.2)
    return actor


def cuboid(bounds, colour, opacity):
    """Actor of a box given as x0, x1, y0, y1, z0, z1."""
    source = vtk.vtkCubeSource()
    source.SetBounds(*bounds)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetAmbient(0.5)
    actor.GetProperty().SetDiffuse(0.5)
    return actor


def edges(bounds):
    """Actor of the edges of a box."""
    source = vtk.vtkCubeSource()
    source.SetBounds(*bounds)
    lines = vtk.vtkExtractEdges()
    lines.SetInputConnection(source.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(lines.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.1, 0.2, 0.4)
    actor.GetProperty().SetLineWidth(4)
    return actor


def blade_bounds(state, width):
    """The blade at the end of spreading [d_p]."""
    scene = yaml.safe_load(state.info["config"])
    diameter = state.diameter
    rear = (float(state.info["blade_start"]) + float(state.info["spread_length"])) / diameter
    thickness = length(scene["blade"]["thickness"], diameter) / diameter
    bottom = float(state.info["clearance"]) / diameter
    return rear, rear + thickness, 0, width, bottom, bottom + 8


def picture(layer, colours, norm, classes):
    """Render the layer behind the blade and the heap before it; RGB image."""
    state = layer.state
    blade = blade_bounds(state, layer.width)
    start = max(blade[1] - LENGTH, float(state.info["blade_start"]) / state.diameter)
    end = blade[1] + max(10, 0.25 * LENGTH)
    position = state.points / state.diameter
    position[:, 1] = (position[:, 1] - float(state.info["y_min"]) / state.diameter) % layer.width
    shown = (position[:, 0] >= start) & (position[:, 0] <= end)
    classes_of = numpy.minimum(layer.coordination[shown], classes - 1)
    hues = (255 * colours(norm(classes_of))[:, :3]).astype(numpy.uint8)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(spheres(position[shown], state.radius[shown] / state.diameter, hues))
    renderer.AddActor(cuboid((start, end, -0.5, layer.width + 0.5, -0.4, 0), (0.85, 0.85, 0.85), 1))
    renderer.AddActor(cuboid(blade, (0.25, 0.45, 0.75), 0.4))
    renderer.AddActor(edges(blade))
    renderer.SetUseDepthPeeling(True)
    camera = renderer.GetActiveCamera()
    middle = (0.5 * (start + end), 0.5 * layer.width, 1.0)
    camera.SetFocalPoint(*middle)
    camera.SetPosition(middle[0] - 18, middle[1] - 62, middle[2] + 42)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.45)
    vtk.vtkLogger.SetStderrVerbosity(vtk.vtkLogger.VERBOSITY_OFF)  # it looks for a screen first, and says so
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)  # depth peeling, which the translucent blade needs, excludes it
    window.SetAlphaBitPlanes(True)
    window.SetSize(*PIXELS)
    window.AddRenderer(renderer)
    window.Render()
    return pixels(window)


def pixels(window):
    """The window's content at half its size, [rows, columns, 3]."""
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    columns, rows, _ = image.GetDimensions()
    values = vtk.util.numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    values = values.reshape(rows // 2, 2, columns // 2, 2, -1).mean(axis=(1, 3))[::-1, :, :3].astype(numpy.uint8)
    if values.min() == values.max():
        raise Implausible("the picture is empty: VTK could not render without a screen; install libegl1 or libosmesa6")
    return values


def crop(image, margin=12):
    """The image without its white border."""
    inked = (image < 250).any(axis=2)
    rows, columns = numpy.flatnonzero(inked.any(axis=1)), numpy.flatnonzero(inked.any(axis=0))
    return image[max(rows[0] - margin, 0) : rows[-1] + margin, max(columns[0] - margin, 0) : columns[-1] + margin]


def draw(layers):
    layer = layers[0]
    colours, norm, classes = coordination_colours(int(layer.coordination.max(initial=0)))
    image = crop(picture(layer, colours, norm, classes))
    figure, axes = pyplot.subplots(figsize=(WIDTH, WIDTH * image.shape[0] / image.shape[1] + 0.75))
    axes.imshow(image)
    axes.set_axis_off()
    axes.set_title(
        f"{bond_label(layer.bond)}, blade clearance {float(layer.state.info['clearance']) / layer.diameter:g} $d_p$"
    )
    scale = pyplot.cm.ScalarMappable(norm, colours)
    bar = figure.colorbar(scale, ax=axes, location="bottom", ticks=range(classes), shrink=0.8, aspect=30)
    bar.ax.set_xticklabels(coordination_ticks(classes))
    bar.set_label("Coordination number [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
