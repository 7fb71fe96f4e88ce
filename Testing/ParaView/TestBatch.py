# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in pvbatch: from samples to a surface, with pictures, state files and errors."""

import os
import sys
import unittest
from xml.etree import ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from session import (Chain, box, column, field, filters, load_plugin, pv, samples, servermanager,
                     write)

from paraview import smstate
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

BASELINES = os.environ["MEDIAL_BASELINES"]


def volume(surface):
    return field(servermanager.Fetch(surface), "Volume")


def stage(proxy):
    """The filter behind a proxy."""
    return proxy.SMProxy.GetClientSideObject()


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


class Batch(unittest.TestCase):
    def setUp(self):
        self.chain = Chain(samples())

    def tearDown(self):
        pv.ResetSession()

    def test_gives_a_closed_surface(self):
        self.chain.crust.UpdatePipeline()
        surface = servermanager.Fetch(self.chain.crust)
        self.assertEqual(field(surface, "Closed"), [1])
        self.assertEqual(field(surface, "BettiCrust"), [1, 0, 0])
        self.assertAlmostEqual(field(surface, "Volume")[0], 6, delta=0.5)

    def test_keeps_all_balls_without_an_axis(self):
        pruned = volume(self.chain.crust)
        self.chain.crust.Axis = None
        self.assertGreater(volume(self.chain.crust), pruned)

    def test_takes_the_schedule_as_rows(self):
        self.assertEqual(list(self.chain.prune.Schedule),
                         ["TriangleCount", "5", "0", "TriangleCount", "5", "0", "HausdorffDistance",
                          "0.5s", "0", "Area", "2s", "0"])
        self.chain.prune.Schedule = ["TriangleCount", "7", "1", "RelativeVolume", "0.25", "0"]
        self.chain.prune.UpdatePipeline()
        history = servermanager.Fetch(self.chain.prune, idx=1)
        self.assertEqual(column(history, "Measure"), [0, 1])
        self.assertEqual(column(history, "Threshold"), [7, 0.25])
        self.assertEqual(column(history, "Passes")[0], 1)

    def test_removes_what_is_selected(self):
        parts = servermanager.Fetch(self.chain.prune)
        ids = parts.GetCellData().GetArray("PartId")
        levels = parts.GetCellData().GetArray("PartLevel")
        cell = next(i for i in range(ids.GetNumberOfTuples()) if levels.GetTuple1(i) == 1)
        selection = pv.IDSelectionSource(FieldType="CELL", IDs=[-1, cell])
        again = filters.MedialPrune(Input=self.chain.prune, Selection=selection, Schedule=[])
        history = servermanager.Fetch(again, idx=1)
        self.assertEqual(column(history, "ByHand"), [1])
        self.assertEqual(column(history, "Removed"), [1])
        removed = servermanager.Fetch(again, idx=2)
        self.assertEqual(set(column(removed.GetCellData(), "PartId")), {ids.GetTuple1(cell)})
        again.SelectionRole = "Protect"
        self.assertEqual(column(servermanager.Fetch(again, idx=1), "Removed"), [])
        again.SelectionRole = "Remove"
        again.Selection = None
        self.assertEqual(column(servermanager.Fetch(again, idx=1), "Removed"), [])
        again.PartsToRemove = [int(ids.GetTuple1(cell))]
        self.assertEqual(column(servermanager.Fetch(again, idx=1), "Removed"), [1])

    def test_refuses_a_query(self):
        query = pv.SelectionQuerySource(QueryString="PartLevel == 1")
        again = filters.MedialPrune(Input=self.chain.prune, Selection=query)
        messages = []
        stage(again).AddObserver("ErrorEvent", lambda *_: messages.append(1))
        again.UpdatePipeline()
        self.assertEqual(messages, [1])
        self.assertEqual(again.GetDataInformation().GetNumberOfCells(), 0)

    def test_simplifies_in_one_filter(self):
        one = filters.SimplifyShape(Input=self.chain.balls.Input)
        self.assertEqual(volume(one), volume(self.chain.crust))
        parts = servermanager.Fetch(one, idx=1)
        table = servermanager.Fetch(one, idx=2)
        self.assertEqual(field(parts, "NumberOfParts"), [table.GetNumberOfRows()])
        one.Schedule = []
        self.assertGreater(volume(one), volume(self.chain.crust))

    def test_offers_every_measure(self):
        suggested = servermanager.Fetch(self.chain.prune).GetFieldData().GetArray(
            "SuggestedThreshold")
        measures = [suggested.GetComponentName(i)
                    for i in range(suggested.GetNumberOfComponents())]
        self.assertGreater(len(measures), 10)
        one = filters.SimplifyShape(Input=self.chain.balls.Input)
        rows = sum(([name, "0", "1"] for name in measures), [])
        for filter, port in ((self.chain.prune, 1), (one, 3)):
            filter.Schedule = rows
            history = servermanager.Fetch(filter, idx=port)
            self.assertEqual(column(history, "Measure"), list(range(len(measures))))

    def test_chooses_and_splits_on_request(self):
        one = filters.SimplifyShape(Input=self.chain.balls.Input)
        for filter, port in ((self.chain.prune, 1), (one, 3)):
            filter.Automatic = 1
            chosen = column(servermanager.Fetch(filter, idx=port), "Threshold")
            self.assertNotIn(9, column(servermanager.Fetch(filter, idx=port), "Measure"))  # as by default
            filter.Schedule = []
            self.assertEqual(column(servermanager.Fetch(filter, idx=port), "Threshold"), chosen)
            filter.Automatic = 0 # and so nothing is pruned
        for filter, port in ((self.chain.parts, 0), (self.chain.prune, 0), (one, 1)):
            filter.SplitAtNecks = 0
            whole = field(servermanager.Fetch(filter, idx=port), "NumberOfParts")
            filter.SplitAtNecks = 1
            filter.NeckRatio = 1
            split = field(servermanager.Fetch(filter, idx=port), "NumberOfParts")
            self.assertGreater(split, whole)

    def test_shows_parts_in_colors_of_their_own(self):
        view = pv.CreateView("RenderView")
        view.ViewSize = [400, 300]
        view.OrientationAxesVisibility = 0
        display = pv.Show(self.chain.prune, view)
        self.assertEqual(list(display.ColorArrayName), ["CELLS", "PartRank"])
        view.CameraPosition = [8, 6, 7]
        view.CameraFocalPoint = [1.5, 1, 0.5]
        view.CameraViewUp = [0, 0, 1]
        view.CameraViewAngle = 24
        self.compare(view, "parts.png")
        pv.Hide(self.chain.prune, view)
        self.assertEqual(pv.Show(self.chain.balls, view).Representation, "Balls")
        self.compare(view, "balls.png")
        pv.Hide(self.chain.balls, view)
        pv.Show(self.chain.crust, view)
        self.compare(view, "crust.png")
        pv.Delete(view)

    def compare(self, view, name):
        path = os.path.join(os.getcwd(), name)
        pv.SaveScreenshot(path, view)
        difference = vtkImageDifference()
        difference.SetThreshold(60)  # its own 105 takes black balls for colored ones
        difference.SetInputData(read_picture(path))
        difference.SetImageData(read_picture(os.path.join(BASELINES, name)))
        difference.Update()
        self.assertLess(difference.GetThresholdedError(), 10, "%s differs from its baseline" % path)

    def test_has_every_filter_in_its_menu(self):
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "ParaView", "Plugin")
        described, menu = (ElementTree.parse(os.path.join(folder, name)) for name in
                           ("MedialAxis.xml", "Menu.xml"))
        shown = [proxy.get("name") for proxy in described.iterfind("ProxyGroup[@name='filters']/SourceProxy")]
        self.assertIn("SimplifyShape", shown)
        self.assertEqual(sorted(proxy.get("name") for proxy in menu.iter("Proxy")), sorted(shown))

    def test_shows_no_spreadsheet_unasked(self):
        balls = filters.BoundarySamples(Input=pv.Sphere())
        for filter in (self.chain.parts, self.chain.prune, balls,
                       filters.SimplifyShape(Input=self.chain.balls.Input)):
            hints = filter.SMProxy.GetHints()
            views = [hints.GetNestedElement(i).GetAttribute("type")
                     for i in range(hints.GetNumberOfNestedElements())
                     if hints.GetNestedElement(i).GetName() == "View"]
            self.assertEqual(set(views), {"None"})
        view = pv.CreateView("RenderView")
        self.assertEqual(pv.Show(pv.OutputPort(balls, 2), view).Representation, "Balls")
        pv.Delete(view)

    def test_follows_a_time_series(self):
        files = [write(box(spacing), "time%d.vtp" % i) for i, spacing in enumerate((0.3, 0.2))]
        alone = [volume(filters.SimplifyShape(Input=pv.XMLPolyDataReader(FileName=[file])))
                 for file in files]
        series = pv.XMLPolyDataReader(FileName=files)
        self.assertEqual(list(series.TimestepValues), [0, 1])
        for result in (Chain(series).crust, filters.SimplifyShape(Input=series)):
            found = []
            for time in (0, 1, 0):
                result.UpdatePipeline(time)
                self.assertEqual(result.GetDataInformation().GetTime(), time)
                output = stage(result).GetOutputDataObject(0)
                found.append(field(output, "Volume"))
            self.assertEqual(found, [alone[0], alone[1], alone[0]])

    def test_comes_back_from_a_state_file(self):
        expected = volume(self.chain.crust)
        self.chain.prune.Schedule = ["TriangleCount", "5", "0", "RelativeVolume", "0.2", "0"]
        changed = volume(self.chain.crust)
        self.assertLess(changed, expected)
        pv.RenameSource("crust", self.chain.crust)
        path = os.path.join(os.getcwd(), "state.pvsm")
        pv.SaveState(path)
        pv.ResetSession()
        pv.LoadState(path)
        self.assertEqual(volume(pv.FindSource("crust")), changed)

    def test_comes_back_from_a_script(self):
        self.chain.prune.Schedule = ["TriangleCount", "5", "0", "RelativeVolume", "0.2", "0"]
        expected = volume(self.chain.crust)
        pv.RenameSource("crust", self.chain.crust)
        script = smstate.get_state()
        pv.ResetSession()
        exec(script, {})
        self.assertEqual(volume(pv.FindSource("crust")), expected)

    def test_measures(self):
        thickness = filters.LocalThickness(Input=self.chain.balls, Places=self.chain.crust, Axis=self.chain.axis)
        means = servermanager.Fetch(thickness, idx=1)
        self.assertEqual(means.GetNumberOfRows(), 5)
        self.assertTrue(0.6 < column(means, "Mean")[0] < 1.1)  # the box is 3 x 2 x 1
        elements = filters.PlatesAndRods(Input=self.chain.prune, Surface=self.chain.crust)
        self.assertGreater(servermanager.Fetch(elements, idx=1).GetNumberOfRows(), 0)
        self.assertTrue(servermanager.Fetch(elements, idx=2).GetCellData().HasArray("PlateOrRod"))
        lines = servermanager.Fetch(filters.MedialCenterlines(Input=self.chain.prune))
        self.assertTrue(lines.GetCellData().HasArray("BranchId"))
        row = servermanager.Fetch(filters.Morphometry(
            Input=self.chain.balls, Axis=self.chain.prune, Surface=self.chain.crust))
        self.assertAlmostEqual(column(row, "BV")[0], 6, delta=0.5)

    def test_saves_and_opens_medial_meshes(self):
        path, again = (os.path.join(os.getcwd(), name) for name in ("axis.ma", "again.ma"))
        pv.SaveData(path, proxy=self.chain.axis)
        mesh = pv.OpenDataFile(path)
        self.assertEqual(mesh.SMProxy.GetXMLName(), "MedialMeshReader")
        axis, read = servermanager.Fetch(self.chain.axis), servermanager.Fetch(mesh)
        self.assertEqual(read.GetNumberOfPolys(), axis.GetNumberOfPolys())
        self.assertEqual(read.GetNumberOfLines(), axis.GetNumberOfLines())
        self.assertGreater(min(column(read.GetPointData(), "Radius")), 0)
        pv.SaveData(again, proxy=mesh)
        with open(path) as first, open(again) as second:
            self.assertEqual(first.read(), second.read())
        os.rename(again, again + "_dup")
        self.assertEqual(pv.OpenDataFile(again + "_dup").SMProxy.GetXMLName(), "MedialMeshReader")

    def test_stops_and_starts_again(self):
        stop = [1]
        stage(self.chain.prune).AddObserver(
            "ProgressEvent", lambda prune, _: prune.SetAbortExecute(stop[0]))
        messages = []
        stage(self.chain.crust).AddObserver("ErrorEvent", lambda *_: messages.append(1))
        self.chain.crust.UpdatePipeline()
        self.assertEqual(self.chain.crust.GetDataInformation().GetNumberOfCells(), 0)
        self.assertEqual(messages, [])
        stop[0] = 0
        self.chain.prune.Schedule = ["TriangleCount", "5", "0"]
        self.chain.crust.UpdatePipeline()
        self.assertGreater(self.chain.crust.GetDataInformation().GetNumberOfCells(), 0)

    def test_refuses_too_few_points(self):
        points = vtkPoints()
        points.InsertNextPoint(0, 0, 0)
        few = vtkPolyData()
        few.SetPoints(points)
        balls = filters.PolarBalls(
            Input=pv.XMLPolyDataReader(FileName=[write(few, "few.vtp")]))
        messages = []
        stage(balls).AddObserver("ErrorEvent", lambda *_: messages.append(1))
        balls.UpdatePipeline()
        self.assertEqual(messages, [1])
        self.assertEqual(balls.GetDataInformation().GetNumberOfPoints(), 0)

    def test_takes_no_text_for_another_number(self):
        messages = []
        stage(self.chain.prune).AddObserver("ErrorEvent", lambda *_: messages.append(1))
        for iteration in (["RelativeVolume", "0,05", "0"], ["RelativeVolume", "abc", "0"],
                          ["RelativeVolume", "", "0"], ["RelativeVolume", "5000", "0"],
                          ["TriangleCount", "5", "1,5"], ["TriangleCount", "5", "-1"]):
            with self.subTest(iteration):
                messages.clear()
                self.chain.prune.Schedule = iteration
                self.chain.prune.UpdatePipeline()
                self.assertEqual(messages, [1, 1])  # of the iteration, and of the run without it
                self.assertEqual(self.chain.prune.GetDataInformation().GetNumberOfCells(), 0)
        messages.clear()
        self.chain.prune.Schedule = ["RelativeVolume", "0.05", "1"]
        self.chain.prune.UpdatePipeline()
        self.assertEqual(messages, [])

    def test_takes_an_image_by_way_of_its_contour(self):
        image = pv.Wavelet(WholeExtent=[-12, 12, -12, 12, -12, 12])
        ball = pv.Calculator(Input=image, Function="coordsX^2 + 2*coordsY^2 + 3*coordsZ^2")
        contour = pv.Contour(Input=ball, ContourBy=["POINTS", "Result"], Isosurfaces=[80])
        one = filters.SimplifyShape(Input=contour)
        one.UpdatePipeline()
        self.assertEqual(field(servermanager.Fetch(one), "BettiCrust"), [1, 0, 0])


load_plugin()
unittest.main(argv=sys.argv[:1], exit=True, verbosity=2)
