#include "core/io/formats/text/blender_scene.h"

#include "core/io/formats/file_format.h"
#include "core/io/formats/text/import_parts.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/matrix.hpp>
#include <iterator>
#include <map>

namespace ramure {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> fileError(const std::string& file, ErrorCode code, const char* text)
{
    auto error = fail(code, text);
    error.value().file = file;
    return error;
}

Expected<std::string> textOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return fileError(path.string(), ErrorCode::Io, RAMURE_NOOP("the file cannot be opened"));
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad())
        return fileError(path.string(), ErrorCode::Io, RAMURE_NOOP("the file cannot be read"));
    return text;
}

/// The files of one object.
struct Pair
{
    fs::path mesh, animation; ///< empty where there is none
};

/// Blender's scripts write a camera as keys alone; its name says what it is: "Camera", "Camera.001".
bool isCamera(const std::string& name)
{
    constexpr std::string_view word = "camera";
    return std::ranges::equal(std::string_view(name).substr(0, word.size()), word,
                              [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 'a' - 'A' : a) == b; });
}

bool hasEnding(const fs::path& path, const char* ending)
{
    return endingOf(path.string()) == ending;
}

void addFile(std::map<std::string, Pair>& pairs, const fs::path& path)
{
    if (hasEnding(path, "obj"))
        pairs[path.stem().string()].mesh = path;
    else if (hasEnding(path, "animation"))
        pairs[path.stem().string()].animation = path;
}

/// By name, hence in one order on every machine.
Expected<std::map<std::string, Pair>> pairsOf(const fs::path& path)
{
    std::map<std::string, Pair> pairs;
    std::error_code problem;
    if (fs::is_directory(path, problem)) {
        for (fs::directory_iterator it(path, problem), end; !problem && it != end; it.increment(problem))
            if (it->is_regular_file(problem))
                addFile(pairs, it->path());
        if (problem)
            return fileError(path.string(), ErrorCode::Io, RAMURE_NOOP("the folder cannot be read"));
        if (pairs.empty())
            return fileError(path.string(), ErrorCode::Io,
                             RAMURE_NOOP("the folder has no .obj and no .animation"));
        return pairs;
    }
    addFile(pairs, path);
    if (pairs.empty())
        pairs[path.stem().string()].mesh = path;
    const fs::path other =
        fs::path(path).replace_extension(hasEnding(path, "animation") ? ".obj" : ".animation");
    if (fs::is_regular_file(other, problem))
        addFile(pairs, other);
    return pairs;
}

class Importer
{
public:
    Importer(const ImportOptions& options, const Progress& progress)
        : m_options(options)
        , m_progress(progress)
    {
    }

