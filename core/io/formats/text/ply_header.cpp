#include "core/io/formats/text/ply_header.h"
#include "core/base/plain_text.h"
#include "core/io/read_parts.h"
#include <charconv>
#include <optional>

namespace ramure::reading {

namespace {

constexpr std::size_t maxProperties = 1000;

struct TypeName
{
    std::string_view name;
    PlyType type;
};
constexpr TypeName typeNames[] = {
    {"char", PlyType::Int8},      {"uchar", PlyType::UInt8},    {"short", PlyType::Int16},
    {"ushort", PlyType::UInt16},  {"int", PlyType::Int32},      {"uint", PlyType::UInt32},
    {"float", PlyType::Float32},  {"double", PlyType::Float64}, {"int8", PlyType::Int8},
    {"uint8", PlyType::UInt8},    {"int16", PlyType::Int16},    {"uint16", PlyType::UInt16},
    {"int32", PlyType::Int32},    {"uint32", PlyType::UInt32},  {"float32", PlyType::Float32},
    {"float64", PlyType::Float64}};

std::optional<PlyType> typeNamed(std::string_view name)
{
    for (const TypeName& entry : typeNames)
        if (isWord(name, entry.name))
            return entry.type;
    return std::nullopt;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> out;
    std::size_t at = 0;
    while (at < line.size()) {
        while (at < line.size() && isBlank(line[at]))
            ++at;
        const std::size_t begin = at;
        while (at < line.size() && !isBlank(line[at]))
            ++at;
        if (at > begin)
            out.push_back(line.substr(begin, at - begin));
    }
    return out;
}

class HeaderParser
{
public:
    HeaderParser(std::string_view bytes, const std::string& file, std::uint64_t fileBytes)
        : m_bytes(bytes)
        , m_fileBytes(fileBytes)
        , m_file(file)
    {
    }

