#!/usr/bin/env python3
"""write_vtk.py FOLDER: writes one cloud by VTK itself as .vtp and .vtu in each of its encodings; prints the names of the files."""
import itertools
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_VERTEX, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

count = 4000  # more than one block of 32768 bytes


def fill(data):
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    u, volume, tag = vtkDoubleArray(), vtkFloatArray(), vtkIntArray()
    u.SetName("displacement [m]")
    u.SetNumberOfComponents(3)
    volume.SetName("volume")
    tag.SetName("tag")
    for k in range(count):
        points.InsertNextPoint(k / 7, 1 / (k + 1), -k)
        u.InsertNextTuple3(k / 3, -k / 9, 1e-9 * k)
        volume.InsertNextValue(0.5 + k)
        tag.InsertNextValue(k % 5)
    data.SetPoints(points)
    for array in (u, volume, tag):
        data.GetPointData().AddArray(array)
    if data.IsA("vtkPolyData"):
        for k in range(count):
            cells.InsertNextCell(1, [k])
        data.SetVerts(cells)
    else:
        for k in range(count):
            data.InsertNextCell(VTK_VERTEX, 1, [k])
    return data


for kind, mode, packed, wide in itertools.product(("vtp", "vtu"), ("Ascii", "Binary", "raw", "base64"), (False, True), (False, True)):
    writer = vtkXMLPolyDataWriter() if kind == "vtp" else vtkXMLUnstructuredGridWriter()
    name = f"{sys.argv[1]}/{mode}_{packed}_{wide}.{kind}"
    writer.SetFileName(name)
    writer.SetInputData(fill(vtkPolyData() if kind == "vtp" else vtkUnstructuredGrid()))
    writer.SetHeaderTypeToUInt64() if wide else writer.SetHeaderTypeToUInt32()
    if not packed:
        writer.SetCompressorTypeToNone()
    if mode in ("Ascii", "Binary"):
        getattr(writer, "SetDataModeTo" + mode)()
    else:
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOn() if mode == "base64" else writer.EncodeAppendedDataOff()
    writer.Write()
    print(name)