    Expected<BlenderImport> run(const std::string& path)
    {
        const auto pairs = pairsOf(path);
        RAMURE_TRY(pairs);
        std::size_t done = 0;
        for (const auto& [name, pair] : *pairs) {
            const double from = double(done++) / double(pairs->size());
            const Progress part = m_progress.part(from, from + 1.0 / double(pairs->size()));
            part.report(0.0);
            if (part.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            RAMURE_TRY(add(name, pair, part));
        }
        if (m_hasTransform)
            for (const std::string& file : m_withoutTransform)
                note(file, RAMURE_NOOP("there is no TRANSFORM: the object stands at the origin"));
        hang(fs::path(path));
        m_out.timeline = timelineOfKeys(m_out.nodes, m_saidRate, m_out.notes);
        return std::move(m_out);
    }

private:
    void note(const std::string& file, const char* text, std::vector<std::string> args = {})
    {
        Note note = fail(ErrorCode::Invalid, text, std::move(args)).value();
        note.file = file;
        m_out.notes.push_back(std::move(note));
    }
    void take(std::vector<Note>& notes)
    {
        std::move(notes.begin(), notes.end(), std::back_inserter(m_out.notes));
    }
    Expected<void> add(const std::string& name, const Pair& pair, const Progress& progress)
    {
        Node node;
        node.id = static_cast<NodeId>(m_out.nodes.size() + 1);
        node.name = name;
        node.kind = !pair.mesh.empty() ? NodeKind::Mesh : isCamera(name) ? NodeKind::Camera : NodeKind::Group;
        std::string parent;
        if (!pair.animation.empty())
            if (auto read = readAnimation(pair.animation, node, parent); !read)
                return read;
        if (!pair.mesh.empty())
            if (auto read = readMesh(pair.mesh, node, parent, progress); !read)
                return read;
        if (pair.mesh.empty())
            note(pair.animation.string(),
                 node.kind == NodeKind::Camera
                     ? RAMURE_NOOP("there is no .obj of this name: a camera, as it is called one")
                     : RAMURE_NOOP("there is no .obj of this name: a group that moves"));
        m_parents[node.id] = parent;
        m_out.nodes.push_back(std::move(node));
        return {};
    }
    Expected<void> readAnimation(const fs::path& path, Node& node, std::string& parent)
    {
        const auto text = textOf(path);
        RAMURE_TRY(text);
        auto read = parseAnimation(*text, path.string(), m_options.cubic);
        RAMURE_TRY(read);
        node.animation = std::move(read->animation);
        parent = read->parent;
        m_out.keyCount += read->keyCount;
        if (read->framesPerSecond >= leastFrameRate && read->framesPerSecond <= mostFrameRate)
            m_saidRate = read->framesPerSecond;
        take(read->notes);
        return {};
    }
    Expected<void> readMesh(const fs::path& path, Node& node, std::string& parent, const Progress& progress)
    {
        if (m_options.space && !node.animation.empty())
            return fileError(path.string(), ErrorCode::Invalid,
                             RAMURE_NOOP("an object with keys has Y up and metres: they cannot be chosen"));
        auto object = hasEnding(path, "obj") ? blenderObject(path, progress) : plainObject(path, progress);
        RAMURE_TRY(object);
        if (!object->parent.empty())
            parent = object->parent;
        take(object->notes);
        m_hasTransform = m_hasTransform || object->transform || !object->parent.empty();
        if (!object->transform)
            m_withoutTransform.push_back(path.string());
        else if (node.animation.empty())
            place(path, node, *object);
        putBack(node, *object);
        takeColour(node, object->mesh);
        if (object->mesh.empty() && object->mesh.positions.empty())
            node.kind = NodeKind::Group;
        else
            node.mesh = SharedValue<TriangleMesh>(std::move(object->mesh));
        return {};
    }
    Expected<BlenderObject> blenderObject(const fs::path& path, const Progress& progress)
    {
        const auto text = textOf(path);
        RAMURE_TRY(text);
        auto object = parseBlenderObject(*text, path.string(), progress, materialsBeside(path.string()));
        if (object)
            turn(*object, m_options.space.value_or(fileSpaceIn(*text).value_or(FileSpace())).matrix());
        return object;
    }
    /// Read with the space that the file says.
    Expected<BlenderObject> plainObject(const fs::path& path, const Progress& progress)
    {
        auto mesh = readMeshFile(path.string(), progress);
        RAMURE_TRY(mesh);
        BlenderObject object;
        object.mesh = mesh->joined();
        object.origin = mesh->origin;
        object.mesh.branch.clear();
        object.mesh.level.clear();
        for (std::string& said : mesh->notes)
            note(path.string(), "%1", {std::move(said)});
        if (m_options.space)
            turn(object, m_options.space->matrix() *
                             glm::inverse(fileSpaceOf(path.string()).value_or(FileSpace()).matrix()));
        return object;
    }
    /// Out of the file's space into the program's.
    static void turn(BlenderObject& object, const glm::dmat4& intoFile)
    {
        if (intoFile == glm::dmat4(1.0))
            return;
        const glm::dmat4 back = glm::inverse(intoFile);
        object.mesh = transformed(object.mesh, back);
        object.origin = glm::dmat3(back) * object.origin;
        if (object.transform)
            object.transform = back * *object.transform * intoFile;
    }
    /// One colour for all is the node's own; several stay as they are.
    static void takeColour(Node& node, TriangleMesh& mesh)
    {
        if (mesh.colours.empty())
            return;
        const glm::u8vec3 first = mesh.colours.front();
        const bool isOne = std::all_of(mesh.colours.begin(), mesh.colours.end(),
                                       [first](const glm::u8vec3& c) { return c == first; });
        node.params.surface.color = isOne ? glm::dvec3(first) / 255.0 : glm::dvec3(1.0);
        if (isOne)
            mesh.colours.clear();
    }
    /// What was subtracted from the coordinates, as far as it can be added again.
    void putBack(Node& node, const BlenderObject& object)
    {
        if (object.origin == glm::dvec3(0.0))
            return;
        NodeParams params = node.params;
        if (object.transform || !node.animation.empty())
            params.local.translation = object.origin;
        else {
            m_origin = m_origin.value_or(object.origin);
            params.tree.translation = object.origin - *m_origin;
        }
        if (checkParams(params))
            node.params = std::move(params);
    }
    /// As a placement where it is one that the parameters allow.
    void place(const fs::path& path, Node& node, BlenderObject& object)
    {
        const auto placement = placementNear(*object.transform);
        if (placement) {
            NodeParams params;
            params.tree = *placement;
            if (checkParams(params)) {
                node.params.tree = *placement;
                return;
            }
        }
        object.mesh = transformed(object.mesh, *object.transform);
        object.origin = glm::dmat3(*object.transform) * object.origin;
        note(path.string(),
             RAMURE_NOOP("the TRANSFORM shears, mirrors or flattens: it was put into the vertices"));
    }
    /// Below the parents that the files name, all below one group where there are several at the top.
    void hang(const fs::path& path)
    {
        std::map<std::string, NodeId> byName;
        for (const Node& node : m_out.nodes)
            byName[node.name] = node.id;
        std::size_t tops = 0;
        for (Node& node : m_out.nodes) {
            const std::string& parent = m_parents[node.id];
            const auto found = byName.find(parent);
            if (!parent.empty() && (found == byName.end() || isAbove(node.id, found->second)))
                note(node.name, RAMURE_NOOP("the parent \"%1\" cannot be: the object is at the top"),
                     {parent});
            else if (!parent.empty())
                node.parent = found->second;
            tops += node.parent == noNode ? 1 : 0;
        }
        if (tops > 1) {
            Node group;
            group.id = static_cast<NodeId>(m_out.nodes.size() + 1);
            group.name = (path.has_filename() ? path.filename() : path.parent_path().filename()).string();
            for (Node& node : m_out.nodes)
                if (node.parent == noNode)
                    node.parent = group.id;
            m_out.nodes.push_back(std::move(group));
        }
        // The top first, parents before their children.
        m_out.nodes = Scene::fromNodes(std::move(m_out.nodes))->nodes();
        if (m_out.nodes.size() > 2 && std::all_of(m_parents.begin(), m_parents.end(),
                                                  [](const auto& entry) { return entry.second.empty(); }))
            note(path.string(), RAMURE_NOOP("no file names a parent: all objects stand side by side"));
    }
    [[nodiscard]] bool isAbove(NodeId above, NodeId below) const
    {
        for (NodeId id = below; id != noNode; id = m_out.nodes[id - 1].parent)
            if (id == above)
                return true;
        return false;
    }
    const ImportOptions& m_options;
    const Progress& m_progress;
    BlenderImport m_out;
    std::map<NodeId, std::string> m_parents;
    bool m_hasTransform = false; ///< some file does, or says what else a script says
    std::vector<std::string> m_withoutTransform;
    double m_saidRate = 0.0;
    std::optional<glm::dvec3> m_origin; ///< of the first object that was far from the origin
};

} // namespace

Expected<BlenderImport> importObjects(const std::string& path, const ImportOptions& options,
                                      const Progress& progress)
{
    std::error_code problem;
    if (fs::is_directory(path, problem))
        return importBlender(path, options, progress);
    const auto format = findFormat(path, FormatUse::Import);
    return format ? (*format)->import(path, options, progress) : fail(format.error());
}

Expected<BlenderImport> importBlender(const std::string& path, const ImportOptions& options,
                                      const Progress& progress)
{
    return Importer(options, progress).run(path);
}

} // namespace ramure
