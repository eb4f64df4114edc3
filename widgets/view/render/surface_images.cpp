#include "widgets/view/render/surface_images.h"

#include "core/lod/spray_picture.h"
#include "core/math/stage_hash.h"
#include "core/surface/bark/bark_maps.h"
#include "core/surface/foliage/leaf_maps.h"
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace ramure {
namespace {

constexpr int leastSide = 16, mostSide = 1024; ///< of what is drawn
constexpr float relief = 0.05f;                ///< of a picture of the height: white over black, in tiles

tl::unexpected<Error> refuse(const std::string& path, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().file = path;
    return error;
}

/// Whether it is a picture of a size that is read; \p reader stands before its pixels then.
Expected<QSize> openPicture(QImageReader& reader, QFile& file, const std::string& path)
{
    const QFileInfo info(file.fileName());
    if (!info.exists())
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("the picture is missing"));
    if (!info.isFile()) // nobody waits for a pipe
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("this is no file"));
    if (!file.open(QIODevice::ReadOnly))
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("cannot be opened: %1"),
                      {file.errorString().toStdString()});
    const QByteArray head = file.peek(4);
    const bool isPng = head.startsWith("\x89PNG"), isJpeg = head.startsWith("\xFF\xD8\xFF");
    if (!isPng && !isJpeg)
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("this is neither a PNG nor a JPEG picture"));
    reader.setFormat(isPng ? "png" : "jpeg");
    reader.setDevice(&file);
    const QSize size = reader.size();
    if (size.isEmpty())
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("the picture is broken: %1"),
                      {reader.errorString().toStdString()});
    if (std::max(size.width(), size.height()) > mostPictureSide)
        return refuse(
            path, ErrorCode::Limit, RAMURE_NOOP("the picture has %1 × %2 pixels: at most %3 a side"),
            {std::to_string(size.width()), std::to_string(size.height()), std::to_string(mostPictureSide)});
    return size;
}

/// The pictures of a surface on one size.
struct Loaded
{
    std::array<QImage, pictureFiles.size()> images; ///< null: none
    std::vector<Error> problems;
    int size = leastSide;

    [[nodiscard]] const QImage& of(PictureMap map) const { return images[static_cast<std::size_t>(map)]; }
};

