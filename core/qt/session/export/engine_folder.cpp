#include "core/qt/session/export/engine_folder.h"

#include "core/base/file_writer.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/io/zip_file.h"
#include "core/qt/session/export/level_export.h"
#include "core/qt/session/export/wind_export.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace ramure {
namespace {

namespace fs = std::filesystem;

struct EngineText
{
    const char *engine, *file, *text;
};
constexpr EngineText engineTexts[] = {
#include <engine_texts.inc>
};

struct EngineFacts
{
    Engine engine;
    const char* name;
    WindProfile wind;
    CollisionNames collision;
};
constexpr EngineFacts engines[] = {
    {Engine::None, "", WindProfile::None, CollisionNames::None},
    {Engine::Godot, "godot", WindProfile::Crysis, CollisionNames::Godot},
    {Engine::Unity, "unity", WindProfile::Unity, CollisionNames::Unity},
    {Engine::Unreal, "unreal", WindProfile::PivotPainter, CollisionNames::Unreal}};

const EngineFacts& factsOf(Engine engine)
{
    return engines[static_cast<std::size_t>(engine)];
}

bool isArchive(const std::string& path)
{
    return path.size() > 4 && (path.ends_with(".zip") || path.ends_with(".ZIP"));
}

bool isCollision(const ExportMesh& mesh)
{
    return mesh.name.starts_with("UCX_") || mesh.name.starts_with("COL_") ||
           mesh.name.ends_with("-convcolonly");
}

bool isBillboard(const ExportMesh& mesh)
{
    return mesh.name.starts_with("billboard");
}

/// "0, 23.5, 47" with so many decimals at most.
std::string listOf(const std::vector<double>& numbers, double decimals)
{
    std::string out;
    for (const double number : numbers)
        out.append(out.empty() ? "" : ", ").append(numberText(std::round(number * decimals) / decimals));
    return out;
}

/// What the marks @...@ of the texts stand for.
using Marks = std::map<std::string, std::string>;

/// Where the levels follow each other: shares of the picture's height, and metres.
struct Switches
{
    std::vector<double> shares, distances; ///< of each level; the first begins at 1 and 0
};

Switches switchesIn(const ExportScene& scene, int levels)
{
    Switches out{std::vector<double>(static_cast<std::size_t>(levels), 1.0),
                 std::vector<double>(static_cast<std::size_t>(levels), 0.0)};
    for (const ExportMesh& mesh : scene.meshes)
        if (mesh.level > 0) {
            out.shares[static_cast<std::size_t>(mesh.level)] = mesh.share;
            out.distances[static_cast<std::size_t>(mesh.level)] = mesh.distance;
        }
    return out;
}

Marks marksOf(const ExportScene& scene, const std::string& name)
{
    const int levels = lastLevel(scene) + 1;
    const Switches switches = switchesIn(scene, levels);
    Marks marks{{"NAME", name}, {"VERSION", RAMURE_VERSION}, {"STEPS", std::to_string(levels + 3)}};
    for (int level = 0; level < levels; ++level) {
        const std::string number = std::to_string(level), file = levelFile(name + ".glb", level);
        marks["FILES"].append(level == 0 ? "" : ", ").append(file);
        marks["RESOURCES"] +=
            "[ext_resource type=\"PackedScene\" path=\"" + file + "\" id=\"level" + number + "\"]\n";
        marks["NODES"] += "\n[node name=\"LOD" + number + "\" parent=\".\" instance=ExtResource(\"level" +
                          number + "\")]\n";
        if (level > 0)
            marks["SWITCHES"]
                .append(level == 1 ? "" : ", ")
                .append("LOD" + number + " from " +
                        numberText(std::round(switches.distances[static_cast<std::size_t>(level)])) +
                        " m on");
    }
    if (levels == 1)
        marks["SWITCHES"] = "the only one";
    marks["DISTANCES"] = listOf(switches.distances, 100.0);
    marks["UNREAL_SIZES"] = listOf(switches.shares, 1000.0);
    std::vector<double> ends(switches.shares.begin() + 1, switches.shares.end());
    ends.push_back(0.005);        // so small that it need not be seen
    for (const double end : ends) // C# knows numbers of single precision by their letter
        marks["UNITY_SHARES"]
            .append(marks["UNITY_SHARES"].empty() ? "" : ", ")
            .append(listOf({end}, 1000.0))
            .append("f");
    const bool hasBillboard = std::ranges::any_of(scene.meshes, &isBillboard);
    marks["STILL"] = std::to_string(hasBillboard ? levels - 1 : -1);
    marks["COLLISION"] = std::to_string(std::ranges::count_if(scene.meshes, &isCollision));
    for (const ExportMesh& mesh : scene.meshes)
        if (mesh.wind) {
            const auto real = [](double number) {
                const std::string text = numberText(std::round(number * 1e6) / 1e6);
                return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
            };
            marks["BEND_SCALE"] = real(mesh.wind->settings.bendScale);
            marks["BRANCH_AMP"] = real(mesh.wind->settings.branchAmp);
            marks["DETAIL_AMP"] = real(mesh.wind->settings.detailAmp);
        }
    return marks;
}

std::string filled(std::string text, const Marks& marks)
{
    for (const auto& [mark, value] : marks) {
        const std::string sign = "@" + mark + "@";
        for (std::size_t at = text.find(sign); at != std::string::npos;
             at = text.find(sign, at + value.size()))
            text.replace(at, sign.size(), value);
    }
    return text;
}

/// What a tree for an engine cannot have. Path = the option.
Expected<void> checkOptions(const ExportOptions& options)
{
    const std::pair<bool, const char*> refused[] = {{options.model != ExportModel::Mesh, "model"},
                                                    {options.instances, "leaves"},
                                                    {options.variants, "variants"},
                                                    {options.growthFrom > 0.0, "growth"},
                                                    {!options.clip.empty(), "frames"},
                                                    {!options.texture, "no-texture"},
                                                    {options.write.mapSize == 0, "map-size"}};
    for (const auto& [isRefused, option] : refused)
        if (isRefused) {
            auto error =
                fail(ErrorCode::Invalid,
                     RAMURE_NOOP("a folder for an engine holds the finished mesh of a tree at rest, with its "
                                 "pictures and merged leaves"));
            error.value().path = option;
            return error;
        }
    return {};
}

Expected<void> checkOneTree(const ExportScene& scene)
{
    std::set<Index> trees;
    for (const ExportMesh& mesh : scene.meshes)
        trees.insert(mesh.isLevel || isCollision(mesh) ? mesh.node : noIndex);
    if (trees.size() == 1 && *trees.begin() != noIndex)
        return {};
    return fail(ErrorCode::Invalid, RAMURE_NOOP("a folder for an engine holds one tree, and nothing else"));
}

Error ioError(const fs::path& path, const std::error_code& problem)
{
    Error error = fail(ErrorCode::Io, RAMURE_NOOP("cannot be written: %1"), {problem.message()}).value();
    error.file = path.string();
    return error;
}

Expected<void> fill(const fs::path& folder, const std::string& name, const ExportScene& scene,
                    const ExportOptions& options, const Progress& progress)
{
    std::error_code problem;
    fs::create_directory(folder, problem);
    if (problem)
        return fail(ioError(folder, problem));
    RAMURE_TRY(writeExport(scene, options, (folder / (name + ".glb")).string(), progress));
    const Marks marks = marksOf(scene, name);
    for (const EngineText& text : engineTexts)
        if (std::string_view(text.engine) == factsOf(options.engine).name) {
            std::string file = text.file;
            if (file.starts_with("NAME"))
                file.replace(0, 4, name);
            RAMURE_TRY(writeFile((folder / file).string(), filled(text.text, marks)));
        }
    return {};
}

Expected<void> pack(const fs::path& folder, const std::string& name, const std::string& path,
                    const Progress& progress)
{
    std::map<std::string, std::string> files; // by their names: the same files make the same archive
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::ostringstream bytes;
        bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        files[name + "/" + entry.path().filename().string()] = std::move(bytes).str();
    }
    std::vector<ZipEntry> entries;
    for (const auto& [file, bytes] : files)
        entries.push_back({file, bytes});
    return writeZip(path, entries, progress);
}