    Expected<PlyHeader> parse()
    {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        m_at = m_bytes.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
        // What lies behind the header may begin with a line feed: the first line says how all of them end.
        const std::size_t end = std::min(m_bytes.find_first_of("\r\n"), m_bytes.size());
        m_out.hasReturns = m_bytes.substr(end).starts_with('\r') && !m_bytes.substr(end).starts_with("\r\n");
        std::string_view line;
        const auto isFirst = [](const std::vector<std::string_view>& words) {
            return words.size() == 1 && isWord(words[0], "ply");
        };
        if (!nextLine(line) || !isFirst(wordsOf(line)))
            return error(RAMURE_NOOP("not a PLY file: it does not begin with \"ply\""));
        for (bool hasEnded = false; !hasEnded;) {
            if (!nextLine(line))
                return error(RAMURE_NOOP("the header has no end"));
            const auto words = wordsOf(line);
            if (words.empty() || isWord(words[0], "comment") || isWord(words[0], "obj_info"))
                continue;
            hasEnded = isWord(words[0], "end_header");
            if (!hasEnded)
                if (const auto taken = take(words); !taken)
                    return ramure::fail(taken.error());
        }
        if (!m_hasFormat)
            return error(RAMURE_NOOP("the header states no format"));
        m_out.bytes = m_at;
        m_out.lines = m_line;
        if (const auto room = checkRoom(); !room)
            return ramure::fail(room.error());
        return std::move(m_out);
    }

private:
    tl::unexpected<Error> error(const char* text, std::vector<std::string> args = {},
                                ErrorCode code = ErrorCode::Syntax) const
    {
        auto out = ramure::fail(code, text, std::move(args));
        out.value().file = m_file;
        out.value().line = m_line;
        return out;
    }
    bool nextLine(std::string_view& line)
    {
        constexpr std::size_t longest = 4096; // binary data may come without a line feed for long
        ++m_line;
        const std::size_t end = m_bytes.substr(m_at, longest).find(m_out.hasReturns ? '\r' : '\n');
        if (end == std::string_view::npos)
            return false;
        line = m_bytes.substr(m_at, end);
        m_at += end + 1;
        return true;
    }
    Expected<void> take(const std::vector<std::string_view>& words)
    {
        if (isWord(words[0], "format") && words.size() == 3)
            return takeFormat(words[1]);
        if (isWord(words[0], "element") && words.size() == 3)
            return takeElement(lowered(words[1]), words[2]);
        if (isWord(words[0], "property") &&
            (words.size() == 3 || (words.size() == 5 && isWord(words[1], "list"))))
            return takeProperty(words);
        return error(RAMURE_NOOP("not a line of a PLY header: \"%1\""), {excerpt(words[0])});
    }
    Expected<void> takeFormat(std::string_view name)
    {
        m_hasFormat = true;
        if (isWord(name, "ascii"))
            m_out.format = PlyFormat::Ascii;
        else if (isWord(name, "binary_little_endian"))
            m_out.format = PlyFormat::LittleEndian;
        else if (isWord(name, "binary_big_endian"))
            m_out.format = PlyFormat::BigEndian;
        else
            return error(RAMURE_NOOP("unknown format \"%1\""), {excerpt(name)});
        return {};
    }
    Expected<void> takeElement(const std::string& name, std::string_view count)
    {
        PlyElement element;
        element.name = name;
        const auto [end, problem] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (problem != std::errc() || end != count.data() + count.size())
            return error(RAMURE_NOOP("\"%1\" is no number of elements"), {excerpt(count)});
        for (const PlyElement& other : m_out.elements)
            if (other.name == name)
                return error(RAMURE_NOOP("two elements \"%1\""), {excerpt(name)});
        m_out.elements.push_back(std::move(element));
        m_elementLines.push_back(m_line);
        if (m_out.elements.size() > maxProperties)
            return error(RAMURE_NOOP("more than %1 elements"), {std::to_string(maxProperties)},
                         ErrorCode::Limit);
        return {};
    }
    Expected<void> takeProperty(const std::vector<std::string_view>& words)
    {
        if (m_out.elements.empty())
            return error(RAMURE_NOOP("a property before the first element"));
        PlyProperty property;
        property.isList = words.size() == 5;
        property.name = lowered(words.back());
        const auto type = typeNamed(words[words.size() - 2]);
        const auto countType = property.isList ? typeNamed(words[2]) : PlyType::UInt8;
        if (!type || !countType || !isInteger(*countType))
            return error(RAMURE_NOOP("unknown type of property \"%1\""), {excerpt(property.name)});
        property.type = *type;
        property.countType = *countType;
        PlyElement& element = m_out.elements.back();
        if (element.find(property.name) >= 0)
            return error(RAMURE_NOOP("two properties \"%1\""), {excerpt(property.name)});
        element.properties.push_back(std::move(property));
        if (element.properties.size() > maxProperties)
            return error(RAMURE_NOOP("more than %1 properties"), {std::to_string(maxProperties)},
                         ErrorCode::Limit);
        return {};
    }
    Expected<void> checkRoom()
    {
        // The last line of an ASCII file may lack its line feed.
        std::uint64_t left = m_fileBytes - m_at + (m_out.format == PlyFormat::Ascii ? 1 : 0);
        for (std::size_t i = 0; i < m_out.elements.size(); ++i) {
            const PlyElement& element = m_out.elements[i];
            const std::uint64_t each = element.smallestSize(m_out.format);
            if (each > 0 && element.count > left / each) {
                m_line = m_elementLines[i];
                return error(RAMURE_NOOP("the file is too short for %1 elements \"%2\""),
                             {std::to_string(element.count), excerpt(element.name)}, ErrorCode::Invalid);
            }
            left -= each * element.count;
        }
        return {};
    }

    std::string_view m_bytes;
    std::uint64_t m_fileBytes;
    const std::string& m_file;
    std::size_t m_at = 0;
    int m_line = 0;
    bool m_hasFormat = false;
    PlyHeader m_out;
    std::vector<int> m_elementLines;
};

} // namespace

int PlyElement::find(std::string_view propertyName) const
{
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == propertyName)
            return static_cast<int>(i);
    return -1;
}

std::uint64_t PlyElement::smallestSize(PlyFormat format) const
{
    std::uint64_t sum = 0;
    for (const PlyProperty& property : properties)
        if (format == PlyFormat::Ascii)
            sum += 2; // a digit and what separates it from the next
        else
            sum += sizeOf(property.isList ? property.countType : property.type);
    return sum;
}

Expected<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& file, std::uint64_t fileBytes)
{
    return HeaderParser(bytes, file, fileBytes).parse();
}

} // namespace ramure::reading
