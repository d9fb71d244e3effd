#!/usr/bin/env python3
"""write_hdf5.py: writes the files of tests/lib/input/hdf5 with h5py (Debian: python3-h5py): points as other programs keep them."""
import pathlib

import h5py
import numpy

folder = pathlib.Path(__file__).parent / "hdf5"
n = 300
k = numpy.arange(n)
X = numpy.column_stack([k / 7, 1 / (k + 1), -k])
u = numpy.column_stack([k / 3, -k / 9, 1e-9 * k])

with h5py.File(folder / "named.h5", "w", libver="earliest", track_order=False) as f:  # packed, in pieces, any sequence
    turned = k[::-1]
    f.attrs["time"] = 0.125
    f.create_dataset("positions", data=X[turned, :2], chunks=(64, 2), compression="gzip", shuffle=True)
    f.create_dataset("displacement [m]", data=u[turned, :2].astype("f4"), chunks=(100, 2), compression="gzip")
    f.create_dataset("volume", data=0.5 + turned)
    f.create_dataset("id", data=turned.astype("i4"))
    f.create_dataset("connectivity", data=numpy.zeros((7, 4), dtype="i8"))
    f.create_dataset("made by", data="h5py")
with h5py.File(folder / "h5md.h5", "w", libver="earliest") as f:  # one frame, http://h5md.nongnu.org
    all_of = f.create_group("particles/all")
    all_of.attrs["time"] = numpy.array([0.25])
    for name, values in (("position", X), ("velocity", u)):
        element = all_of.create_group(name)
        element.create_dataset("value", data=values[None, :, :])
        element.create_dataset("step", data=[7])
with h5py.File(folder / "columns.h5", "w", libver="latest") as f:  # a quantity each
    out = f.create_group("out")
    for name, values in (("x", X[:, 0]), ("y", X[:, 1]), ("ux", u[:, 0]), ("uy", u[:, 1])):
        out.create_dataset(name, data=values)
with h5py.File(folder / "two_bodies.h5", "w", libver="earliest") as f:
    for part in ("PartType0", "PartType1"):
        f.create_dataset(part + "/Coordinates", data=X[:5])
with h5py.File(folder / "two_frames.h5", "w", libver="earliest") as f:
    f.create_dataset("particles/all/position/value", data=numpy.stack([X[:5], X[:5]]))
with h5py.File(folder / "no_positions.h5", "w", libver="earliest") as f:
    f.create_dataset("temperature", data=k[:5])
