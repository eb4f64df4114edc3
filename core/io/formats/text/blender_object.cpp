// OBJ with a TRANSFORM.
#include "core/base/plain_text.h"
#include "core/io/formats/text/blender_scene.h"

#include <array>
#include <charconv>
#include <cmath>

namespace ramure {
namespace {

constexpr std::string_view keyword = "transform"; // in capitals, as a rule
constexpr std::string_view blanks = " \t\r\n";

/// Finds the TRANSFORM, and takes it out of the text without moving any line.
class TransformReader
{
public:
    TransformReader(std::string& text, const std::string& file)
        : m_text(text)
        , m_file(file)
    {
    }

    Expected<void> read(BlenderObject& object)
    {
        int line = 1;
        for (std::size_t at = 0; at < m_text.size(); ++line) {
            const std::size_t end = std::min(m_text.find('\n', at), m_text.size());
            const std::string_view content = std::string_view(m_text).substr(at, end - at);
            const std::size_t first = content.find_first_not_of(" \t");
            const std::string_view word = first == std::string_view::npos ? "" : content.substr(first);
            if (word.starts_with("# parent="))
                object.parent = std::string(trimmed(word.substr(9)));
            if (isKeyword(word)) {
                if (object.transform)
                    object.notes.push_back(problem(ErrorCode::Invalid, line,
                                                   RAMURE_NOOP("TRANSFORM stands twice: the last counts"))
                                               .value());
                if (auto taken = take(at + first, line, object); !taken)
                    return taken;
            }
            at = end + 1;
        }
        return {};
    }

private:
    static std::string_view trimmed(std::string_view text)
    {
        const std::size_t last = text.find_last_not_of(blanks);
        return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
    }
    static bool isKeyword(std::string_view word)
    {
        return isWord(word.substr(0, keyword.size()), keyword) &&
               (word.size() == keyword.size() || blanks.find(word[keyword.size()]) != std::string_view::npos);
    }
    tl::unexpected<Error> problem(ErrorCode code, int line, const char* text,
                                  std::vector<std::string> args = {}) const
    {
        auto error = fail(code, text, std::move(args));
        error.value().file = m_file;
        error.value().line = line;
        return error;
    }
    /// The keyword and the numbers behind it become blanks, the ends of lines stay.
    Expected<void> take(std::size_t begin, int line, BlenderObject& object)
    {
        std::array<double, 16> numbers{};
        std::size_t count = 0, at = begin + keyword.size(), end = at;
        for (; count < numbers.size(); ++count) {
            at = m_text.find_first_not_of(blanks, at);
            if (at == std::string::npos)
                break;
            const std::size_t behind = std::min(m_text.find_first_of(blanks, at), m_text.size());
            const std::string_view digits = std::string_view(m_text).substr(at, behind - at);
            const auto [stop, status] =
                std::from_chars(digits.data(), digits.data() + digits.size(), numbers[count]);
            if (status != std::errc() || stop != digits.data() + digits.size())
                break;
            if (!std::isfinite(numbers[count]))
                return problem(ErrorCode::Invalid, line, RAMURE_NOOP("must be a finite number"));
            at = end = behind;
        }
        if (count < numbers.size())
            return problem(ErrorCode::Syntax, line, RAMURE_NOOP("TRANSFORM has %1 numbers, 16 are expected"),
                           {std::to_string(count)});
        for (std::size_t i = begin; i < end; ++i)
            if (m_text[i] != '\n')
                m_text[i] = ' ';
        return keep(numbers, line, object);
    }
    Expected<void> keep(const std::array<double, 16>& numbers, int line, BlenderObject& object) const
    {
        glm::dmat4 matrix(1.0);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            matrix[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = numbers[i];
        const bool affine =
            numbers[12] == 0.0 && numbers[13] == 0.0 && numbers[14] == 0.0 && numbers[15] == 1.0;
        if (!affine)
            return problem(ErrorCode::Invalid, line,
                           RAMURE_NOOP("the last row of TRANSFORM must be 0 0 0 1"));
        object.transform = matrix;
        return {};
    }

    std::string& m_text;
    const std::string& m_file;
};

} // namespace

/// Any line of this keyword: a file that only places something has no vertices, a curve no faces.
static bool hasLine(std::string_view text, std::string_view word)
{
    for (TextLines lines(text); lines.next();)
        if (isWord(lines.line().substr(0, lines.line().find_first_of(" \t")), word))
            return true;
    return false;
}

Expected<BlenderObject> parseBlenderObject(std::string_view text, const std::string& file,
                                           const Progress& progress, const MaterialSource& materials)
{
    const PlainText plain(text);
    std::string copy(plain.view());
    BlenderObject object;
    RAMURE_TRY(TransformReader(copy, file).read(object));
    if (object.transform && !hasLine(copy, "f")) {
        if (hasLine(copy, "v")) {
            object.notes.push_back(
                fail(ErrorCode::Invalid, RAMURE_NOOP("points without faces: a group stands in their place"))
                    .value());
            object.notes.back().file = file;
        }
        return object;
    }
    auto mesh = parseObj(copy, file, progress, materials);
    RAMURE_TRY(mesh);
    for (std::string& said : mesh->notes) {
        Note note = fail(ErrorCode::Invalid, "%1", {std::move(said)}).value();
        note.file = file;
        object.notes.push_back(std::move(note));
    }
    object.mesh = mesh->joined();
    object.origin = mesh->origin;
    object.mesh.branch.clear();
    object.mesh.level.clear();
    if (object.mesh.normals.size() != object.mesh.positions.size())
        object.mesh.normals.clear();
    return object;
}

} // namespace ramure
