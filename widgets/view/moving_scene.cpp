#include "widgets/view/moving_scene.h"

#include "widgets/view/render/arm_items.h"
#include <algorithm>

namespace ramure {
namespace {

bool followsBranches(const LineItem& item)
{
    return !item.lines->segments.empty() && item.lines->segments.front().branch != noIndex;
}

bool followsBranches(const PointItem& item)
{
    return !item.points->points.empty() && item.points->points.front().branch != noIndex;
}

/// Lines and marks of trees that move get the bones; those without a branch go.
template <class Item> void moveItems(std::vector<Item>& items, const MotionFrame& frame)
{
    std::erase_if(items, [&frame](const Item& item) {
        const NodeMotion* motion = frame.of(item.node);
        return motion && motion->moves() && !followsBranches(item);
    });
    for (Item& item : items) {
        const NodeMotion* motion = frame.of(item.node);
        if (motion && motion->moves())
            item.motion = {nullptr, motion->bones, SkinMethod::Rigid};
    }
}

/// bindRigidly of a merged mesh that is not made yet.
Skin rigidCopies(const MeshItem& item)
{
    const std::vector<MeshCopy>& copies = item.copies->copies;
    Skin skin;
    skin.vertices = item.mesh.vertexCount();
    skin.runs.resize(copies.size());
    const auto perCopy = static_cast<Index>(skin.vertices / std::max<std::size_t>(1, copies.size()));
    for (std::size_t i = 0; i < copies.size(); ++i) {
        const Index branch = copies[i].branch;
        const std::size_t piece = item.copies->pieceOf(i);
        skin.runs[piece] = {static_cast<Index>(piece) * perCopy,
                            {{branch, branch, branch}, {1.0F, 0.0F, 0.0F}}};
        skin.bones = std::max(skin.bones, branch + 1);
    }
    return skin;
}

} // namespace

bool MovingScene::moves(const RenderScene& rest, const MotionFrame& frame)
{
    if (!frame.transforms.empty())
        return true;
    const auto moving = [&frame](const auto& item) {
        const NodeMotion* motion = frame.of(item.node);
        return motion && motion->moves();
    };
    return std::any_of(rest.meshes.begin(), rest.meshes.end(), moving) ||
           std::any_of(rest.lines.begin(), rest.lines.end(), moving) ||
           std::any_of(rest.points.begin(), rest.points.end(), moving);
}

std::shared_ptr<const Skin> MovingScene::rigidSkin(const MeshItem& item)
{
    Bound& bound = m_bound[item.mesh.key().get()];
    bound.used = true;
    if (bound.skin)
        return bound.skin;
    bound.mesh = item.mesh.key();
    bound.skin =
        std::make_shared<const Skin>(item.mesh.isMade() ? bindRigidly(*item.mesh) : rigidCopies(item));
    return bound.skin;
}

/// Copies of a vertex follow the bones that it follows: nothing comes apart at a seam.
std::shared_ptr<const Skin> MovingScene::splitSkin(const MeshItem& item,
                                                   const std::shared_ptr<const Skin>& whole)
{
    Bound& bound = m_bound[item.mesh.key().get()];
    bound.used = true;
    if (bound.skin && bound.whole == whole)
        return bound.skin;
    auto skin = std::make_shared<Skin>();
    skin->vertices = item.mesh->vertexCount();
    skin->bones = whole->bones;
    const std::vector<SkinRun>& runs = whole->runs;
    std::size_t last = runs.size();
    std::vector<std::size_t> runOf(whole->vertices);
    for (std::size_t r = 0; r < runs.size(); ++r)
        std::fill(runOf.begin() + runs[r].firstVertex,
                  r + 1 < runs.size() ? runOf.begin() + runs[r + 1].firstVertex : runOf.end(), r);
    for (Index v = 0; v < skin->vertices; ++v) {
        const std::size_t run = runOf[(*item.split.vertex)[v]];
        if (run != last)
            skin->runs.push_back({v, runs[run].influence});
        last = run;
    }
    bound = {item.mesh.key(), std::move(skin), whole, true};
    return bound.skin;
}

std::shared_ptr<const Skin> MovingScene::skinOf(const MeshItem& item, const NodeMotion& motion)
{
    if (item.motion.skin) // of an arm: it is never at rest
        return item.motion.skin;
    const std::pair<DeferredMesh, const std::shared_ptr<const Skin>&> known[] = {
        {motion.mesh ? DeferredMesh::Pointer(motion.mesh, &motion.mesh->mesh) : nullptr, motion.branches},
        {motion.leavesMesh, motion.leaves},
        {motion.applesMesh, motion.apples},
    };
    for (const auto& [mesh, skin] : known)
        if (skin && mesh == item.mesh)
            return skin;
    if (motion.mesh && motion.branches && item.split.from.get() == &motion.mesh->mesh)
        return splitSkin(item, motion.branches);
    if (item.mesh.vertexCount() == 0 || !item.hasBranches() ||
        (item.mesh.isMade() && item.mesh->branch.size() != item.mesh->positions.size()))
        return nullptr;
    auto skin = rigidSkin(item);
    return skin->bones <= motion.bones->size() ? skin : nullptr; // of another skeleton: a draft, perhaps
}

/// Nodes that tracks move, and objects that they change.
static void placeItems(RenderScene& scene, const MotionFrame& frame)
{
    const auto place = [&frame](auto& items) {
        for (auto& item : items)
            if (const auto found = frame.transforms.find(item.node); found != frame.transforms.end())
                item.world = found->second.geometry;
    };
    place(scene.crowds);
    place(scene.lines);
    place(scene.points);
    for (MeshItem& item : scene.meshes) {
        const auto found = frame.objects.find(item.node);
        const bool changed = found != frame.objects.end();
        if (item.isMark && changed && found->second.target)
            item.inNode = armTargetPlace(*found->second.target);
        if (const auto at = frame.transforms.find(item.node); at != frame.transforms.end())
            item.world = at->second.geometry * item.inNode;
        if (!changed || item.isMark)
            continue;
        item.material.colour = glm::u8vec3(found->second.surface.color * 255.0 + 0.5);
        if (found->second.mesh) {
            item.mesh = found->second.mesh;
            item.box = meshBox(*item.mesh);
            if (item.outlined)
                item.outlined = std::make_shared<const OutlinedFaces>(
                    OutlinedFaces{.runs = {}, .ofBranches = false, .box = item.box});
        }
    }
}

RenderScene MovingScene::moved(const RenderScene& rest, const MotionFrame& frame)
{
    RenderScene scene = rest;
    if (!frame.transforms.empty())
        placeItems(scene, frame);
    for (auto& [mesh, bound] : m_bound)
        bound.used = false;
    for (MeshItem& item : scene.meshes) {
        const NodeMotion* motion = frame.of(item.node);
        if (!motion || !motion->moves())
            continue;
        item.motion.wind = nullptr;
        if (auto skin = skinOf(item, *motion)) {
            item.motion = {std::move(skin), motion->bones, motion->method};
            item.box = motion->box.grown(item.margin);
        }
    }
    std::erase_if(m_bound, [](const auto& entry) { return !entry.second.used; });
    moveItems(scene.lines, frame);
    moveItems(scene.points, frame);
    scene.updateBoxes();
    return scene;
}

RenderScene posed(const RenderScene& scene)
{
    RenderScene still = scene;
    for (MeshItem& item : still.meshes) {
        if (!item.motion.moves() || !item.motion.skin)
            continue;
        const ItemMotion& motion = item.motion;
        item.mesh = std::make_shared<const TriangleMesh>(
            deformed(*item.mesh, *motion.skin, *motion.bones, motion.method));
        item.copies = nullptr;
        item.motion = {};
    }
    for (LineItem& item : still.lines) {
        if (!item.motion.moves())
            continue;
        auto lines = std::make_shared<LineSet>(*item.lines);
        for (LineSegment& segment : lines->segments)
            if (segment.branch < item.motion.bones->size()) {
                const RigidTransform& bone = (*item.motion.bones)[segment.branch];
                segment.a = glm::vec3(bone.point(segment.a));
                segment.b = glm::vec3(bone.point(segment.b));
            }
        item.lines = std::move(lines);
        item.motion = {};
    }
    return still;
}

} // namespace ramure
