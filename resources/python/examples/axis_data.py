"""The stems of a tree as a table for statistics: length, radius, angle and order of each, and Horton's ratio."""
import sys
from pathlib import Path

import numpy
import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "axes")
folder.mkdir(exist_ok=True)
tree = ramure.grow("EnglishOak", seed=3, age=25)
axes, bones = tree.axes(), tree.skeleton()
columns = {"order": axes.order, "parent": axes.parent, "length": axes.length, "radius": axes.radius,
           "down": numpy.degrees(axes.down_angle), "azimuth": numpy.degrees(axes.azimuth), "share": axes.share}
numpy.savetxt(folder / "axes.csv", numpy.column_stack(list(columns.values())), "%.6g", ",",
              header=",".join(columns), comments="")
counts = numpy.bincount(axes.order)
print("axes of each order:", counts)
print("mean angle of limbs:", numpy.degrees(axes.down_angle[axes.order == 1]).mean().round(1))
trunk = axes.branches[axes.first[0]:axes.first[0] + axes.count[0]]
print("the trunk tapers from", bones.start_radius[trunk[0]].round(3), "to", bones.end_radius[trunk[-1]].round(4), "m")