Loaded load(const PictureParams& pictures)
{
    Loaded out;
    for (std::size_t i = 0; i < pictureFiles.size(); ++i) {
        const std::string& path = pictures.*pictureFiles[i];
        if (path.empty())
            continue;
        auto image = readPicture(path, mostSide);
        if (!image) {
            out.problems.push_back(image.error());
            continue;
        }
        out.size = std::max({out.size, image->width(), image->height()});
        out.images[i] = std::move(*image);
    }
    out.size = std::min(mostSide, static_cast<int>(std::bit_ceil(static_cast<unsigned>(out.size))));
    for (QImage& image : out.images)
        if (!image.isNull())
            image = image.scaled(out.size, out.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                        .convertToFormat(QImage::Format_RGBA8888)
                        .mirrored();
    return out;
}

glm::u8vec4 pixel(const QImage& image, std::size_t at)
{
    const uchar* p = image.constBits() + 4 * at; // rows of whole pixels have no gap
    return {p[0], p[1], p[2], p[3]};
}

std::uint8_t product(int a, int b)
{
    return static_cast<std::uint8_t>((a * b + 127) / 255);
}

/// Normals of a height that repeats.
glm::u8vec3 slope(const QImage& height, int size, int x, int y)
{
    const auto at = [&](int dx, int dy) {
        const int column = (x + dx + size) % size, row = (y + dy + size) % size;
        return float(pixel(height, static_cast<std::size_t>(row * size + column)).r) / 255.0f;
    };
    const float scale = 0.5f * relief * float(size);
    const glm::vec3 n =
        glm::normalize(glm::vec3((at(-1, 0) - at(1, 0)) * scale, (at(0, -1) - at(0, 1)) * scale, 1.0f));
    return glm::u8vec3(n * 127.0f + 128.5f);
}

/// What the program makes, where the surface has pictures of it.
struct Made
{
    std::optional<BarkMaps> bark;
    std::optional<LeafMaps> leaf;
};

Made made(const Material& material, int size)
{
    Made out;
    if (material.bark.family != BarkFamily::Plain)
        out.bark = std::move(*barkMaps(material.bark, size));
    else if (material.leaf != LeafShape::Faithful)
        out.leaf = std::move(*leafMaps(material.leaf, size));
    return out;
}

glm::u8vec4 colourAt(const Loaded& loaded, const Made& base, std::size_t at)
{
    glm::u8vec4 out(255);
    if (const QImage& image = loaded.of(PictureMap::Colour); !image.isNull())
        out = pixel(image, at);
    else if (base.bark)
        out = {base.bark->colour[at], 255};
    else if (base.leaf)
        out = {base.leaf->colour[at], 255};
    int open = 255;
    if (const QImage& image = loaded.of(PictureMap::Occlusion); !image.isNull())
        open = pixel(image, at).r;
    else if (base.bark)
        open = base.bark->occlusion[at];
    if (const QImage& image = loaded.of(PictureMap::Opacity); !image.isNull())
        out.a = pixel(image, at).r;
    return {product(out.r, open), product(out.g, open), product(out.b, open), out.a};
}

glm::u8vec4 normalAt(const Loaded& loaded, const Made& base, std::size_t at)
{
    glm::u8vec3 normal(128, 128, 255);
    const int size = loaded.size;
    if (const QImage& image = loaded.of(PictureMap::Normal); !image.isNull())
        normal = glm::u8vec3(pixel(image, at));
    else if (const QImage& height = loaded.of(PictureMap::Height); !height.isNull())
        normal = slope(height, size, static_cast<int>(at) % size, static_cast<int>(at) / size);
    else if (base.bark)
        normal = base.bark->normal[at];
    else if (base.leaf)
        normal = base.leaf->normal[at];
    const QImage& dull = loaded.of(PictureMap::Roughness);
    return {normal, dull.isNull() ? std::uint8_t(128) : pixel(dull, at).r};
}

/// Nobody takes them for a surface.
SurfaceImages checks(std::vector<Error> problems)
{
    constexpr int size = 64, square = 8;
    SurfaceImages out;
    out.size = size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            out.colour.push_back((x / square + y / square) % 2 == 0 ? glm::u8vec4(255, 0, 255, 255)
                                                                    : glm::u8vec4(20, 0, 20, 255));
    out.normal.assign(out.colour.size(), glm::u8vec4(128, 128, 255, 128));
    out.problems = std::move(problems);
    return out;
}

} // namespace

Expected<QImage> readPicture(const std::string& path, int most)
{
    QFile file(QFile::decodeName(path.c_str()));
    QImageReader reader;
    const auto size = openPicture(reader, file, path);
    RAMURE_TRY(size);
    if (most > 0 && std::max(size->width(), size->height()) > most)
        reader.setScaledSize(size->scaled(most, most, Qt::KeepAspectRatio).expandedTo({1, 1}));
    QImage image = reader.read();
    if (image.isNull())
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("the picture is broken: %1"),
                      {reader.errorString().toStdString()});
    return image;
}

std::vector<Error> pictureProblems(const PictureParams& pictures)
{
    std::vector<Error> out;
    for (const auto member : pictureFiles) {
        const std::string& path = pictures.*member;
        if (path.empty())
            continue;
        QFile file(QFile::decodeName(path.c_str()));
        QImageReader reader;
        if (const auto size = openPicture(reader, file, path); !size)
            out.push_back(size.error());
    }
    return out;
}

/// Twigs, or the tree, cut out of cards. What draws them cuts at a half.
static SurfaceImages imagesOfSprays(const CardAtlas& sprays)
{
    constexpr int side = 1024;
    const SprayMaps maps = sprayMaps(sprays, side).value();
    SurfaceImages out;
    out.size = side;
    out.isCut = true;
    for (std::size_t at = 0; at < maps.colour.size(); ++at) {
        out.colour.push_back(maps.colour[at]);
        out.normal.emplace_back(maps.normal[at], 128);
    }
    return out;
}

