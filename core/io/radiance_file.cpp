#include "core/io/light_picture.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <vector>

namespace ramure {
namespace {

using Rgbe = std::array<unsigned char, 4>;

struct Size
{
    int width = 0, height = 0;
};

tl::unexpected<Error> endsEarly(int y)
{
    return fail(ErrorCode::Syntax, RAMURE_NOOP("the picture is damaged: it ends in row %1"),
                {std::to_string(y + 1)});
}

/// "-Y height +X width": rows from the top, from left to right.
Expected<Size> sizeOf(const std::string& line)
{
    Size size;
    const auto across = line.find(" +X ");
    if (!line.starts_with("-Y ") || across == std::string::npos)
        return fail(ErrorCode::Syntax, RAMURE_NOOP("\"%1\": \"-Y height +X width\" expected"),
                    {line.substr(0, 40)});
    std::from_chars(line.data() + 3, line.data() + across, size.height);
    std::from_chars(line.data() + across + 4, line.data() + line.size(), size.width);
    return size;
}

Expected<Size> header(std::istream& file)
{
    constexpr std::size_t longest = 65536; // of a header, lines and all
    std::size_t total = 0;
    for (std::string line; std::getline(file, line) && (total += line.size() + 1) < longest;) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            return fail(ErrorCode::Syntax, RAMURE_NOOP("\"%1\": \"FORMAT=32-bit_rle_rgbe\" expected"),
                        {line.substr(0, 40)});
        if (line.empty() && std::getline(file, line))
            return sizeOf(line);
    }
    return fail(ErrorCode::Syntax, RAMURE_NOOP("the picture is damaged: its header has no end"));
}

/// Pixels one after the other; 1 1 1 n repeats the one before.
bool readFlat(std::istream& file, std::vector<Rgbe>& row, std::size_t x, int shift = 0)
{
    while (x < row.size()) {
        Rgbe next;
        if (!file.read(reinterpret_cast<char*>(next.data()), 4))
            return false;
        if (next[0] != 1 || next[1] != 1 || next[2] != 1) {
            row[x++] = next;
            shift = 0;
            continue;
        }
        if (x == 0 || shift > 16)
            return false;
        for (std::size_t n = std::size_t(next[3]) << shift; n > 0 && x < row.size(); --n, ++x)
            row[x] = row[x - 1];
        shift += 8;
    }
    return true;
}

/// One colour after the other, in runs.
bool readRuns(std::istream& file, std::vector<Rgbe>& row)
{
    constexpr int literal = 128; // longer counts are repetitions
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t x = 0; x < row.size();) {
            int count = file.get();
            const bool repeats = count > literal;
            count -= repeats ? literal : 0;
            if (count <= 0 || x + std::size_t(count) > row.size())
                return false;
            int value = repeats ? file.get() : 0;
            for (; count > 0; --count) {
                value = repeats ? value : file.get();
                row[x++][i] = static_cast<unsigned char>(value);
            }
            if (!file)
                return false;
        }
    return true;
}

bool readRow(std::istream& file, std::vector<Rgbe>& row)
{
    Rgbe first;
    if (!file.read(reinterpret_cast<char*>(first.data()), 4))
        return false;
    if (first[0] == 2 && first[1] == 2 && std::size_t(first[2] << 8 | first[3]) == row.size())
        return readRuns(file, row);
    row[0] = first;
    return readFlat(file, row, 1);
}

} // namespace

Expected<void> readRadianceRows(const std::string& path, const LightRows& rows)
{
    std::ifstream file(path, std::ios::binary);
    const auto size = header(file);
    RAMURE_TRY(size);
    RAMURE_TRY(rows.begin(size->width, size->height));
    std::vector<Rgbe> row(std::size_t(size->width));
    std::vector<glm::vec3> light(row.size());
    for (int y = 0; y < size->height; ++y) {
        if (!readRow(file, row))
            return endsEarly(y);
        for (std::size_t x = 0; x < row.size(); ++x) {
            const Rgbe& p = row[x];
            light[x] = p[3] == 0 ? glm::vec3(0.0f)
                                 : glm::vec3(float(p[0]) + 0.5f, float(p[1]) + 0.5f, float(p[2]) + 0.5f) *
                                       std::ldexp(1.0f, int(p[3]) - 136);
        }
        RAMURE_TRY(rows.add(y, light));
    }
    return {};
}

} // namespace ramure
