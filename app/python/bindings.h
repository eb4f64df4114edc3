/// \file
/// The parts of the module ramure._ramure. It is plain: the package around it, written in Python, makes
/// objects of it.
#pragma once

#include "app/python/work.h"

namespace ramure::python {

/// open, save, info, validate, export.
void bindWork(pybind11::module_& module, pybind11::class_<Work, std::shared_ptr<Work>>& work);
/// Values of a tree, its meshes and its skeleton.
void bindTree(pybind11::class_<Work, std::shared_ptr<Work>>& work);
/// Steps of a recipe.
void bindSteps(pybind11::class_<Work, std::shared_ptr<Work>>& work);
/// Presets, parameters, kinds of steps, options.
void bindTables(pybind11::module_& module);

} // namespace ramure::python
