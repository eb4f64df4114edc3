/// \file
/// Where the numbers of a PLY body come from: text, or bytes in either order. Internal to core/io.
///
/// Both sources have the same functions; those that read return false after an error, which takeError() hands
/// over.
#pragma once

#include "core/io/formats/text/ply_header.h"
#include "core/io/read_parts.h"
#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

namespace ramure::reading {

/// What both have in common: where they are, and the error.
class PlySource
{
public:
    explicit PlySource(const std::string& file)
        : m_file(&file)
    {
    }
    /// Says of which element an unexpected end is.
    bool begin(const std::string& element, std::uint64_t number)
    {
        m_element = &element;
        m_number = number;
        return true;
    }
    Error takeError() { return std::move(*m_error); }

protected:
    bool store(Error error)
    {
        error.file = *m_file;
        m_error = std::move(error);
        return false;
    }
    static Error makeError(ErrorCode code, const char* text, std::vector<std::string> args)
    {
        return ramure::fail(code, text, std::move(args)).value();
    }
    Error endError() const
    {
        return makeError(ErrorCode::Syntax, RAMURE_NOOP("the file ends within element %1 of \"%2\""),
                         {std::to_string(m_number), m_element ? excerpt(*m_element) : std::string()});
    }

private:
    const std::string* m_file;
    const std::string* m_element = nullptr;
    std::uint64_t m_number = 0;
    std::optional<Error> m_error;
};

class AsciiSource : public PlySource
{
public:
    /// \param blocks the text behind the header; must outlive the source. \param headerLines for messages.
    /// \param isExact read in double precision, which takes longer
    AsciiSource(const ScanBlocks& blocks, const std::string& file, int headerLines, bool isExact)
        : PlySource(file)
        , m_isExact(isExact)
        , m_blocks(&blocks)
        , m_at(blocks.body.data())
        , m_end(blocks.body.data() + blocks.body.size())
        , m_line(headerLines + 1)
    {
    }

    bool fail(ErrorCode code, const char* text, std::vector<std::string> args = {})
    {
        Error error = makeError(code, text, std::move(args));
        error.line = m_line;
        return store(std::move(error));
    }
    bool number(PlyType type, double& value);
    bool integer(PlyType type, std::int64_t& value);
    bool listSize(const PlyProperty& list, std::uint64_t& size);
    bool skipList(const PlyProperty& list);
    [[nodiscard]] double fraction() const;
    /// Room worth taking for the triangles of \p element.
    [[nodiscard]] std::size_t mostTriangles(const PlyElement& element, const PlyProperty& list) const;
    void noteTrailing(std::vector<std::string>& notes);

private:
    bool findToken();
    bool toToken();
    bool badToken();
    [[nodiscard]] bool endsToken() const { return isBlank(*m_at) || *m_at == '\n'; }

    bool m_isExact;
    const ScanBlocks* m_blocks;
    const char* m_at;
    const char* m_end;
    bool m_isInRest = false;
    int m_line;
};

template <bool BigEndian> class BinarySource : public PlySource
{
public:
    BinarySource(std::string_view bytes, std::size_t begin, const std::string& file)
        : PlySource(file)
        , m_bytes(bytes)
        , m_at(begin)
    {
    }

    bool fail(ErrorCode code, const char* text, std::vector<std::string> args = {})
    {
        Error error = makeError(code, text, std::move(args));
        error.path = "byte " + std::to_string(m_at);
        return store(std::move(error));
    }
    bool number(PlyType type, double& value)
    {
        switch (type) {
        case PlyType::Float32:
            return take<float>(value);
        case PlyType::Float64:
            return take<double>(value);
        default:
            break;
        }
        std::int64_t whole = 0;
        const bool isRead = integer(type, whole);
        value = static_cast<double>(whole);
        return isRead;
    }
    bool integer(PlyType type, std::int64_t& value)
    {
        switch (type) {
        case PlyType::Int8:
            return take<std::int8_t>(value);
        case PlyType::UInt8:
            return take<std::uint8_t>(value);
        case PlyType::Int16:
            return take<std::int16_t>(value);
        case PlyType::UInt16:
            return take<std::uint16_t>(value);
        case PlyType::Int32:
            return take<std::int32_t>(value);
        case PlyType::UInt32:
            return take<std::uint32_t>(value);
        default:
            return fail(ErrorCode::Syntax, RAMURE_NOOP("an integer expected"));
        }
    }
    bool listSize(const PlyProperty& list, std::uint64_t& size)
    {
        std::int64_t count = 0;
        if (!integer(list.countType, count))
            return false;
        if (count < 0)
            return fail(ErrorCode::Syntax, RAMURE_NOOP("a list of %1 values"), {std::to_string(count)});
        size = static_cast<std::uint64_t>(count);
        return size * sizeOf(list.type) <= left() || atEnd();
    }
    bool skipList(const PlyProperty& list)
    {
        std::uint64_t size = 0;
        if (!listSize(list, size))
            return false;
        m_at += size * sizeOf(list.type);
        return true;
    }
    [[nodiscard]] double fraction() const { return double(m_at) / double(m_bytes.size()); }
    [[nodiscard]] std::size_t mostTriangles(const PlyElement& element, const PlyProperty& list) const
    {
        const std::size_t each = sizeOf(list.countType) + 3 * sizeOf(list.type);
        return static_cast<std::size_t>(std::min<std::uint64_t>(element.count, left() / each));
    }
    void noteTrailing(std::vector<std::string>& notes)
    {
        if (left() > 0)
            notes.push_back(std::to_string(left()) + " bytes behind the last element");
    }

private:
    [[nodiscard]] std::uint64_t left() const { return m_bytes.size() - m_at; }
    bool atEnd()
    {
        Error error = endError();
        error.path = "byte " + std::to_string(m_at);
        return store(std::move(error));
    }
    template <class T, class To> bool take(To& to)
    {
        char bytes[sizeof(T)];
        if (left() < sizeof(T))
            return atEnd();
        std::memcpy(bytes, m_bytes.data() + m_at, sizeof(T));
        if constexpr (BigEndian != (std::endian::native == std::endian::big))
            std::reverse(bytes, bytes + sizeof(T));
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        m_at += sizeof(T);
        to = static_cast<To>(value);
        return true;
    }

    std::string_view m_bytes;
    std::size_t m_at;
};

/// The common case, in a fraction of the time: little endian, vertices of scalars with float positions,
/// triangles as a byte and three 32-bit indices, nothing else. Nothing where the file is different, or wrong:
/// the general reader, which says what and where, has to read it.
std::optional<ReadMesh> readPlainPly(std::string_view bytes, const PlyHeader& header,
                                     const Progress& progress);
/// The same from a file that stands where the data begin but for \p begun, which was read already.
std::optional<ReadMesh> readPlainPly(InputFile& file, std::string_view begun, const PlyHeader& header,
                                     const Progress& progress);

} // namespace ramure::reading
