/// \file
/// Counts and measures of a scene or a mesh file, as `info` prints them and the Python module returns them.
#pragma once

#include "app/cli/input.h"
#include "app/cli/json_measures.h"
#include "core/math/box.h"
#include "core/recipe/apply_edits.h"
#include "core/skeleton/measures.h"
#include "core/surface/season/foliage_on_day.h"
#include <QJsonArray>
#include <QJsonObject>
#include <optional>

namespace ramure::cli {

/// What is said of one skeleton, or of several together.
struct SkeletonFacts
{
    std::int64_t branches = 0, terminals = 0, maxChildren = 0;
    double totalLength = 0.0, sumA1 = 0.0;
    glm::dvec3 sumTip{0.0};
    Box box;
};

struct TreeFacts
{
    std::string name;
    std::int64_t symbols = 0;
    SkeletonFacts full, simplified;
    std::int64_t leaves = 0, shed = 0; ///< shed: by the season; below 0: there would be too many leaves
    LayerCount layer;
    QJsonArray editList;
    QJsonArray axes;                      ///< where they were asked for
    std::optional<TreeMeasures> measures; ///< of one tree
    std::optional<LeafMeasures> crown;    ///< of one tree whose leaves are those of a plant
};

struct SceneFacts
{
    std::vector<TreeFacts> trees;
    TreeFacts sum; ///< of all trees; its box is in the world
};

/// Measures all trees at rest, but with the parameters of the time; arms are posed. \param axes also lists
/// every axis. Errors: those of treesOrShapes, of the trees and of EvaluatedScene::pose.
Expected<SceneFacts> sceneFacts(EvaluatedScene& now, bool axes);
/// Returns what `info --json` prints, but for bad pictures and the verdict. Errors: those of
/// EvaluatedScene::solid.
Expected<QJsonObject> jsonOf(const SceneFacts& facts, EvaluatedScene& now);
QJsonObject jsonFacts(const ReadMesh& mesh);
Box boxOf(const TriangleMesh& mesh);

} // namespace ramure::cli
