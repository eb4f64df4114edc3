#include "core/io/formats/file_format.h"

#include "core/io/file_space.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <cctype>
#include <glm/matrix.hpp>

namespace ramure {

bool isFor(const FileFormat& format, FormatUse use)
{
    switch (use) {
    case FormatUse::Read:
        return format.read != nullptr;
    case FormatUse::Import:
        return format.import != nullptr;
    case FormatUse::Write:
        break;
    }
    return format.write != nullptr;
}

std::string endingOf(const std::string& path)
{
    const std::size_t dot = path.find_last_of("./\\");
    std::string ending = dot == std::string::npos || path[dot] != '.' ? "" : path.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

std::string endingList(FormatUse use, const char* before, const char* between)
{
    std::string out, last;
    for (const FileFormat* format : fileFormats()) {
        if (!isFor(*format, use) || format->ending == last)
            continue;
        last = format->ending;
        out.append(out.empty() ? "" : between).append(before).append(last);
    }
    return out;
}

Expected<const FileFormat*> findFormat(const std::string& path, FormatUse use, bool asText)
{
    const std::string ending = endingOf(path);
    const FileFormat* found = nullptr;
    for (const FileFormat* format : fileFormats())
        if (isFor(*format, use) && format->ending == ending && (!found || format->isText == asText))
            found = format;
    if (found)
        return found;
    auto error =
        fail(ErrorCode::Unknown,
             use == FormatUse::Write ? RAMURE_NOOP("unknown file ending \"%1\": meshes are written as %2")
                                     : RAMURE_NOOP("unknown file ending \"%1\": %2 can be read"),
             {ending.empty() ? ending : '.' + ending, endingList(use)});
    error.value().file = path;
    return error;
}

Expected<ReadMesh> readMeshFile(const std::string& path, const Progress& progress)
{
    const auto format = findFormat(path, FormatUse::Read);
    RAMURE_TRY(format);
    auto mesh = (*format)->read(path, progress);
    if (const auto space = mesh ? fileSpaceOf(path) : std::nullopt) {
        const glm::dmat4 back = glm::inverse(space->matrix());
        mesh->origin = glm::dmat3(back) * mesh->origin;
        for (ReadObject& object : mesh->objects)
            object.mesh = transformed(object.mesh, back);
    }
    return mesh;
}

} // namespace ramure
