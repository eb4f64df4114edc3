#include "widgets/view/render/passes/billboard_files.h"

#include "core/base/file_writer.h"
#include "core/base/version.h"
#include "core/io/export_scene.h"
#include "core/io/formats/file_format.h"
#include "core/io/picture_file.h"
#include "core/qt/base/system_path.h"
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

namespace ramure {
namespace {

/// \param channels the first ones; 1: the alpha alone
Expected<void> writePng(const QString& file, const BillboardPicture& picture,
                        const std::vector<glm::u8vec4>& pixels, int channels, bool areColours)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(pixels.size() * std::size_t(channels));
    for (int y = picture.height; y-- > 0;) // the lowest row first
        for (int x = 0; x < picture.width; ++x) {
            const glm::u8vec4& pixel = pixels[picture.at(x, y)];
            for (int c = 0; c < channels; ++c)
                bytes.push_back(channels == 1 ? pixel.a : pixel[c]);
        }
    const auto png = pngOf({picture.width, picture.height, channels, areColours, bytes});
    RAMURE_TRY(png);
    return writeFile(systemPath(file), *png);
}

/// In a file's folder.
QString beside(const QString& folder, const char* name)
{
    return QDir(folder).filePath(QLatin1String(name));
}

/// One GLB with its pictures inside.
Expected<void> writeCardFile(const BillboardCards& cards, const QString& file)
{
    const QTemporaryDir pictures;
    if (!pictures.isValid())
        return fail(ErrorCode::Io, RAMURE_NOOP("no temporary folder can be made: %1"),
                    {pictures.errorString().toStdString()});
    const BillboardPicture& picture = cards.picture;
    const QString colour = pictures.filePath(QStringLiteral("colour.png")),
                  normal = pictures.filePath(QStringLiteral("normal.png")),
                  opacity = pictures.filePath(QStringLiteral("opacity.png"));
    RAMURE_TRY(writePng(colour, picture, picture.colour, 3, true));
    RAMURE_TRY(writePng(normal, picture, picture.normal, 3, false));
    RAMURE_TRY(writePng(opacity, picture, picture.colour, 1, true));
    Material material;
    material.name = "billboard";
    material.twoSided = true;
    material.pictures.colour = systemPath(colour);
    material.pictures.normal = systemPath(normal);
    material.pictures.opacity = systemPath(opacity);
    std::vector<ReadObject> objects(1);
    objects[0].name = "billboard";
    objects[0].mesh = cards.mesh;
    const std::string path = systemPath(file);
    const auto format = findFormat(path, FormatUse::Write);
    RAMURE_TRY(format);
    return (*format)->write(path, sceneOfMeshes(std::move(objects), material), {}, {});
}

} // namespace

bool holdsViews(int size, int views)
{
    return size % views == 0 && size / views >= leastViewSize;
}

bool isCardFile(const QString& place)
{
    return place.endsWith(QLatin1String(".glb"), Qt::CaseInsensitive);
}

QStringList billboardFiles(bool isAtlas)
{
    if (isAtlas)
        return {QStringLiteral("atlas_colour.png"), QStringLiteral("atlas_normal.png"),
                QStringLiteral("atlas.json")};
    return {QStringLiteral("cards.glb"), QStringLiteral("cards_colour.png"),
            QStringLiteral("cards_normal.png")};
}

QJsonObject atlasJson(const BillboardAtlas& atlas)
{
    const auto text = [](const char* words) { return QJsonValue(QString::fromLatin1(words)); };
    return {
        {QStringLiteral("generator"), text("Ramure " RAMURE_VERSION)},
        {QStringLiteral("kind"), text("hemi-octahedral atlas")},
        {QStringLiteral("colourFile"), text("atlas_colour.png")},
        {QStringLiteral("normalFile"), text("atlas_normal.png")},
        {QStringLiteral("size"), atlas.picture.width},
        {QStringLiteral("views"), atlas.views},
        {QStringLiteral("viewSize"), atlas.picture.width / atlas.views},
        {QStringLiteral("middle"), QJsonArray{atlas.middle.x, atlas.middle.y, atlas.middle.z}},
        {QStringLiteral("radius"), atlas.radius},
        {QStringLiteral("units"), text("metres, Y up, right-handed")},
        {QStringLiteral("layout"),
         text("view (i, j): column i from the left, row j from the top, both from 0; each shows the square "
              "of 2 radius around the middle, straight (orthographic)")},
        {QStringLiteral("direction"),
         text("from the tree to the eye: u = 2 i / (views - 1) - 1, v = 2 j / (views - 1) - 1, x = (u + v) / "
              "2, z = (u - v) / 2, y = 1 - |x| - |z|, normalised")},
        {QStringLiteral("inverse"),
         text(
             "s = |x| + |y| + |z|, u = (x + z) / s, v = (x - z) / s, i = (u + 1) / 2 * (views - 1), j = (v + "
             "1) / 2 * (views - 1)")},
        {QStringLiteral("axes"),
         text("right = normalise(z, 0, -x), straight from above (1, 0, 0); up = cross(direction, right)")},
        {QStringLiteral("colour"), text("sRGB of the surface, unlit; alpha: covered share of the pixel")},
        {QStringLiteral("normal"),
         text("linear, the tree's axes, value / 127.5 - 1; alpha: depth, metres towards the eye from the "
              "middle = ((alpha - 1) / 127 - 1) * radius")},
    };
}

Expected<QStringList> writeAtlas(const BillboardAtlas& atlas, const QString& folder)
{
    const BillboardPicture& picture = atlas.picture;
    RAMURE_TRY(writePng(beside(folder, "atlas_colour.png"), picture, picture.colour, 4, true));
    RAMURE_TRY(writePng(beside(folder, "atlas_normal.png"), picture, picture.normal, 4, false));
    const std::string json = QJsonDocument(atlasJson(atlas)).toJson().toStdString();
    RAMURE_TRY(writeFile(systemPath(beside(folder, "atlas.json")), json));
    return billboardFiles(true);
}

Expected<QStringList> writeCards(const BillboardCards& cards, const QString& place)
{
    if (isCardFile(place))
        return writeCardFile(cards, place).map([&] { return QStringList{QFileInfo(place).fileName()}; });
    const BillboardPicture& picture = cards.picture;
    RAMURE_TRY(writeCardFile(cards, beside(place, "cards.glb")));
    RAMURE_TRY(writePng(beside(place, "cards_colour.png"), picture, picture.colour, 4, true));
    RAMURE_TRY(writePng(beside(place, "cards_normal.png"), picture, picture.normal, 3, false));
    return billboardFiles(false);
}

} // namespace ramure
