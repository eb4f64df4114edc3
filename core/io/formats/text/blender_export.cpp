// Scenes into the format of blender_scene.h.
#include "core/base/file_writer.h"
#include "core/base/number_text.h"
#include "core/evaluate/evaluator.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/write_parts.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

namespace ramure {
namespace {

/// Names of nodes as names of files, each once.
class FileNames
{
public:
    std::string next(const std::string& wish)
    {
        std::string name = wish;
        for (char& c : name)
            if (static_cast<unsigned char>(c) < 32 ||
                std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos)
                c = '_';
        if (name.empty() || name.front() == '.')
            name = std::string("_").append(name);
        std::string unique = name;
        for (int i = 2; !m_used.insert(unique).second; ++i)
            unique = std::string(name).append(" ").append(std::to_string(i));
        return unique;
    }

private:
    std::set<std::string> m_used;
};

void appendVector(std::string& text, const char* word, const glm::vec3& v)
{
    text.append(word);
    for (int i = 0; i < 3; ++i)
        text.append(" ").append(numberText(v[i] + 0.0F));
    text.append("\n");
}

std::string meshText(const std::string& name, const TriangleMesh* mesh, const glm::dmat4& transform,
                     const std::string& parent)
{
    std::string text("# Ramure\n");
    if (!parent.empty())
        text.append("# parent=").append(parent).append("\n");
    text.append("o ").append(name).append("\n");
    const bool normals = mesh && !mesh->normals.empty();
    for (std::size_t i = 0; mesh && i < mesh->positions.size(); ++i)
        appendVector(text, "v", mesh->positions[i]);
    for (std::size_t i = 0; normals && i < mesh->normals.size(); ++i)
        appendVector(text, "vn", mesh->normals[i]);
    const bool texture = mesh && writing::hasTexture(*mesh);
    for (std::size_t i = 0; texture && i < mesh->uv.size(); ++i)
        text.append("vt ")
            .append(numberText(double(mesh->uv[i].x)))
            .append(" ")
            .append(numberText(double(mesh->uv[i].y)))
            .append("\n");
    for (std::size_t i = 0; mesh && i < mesh->triangles.size(); ++i) {
        text.append("f");
        for (int c = 0; c < 3; ++c) {
            const std::string index = std::to_string(mesh->triangles[i][c] + 1);
            text.append(" ").append(index);
            if (texture)
                text.append("/").append(std::to_string(writing::textureTriangles(*mesh)[i][c] + 1));
            if (normals)
                text.append(texture ? "/" : "//").append(index);
        }
        text.append("\n");
    }
    text.append("\nTRANSFORM");
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            text.append(" ").append(numberText(transform[column][row] + 0.0));
    return text.append("\n");
}

/// Into what is keyed goes all that the format has no other place for: world = parent * track * static.
bool isPlain(const Node& node)
{
    return node.params.tree == PlacementParams{};
}

class Exporter
{
public:
    Exporter(const Scene& scene, const std::string& folder)
        : m_scene(scene)
        , m_atRest(scene)
        , m_folder(folder)
    {
    }

