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
    PlySource(std::string_view bytes, const std::string& file)
        : m_bytes(bytes)
        , m_file(&file)
    {
    }
    virtual ~PlySource() = default;

    /// Says of which element an unexpected end is.
    void begin(const std::string& element, std::uint64_t number)
    {
        m_element = &element;
        m_number = number;
    }
    bool fail(ErrorCode code, const char* text, std::vector<std::string> args = {});
    Error takeError() { return std::move(*m_error); }
    /// Bytes that are not read yet.
    [[nodiscard]] std::size_t left() const { return m_bytes.size() - m_at; }
    [[nodiscard]] double fraction() const { return 1.0 - double(left()) / double(m_bytes.size() + 1); }

protected:
    virtual void tellPlace(Error& error) const = 0;
    bool atEnd();

    std::string_view m_bytes;
    std::size_t m_at = 0;

private:
    const std::string* m_file;
    const std::string* m_element = nullptr;
    std::uint64_t m_number = 0;
    std::optional<Error> m_error;
};

class TextSource final : public PlySource
{
public:
    /// \param text behind the header; must outlive the source. \param headerLines for messages.
    /// \param isExact read in double precision, which takes longer
    TextSource(std::string_view text, const std::string& file, int headerLines, bool isExact)
        : PlySource(text, file)
        , m_isExact(isExact)
        , m_line(headerLines + 1)
    {
    }
    bool number(PlyType type, double& value);
    /// Whether a list of so many can be there: text tells it only by ending.
    bool holds(std::uint64_t, PlyType) { return true; }
    void noteTrailing(std::vector<std::string>& notes);

private:
    bool findToken();
    void tellPlace(Error& error) const override { error.line = m_line; }

    bool m_isExact;
    int m_line;
};

class BinarySource final : public PlySource
{
public:
    BinarySource(std::string_view bytes, const PlyHeader& header, const std::string& file)
        : PlySource(bytes, file)
        , m_isSwapped((header.format == PlyFormat::BigEndian) != (std::endian::native == std::endian::big))
    {
        m_at = header.bytes;
    }
    bool number(PlyType type, double& value)
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
        case PlyType::Float32:
            return take<float>(value);
        case PlyType::Float64:
            break;
        }
        return take<double>(value);
    }
    bool holds(std::uint64_t size, PlyType type) { return size * sizeOf(type) <= left() || atEnd(); }
    void noteTrailing(std::vector<std::string>& notes)
    {
        if (left() > 0)
            notes.push_back(std::to_string(left()) + " bytes behind the last element");
    }

private:
    void tellPlace(Error& error) const override { error.path = "byte " + std::to_string(m_at); }
    template <class T> bool take(double& to)
    {
        char bytes[sizeof(T)];
        if (left() < sizeof(T))
            return atEnd();
        std::memcpy(bytes, m_bytes.data() + m_at, sizeof(T));
        if (m_isSwapped)
            std::reverse(bytes, bytes + sizeof(T));
        to = static_cast<double>(std::bit_cast<T>(bytes));
        m_at += sizeof(T);
        return true;
    }

    bool m_isSwapped;
};

} // namespace ramure::reading
