#include "core/io/copy_list.h"

#include "core/io/write_parts.h"
#include "core/surface/mesh/transformed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/matrix.hpp>
#include <span>

namespace ramure {
namespace {

/// "tree_NAME" for "tree.ply".
std::string besidePath(const std::string& path, const std::string& name)
{
    std::filesystem::path out(path);
    out.replace_filename(out.stem().string() + "_" + name);
    return out.string();
}

/// As RFC 4180 has it.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out.append(c == '"' ? 2 : 1, c);
    return out + '"';
}

/// A text of JSON; bytes that are no UTF-8 stay as they are.
std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        constexpr const char* digits = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20)
            out.append("\\u00").append({digits[byte >> 4], digits[byte & 15]});
        else
            out.append(c == '"' || c == '\\' ? "\\" : "").append(1, c);
    }
    return out + '"';
}

std::string hexOf(std::uint64_t key)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string out;
    for (int shift = 60; shift >= 0; shift -= 4)
        out += digits[(key >> shift) & 15U];
    return out;
}

/// The files of the shapes, each once.
class ShapeFiles
{
public:
    ShapeFiles(const std::string& path, const ExportScene& scene, const WriteOptions& options)
        : m_path(path)
        , m_scene(scene)
        , m_options(options)
    {
    }

    /// The name of the file, which is written where it was not yet.
    Expected<std::string> of(const ExportCopies& copies, const Progress& progress)
    {
        const std::string part = copies.name.substr(0, copies.name.find('_')),
                          base = part + "_" + copies.kind;
        std::string name = base;
        for (int number = 2;; ++number) {
            const auto same = std::ranges::find(m_written, name, &Written::name);
            if (same == m_written.end())
                break;
            if (same->material == copies.material && *same->shape == *copies.shape)
                return fileOf(name);
            name = base + "_" + std::to_string(number);
        }
        const TriangleMesh shape = transformed(*copies.shape, m_scene.space.matrix());
        const MeshPart whole{name, &shape, m_scene.materials[copies.material]};
        const std::string file = besidePath(m_path, name + ".obj");
        RAMURE_TRY(writeObj(file, {&whole, 1}, progress, m_options));
        m_written.push_back({name, copies.material, copies.shape});
        return fileOf(name);
    }

private:
    struct Written
    {
        std::string name;
        Index material;
        std::shared_ptr<const TriangleMesh> shape;
    };
    [[nodiscard]] std::string fileOf(const std::string& name) const
    {
        return std::filesystem::path(besidePath(m_path, name + ".obj")).filename().string();
    }

    const std::string& m_path;
    const ExportScene& m_scene;
    const WriteOptions& m_options;
    std::vector<Written> m_written;
};

/// Everything of a row: the space of the file is that of its shape too.
struct Row
{
    std::string begin; ///< node, object, kind, mesh, material
    glm::dmat4 before, after;

    [[nodiscard]] std::array<float, 15> numbers(const ExportCopy& copy) const
    {
        const glm::dmat4 place = before * copy.place * after;
        std::array<float, 15> out{copy.tint.x, copy.tint.y, copy.tint.z};
        for (std::size_t i = 0; i < 12; ++i)
            out[3 + i] = static_cast<float>(place[static_cast<int>(i % 4)][static_cast<int>(i / 4)]);
        return out;
    }
};

/// Numbers with commas between.
char* appendNumbers(char* to, std::span<const float> numbers)
{
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0)
            *to++ = ',';
        to = appendFloat(to, std::isfinite(numbers[i]) ? numbers[i] : 0.0F);
    }
    return to;
}

/// A table and JSON.
struct Lists
{
    FileWriter& table;
    FileWriter& json;
};

