/// \file
/// INPUT of the command line: preset:NAME, demo:NAME, a .ramure or mesh file, with --set.
#pragma once

#include "app/cli/command_line.h"
#include "core/evaluate/evaluator.h"
#include "core/io/mesh_file.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/scene/scene.h"
#include <QJsonArray>
#include <variant>

namespace ramure::cli {

/// A scene, or the mesh of a file.
struct Input
{
    std::variant<Scene, ReadMesh> content;

    [[nodiscard]] const Scene* scene() const { return std::get_if<Scene>(&content); }
    [[nodiscard]] const ReadMesh* mesh() const { return std::get_if<ReadMesh>(&content); }
};

/// \param sets the values of --set, applied to every node that has the parameter; refused for mesh files.
/// Errors: Unknown (preset, ending, parameter), Invalid and Syntax (a value), and those of the files.
Expected<Input> loadInput(const QString& text, const QStringList& sets, const Progress& progress = {});

/// The INPUT of a command with its --set. Warnings about it go to the standard error. Errors as above.
Expected<Input> loadInput(const CommandLine& line, const Progress& progress = {});

/// What a tree grows from but probably does not mean (core/generators/parametric/grammar_notes.h); names of
/// several trees stand before it.
std::vector<Error> warningsOf(const Scene& scene);
/// Likewise, as the value of "warnings" in the JSON of commands, which have it where it is not empty.
QJsonArray jsonWarnings(const Scene& scene);

/// The values of --set, for every node that has the parameter. Errors: Unknown, Invalid, Syntax; path = the
/// key.
Expected<void> applySettings(Scene& scene, const QStringList& sets);

/// What became of a step of a recipe, as commands print it: "placed".
const char* stateName(EditState state);

/// The trees of a scene, shown or not, in its order; at least one. Error: Invalid.
Expected<std::vector<const Node*>> treesOf(const Scene& scene);

/// The same, but no trees are fine where there is anything else with a shape. Error: Invalid.
Expected<std::vector<const Node*>> treesOrShapes(const Scene& scene);

/// --node: hides all but the nodes with these names and what hangs below them; they are shown even where the
/// project hides them. No names: nothing happens. Errors: Unknown (no node has the name), Invalid (a mesh
/// file).
Expected<void> keepNodes(Input& input, const QStringList& names);

/// Names of several trees stand before what an error is about.
Expected<TreeResult> evaluateTree(TreePipeline& pipeline, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress = {});

Expected<TreeResult> evaluateTree(EvaluatedScene& scene, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress = {});

} // namespace ramure::cli
