/// \file
/// Leaves, fruit and flowers as a list of instances beside a mesh file, and one OBJ for each shape.
#pragma once

#include "core/io/export_scene.h"

namespace ramure {

/// "tree_leaves.csv" for "tree.ply"; with \p ending ".json" the same list in that form.
std::string copyListPath(const std::string& path, const char* ending = ".csv");

/// Writes beside PATH a table of all copies, a row each, and before it every shape once as an OBJ with its
/// materials ("tree_leaves_birch.obj"). Two shapes of one kind that differ are "..._birch" and "..._birch_2".
///
/// Lines end in a line feed; the first has the names of the columns: node, object, kind, mesh (a file beside
/// the table), material, branch, address, number, red green blue (factors of the shape's colours) and m11 ...
/// m34, the matrix row by row. A point of the shape's file times the matrix is that of the merged mesh, both
/// in the space of the file.
///
/// Beside it stands the same as JSON: {"objects": [{"node", "object", "kind", "mesh", "material",
/// "instances":
/// [{"branch", "address", "number", "colour": 3 factors, "matrix": 12 numbers}, ...]}, ...]}, with one
/// instance a line. Either both files are new afterwards or none. Errors: those of writeObj; Invalid (a place
/// that is no finite number).
Expected<void> writeCopyList(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                             const Progress& progress = {});

} // namespace ramure
