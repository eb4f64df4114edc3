/// \file
/// Counts the vertices and faces of a scene, part by part, as an export would write them.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/session/export/export_options.h"
#include <array>
#include <cstdint>
#include <map>

namespace ramure {

/// Has the node a shape, and do the options ask for it? What a scatter copies is exported by itself where it
/// is named alone.
bool isExported(const Scene& scene, const ExportOptions& options, const Node& node);
/// The same of a node of any kind.
bool isChosen(const Scene& scene, const ExportOptions& options, const Node& node);

/// The parts of trees that are counted; other nodes are counted by their kind.
enum class ScenePart : std::uint8_t { Branches, Leaves, Apples };

struct PartCount
{
    std::uint64_t vertices = 0, faces = 0;
    bool operator==(const PartCount&) const = default;
};

struct SceneCounts
{
    std::array<PartCount, 3> parts{};
    std::map<NodeKind, PartCount> kinds;
    bool complete = true; ///< every tree that counts had a result

    [[nodiscard]] const PartCount& of(ScenePart part) const { return parts[static_cast<std::size_t>(part)]; }
    [[nodiscard]] PartCount of(NodeKind kind) const
    {
        const auto found = kinds.find(kind);
        return found == kinds.end() ? PartCount() : found->second;
    }
    [[nodiscard]] PartCount total() const;
};

/// Keeps the counts of arms, terrains, primitives and imported meshes: another look builds only those whose
/// shape has changed. Shapes that cannot be made count nothing.
class SceneCounter
{
public:
    /// \param options which nodes and which parts of trees; the model counts as ExportModel::Mesh, at rest.
    SceneCounts count(const Scene& scene, const ExportOptions& options, const TreeSource& trees);

private:
    struct Known
    {
        Node node; ///< the node in the state that was counted
        PartCount count;
    };
    std::map<NodeId, Known> m_shapes;
};

} // namespace ramure