    Expected<BlenderExport> run(const Progress& progress)
    {
        std::size_t done = 0;
        for (const Node& node : m_scene.nodes()) {
            progress.report(double(done++) / double(m_scene.nodes().size()));
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            if (node.kind == NodeKind::Tree || node.kind == NodeKind::Arm) {
                note(node, RAMURE_NOOP("this kind of node has no place in the format: left out"));
                continue;
            }
            RAMURE_TRY(add(node));
        }
        if (m_out.files.empty())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no object to export"));
        return std::move(m_out);
    }

private:
    void note(const Node& node, const char* text)
    {
        Note note = fail(ErrorCode::Invalid, text).value();
        note.path = node.name;
        m_out.notes.push_back(std::move(note));
    }
    Expected<void> write(const std::string& name, const std::string& text)
    {
        const std::string path = (std::filesystem::path(m_folder) / name).string();
        if (auto written = writeFile(path, text); !written)
            return written;
        m_out.files.push_back(path);
        return {};
    }
    Expected<void> add(const Node& node)
    {
        const std::string name = m_names.next(node.name);
        m_nameOf[node.id] = name;
        const std::string parent = m_nameOf.contains(node.parent) ? m_nameOf[node.parent] : std::string();
        const double rate = m_scene.timeline().framesPerSecond;
        const bool moves =
            std::any_of(node.animation.tracks().begin(), node.animation.tracks().end(),
                        [](const auto& entry) { return entry.first.part <= ChannelPart::GlobalScale; });
        if (std::any_of(node.animation.tracks().begin(), node.animation.tracks().end(),
                        [](const auto& entry) { return entry.first.part > ChannelPart::GlobalScale; }))
            note(node, RAMURE_NOOP("tracks of the own shape and of parameters have no place in the format"));
        const glm::dmat4 local = placementMatrix(node.params.local);
        auto solid = m_atRest.solid(node);
        RAMURE_TRY(solid);
        std::shared_ptr<const TriangleMesh> mesh = std::move(*solid);
        if (mesh && node.params.local != PlacementParams{})
            mesh = std::make_shared<const TriangleMesh>(transformed(*mesh, local));
        if (auto written =
                write(name + ".obj", meshText(name, mesh.get(), placementMatrix(node.params.tree), parent));
            !written)
            return written;
        if (!moves)
            return {};
        bool baked = false;
        NodeAnimation animation = node.animation;
        if (!isPlain(node)) {
            animation = withPlacement(node, rate);
            baked = true;
        }
        bool sampled = false;
        const std::string text = animationText(animation, rate, parent, &sampled);
        if (baked || sampled)
            note(node, RAMURE_NOOP("the keys differ between the channels: written frame by frame"));
        return write(name + ".animation", text);
    }
    /// Track and static as one track, a key per frame. A sheared frame keeps what a placement can say of it.
    static NodeAnimation withPlacement(const Node& node, double rate)
    {
        const auto [first, last] = rangeOf(node.animation);
        std::array<std::vector<Key>, 6> numbers;
        std::vector<OrientationKey> turns;
        const glm::dmat4 own = placementMatrix(node.params.tree);
        for (double frame = std::floor(secondsOf(first) * rate); frame <= std::ceil(secondsOf(last) * rate);
             frame += 1.0) {
            const double seconds = frame / rate;
            const auto placement = decomposePlacement(
                transformAt(node.animation, ChannelPart::GlobalTranslation, seconds) * own);
            if (!placement)
                continue;
            OrientationKey turn;
            turn.time = ticksOf(seconds);
            turn.mode = KeyMode::Linear;
            turn.value = glm::quat_cast(rotationMatrix(placement->rotation));
            turns.push_back(turn);
            for (std::size_t c = 0; c < 6; ++c) {
                Key key;
                key.time = turn.time;
                key.mode = KeyMode::Linear;
                const auto i = static_cast<int>(c % 3);
                key.value = c < 3 ? placement->translation[i] : placement->scale[i];
                numbers[c].push_back(key);
            }
        }
        NodeAnimation out;
        for (std::size_t c = 0; c < 6; ++c)
            if (auto track = Track::fromKeys(std::move(numbers[c])))
                out.set({c < 3 ? ChannelPart::GlobalTranslation : ChannelPart::GlobalScale,
                         static_cast<std::uint8_t>(c % 3), 0},
                        AnyTrack(std::move(*track)));
        if (auto track = OrientationTrack::fromKeys(std::move(turns))) {
            track->blend = OrientationBlend::Components;
            out.set({ChannelPart::GlobalOrientation, 0, 0}, AnyTrack(std::move(*track)));
        }
        return out;
    }

    const Scene& m_scene;
    EvaluatedScene m_atRest; ///< the files have the keys beside it
    std::string m_folder;
    FileNames m_names;
    std::map<NodeId, std::string> m_nameOf;
    BlenderExport m_out;
};

} // namespace

Expected<BlenderExport> exportBlender(const Scene& scene, const std::string& folder, const Progress& progress)
{
    return Exporter(scene, folder).run(progress);
}

} // namespace ramure
