"""Prints as JSON what VTK's own reader finds in the files that a .pvd lists: read_back.py FILE.pvd"""
import json
import os
import sys
import xml.etree.ElementTree

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

pvd = sys.argv[1]
frames = []
for entry in xml.etree.ElementTree.parse(pvd).getroot().iter("DataSet"):
    name = os.path.join(os.path.dirname(pvd), entry.get("file"))
    assert os.path.exists(name), name
    reader = vtkXMLPolyDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("read error"))
    reader.SetFileName(name)
    reader.Update()
    assert not errors, name
    data = reader.GetOutput()

    def rows(array):
        return [list(array.GetTuple(i)) for i in range(array.GetNumberOfTuples())]

    points = data.GetPointData()
    frames.append({
        "time": float(entry.get("timestep")),
        "field_time": data.GetFieldData().GetArray("TimeValue").GetValue(0),
        "points": rows(data.GetPoints().GetData()) if data.GetNumberOfPoints() else [],
        "verts": data.GetNumberOfVerts(),
        "arrays": {points.GetArrayName(k): rows(points.GetArray(k)) for k in range(points.GetNumberOfArrays())},
    })
print(json.dumps(frames))
