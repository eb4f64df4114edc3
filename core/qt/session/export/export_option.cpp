#include "core/qt/session/export/export_option.h"

#include "core/base/number_text.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <type_traits>

namespace ramure {
namespace {

constexpr const char* mapLabel = RAMURE_NOOP("%1 × %1 pixels");
constexpr const char* jointLabel = RAMURE_NOOP("%1 at most");

constexpr OptionItem partItems[] = {
    {"branches", exportBranches}, {"leaves", exportLeaves}, {"fruit", exportApples}, {"all", exportAll}};
constexpr OptionItem modelItems[] = {
    {"mesh", std::int64_t(ExportModel::Mesh), RAMURE_NOOP("Finished mesh")},
    {"rough", std::int64_t(ExportModel::Rough), RAMURE_NOOP("Rough model")},
    {"skeleton", std::int64_t(ExportModel::Skeleton), RAMURE_NOOP("Skeleton as lines")}};
constexpr OptionItem leafItems[] = {{"merged", 0, RAMURE_NOOP("Merged into one mesh")},
                                    {"instances", 1, RAMURE_NOOP("List of instances")}};
constexpr OptionItem mapItems[] = {{"0", 0, RAMURE_NOOP("None")}, {"256", 256, mapLabel},
                                   {"512", 512, mapLabel},        {"1024", 1024, mapLabel},
                                   {"2048", 2048, mapLabel},      {"4096", 4096, mapLabel}};
constexpr OptionItem jointItems[] = {{"64", 64, jointLabel},
                                     {"110", 110, jointLabel},
                                     {"256", 256, jointLabel},
                                     {"all", 0, RAMURE_NOOP("All branches")}};
constexpr OptionItem compressItems[] = {{"none", 0}, {"meshopt", 1}};
constexpr OptionItem growthItems[] = {{"none", 0, RAMURE_NOOP("None: it has its age")},
                                      {"1", 1, RAMURE_NOOP("From the first year on")}};
const auto windItems = [] {
    std::vector<OptionItem> items{{"none", std::int64_t(WindProfile::None), RAMURE_NOOP("None")}};
    for (const WindProfileFacts& facts : windProfiles())
        items.push_back({facts.name, std::int64_t(facts.profile), facts.choice});
    return items;
}();
constexpr OptionItem collisionItems[] = {
    {"none", std::int64_t(CollisionNames::None), RAMURE_NOOP("None")},
    {"unreal", std::int64_t(CollisionNames::Unreal), RAMURE_NOOP("Unreal Engine")},
    {"godot", std::int64_t(CollisionNames::Godot), RAMURE_NOOP("Godot")},
    {"unity", std::int64_t(CollisionNames::Unity), RAMURE_NOOP("Unity")}};
constexpr OptionItem engineItems[] = {{"none", std::int64_t(Engine::None)},
                                      {"godot", std::int64_t(Engine::Godot)},
                                      {"unity", std::int64_t(Engine::Unity)},
                                      {"unreal", std::int64_t(Engine::Unreal)}};
constexpr OptionItem upItems[] = {{"y", std::int64_t(UpAxis::Y), RAMURE_NOOP("Y up")},
                                  {"z", std::int64_t(UpAxis::Z), RAMURE_NOOP("Z up")}};
constexpr OptionItem unitItems[] = {
    {"m", 0, RAMURE_NOOP("metres")},       {"cm", 1, RAMURE_NOOP("centimetres")},
    {"mm", 2, RAMURE_NOOP("millimetres")}, {"km", 3, RAMURE_NOOP("kilometres")},
    {"in", 4, RAMURE_NOOP("inches")},      {"ft", 5, RAMURE_NOOP("feet")}};
static_assert(std::size(unitItems) == std::size(lengthUnits));
constexpr OptionItem footItems[] = {{"disc", 1}, {"flat", 0}};
constexpr OptionItem printLeafItems[] = {
    {"off", std::int64_t(PrintLeaves::Off), RAMURE_NOOP("None")},
    {"shells", std::int64_t(PrintLeaves::Shells), RAMURE_NOOP("Thick shells")}};
const auto processItems = [] {
    std::vector<OptionItem> items;
    for (const PrintProcessFacts& facts : printProcesses())
        items.push_back({facts.name, std::int64_t(items.size()), facts.title});
    return items;
}();

/// \param At a lambda that leads from the options to one of their members
template <class At> constexpr OptionPlace at(At)
{
    return {[](const ExportOptions& options) { return static_cast<double>(At()(options)); },
            [](ExportOptions& options, double number) {
                auto& member = At()(options);
                member = static_cast<std::remove_reference_t<decltype(member)>>(number);
            }};
}

template <class Number> std::optional<Number> numberIn(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    if (first == std::string_view::npos)
        return std::nullopt;
    const char* const end = text.data() + last + 1;
    Number number{};
    const auto [read, problem] = std::from_chars(text.data() + first, end, number);
    return problem == std::errc() && read == end ? std::optional(number) : std::nullopt;
}

/// \param option of whose name an error tells
template <class Value, class Into>
Expected<void> take(Expected<Value>&& value, Into& into, const char* option)
{
    if (!value) {
        value.error().path = option;
        return fail(std::move(value.error()));
    }
    into = *value;
    return {};
}

Expected<double> lengthIn(const std::string& text)
{
    auto length = printLength(text);
    if (length && !(*length > 0.0))
        return fail(ErrorCode::Invalid, "\"%1\": a length above 0 expected, such as 180mm", {text});
    return length;
}

Expected<double> scaleIn(const std::string& text)
{
    const auto number = numberIn<double>(text);
    return number ? fileScaleOf(*number) : fail(ErrorCode::Syntax, "\"%1\" is not a number", {text});
}

Expected<void> readBudgets(ExportOptions& options, const std::string& text)
{
    std::vector<std::int64_t> budgets;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        const auto budget = numberIn<std::int64_t>(std::string_view(text).substr(from, end - from));
        if (!budget)
            return fail(ErrorCode::Invalid, "--budget \"%1\": triangles, separated by commas, expected",
                        {text});
        budgets.push_back(*budget);
        from = end + 1;
    }
    options.levels.budgets = std::move(budgets);
    return {};
}

std::string budgetsText(const ExportOptions& options)
{
    std::string out;
    for (const std::int64_t budget : options.levels.budgets)
        out.append(out.empty() ? "" : ",").append(numberText(budget));
    return out;
}

// clang-format off
const ExportOption table[] = {
    {.name = "part", .values = "branches|leaves|fruit|all",
     .help = "What is written. Without it formats with objects get all, others the branches.",
     .flags = ofExport | notOfPrint | ofTrees,
     .place = at([](auto& o) -> auto& { return o.parts; }), .items = partItems},
    {.name = "model", .values = "mesh|rough|skeleton",
     .help = "mesh (one continuous mesh; the default), rough (open cylinders, squares, cubes) or skeleton (line segments).",
     .flags = ofExport | notOfPrint | ofTrees,
     .place = at([](auto& o) -> auto& { return o.model; }), .items = modelItems,
     .key = "model", .label = RAMURE_NOOP("Model"), .uses = forBlender},
    {.name = "leaves", .values = "merged|instances",
     .help = "merged (one mesh of all leaves, all fruit another) or instances: FILE holds what else there is, and beside it "
             "stand FILE_leaves.csv, a row for each leaf, fruit and flower with its node, shape, material, branch, colour "
             "and matrix (3 rows of 4), and FILE_leaves.json, the same as JSON, and FILE_leaves_birch.obj, "
             "FILE_fruit_acorn.obj and so on, the shapes that the rows name. A point of the shape times the matrix is the "
             "point of the merged mesh. A .glb or .usda holds them itself; in a .usda that moves each leaf names its joint.",
     .flags = ofExport | notOfPrint | ofTrees,
     .place = at([](auto& o) -> auto& { return o.instances; }), .items = leafItems,
     .key = "instances", .label = RAMURE_NOOP("Leaves and fruit"),
     .tip = RAMURE_NOOP("Merged: the file holds every leaf and every fruit. List of instances: it holds the rest, and beside "
                        "it stand a table, FILE_leaves.csv, with a row for each leaf, fruit and flower (its shape, material, "
                        "branch, colour and matrix), and one OBJ for each shape; in a GLB or USD file they stand inside. Much smaller, "
                        "for programs that draw instances."),
     .uses = forBlender | forWeb},
    {.name = "texture",
     .help = "With texture coordinates, which is the default for --model mesh: vt lines of .obj, a list texcoord per face "
             "of .ply. Parameter texture.tileSize (metres) is the size of one repeat of the bark. A tree that moves keeps "
             "the coordinates it has at rest.",
     .flags = ofExport | notOfPrint | ofTrees,
     .place = at([](auto& o) -> auto& { return o.texture; }),
     .key = "texture", .label = RAMURE_NOOP("Texture coordinates"),
     .tip = RAMURE_NOOP("Writes texture coordinates for bark, leaves and fruit. The tree's parameter \"Bark tile\" is the size of one repeat of the bark, in metres. Beside an .obj, the pictures of the bark are written, too."),
     .uses = forEveryUse},
    {.name = "no-texture", .help = "Without texture coordinates and pictures.",
     .flags = ofExport | notOfPrint,
     .read = [](ExportOptions& o, const std::string&) -> Expected<void> { o.texture = false; return {}; }},
    {.name = "map-size", .values = "PIXELS", .help = "Pixels a side, 16 to 8192, of %1",
     .inExport = "the pictures of bark that are written beside an .obj and named in its .mtl; 0: none, the bark has its "
                 "mean colour.",
     .inBatch = "pictures of bark in and beside the meshes; 0, as without it: none.",
     .flags = ofExport | ofBatch | notOfPrint,
     .place = at([](auto& o) -> auto& { return o.write.mapSize; }), .items = mapItems,
     .least = leastBarkSize, .most = mostBarkSize, .expected = "0, or 16 to 8192 pixels",
     .holds = holdsTexture | holdsObjects, .key = "maps", .label = RAMURE_NOOP("Pictures"),
     .tip = RAMURE_NOOP("Size of the pictures of bark and leaves that the program makes: inside a GLB, beside an OBJ"),
     .uses = forEveryUse},
    {.name = "joints", .values = "NUMBER|all",
     .help = "Of each tree in a .glb or .usda with --frames, at most, or all: thin branches go with those that carry them, and it is "
             "said how far that is off.",
     .flags = ofExport | notOfPrint | ofClips,
     .place = at([](auto& o) -> auto& { return o.write.joints; }), .items = jointItems,
     .least = 1, .most = 65535, .expected = "all, or 1 to 65535",
     .holds = holdsClip, .key = "joints", .label = RAMURE_NOOP("Joints"),
     .tip = RAMURE_NOOP("Joints of each tree that moves: thin branches go with those that carry them. Engines limit how many "
                        "a mesh may have; fewer cost less to play"),
     .uses = forEveryUse},
    {.name = "compress", .values = "meshopt|none",
     .help = "Of a .glb: meshopt makes it about a fifth as large (EXT_meshopt_compression and KHR_mesh_quantization), for "
             "web pages and engines that read that. Places are rounded to 1/65000 of how far they are from the origin, "
             "directions to a degree.",
     .flags = ofExport | ofBatch | ofFormats,
     .place = at([](auto& o) -> auto& { return o.write.compressed; }), .items = compressItems, .expected = "meshopt or none",
     .hashed = "compressed", .holds = holdsCompressed, .key = "compressed", .label = RAMURE_NOOP("Compressed"),
     .tip = RAMURE_NOOP("Rounds numbers to visible precision and packs them (EXT_meshopt_compression): without its pictures, the file is about a fifth as large. For web pages and engines that read it; Blender 3.4 does not."),
     .uses = forEveryUse},
    {.name = "variants",
     .help = "Leaves and fruit of the trees of a .glb (KHR_materials_variants) or .usda in four seasons: spring, summer, autumn and "
             "winter, whatever the day. Leaves of a .glb have _SEASON, a number by which shaders know when one turns: 0 is the first, "
             "1 the last.",
     .flags = ofExport | ofBatch | notOfPrint | ofFormats,
     .place = at([](auto& o) -> auto& { return o.variants; }),
     .hashed = "variants", .holds = holdsVariants, .key = "variants", .label = RAMURE_NOOP("Four seasons"),
     .tip = RAMURE_NOOP("One file for a year: materials for spring, summer, autumn and winter, which engines and web viewers can choose from. Shaders that want any day in between find a number at each leaf that says when it turns."),
     .uses = forGame | forWeb},
    {.name = "wind", .values = "plain|crysis|unity|pivot-painter|none",
     .help = "Of the trees of a .glb: numbers of each vertex by which a game moves them. plain: _WIND, four numbers for any "
             "shader; crysis: vertex colours of CryEngine; unity: colours and second texture coordinates of Unity's Tree "
             "Creator; pivot-painter: second texture coordinates, and beside the file FILE_pivots.exr and FILE_axes.exr, for "
             "Unreal's PivotPainter2FoliageShader. The handbook has the formulas (Files).",
     .flags = ofExport | ofBatch | notOfPrint | ofFormats,
     .place = at([](auto& o) -> auto& { return o.wind; }), .items = windItems,
     .hashed = "%1", .holds = holdsWind, .key = "wind", .label = RAMURE_NOOP("Wind for"),
     .tip = RAMURE_NOOP("Data of each vertex by which the shaders of an engine move the tree in the wind: the phase of its branch, the size of its movement, the flutter of its leaves. The tree is exported at rest; Unreal gets two textures beside the file. The handbook's page “Files” has the formulas."),
     .uses = forGame},
    {.name = "levels", .values = "N",
     .help = "So many meshes of each tree, 1 to 8, for less and less triangles: fewer sides, cross-sections and twigs, fewer "
             "and larger leaves. A .glb holds them all, as nodes branches_LOD0, branches_LOD1 and so on that MSFT_lod names, a .usda as variants; "
             "%1. Without --budget the first is the tree as it is, and each further one has a quarter of the triangles or "
             "less.",
     .inExport = "of other formats each is a file, FILE_LOD0, FILE_LOD1 and so on", .inBatch = "other files hold the tree alone",
     .flags = ofLevels | ofExport | ofBatch | ofTrees, .place = at([](auto& o) -> auto& { return o.levels.count; }),
     .least = 1, .most = mostLevels, .expected = "1 to 8"},
    {.name = "budget", .values = "T0,T1,...",
     .help = "Triangles of each level, bark, leaves and fruit together, separated by commas; each less than the one before. "
             "Levels keep them within 2 %.",
     .flags = ofLevels | ofExport | ofBatch | ofTrees, .read = &readBudgets, .text = &budgetsText, .hashed = "%1"},
    {.name = "switch", .values = "D1,D2,...",
     .help = "When each level but the first takes the place of the one before: distances in metres, rising, for a vertical "
             "angle of view of 40°, such as 20,60; or shares of the picture's height that the tree has, falling, such as "
             "60%,30%. A .glb holds it as MSFT_screencoverage. Without it 60%, and half of that for each further level.",
     .flags = ofLevels | ofExport | ofBatch | ofTrees,
     .read = [](ExportOptions& o, const std::string& t) { return readSwitches(t, o.levels); },
     .text = [](const ExportOptions& o) { return switchesText(o.levels); }, .hashed = "%1"},
    {.name = "leaf-cards",
     .help = "Of levels, where not all leaves are there: cards with pictures of the tree's own twigs in the place of enlarged "
             "leaves, cut out by their opacity. For formats with pictures, and leaves without pictures of their own.",
     .flags = ofLevels | ofExport | ofBatch | ofTrees | ofFormats, .place = at([](auto& o) -> auto& { return o.levels.cards; }),
     .hashed = "leaf-cards", .holds = holdsTexture | holdsObjects},
    {.name = "billboard",
     .help = "Of levels, one more after them: three crossed cards with pictures of the whole tree, which take the place of all "
             "its meshes. For formats with pictures.",
     .flags = ofLevels | ofExport | ofBatch | ofTrees | ofFormats, .place = at([](auto& o) -> auto& { return o.levels.billboard; }),
     .hashed = "billboard", .holds = holdsTexture | holdsObjects},
    {.name = "level-files",
     .help = "Writes each level as a file also into formats that hold them all: tree_LOD0.glb, tree_LOD1.glb and so on, for "
             "engines that do not know MSFT_lod.",
     .flags = ofExport | ofTrees, .place = at([](auto& o) -> auto& { return o.levelFiles; })},
    {.name = "for", .values = "godot|unity|unreal|none",
     .help = "FILE is a folder for this engine, or a .zip with one: a GLB for each level, pieces for collision, data for wind and "
             "the shader that reads them, and a README that says how all this comes into the engine. Without --levels "
             "levels of 80,000, 20,000 and 5,000 triangles with --leaf-cards and --billboard; where a tree cannot have these, it is "
             "whole and two coarser ones. It holds one tree: --node names it.",
     .flags = ofExport | notOfPrint | ofTrees, .place = at([](auto& o) -> auto& { return o.engine; }), .items = engineItems},
    {.name = "collision", .values = "unreal|godot|unity|none",
     .help = "Convex pieces around trunk and thick limbs, 32 at most, for bodies to bump into, with the names by which an engine "
             "knows them: UCX_branches_LOD0_00 and so on for unreal, branches_LOD0_00-convcolonly for godot, COL_branches_LOD0_00 "
             "for the script that --for unity writes. They stand in the file of the finest level.",
     .flags = ofExport | ofBatch | ofTrees | ofFormats, .place = at([](auto& o) -> auto& { return o.collision; }),
     .items = collisionItems, .hashed = "collision %1", .holds = holdsObjects, .key = "collision",
     .label = RAMURE_NOOP("Collision for"),
     .tip = RAMURE_NOOP("Adds convex pieces around the trunk and thick limbs, under the names by which the engine takes them for what bodies bump into."),
     .uses = forGame},
    {.name = "growth", .values = "YEARS",
     .help = "Of trees in a .glb, .usda, .usdz or .pc2 that grow by years: one mesh that grows from this age to the tree's own as it plays. "
             "Its vertices and triangles stay the same; a .glb has key shapes (morph targets), a USD file time samples, a .pc2 the places of its "
             "points and the mesh as an .obj beside it. Leaves open and close: each key shape has its own.",
     .flags = ofExport | notOfPrint | ofTrees | ofFormats,
     .place = at([](auto& o) -> auto& { return o.growthFrom; }), .items = growthItems,
     .least = 1, .most = 1999, .expected = "years, 1 to 1999",
     .holds = holdsShapes, .key = "growth", .label = RAMURE_NOOP("Growth"),
     .tip = RAMURE_NOOP("A tree that grows by years, as one mesh that grows from its first year to its age when it plays: the same vertices and triangles at every age, with key shapes (morph targets) between which engines mix. Leaves open and close at each key shape."),
     .uses = forBlender | forWeb},
    {.name = "growth-speed", .values = "YEARS", .help = "With --growth: years that go by in a second; without it 5.",
     .flags = ofExport | notOfPrint | ofTrees | ofFormats,
     .place = at([](auto& o) -> auto& { return o.growthSpeed; }),
     .least = 1, .most = 1000, .expected = "years a second, 1 to 1000", .holds = holdsShapes},
    {.name = "growth-keys", .values = "N",
     .help = "With --growth: most key shapes, 2 to 32, at the ages that tell most; without it 12. How far a branch is from its "
             "place between two is said.",
     .flags = ofExport | notOfPrint | ofTrees | ofFormats,
     .place = at([](auto& o) -> auto& { return o.growthKeys; }),
     .least = 2, .most = 32, .expected = "2 to 32", .holds = holdsShapes},
    {.name = "growth-triangles", .values = "N", .help = "With --growth: triangles of the mesh, about; without it 60,000.",
     .flags = ofExport | notOfPrint | ofTrees | ofFormats,
     .place = at([](auto& o) -> auto& { return o.growthTriangles; }),
     .least = 500, .most = 5'000'000, .expected = "500 to 5,000,000 triangles", .holds = holdsShapes},
    {.name = "up", .values = "y|z", .help = "The axis of the mesh file that points up; in the program it is y.",
     .flags = ofExport | ofImport,
     .place = at([](auto& o) -> auto& { return o.space.up; }), .items = upItems,
     .read = [](ExportOptions& o, const std::string& t) { return take(upAxisNamed(t), o.space.up, "--up"); },
     .holds = holdsSpace, .key = "up", .label = RAMURE_NOOP("Axis that points up"),
     .tip = RAMURE_NOOP("The axis of the file that points up: Y for most game engines and Maya, Z for Blender, 3ds Max and "
                        "printers"),
     .uses = forEveryUse},
    {.name = "unit", .values = "m|cm|mm|km|in|ft", .help = "What a 1 in the mesh file is; m is the default.",
     .flags = ofExport | ofImport,
     .place = at([](auto& o) -> auto& { return o.space.unit; }), .items = unitItems,
     .read = [](ExportOptions& o, const std::string& t) { return take(lengthUnitNamed(t), o.space.unit, "--unit"); },
     .holds = holdsSpace, .key = "unit", .label = RAMURE_NOOP("Unit"), .tip = RAMURE_NOOP("Length unit of the file"),
     .uses = forEveryUse},
    {.name = "scale", .values = "NUMBER",
     .help = "How much larger than in the program things are in the mesh file besides.",
     .flags = ofExport | ofImport | notOfPrint,
     .place = at([](auto& o) -> auto& { return o.space.scale; }),
     .least = FileSpace::leastScale, .most = FileSpace::mostScale,
     .read = [](ExportOptions& o, const std::string& t) { return take(scaleIn(t), o.space.scale, "--scale"); },
     .holds = holdsSpace, .key = "scale", .label = RAMURE_NOOP("Scale"),
     .tip = RAMURE_NOOP("How many times larger than in the scene"), .uses = forEveryUse},
    {.name = "print", .values = "fdm|resin|powder",
     .help = "Makes a tree ready for this kind of printer: without leaves, at --height, twigs thickened or cut, all branches "
             "united into one closed surface that is flat at the ground; in mm with Z up unless --unit and --up say "
             "otherwise. Prints a report: the thinnest place, overhangs, whether it stands.",
     .flags = ofExport | ofPrint,
     .place = at([](auto& o) -> auto& { return o.print.process; }), .items = processItems,
     .key = "process", .label = RAMURE_NOOP("Process"),
     .tip = RAMURE_NOOP("How the printer works: it says how thin a twig may be"), .uses = forPrint},
    {.name = "height", .values = "LENGTH", .help = "Of the print, in mm or with a unit (cm, m, in).",
     .flags = ofExport | ofPrint,
     .place = at([](auto& o) -> auto& { return o.print.height; }),
     .least = PrintOptions::leastHeight, .most = PrintOptions::mostHeight,
     .read = [](ExportOptions& o, const std::string& t) { return take(lengthIn(t), o.print.height, "--height"); },
     .key = "height", .label = RAMURE_NOOP("Height, mm"), .tip = RAMURE_NOOP("From the ground to the top of the print"),
     .uses = forPrint, .factor = 1000.0},
    {.name = "thinnest", .values = "LENGTH",
     .help = "The smallest diameter of a twig; without it 2 mm for fdm, 0.8 for resin, 1 for powder. Thinner twigs become so "
             "thick; those that would have to be more than 1.5 times as thick as they are are cut.",
     .flags = ofExport | ofPrint,
     .place = at([](auto& o) -> auto& { return o.print.thinnest; }),
     .least = PrintOptions::leastThinnest, .most = PrintOptions::mostThinnest,
     .read = [](ExportOptions& o, const std::string& t) { return take(lengthIn(t), o.print.thinnest, "--thinnest"); },
     .key = "thinnest", .label = RAMURE_NOOP("Thinnest twig, mm"),
     .tip = RAMURE_NOOP("Least thickness of a twig. Thinner twigs are thickened, and twigs that would need more than 1.5 times their thickness are cut."),
     .uses = forPrint, .factor = 1000.0},
    {.name = "foot", .values = "disc|flat", .help = "What a print stands on: a disc, or the trunk, cut flat.",
     .flags = ofExport | ofPrint,
     .place = at([](auto& o) -> auto& { return o.print.hasFootDisc; }), .items = footItems,
     .key = "disc", .label = RAMURE_NOOP("Disc as a foot"),
     .tip = RAMURE_NOOP("Prints a disc below the trunk. If it is off, the trunk is cut flat at the ground"), .uses = forPrint},
    {.name = "print-leaves", .values = "off|shells",
     .help = "Leaves of a print: off, or closed shells as thick as the thinnest twig, in one piece with their twigs. Small "
             "leaves are enlarged and fewer; those too far from what is left of their twig are left out.",
     .flags = ofExport | ofPrint,
     .place = at([](auto& o) -> auto& { return o.print.leaves; }), .items = printLeafItems, .expected = "off or shells",
     .key = "shells", .label = RAMURE_NOOP("Leaves"),
     .tip = RAMURE_NOOP("Thick shells: each leaf is as thick as the thinnest twig and in one piece with its own. Small leaves "
                        "are enlarged and fewer. Fruit stays off."),
     .uses = forPrint},
};
// clang-format on

} // namespace