SurfaceImages surfaceImages(const Material& material)
{
    if (material.sprays)
        return imagesOfSprays(*material.sprays);
    Loaded loaded = load(material.pictures);
    const bool isBark = material.name.starts_with("bark");
    if (!loaded.problems.empty()) {
        SurfaceImages out = checks(std::move(loaded.problems));
        out.base = material.colour;
        return out;
    }
    const Made base = made(material, loaded.size);
    SurfaceImages out;
    out.size = loaded.size;
    out.isAged = isBark;
    if (material.pictures.colour.empty() && base.bark)
        out.base = material.colour;
    else if (material.pictures.colour.empty() && base.leaf)
        out.base = base.leaf->blade;
    const std::size_t count = static_cast<std::size_t>(out.size) * static_cast<std::size_t>(out.size);
    out.colour.reserve(count);
    out.normal.reserve(count);
    for (std::size_t at = 0; at < count; ++at) {
        out.colour.push_back(colourAt(loaded, base, at));
        out.normal.push_back(normalAt(loaded, base, at));
    }
    if (isBark) // closed, whatever its picture says
        for (glm::u8vec4& each : out.colour)
            each.a = 255;
    out.isCut = std::ranges::any_of(out.colour, [](const glm::u8vec4& each) { return each.a < 128; });
    return out;
}

std::uint64_t pictureStamp(const PictureParams& pictures)
{
    StageHash hash(0);
    for (const auto member : pictureFiles) {
        const std::string& path = pictures.*member;
        hash.add(std::string_view(path));
        if (path.empty())
            continue;
        const QFileInfo info(QFile::decodeName(path.c_str()));
        hash.add(static_cast<std::uint64_t>(info.size()))
            .add(static_cast<std::uint64_t>(info.lastModified().toMSecsSinceEpoch()));
    }
    return hash.value();
}

/// Half as large; colours count as far as they are there.
static std::vector<glm::vec4> halved(int size, const std::vector<glm::vec4>& pixels)
{
    const int half = std::max(1, size / 2);
    std::vector<glm::vec4> out;
    out.reserve(std::size_t(half) * std::size_t(half));
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < half; ++x) {
            glm::vec4 sum(0.0f), plain(0.0f);
            for (int i = 0; i < 4; ++i) {
                const int column = std::min(2 * x + i % 2, size - 1), row = std::min(2 * y + i / 2, size - 1);
                const glm::vec4& from = pixels[std::size_t(row) * std::size_t(size) + std::size_t(column)];
                sum += glm::vec4(from.a * glm::vec3(from), from.a);
                plain += 0.25f * from;
            }
            out.emplace_back(sum.a > 0.0f ? glm::vec3(sum) / sum.a : glm::vec3(plain), 0.25f * sum.a);
        }
    return out;
}

std::vector<std::vector<glm::u8vec4>> smallerPictures(int size, const std::vector<glm::u8vec4>& pixels)
{
    constexpr float threshold = 127.5f;
    std::vector<glm::vec4> level(pixels.begin(), pixels.end());
    const auto isThere = [](const glm::vec4& pixel) { return pixel.a > threshold; };
    const double share = double(std::ranges::count_if(level, isThere)) / double(level.size());
    std::vector<std::vector<glm::u8vec4>> out;
    for (; size > 1; size = std::max(1, size / 2)) {
        level = halved(size, level);
        std::vector<float> opacities;
        for (const glm::vec4& pixel : level)
            opacities.push_back(pixel.a);
        const auto gone = std::min(opacities.size() - 1,
                                   std::size_t(std::llround((1.0 - share) * double(opacities.size()))));
        std::ranges::nth_element(opacities, opacities.begin() + std::ptrdiff_t(gone));
        const float least = std::max(opacities[gone], 1.0f); // of what has to be there
        const float factor = share > 0.0 ? 128.0f / least : 0.0f;
        auto& bytes = out.emplace_back();
        for (const glm::vec4& pixel : level)
            bytes.emplace_back(glm::vec4(glm::vec3(pixel), std::min(pixel.a * factor, 255.0f)) + 0.5f);
    }
    return out;
}

} // namespace ramure
