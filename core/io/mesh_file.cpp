#include "core/io/mesh_file.h"
#include "core/io/read_parts.h"
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace ramure {

Material barkMaterial()
{
    return {"bark", {0x8B, 0x5A, 0x2B}, false, false};
}

Material leavesMaterial()
{
    return {"leaves", {0x3A, 0x5F, 0x0B}, true, true};
}

Material applesMaterial()
{
    return {"apples", {0x5F, 0x0B, 0x0B}, true, false};
}

namespace {

void appendOrFill(std::vector<Index>& to, const std::vector<Index>& from, std::size_t before,
                  std::size_t count)
{
    if (to.empty() && from.empty())
        return;
    to.resize(before, noIndex);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, noIndex);
}

/// The objects one after the other.
TriangleMesh appended(const std::vector<ReadObject>& objects)
{
    TriangleMesh out;
    const bool hasNormals = std::all_of(objects.begin(), objects.end(), [](const ReadObject& object) {
        return object.mesh.normals.size() == object.mesh.positions.size();
    });
    for (const ReadObject& object : objects) {
        const TriangleMesh& mesh = object.mesh;
        const std::size_t before = out.positions.size();
        out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
        if (hasNormals)
            out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
        appendOrFill(out.branch, mesh.branch, before, mesh.positions.size());
        appendOrFill(out.level, mesh.level, before, mesh.positions.size());
        for (const glm::uvec3& t : mesh.triangles)
            out.triangles.push_back(t + static_cast<Index>(before));
    }
    return out;
}

/// The objects with the vertices of the file, each once.
TriangleMesh rewelded(const std::vector<ReadObject>& objects)
{
    Index count = 0;
    for (const ReadObject& object : objects)
        for (const Index v : object.fileVertex)
            count = std::max(count, v + 1);
    TriangleMesh out;
    out.positions.resize(count);
    const bool hasNormals = std::all_of(objects.begin(), objects.end(), [](const ReadObject& object) {
        return object.mesh.normals.size() == object.mesh.positions.size();
    });
    if (hasNormals)
        out.normals.resize(count);
    for (const ReadObject& object : objects) {
        for (std::size_t i = 0; i < object.fileVertex.size(); ++i) {
            out.positions[object.fileVertex[i]] = object.mesh.positions[i];
            if (hasNormals)
                out.normals[object.fileVertex[i]] = object.mesh.normals[i];
        }
        for (const glm::uvec3& t : object.mesh.triangles)
            out.triangles.emplace_back(object.fileVertex[t.x], object.fileVertex[t.y],
                                       object.fileVertex[t.z]);
    }
    return out;
}

} // namespace

TriangleMesh ReadMesh::joined() const
{
    if (objects.size() == 1)
        return objects.front().mesh;
    const bool isShared = std::any_of(objects.begin(), objects.end(),
                                      [](const ReadObject& object) { return !object.fileVertex.empty(); });
    return isShared ? rewelded(objects) : appended(objects);
}

Expected<ReadMesh> readMeshFile(const std::string& path, const Progress& progress)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending != ".obj" && ending != ".ply") {
        auto error = fail(ErrorCode::Unknown,
                          RAMURE_NOOP("unknown file ending \"%1\": .obj and .ply can be read"), {ending});
        error.value().file = path;
        return error;
    }
    const auto bytes = reading::loadFile(path);
    if (!bytes)
        return fail(bytes.error());
    return ending == ".obj" ? parseObj(bytes->view(), path, progress)
                            : parsePly(bytes->view(), path, progress);
}

namespace reading {

namespace {

tl::unexpected<Error> readError(const std::string& path, int code)
{
    auto error =
        fail(ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"), {std::generic_category().message(code)});
    error.value().file = path;
    return error;
}

/// Reads up to \p room bytes; fewer only at the end. Negative: an error, see errno.
ssize_t readFully(int file, char* to, std::size_t room)
{
    std::size_t done = 0;
    while (done < room) {
        const ssize_t got = ::read(file, to + done, room - done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return -1;
        if (got == 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return static_cast<ssize_t>(done);
}

/// Pipes and devices do not say how long they are.
constexpr std::size_t largestStream = std::size_t(1) << 30;

Expected<Bytes> loadStream(int file, const std::string& path)
{
    std::string text;
    for (;;) {
        const std::size_t before = text.size();
        constexpr std::size_t block = std::size_t(1) << 20;
        text.resize(before + block);
        const ssize_t got = readFully(file, text.data() + before, block);
        if (got < 0)
            return readError(path, errno);
        text.resize(before + static_cast<std::size_t>(got));
        if (static_cast<std::size_t>(got) < block)
            break;
        if (text.size() >= largestStream) {
            auto error = fail(ErrorCode::Limit, RAMURE_NOOP("more than 1 GiB from a pipe or device"));
            error.value().file = path;
            return error;
        }
    }
    Bytes out{LargeBuffer<char>(text.size() + 1), text.size()};
    text.copy(out.buffer.data(), text.size());
    return out;
}

} // namespace

Expected<Bytes> loadFile(const std::string& path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return readError(path, errno);
    struct Closer
    {
        int file;
        ~Closer() { ::close(file); }
    } closer{file};
    struct stat status = {};
    if (::fstat(file, &status) != 0)
        return readError(path, errno);
    if (!S_ISREG(status.st_mode))
        return loadStream(file, path);
    const auto size = static_cast<std::size_t>(status.st_size);
    Bytes out{LargeBuffer<char>(size + 1), 0};
    const ssize_t got = readFully(file, out.buffer.data(), size);
    if (got < 0)
        return readError(path, errno);
    out.size = static_cast<std::size_t>(got);
    return out;
}

std::string stem(const std::string& path)
{
    return std::filesystem::path(path).stem().string();
}

ScanBlocks::ScanBlocks(std::string_view text)
{
    // The last line feed that is far enough from the end and is not taken back by a backslash before it.
    std::size_t split =
        text.size() > padding ? text.rfind('\n', text.size() - padding - 1) : std::string_view::npos;
    const auto isContinued = [&](std::size_t at) {
        if (at > 0 && text[at - 1] == '\r')
            --at;
        return at > 0 && text[at - 1] == '\\';
    };
    while (split != std::string_view::npos && isContinued(split))
        split = split > 0 ? text.rfind('\n', split - 1) : std::string_view::npos;
    body = split == std::string_view::npos ? std::string_view() : text.substr(0, split + 1);
    rest = text.substr(body.size());
    rest += '\n';
    rest.append(padding, '\0');
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string out(text.substr(0, longest));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F)
            c = '?';
    return text.size() > longest ? out + "..." : out;
}

} // namespace reading

} // namespace ramure
