/// \file
/// Arrays of NumPy that share the memory of the core's lists. They cannot be written, and keep what they show
/// alive, whatever becomes of the tree.
#pragma once

#include "app/python/python_api.h"
#include "core/io/export_scene.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <memory>

namespace ramure::python {

/// positions, normals, triangles, texture coordinates and so on: those that the mesh has, by their names.
pybind11::dict arraysOf(const std::shared_ptr<const TriangleMesh>& mesh);
/// parent, start, end and so on, a row each branch.
pybind11::dict arraysOf(const std::shared_ptr<const Skeleton>& skeleton);
/// The axes of a skeleton, a row each, parents before children; branch numbers axis by axis.
pybind11::dict axisArrays(const Skeleton& skeleton);
/// matrices and so on, a row each copy; "shape" is the dict of the mesh.
pybind11::dict arraysOf(const std::shared_ptr<const ExportCopies>& copies);

} // namespace ramure::python
