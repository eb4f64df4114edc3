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

/// Warnings about grammars that grow a tree but probably do not mean it
/// (core/generators/parametric/grammar_notes.h). If there are several trees, the tree's name stands before
/// each.
std::vector<Error> warningsOf(const Scene& scene);
/// Returns the same as the value of "warnings" in a command's JSON, which has the key only if there are any.
QJsonArray jsonWarnings(const Scene& scene);

/// The values of --set, for every node that has the parameter. Errors: Unknown, Invalid, Syntax; path = the
/// key.
Expected<void> applySettings(Scene& scene, const QStringList& sets);

/// Returns the state of a recipe's step as commands print it: "placed".
const char* stateName(EditState state);

/// The trees of a scene, shown or not, in its order; at least one. Error: Invalid.
Expected<std::vector<const Node*>> treesOf(const Scene& scene);

/// The same, but no trees are fine where there is anything else with a shape. Error: Invalid.
Expected<std::vector<const Node*>> treesOrShapes(const Scene& scene);

/// --node: hides all but the nodes with these names and what hangs below them; they are shown even where the
/// project hides them. No names: nothing happens. Errors: Unknown (no node has the name), Invalid (a mesh
/// file).
Expected<void> keepNodes(Input& input, const QStringList& names);

/// If there are several trees, the tree's name stands in front of the error's subject.
Expected<TreeResult> evaluateTree(TreePipeline& pipeline, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress = {});

Expected<TreeResult> evaluateTree(EvaluatedScene& scene, const Node& node, bool isOneOfSeveral, Stage last,
                                  const Progress& progress = {});

} // namespace ramure::cli