std::span<const ExportOption> exportOptions()
{
    return table;
}

Expected<void> readOption(const ExportOption& option, ExportOptions& options, const std::string& text)
{
    if (option.read)
        return option.read(options, text);
    const bool isSwitch = option.items.empty() && option.least == option.most;
    const std::string name = text == "apples" ? "fruit" : text; // This is its old name.
    std::optional<double> value;
    if (const auto number = numberIn<std::int64_t>(text); isSwitch)
        value = 1.0;
    else if (number && double(*number) >= option.least && double(*number) <= option.most)
        value = double(*number);
    std::string names;
    for (const OptionItem& item : option.items) {
        if (name == item.name)
            value = static_cast<double>(item.value);
        names.append(names.empty() ? "" : ", ").append(item.name);
    }
    if (!value)
        return fail(ErrorCode::Unknown, "--%1 \"%2\": %3 expected",
                    {option.name, text, *option.expected != '\0' ? option.expected : names});
    option.place.set(options, *value);
    return {};
}

std::string optionText(const ExportOption& option, const ExportOptions& options)
{
    if (option.text)
        return option.text(options);
    if (!option.place.get)
        return {};
    const auto number = static_cast<std::int64_t>(option.place.get(options));
    const auto item = std::ranges::find(option.items, number, &OptionItem::value);
    return item == option.items.end() ? numberText(option.place.get(options)) : item->name;
}

bool isUsual(const ExportOption& option, const ExportOptions& options)
{
    return optionText(option, options) == optionText(option, ExportOptions());
}

bool isOffered(const ExportOption& option, const ExportPage& page)
{
    const bool holds =
        option.holds == 0 || (page.format && (page.format->holds & option.holds) == option.holds);
    return holds && (option.uses >> int(page.use) & 1) != 0 && !(page.isPrint && option.is(notOfPrint)) &&
           (page.isClip || !option.is(ofClips));
}

} // namespace ramure