/// A folder that goes with this object.
class PassingFolder
{
public:
    explicit PassingFolder(fs::path path)
        : m_path(std::move(path))
    {
    }
    ~PassingFolder()
    {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

} // namespace

ExportOptions engineOptions(const ExportOptions& options)
{
    ExportOptions out = options;
    const EngineFacts& facts = factsOf(options.engine);
    out.wind = facts.wind;
    out.collision = facts.collision;
    out.levelFiles = true;
    if (!out.levels.isWanted()) {
        out.levels.budgets = {80'000, 20'000, 5'000};
        out.levels.count = 3;
        out.levels.cards = out.levels.billboard = true;
    }
    return out;
}

std::string engineTreeName(const std::string& path)
{
    fs::path given(path);
    if (!given.has_filename()) // "folder/"
        given = given.parent_path();
    std::string name = (isArchive(path) ? given.stem() : given.filename()).string();
    for (char& letter : name) {
        const bool isPlain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                             (letter >= '0' && letter <= '9') || letter == '_';
        letter = isPlain ? letter : '_';
    }
    return name.find_first_not_of('_') == std::string::npos ? "tree" : name;
}

Expected<void> exportEngineFolder(EvaluatedScene scene, const ExportOptions& options, const std::string& path,
                                  const Progress& progress)
{
    RAMURE_TRY(checkOptions(options));
    ExportOptions wanted = engineOptions(options);
    const auto format = findFormat("tree.glb", FormatUse::Write);
    RAMURE_TRY(format);
    RAMURE_TRY(checkLevelExport(wanted, **format));
    RAMURE_TRY(checkWindExport(wanted, **format));
    auto collected = collectExport(scene, wanted, progress.part(0.0, 0.5));
    if (!collected && collected.error().code != ErrorCode::Cancelled && !options.levels.isWanted()) {
        wanted.levels.budgets.clear(); // nobody asked for them, and not every tree can keep them
        collected = collectExport(std::move(scene), wanted, progress.part(0.0, 0.5));
    }
    RAMURE_TRY(collected);
    RAMURE_TRY(checkOneTree(*collected));
    for (ExportMesh& mesh : collected->meshes)
        if (isBillboard(mesh))
            mesh.wind.reset(); // it keeps the engine's own material, which would take the numbers for colours
    const std::string name = engineTreeName(path);
    if (!isArchive(path))
        return fill(path, name, *collected, wanted, progress.part(0.5, 1.0));
    const PassingFolder folder(path + ".parts");
    RAMURE_TRY(fill(folder.path(), name, *collected, wanted, progress.part(0.5, 0.9)));
    return pack(folder.path(), name, path, progress.part(0.9, 1.0));
}

} // namespace ramure
