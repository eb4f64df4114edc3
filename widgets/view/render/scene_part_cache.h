/// \file
/// What the scene builder made, under the identity of what it was made from.
#pragma once

#include "core/surface/mesh/mesh_arrays.h"
#include "widgets/view/render/render_scene.h"
#include <compare>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace ramure {

enum class ScenePart : std::uint8_t {
    MeshBox,
    RoughBranches,
    RoughLeaves,
    RoughApples,
    SkeletonLines,
    SkeletonMarks,
    SimplifiedLines,
    SimplifiedMarks,
    RemovedMarks,
    SectionLines,
    FrameArrows,
    Inspected,
    SelectedCurves,
    Isolated,
    LeafCopies,
    AppleCopies,
    Crown,
    Textured,
    Bark,
    LeafPicture,
    ArmSkin,
    ArmRods,
    ArmTarget,
    Object,
    ObjectTexture,
    Images,
    CameraBody,
    Outlined,
    Wind,
    WindOfItem,
    Hillside,
    Grass,
    FallenLeaves,
    CrowdForms,
    StandIn,
    Crowd,
    CrowdFrame,
};

/// What a part was made from: two blocks and some numbers.
struct ScenePartKey
{
    ScenePart part;
    const void* first = nullptr;
    const void* second = nullptr;
    std::vector<double> numbers;
    auto operator<=>(const ScenePartKey&) const = default;
};

/// What was made. The sources are kept alive so that their addresses stay theirs.
struct ScenePartMade
{
    std::shared_ptr<const void> first, second;
    std::shared_ptr<const void> block;
    std::uint64_t usedIn = 0;
};

class ScenePartCache
{
public:
    void beginBuild() { ++m_build; }
    /// The part under this key, made by \p make where it is new: a T, or one that is shared already.
    template <class T, class First, class Second, class Make>
    std::shared_ptr<const T> get(ScenePart part, const std::shared_ptr<First>& first,
                                 const std::shared_ptr<Second>& second, std::vector<double> numbers,
                                 Make&& make)
    {
        const auto [it, isNew] =
            m_parts.try_emplace(ScenePartKey{part, first.get(), second.get(), std::move(numbers)});
        ScenePartMade& made = it->second;
        made.usedIn = m_build;
        if (isNew) {
            made.first = first;
            made.second = second;
            if constexpr (std::is_convertible_v<decltype(make()), std::shared_ptr<const T>>)
                made.block = make();
            else
                made.block = std::make_shared<const T>(make());
        }
        return std::static_pointer_cast<const T>(made.block);
    }
    Box box(const std::shared_ptr<const TriangleMesh>& mesh)
    {
        return *get<Box>(ScenePart::MeshBox, mesh, mesh, {}, [&mesh] { return meshBox(*mesh); });
    }
    /// Arrays of rough models that are no longer shown, to be used again.
    MeshArrays& roughArrays() { return m_roughArrays; }
    /// Forgets what the build did not use.
    void dropUnused()
    {
        std::erase_if(m_parts, [this](const auto& entry) { return entry.second.usedIn != m_build; });
    }

private:
    std::map<ScenePartKey, ScenePartMade> m_parts;
    std::uint64_t m_build = 0;
    MeshArrays m_roughArrays;
};

} // namespace ramure
