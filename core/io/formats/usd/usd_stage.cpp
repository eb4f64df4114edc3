#include "core/io/formats/usd/usd_stage.h"

#include "core/base/plain_text.h"
#include "core/io/read_parts.h"
#include "core/io/zip_file.h"
#include <filesystem>

namespace ramure::usd {
namespace {

constexpr std::uint64_t mostBytes = std::uint64_t(1) << 30;
constexpr std::size_t mostLayers = 256; ///< that a file refers to
constexpr std::uint64_t mostPictureBytes = std::uint64_t(256) << 20;

std::string folderOf(const std::string& path)
{
    const std::filesystem::path own(path);
    return (own.parent_path() / (own.stem().string() + "_pictures")).string();
}

Expected<std::string> entryOf(const ZipReader& archive, const std::string& name, std::uint64_t most,
                              const Progress& progress)
{
    std::string out;
    const auto read = archive.read(
        name, most,
        [&](std::string_view piece) {
            out += piece;
            return true;
        },
        progress);
    return read ? Expected<std::string>(std::move(out)) : fail(read.error());
}

/// The text of the layer, which is the first file of a package.
Expected<std::string> layerText(const std::string& path, OpenStage& out, const Progress& progress)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    out.pictures.folder = folderOf(path);
    out.pictures.path = [](const std::string&) { return std::string(); };
    if (path.size() < 5 || lowered(path.substr(path.size() - 5)) != ".usdz") {
        const auto fileOf = [folder](const std::string& asset) {
            const std::filesystem::path file = folder / asset;
            std::error_code problem;
            return std::filesystem::is_regular_file(file, problem) ? file.lexically_normal().string()
                                                                   : std::string();
        };
        out.pictures.path = fileOf;
        out.pictures.bytes = [fileOf](const std::string& asset) -> Expected<std::string> {
            const std::string file = fileOf(asset);
            if (file.empty())
                return fail(ErrorCode::Io, RAMURE_NOOP("the picture \"%1\" is not there"), {asset});
            return reading::loadFile(file);
        };
        return reading::loadFile(path);
    }
    auto opened = ZipReader::open(path);
    RAMURE_TRY(opened);
    const auto archive = std::make_shared<const ZipReader>(std::move(*opened));
    const std::string first = archive->first();
    if (!lowered(first).ends_with(".usda") && !lowered(first).ends_with(".usd"))
        return fail(ErrorCode::Version, RAMURE_NOOP("a binary USD file: only USD as text can be read"));
    const std::string inside = std::filesystem::path(first).parent_path().string();
    out.pictures.bytes = [archive, inside](const std::string& asset) {
        const std::string name = (std::filesystem::path(inside) / asset).lexically_normal().string();
        return archive->has(name)
                   ? entryOf(*archive, name, mostPictureBytes, {})
                   : Expected<std::string>(
                         fail(ErrorCode::Io, RAMURE_NOOP("the picture \"%1\" is not there"), {asset}));
    };
    return entryOf(*archive, first, mostBytes, progress);
}

/// Null where it cannot be read.
std::shared_ptr<const Layer> otherLayer(const PictureSource& files, const std::string& asset,
                                        const Progress& progress)
{
    const auto text = files.bytes(asset);
    auto layer = text ? parseLayer(*text, asset, {progress.stop, {}}) : fail(text.error());
    if (!layer)
        return nullptr;
    relocate(*layer, asset);
    return std::make_shared<const Layer>(std::move(*layer));
}

} // namespace

Expected<OpenStage> openStage(const std::string& path, const Progress& progress)
{
    OpenStage out;
    const auto text = layerText(path, out, progress.part(0.0, 0.1));
    RAMURE_TRY(text);
    const auto layer = parseLayer(*text, path, progress.part(0.1, 0.4));
    RAMURE_TRY(layer);
    std::map<std::string, std::shared_ptr<const Layer>> known;
    auto seen = composed(*layer, out.notes, [&](const std::string& asset) {
        const auto [place, isNew] = known.try_emplace(asset);
        if (isNew && known.size() <= mostLayers)
            place->second = otherLayer(out.pictures, asset, progress);
        return place->second;
    });
    RAMURE_TRY(seen);
    out.layer = std::move(*seen);
    return out;
}

} // namespace ramure::usd
