#include "core/pipeline/stage_hashes.h"

#include "core/generators/tree_life.h"
#include "core/math/stage_hash.h"
#include "core/params/param_def.h"
#include "core/params/tree_edit_table.h"

namespace ramure {
namespace {

void add(StageHash& hash, const ParamValue& value)
{
    const auto addHeld = [&hash]<class T>(const T& held) {
        if constexpr (std::is_same_v<T, std::string>)
            hash.add(std::string_view(held));
        else if constexpr (std::is_same_v<T, EnumValue>)
            hash.add(std::string_view(held.name));
        else if constexpr (std::is_same_v<T, glm::dvec3>)
            hash.add(held.x).add(held.y).add(held.z);
        else
            hash.add(held);
    };
    std::visit(addHeld, value);
}

void add(StageHash& hash, const BranchPlace& place)
{
    hash.add(place.tree).add(place.way.size()).add(place.fork).add(place.piece).add(place.share);
    for (const AxisPrint& p : place.way)
        hash.add(p.address)
            .add(p.fork)
            .add(p.mate)
            .add(p.forks)
            .add(p.mates)
            .add(p.s)
            .add(p.share)
            .add(p.downAngle)
            .add(p.azimuth)
            .add(p.length)
            .add(p.radius);
}

void add(StageHash& hash, const glm::dvec3& v)
{
    hash.add(v.x).add(v.y).add(v.z);
}

void add(StageHash& hash, const EditTarget& target)
{
    add(hash.add(target.address).add(target.maker), target.place);
}

/// Its name alone changes nothing.
void add(StageHash& hash, const TreeEdit& edit)
{
    hash.add(edit.id).add(static_cast<int>(edit.operation)).add(edit.enabled);
    add(hash, edit.target);
    add(hash, edit.other);
    hash.add(edit.at).add(edit.from).add(edit.to).add(edit.factor).add(edit.angleRad).add(edit.azimuthRad);
    hash.add(edit.radius).add(edit.strength).add(edit.below).add(edit.shown);
    hash.add(edit.falls).add(edit.seconds).add(edit.year).add(static_cast<int>(edit.organ));
    for (const glm::dvec3& v : {edit.rotation, edit.direction, edit.centre, edit.offset})
        add(hash, v);
    hash.add(static_cast<int>(edit.shape.kind));
    for (const double number : edit.shape.numbers)
        hash.add(number);
    hash.add(edit.shape.points.size()).add(edit.shape.triangles.size());
    for (const glm::dvec3& point : edit.shape.points)
        add(hash, point);
    for (const auto& triangle : edit.shape.triangles)
        hash.add(triangle[0]).add(triangle[1]).add(triangle[2]);
    hash.add(edit.points.size());
    for (const StrokePoint& point : edit.points) {
        add(hash, point.position);
        hash.add(point.radius);
    }
    hash.add(edit.limb.size());
    for (const LimbPiece& piece : edit.limb) {
        add(hash.add(piece.parent).add(piece.axis).add(piece.a0).add(piece.a1), piece.p0);
        add(hash.add(piece.sawn).add(piece.bare).add(piece.organs.size()), piece.p1);
        for (const LimbOrgan& organ : piece.organs) {
            hash.add(static_cast<int>(organ.organ)).add(organ.share).add(organ.size);
            for (const glm::dvec3& v : {organ.offset, organ.heading, organ.up})
                add(hash, v);
        }
    }
    for (const ParamDef* def : stepParams(edit.operation))
        add(hash, def->get(*edit.values));
    hash.add(edit.version);
}

/// What the history of a growing tree is made from beside its parameters, but for its years.
std::uint64_t lifeHash(std::uint64_t before, const NodeParams& params)
{
    StageHash hash(before);
    hash.add(params.growth.space.hash);
    for (const TreeEdit& edit : params.edits)
        if (growthYears(params) > 0.0 && edit.year > 0.0 && canLiveOn(edit))
            add(hash, edit);
    return hash.value();
}

} // namespace

StageHashes::StageHashes(const NodeParams& params)
{
    const auto of = [this](Stage stage) -> std::uint64_t& {
        return m_hashes[static_cast<std::size_t>(stage)];
    };
    for (const ParamDef& def : paramTable()) {
        const bool isOfPipeline = def.stage < Stage::Placement || def.stage == Stage::Texture;
        if (!isOfPipeline || !hasParam(NodeKind::Tree, def) || (def.matters && !def.matters(params)))
            continue;
        StageHash hash(of(def.stage));
        add(hash, def.get(params));
        of(def.stage) = hash.value();
    }
    if (params.generator.kind == EditOperation::Growth) {
        m_life = lifeHash(of(Stage::Symbols), params);
        of(Stage::Symbols) = StageHash(m_life).add(historyYears(params)).value();
    } else if (params.colonisation.space.hash != 0)
        of(Stage::Skeleton) = StageHash(of(Stage::Skeleton)).add(params.colonisation.space.hash).value();
    // So far each has its own parameters alone: now what comes before it too.
    const auto follow = [&of](Stage stage, std::uint64_t before) {
        of(stage) = StageHash(before).add(of(stage)).value();
    };
    follow(Stage::Skeleton, of(Stage::Symbols));
    const std::size_t frozen = stepsFrozen(params.edits);
    m_grown = frozen > 0 ? params.edits[frozen - 1].frozen.hash() : of(Stage::Skeleton);
    StageHash edited(m_grown);
    for (std::size_t i = frozen; i < params.edits.size(); ++i)
        add(edited, params.edits[i]);
    of(Stage::Skeleton) = edited.value();
    follow(Stage::Simplified, of(Stage::Skeleton));
    follow(Stage::Sections, of(Stage::Simplified));
    // A mesh for a budget has sections of its own.
    follow(Stage::Mesh, of(params.mesh.targetTriangles > 0 ? Stage::Simplified : Stage::Sections));
    if (const auto ground = params.ground.nearby())
        of(Stage::Mesh) =
            StageHash(of(Stage::Mesh)).add(ground->height).add(ground->grade.x).add(ground->grade.y).value();
    follow(Stage::Foliage, of(Stage::Simplified));
    follow(Stage::Season, of(Stage::Foliage));
    follow(Stage::Texture, of(Stage::Mesh));
}

std::uint64_t barkHash(const BarkParams& bark, std::uint64_t version)
{
    NodeParams params;
    params.bark = bark;
    StageHash hash(version);
    for (const ParamDef& def : paramTable())
        if (std::string_view(def.key).starts_with("bark.") && !(def.flags & paramPicture))
            add(hash, def.get(params));
    return hash.value();
}

} // namespace ramure
