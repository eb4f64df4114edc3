/// \file
/// Parts that the OBJ and the PLY reader share. Internal to core/io.
#pragma once

#include "core/io/float_text.h"
#include "core/io/mesh_file.h"
#include <algorithm>
#include <string_view>

namespace ramure::reading {

/// The colour of triangles whose material names none, in a mesh where others have one.
inline constexpr glm::u8vec3 plainColour{184, 184, 184};

/// Elements or lines between two looks at the stop token.
inline constexpr std::size_t chunk = std::size_t(1) << 16;

inline constexpr std::string_view blanksOfLine = " \t\r";

/// A line without the blanks at its ends.
inline std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(blanksOfLine);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(blanksOfLine) - first + 1);
}

/// An open file that is read from its beginning to its end.
class InputFile
{
public:
    /// Error: Io.
    static Expected<InputFile> open(const std::string& path);
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&&) = delete;
    ~InputFile();

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] bool isRegular() const { return m_isRegular; }
    [[nodiscard]] std::size_t size() const { return m_size; } ///< bytes, for a regular file
    /// Reads up to \p room bytes; fewer only at the end. Error: Io.
    Expected<std::size_t> read(char* to, std::size_t room);
    void rewind(); ///< a regular file

private:
    InputFile(int file, std::string path);

    int m_file;
    std::string m_path;
    bool m_isRegular = false;
    std::size_t m_size = 0;
};

/// The rest of the file. Errors: Io, Limit (a device or pipe that does not end).
Expected<std::string> loadFile(InputFile& file);
Expected<std::string> loadFile(const std::string& path);

/// Bytes of a file that are looked at together: they stay in the cache.
inline constexpr std::size_t lineBlockSize = std::size_t(1) << 18;

/// A file as blocks of whole lines, in one buffer that stays in the cache: fresh memory of the whole file's
/// size would cost as much again as the mesh. Lines that a backslash continues are not torn.
class LineBlocks
{
public:
    /// \p size: of the buffer at first; a longer line makes it grow.
    explicit LineBlocks(InputFile& file, std::size_t size)
        : m_file(file)
        , m_buffer(std::max<std::size_t>(size, 1) + 1, '\0')
    {
    }
    /// The next block, or nothing when there is none. The last block ends in a line feed that the file need
    /// not have. Lone carriage returns have become line feeds. Error: Io.
    Expected<std::string_view> next();
    [[nodiscard]] bool isLast() const { return m_isAtEnd; }
    /// Counts the zeros and end marks behind the text, which are left out. It is known with the last block.
    [[nodiscard]] std::size_t padding() const { return m_padding; }

private:
    [[nodiscard]] std::size_t lastLineEnd() const;

    InputFile& m_file;
    std::string m_buffer;    ///< one byte more than are read, for the last line feed
    std::size_t m_used = 0;  ///< bytes in the buffer
    std::size_t m_given = 0; ///< bytes; those in front were already given out
    std::size_t m_padding = 0;
    bool m_isAtEnd = false;
};

/// "dir/tree.v2.obj" is "tree.v2": the name of an object that has none.
std::string stem(const std::string& path);

inline bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// Regular files in blocks.
Expected<ReadMesh> readObjFile(const std::string& path, const Progress& progress,
                               const MaterialSource& materials = {}, std::size_t blockSize = lineBlockSize);
Expected<ReadMesh> readPlyFile(const std::string& path, const Progress& progress);

/// Part of a text as it may be shown in a message: short, printable.
std::string excerpt(std::string_view text);

} // namespace ramure::reading
