/// \file
/// The text of a USD layer (.usda): prims with what they say of themselves, their attributes and arrays of
/// numbers. Internal to the formats.
#pragma once

#include "core/base/file_writer.h"
#include "core/base/progress.h"
#include "core/io/float_text.h"
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ramure::usd {

/// Any text between quotation marks, on one line.
std::string inQuotes(std::string_view text);
/// The path of a prim as relationships name it: "</Scene/Oak>".
std::string target(const std::string& path);
/// A matrix as USD has it: rows of a row vector's matrix, the translation last.
std::string matrixText(const glm::dmat4& matrix);
/// "(0.5, 0.25, 1)", each number at most four decimals.
std::string colourText(const glm::vec3& colour);

/// The names of prims below one parent: letters, digits and underscores, each name once.
class Names
{
public:
    /// \param text any name that people gave. \return a name that is free; it is taken now.
    std::string take(const std::string& text);

private:
    std::set<std::string> m_taken;
};

/// Room of one element of an array.
inline constexpr std::size_t elementRoom = 128;

/// Writes "(x, y, z)" of numbers that read back as they are. Returns the end of the text.
template <class Vector> char* appendTuple(char* to, const Vector& v)
{
    for (glm::length_t k = 0; k < Vector::length(); ++k) {
        *to++ = k == 0 ? '(' : ',';
        to = std::to_chars(to, to + 24, v[k]).ptr;
    }
    *to++ = ')';
    return to;
}
/// Writes a number with at most so many decimals, shorter where the rest is 0.
char* appendRounded(char* to, double number, double scale = 1e4);
/// The same of all numbers of a vector, between brackets.
template <class Vector> char* appendRoundedTuple(char* to, const Vector& v, double scale = 1e4)
{
    for (glm::length_t k = 0; k < Vector::length(); ++k) {
        *to++ = k == 0 ? '(' : ',';
        to = appendRounded(to, double(v[k]), scale);
    }
    *to++ = ')';
    return to;
}

class Text
{
public:
    /// \param file that gets the text piece by piece; null: it stays in memory
    Text(FileWriter* file, const Progress& progress)
        : m_file(file)
        , m_progress(progress)
    {
    }

    /// A line, as far to the right as prims are open.
    void line(std::string_view text);
    /// Begins a prim, such as `def Mesh "bark"`. \param metadata lines between the brackets behind it
    void open(const std::string& head, const std::vector<std::string>& metadata = {});
    /// Begins a block without metadata, such as `variantSet "lod" = {`.
    void openBlock(const std::string& head);
    void close();

    /// \param head such as "point3f[] points"; \param write `char* (char* to, std::size_t i)` writes element
    /// i into at most elementRoom bytes. \param metadata lines between brackets behind the array
    template <class Write>
    void array(std::string_view head, std::size_t count, Write&& write,
               const std::vector<std::string>& metadata = {})
    {
        indent();
        m_text.append(head).append(" = ");
        values(count, write);
        endArray(metadata);
    }
    /// One line of timeSamples: "2: [...],".
    template <class Write> void sample(double code, std::size_t count, Write&& write)
    {
        indent();
        std::array<char, 32> number{};
        m_text.append(number.data(), appendRounded(number.data(), code, 1e6)).append(": ");
        values(count, write);
        m_text.append(",\n");
        flush();
    }

    /// True where nobody waits for the rest.
    [[nodiscard]] bool isStopped() const { return m_progress.cancelled() || (m_file && !m_file->isGood()); }
    /// Room for so many bytes in memory.
    void reserve(std::size_t bytes) { m_text.reserve(bytes); }
    /// What stayed in memory.
    [[nodiscard]] std::string take() && { return std::move(m_text); }
    /// Hands the rest to the file.
    void finish();

private:
    static constexpr std::size_t blockSize = std::size_t(1) << 16;

    template <class Write> void values(std::size_t count, Write&& write)
    {
        m_text += '[';
        std::array<char, blockSize> block;
        char* to = block.data();
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0)
                *to++ = ',';
            to = write(to, i);
            if (to > block.data() + blockSize - elementRoom) {
                m_text.append(block.data(), to);
                to = block.data();
                flush();
                if (isStopped())
                    break;
            }
        }
        m_text.append(block.data(), to).append("]");
    }
    void indent() { m_text.append(4 * m_depth, ' '); }
    void endArray(const std::vector<std::string>& metadata);
    void flush();

    FileWriter* m_file;
    const Progress& m_progress;
    std::string m_text;
    std::size_t m_depth = 0;
};

} // namespace ramure::usd
