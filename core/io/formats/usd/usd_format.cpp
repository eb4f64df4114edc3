/// \file
/// USD (Universal Scene Description, Pixar; OpenUSD 24) as text: a layer with its pictures beside it, and the
/// package .usdz with all of it inside.

#include "core/base/file_writer.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/usd/usd_reader.h"
#include "core/io/formats/usd/usd_writer.h"
#include "core/io/zip_file.h"
#include <filesystem>

namespace ramure {
namespace {

/// Data of a package begins where it can be used without a copy.
constexpr int packageAlignment = 64;

tl::unexpected<Error> cancelled()
{
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
}

/// Pictures that are there already stay: somebody may have painted over them.
Expected<void> writePictures(const std::string& path, const std::vector<usd::Picture>& pictures)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code problem; // a folder that cannot be read is told by whoever writes into it
    for (const usd::Picture& picture : pictures)
        if (const auto file = folder / picture.name; !std::filesystem::exists(file, problem))
            if (auto written = writeFile(file.string(), picture.bytes); !written)
                return written;
    return {};
}

Expected<void> writeUsda(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    const auto plan = usd::planOf(scene, options, progress.part(0.0, 0.3));
    RAMURE_TRY(plan);
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    usd::Text text(&*out, progress);
    usd::writeLayer(text, scene, *plan, progress.part(0.3, 1.0));
    if (progress.cancelled())
        return cancelled();
    if (out->isRegular())
        if (auto written = writePictures(path, plan->materials.pictures()); !written)
            return written;
    return out->commit();
}

/// More bytes than the text will have, so that it never moves to larger room.
std::size_t roomOf(const usd::Plan& plan)
{
    constexpr std::size_t perVertex = 200, perFace = 120, perCopy = 400;
    std::size_t room = 0;
    for (const usd::PlannedNode& node : plan.nodes) {
        for (const usd::PlannedMesh& mesh : node.meshes)
            room += node.sameAs == noIndex ? perVertex * mesh.from->mesh->positions.size() +
                                                 perFace * mesh.from->mesh->triangles.size()
                                           : 0;
        for (const usd::PlannedCopies& copies : node.copies)
            room += node.sameAs == noIndex ? perCopy * copies.from->copies.size() : 0;
    }
    return room;
}

Expected<void> writeUsdz(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    const auto plan = usd::planOf(scene, options, progress.part(0.0, 0.3));
    RAMURE_TRY(plan);
    usd::Text text(nullptr, progress);
    text.reserve(roomOf(*plan));
    usd::writeLayer(text, scene, *plan, progress.part(0.3, 0.8));
    if (progress.cancelled())
        return cancelled();
    const std::string layer = std::move(text).take();
    std::vector<ZipEntry> entries{{"scene.usda", layer, false, packageAlignment}};
    for (const usd::Picture& picture : plan->materials.pictures())
        entries.push_back({picture.name, picture.bytes, false, packageAlignment});
    return writeZip(path, entries, progress.part(0.8, 1.0));
}

template <Expected<void> (*write)(const std::string&, const ExportScene&, const WriteOptions&,
                                  const Progress&)>
Expected<void> exportUsd(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    auto written = write(path, scene, options, progress);
    if (!written && written.error().file.empty())
        written.error().file = path;
    return written;
}

/// A point, a normal, a radius's colour; three indices.
FileRates usdRates(bool texture, double digits)
{
    return {texture ? 80.0 : 60.0, 3.0 + 3.0 * (texture ? 2.0 : 1.0) * (digits + 2.0)};
}

constexpr std::uint16_t held = holdsObjects | holdsTexture | holdsSpace | holdsLines | holdsCopies |
                               holdsClip | holdsLevels | holdsVariants | holdsRiders | holdsShapes;

} // namespace

extern const FileFormat usdaFormat, usdzFormat;
const FileFormat usdaFormat = {
    .id = "usda",
    .ending = "usda",
    .name = RAMURE_NOOP("USD"),
    .choice = RAMURE_NOOP("USD, with materials, motion and variants"),
    .help = "USD as text, its pictures beside it: nodes as in the scene, levels and seasons as variants",
    .holds = held,
    .read = &readUsd,
    .import = &importUsd,
    .write = &exportUsd<&writeUsda>,
    .rates = &usdRates,
};
const FileFormat usdzFormat = {
    .id = "usdz",
    .ending = "usdz",
    .name = RAMURE_NOOP("USD package"),
    .choice = RAMURE_NOOP("USD package (usdz), in one file"),
    .help = "the same with its pictures in one file",
    .holds = held,
    .read = &readUsd,
    .import = &importUsd,
    .write = &exportUsd<&writeUsdz>,
    .rates = &usdRates,
};

} // namespace ramure
