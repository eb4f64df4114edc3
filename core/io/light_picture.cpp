#include "core/io/light_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace ramure {
namespace {

constexpr float largest = 1e30f; ///< of what is added up; pictures of 16 bits end at 65504

tl::unexpected<Error> in(const std::string& path, Error error)
{
    error.file = path;
    return tl::make_unexpected(std::move(error));
}

/// The first column that is not a number.
std::optional<std::size_t> clean(std::span<const glm::vec3> row, std::vector<glm::vec3>& out)
{
    out.assign(row.begin(), row.end());
    for (std::size_t x = 0; x < out.size(); ++x)
        for (int i = 0; i < 3; ++i) {
            if (std::isnan(out[x][i]))
                return x;
            out[x][i] = std::isinf(out[x][i]) ? (out[x][i] > 0.0f ? 65504.0f : 0.0f)
                                              : std::clamp(out[x][i], 0.0f, largest);
        }
    return std::nullopt;
}

Expected<std::string> firstBytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::error_code none;
    if (!file || std::filesystem::is_directory(path, none))
        return in(path, fail(ErrorCode::Io, RAMURE_NOOP("this picture cannot be opened")).value());
    std::string bytes(4, '\0');
    file.read(bytes.data(), 4);
    return bytes;
}

} // namespace

Expected<void> readLightPicture(const std::string& path, const LightRows& rows, const Progress& progress)
{
    const auto first = firstBytes(path);
    RAMURE_TRY(first);
    const bool isExr = *first == "\x76\x2f\x31\x01";
    if (!isExr && !first->starts_with("#?"))
        return in(path, fail(ErrorCode::Syntax,
                             RAMURE_NOOP("this is neither a Radiance HDR nor an OpenEXR picture"))
                            .value());
    std::vector<glm::vec3> row;
    int height = 1;
    const LightRows cleaned{[&](int w, int h) {
                                height = h;
                                return rows.begin(w, h);
                            },
                            [&](int y, std::span<const glm::vec3> raw) -> Expected<void> {
                                if (progress.cancelled())
                                    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
                                if (const auto bad = clean(raw, row))
                                    return fail(ErrorCode::Invalid,
                                                RAMURE_NOOP("row %1, column %2 is not a number"),
                                                {std::to_string(y + 1), std::to_string(*bad + 1)});
                                if (y % 64 == 0)
                                    progress.report(double(y) / height);
                                return rows.add(y, row);
                            }};
    auto read = isExr ? readExrRows(path, cleaned) : readRadianceRows(path, cleaned);
    return read ? read : in(path, std::move(read.error()));
}

} // namespace ramure
