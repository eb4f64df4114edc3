#include "core/io/file_space.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ramure {
namespace {

constexpr std::size_t headSize = 4096;

/// The text of a comment line of either format, or nothing.
std::string_view commentOf(std::string_view line)
{
    for (const std::string_view sign : {"# ", "comment "})
        if (line.starts_with(sign))
            return line.substr(sign.size());
    return {};
}

/// The word behind a keyword that must come next.
std::optional<std::string> wordAfter(std::string_view& text, std::string_view keyword)
{
    if (!text.starts_with(keyword))
        return std::nullopt;
    text.remove_prefix(keyword.size());
    const std::size_t end = std::min(text.find_first_of(", \r"), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(end);
    return word;
}

std::optional<FileSpace> spaceIn(std::string_view comment)
{
    const auto up = wordAfter(comment, "up "), unit = wordAfter(comment, ", unit "),
               scale = wordAfter(comment, ", scale ");
    if (!up || !unit || !scale)
        return std::nullopt;
    double number = 0.0;
    const auto [end, problem] = std::from_chars(scale->data(), scale->data() + scale->size(), number);
    if (problem != std::errc() || end != scale->data() + scale->size())
        return std::nullopt;
    const auto axis = upAxisNamed(*up);
    const auto length = lengthUnitNamed(*unit);
    const auto checked = fileScaleOf(number);
    if (!axis || !length || !checked)
        return std::nullopt;
    return FileSpace{*axis, *length, *checked};
}

} // namespace

glm::dmat4 FileSpace::matrix() const
{
    const double size = scale / lengthUnits[unit].metres;
    glm::dmat4 out(size);
    out[3][3] = 1.0;
    if (up == UpAxis::Z) {
        out[1] = {0.0, 0.0, size, 0.0};
        out[2] = {0.0, -size, 0.0, 0.0};
    }
    return out;
}

std::string FileSpace::comment() const
{
    if (isOwn())
        return {};
    return std::string("up ") + (up == UpAxis::Z ? "z" : "y") + ", unit " + lengthUnits[unit].name +
           ", scale " + numberText(scale);
}

Expected<UpAxis> upAxisNamed(const std::string& name)
{
    if (name == "y" || name == "Y")
        return UpAxis::Y;
    if (name == "z" || name == "Z")
        return UpAxis::Z;
    return fail(ErrorCode::Unknown, RAMURE_NOOP("unknown axis \"%1\": y or z expected"), {name});
}

Expected<std::size_t> lengthUnitNamed(const std::string& name)
{
    std::string names;
    for (std::size_t i = 0; i < std::size(lengthUnits); ++i) {
        if (name == lengthUnits[i].name)
            return i;
        names.append(i == 0 ? "" : ", ").append(lengthUnits[i].name);
    }
    return fail(ErrorCode::Unknown, RAMURE_NOOP("unknown unit \"%1\": one of %2 expected"), {name, names});
}

Expected<double> fileScaleOf(double number)
{
    if (number >= FileSpace::leastScale && number <= FileSpace::mostScale)
        return number;
    return fail(ErrorCode::Invalid, RAMURE_NOOP("the scale must be from %1 to %2"),
                {numberText(FileSpace::leastScale), numberText(FileSpace::mostScale)});
}

std::optional<FileSpace> fileSpaceIn(std::string_view head)
{
    const PlainText plain(head.substr(0, headSize));
    for (TextLines lines(plain.view()); lines.next();)
        if (auto space = spaceIn(commentOf(lines.line())))
            return space;
    return std::nullopt;
}

std::optional<FileSpace> fileSpaceOf(const std::string& path)
{
    // What comes through a pipe can be read only once.
    if (std::error_code problem; !std::filesystem::is_regular_file(path, problem))
        return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    std::string head(headSize, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return fileSpaceIn(head);
}

} // namespace ramure