bool writeRows(const Lists& out, const ExportCopies& copies, const Row& row, writing::Ticker& ticker,
               bool& areFinite)
{
    constexpr std::size_t most = 16 + 2 * maxIndexText + 15 * (maxFloatText + 1);
    std::size_t written = 0;
    for (const ExportCopy& copy : copies.copies) {
        const std::array<float, 15> numbers = row.numbers(copy);
        areFinite = areFinite && std::ranges::all_of(numbers, [](float n) { return std::isfinite(n); });
        out.table.append(row.begin); // of any length: nodes have names
        out.table.append(std::to_string(copy.branch) + "," + hexOf(copy.key) + ",");
        char* to = appendIndex(out.table.room(most), copy.number);
        *to++ = ',';
        to = appendNumbers(to, numbers);
        *to++ = '\n';
        out.table.advance(to);
        std::string begin(written == 0 ? "\n" : ",\n");
        out.json.append(begin.append("{\"branch\":")
                            .append(std::to_string(copy.branch))
                            .append(",\"address\":\"")
                            .append(hexOf(copy.key))
                            .append("\",\"number\":")
                            .append(std::to_string(copy.number))
                            .append(",\"colour\":["));
        out.json.advance(appendNumbers(out.json.room(most), std::span(numbers).first(3)));
        out.json.append("],\"matrix\":[");
        out.json.advance(appendNumbers(out.json.room(most), std::span(numbers).subspan(3)));
        out.json.append("]}");
        if (++written % writing::chunk == 0 && !ticker.tick(out.table, writing::chunk))
            return false;
    }
    return ticker.tick(out.table, written % writing::chunk);
}

tl::unexpected<Error> failAt(const std::string& path, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().file = path;
    return error;
}

} // namespace

std::string copyListPath(const std::string& path, const char* ending)
{
    return besidePath(path, std::string("leaves") + ending);
}

Expected<void> writeCopyList(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                             const Progress& progress)
{
    const std::string list = copyListPath(path);
    ShapeFiles files(path, scene, options);
    auto out = FileWriter::open(list);
    RAMURE_TRY(out);
    auto json = FileWriter::open(copyListPath(path, ".json"));
    RAMURE_TRY(json);
    json->append("{\"objects\":[");
    out->append("node,object,kind,mesh,material,branch,address,number,red,green,blue,"
                "m11,m12,m13,m14,m21,m22,m23,m24,m31,m32,m33,m34\n");
    std::size_t count = 0;
    for (const ExportCopies& copies : scene.copies)
        count += copies.copies.size();
    const Progress rows = progress.part(0.5, 1.0);
    writing::Ticker ticker(rows, count);
    const glm::dmat4 space = scene.space.matrix();
    for (std::size_t i = 0; i < scene.copies.size(); ++i) {
        const ExportCopies& copies = scene.copies[i];
        const double share = 0.5 / double(scene.copies.size());
        const auto file = files.of(copies, progress.part(share * double(i), share * double(i + 1)));
        RAMURE_TRY(file);
        Row row{{}, space * scene.frames.front().transforms[copies.node].geometry, glm::inverse(space)};
        const std::array texts{scene.nodes[copies.node].name, copies.name, copies.kind, *file,
                               scene.materials[copies.material].name};
        constexpr std::array keys{"node", "object", "kind", "mesh", "material"};
        json->append(i == 0 ? "\n{" : ",\n{");
        for (std::size_t t = 0; t < texts.size(); ++t) {
            row.begin += field(texts[t]) + ",";
            std::string entry("\"");
            json->append(entry.append(keys[t]).append("\":").append(quoted(texts[t])).append(","));
        }
        json->append("\"instances\":[");
        bool areFinite = true;
        const bool goesOn = writeRows({*out, *json}, copies, row, ticker, areFinite);
        if (ticker.cancelled())
            return failAt(list, ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        if (!areFinite)
            return failAt(list, ErrorCode::Invalid,
                          RAMURE_NOOP("the place of one of %1 is not a finite number"), {copies.name});
        if (!goesOn)
            break;
        json->append("]}");
    }
    json->append("\n]}\n");
    return FileWriter::commitTogether({&*json, &*out});
}

} // namespace ramure
