/// \file
/// Trees of ez-tree (Daniel Greenheck): a JSON file with numbers for up to four levels of branches. Its
/// stems are much like those of Weber and Penn; what differs is noted.

#include "core/base/number_text.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/text/tree_sheet.h"
#include "core/math/angle.h"
#include "core/math/reproducible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace ramure {
namespace {

using Json = nlohmann::json;

constexpr std::size_t mostLevels = weberPennLevels;
/// About what its pictures of leaves show.
constexpr int leavesOfPicture = 12, leavesAcross = 3;

/// What ez-tree itself takes for a number that a file leaves out.
struct Level
{
    double angle, children, gnarliness, length, radius, sections, start, taper;
};
constexpr std::array<Level, mostLevels> usual{{{0, 0, 0.15, 20, 1.5, 12, 0, 0.7},
                                               {70, 7, 0.2, 20, 0.7, 10, 0.4, 0.7},
                                               {60, 7, 0.3, 10, 0.7, 8, 0.3, 0.7},
                                               {60, 5, 0.02, 1, 0.7, 6, 0.3, 0.7}}};

class EzTree
{
public:
    EzTree(TreeSheet& sheet, const Json& root)
        : m_sheet(sheet)
        , m_root(root)
    {
    }

    Expected<void> run()
    {
        readLevels();
        if (m_problem)
            return fail(*m_problem);
        setTree();
        for (std::size_t i = 0; i <= m_last; ++i)
            setLevel(i);
        dress();
        noteTheRest();
        return m_problem ? fail(*m_problem) : Expected<void>();
    }

private:
    /// "branch.length.1"; null where there is nothing.
    const Json* find(const std::string& path)
    {
        m_sheet.standAt(path);
        const Json* at = &m_root;
        for (std::size_t from = 0; at && from <= path.size();) {
            const std::size_t dot = std::min(path.find('.', from), path.size());
            const auto child = at->is_object() ? at->find(path.substr(from, dot - from)) : at->end();
            at = child == at->end() ? nullptr : &*child;
            from = dot + 1;
        }
        return at;
    }

    void keep(const Expected<void>& done)
    {
        if (!done && !m_problem)
            m_problem = done.error();
    }
    void refuse(ErrorCode code, const char* text) { keep(m_sheet.refuse(code, text)); }

    double number(const std::string& path, double otherwise)
    {
        const Json* value = find(path);
        if (!value)
            return otherwise;
        if (value->is_number() && std::isfinite(value->get<double>()))
            return value->get<double>();
        refuse(ErrorCode::Syntax, RAMURE_NOOP("a number is expected"));
        return otherwise;
    }

    std::string text(const std::string& path)
    {
        const Json* value = find(path);
        if (value && !value->is_string())
            refuse(ErrorCode::Syntax, RAMURE_NOOP("a text is expected"));
        return value && value->is_string() ? value->get<std::string>() : std::string();
    }

    void readLevels()
    {
        m_isConifer = text("type") == "evergreen";
        const double last = number("branch.levels", 3);
        if (!(last >= 0 && last < double(mostLevels)) || last != std::floor(last))
            refuse(ErrorCode::Invalid, RAMURE_NOOP("a whole number from 0 to 3 is expected"));
        else
            m_last = static_cast<std::size_t>(last);
        for (std::size_t i = 0; i <= m_last; ++i) {
            const auto of = [&, i](const char* name, double Level::*member) {
                return number(std::string("branch.") + name + '.' + std::to_string(i), usual[i].*member);
            };
            m_level[i] = {of("angle", &Level::angle),           0.0,
                          of("gnarliness", &Level::gnarliness), of("length", &Level::length),
                          of("radius", &Level::radius),         of("sections", &Level::sections),
                          of("start", &Level::start),           of("taper", &Level::taper)};
            if (i > 0)
                m_level[i].children = number("branch.children." + std::to_string(i - 1), usual[i].children);
            if (!(m_level[i].length > 0.0) || !(m_level[i].radius > 0.0)) {
                m_sheet.standAt("branch.length." + std::to_string(i));
                refuse(ErrorCode::Invalid, RAMURE_NOOP("length and radius must be more than zero"));
            }
        }
        // At the end of each stem of a broad-leaved tree, one of the next level goes on.
        for (std::size_t i = m_last + 1; i-- > 0;) {
            const bool goesOn = !m_isConifer && i < m_last;
            m_whole[i] = m_level[i].length + (goesOn ? m_whole[i + 1] : 0.0);
            if (i > 0 && goesOn)
                m_level[i].children += m_level[i + 1].children;
        }
    }

    void set(std::string_view key, const std::string& path, double value)
    {
        m_sheet.standAt(path);
        keep(m_sheet.set(key, value));
    }
    void fit(std::string_view key, const std::string& path, double value)
    {
        m_sheet.standAt(path);
        keep(m_sheet.fit(key, value));
    }

    void setTree()
    {
        WeberPennParams& tree = m_sheet.params.weberPenn;
        tree = {};
        tree.shape = CrownShape::Conical; // what goes on from a trunk's end carries ever shorter limbs, too
        tree.scaleV = tree.flare = tree.attractionUp = 0.0;
        tree.lobes = 0;
        set("grammar.seed", "seed", number("seed", 1));
        set("weberPenn.levels", "branch.levels", double(m_last + 1));
        set("weberPenn.scale", "branch.length.0", m_whole[0]);
        fit("weberPenn.ratio", "branch.radius.0", m_level[0].radius / m_whole[0]);
        if (m_last == 0)
            return;
        const Level &trunk = m_level[0], &limbs = m_level[1];
        fit("weberPenn.baseSize", "branch.start.1", limbs.start * trunk.length / m_whole[0]);
        // In the middle of the crown, a limb is to be as thick as it is there.
        const double thinner = limbs.radius * (1.0 - trunk.taper * 0.5 * (1.0 + limbs.start));
        const double shorter = m_whole[1] / m_whole[0];
        if (thinner > 0.0 && thinner < 1.0 && shorter < 1.0)
            tree.ratioPower = std::clamp(maths::log(thinner) / maths::log(shorter), 0.0, 10.0);
        if (m_last > 1)
            setAttraction(tree);
    }

    /// ez-tree turns each section by strength / radius, the paper's a whole stem by a share of its
    /// declination: at a quarter of a half turn both are to be the same.
    void setAttraction(WeberPennParams& tree)
    {
        const double strength = number("branch.force.strength", 0.01),
                     up = number("branch.force.direction.y", 1);
        const double turned = strength * m_level[2].sections / radiusAt(2);
        tree.attractionUp = std::clamp((up < 0.0 ? -turned : turned) / (0.25 * pi), -10.0, 10.0);
    }

    /// m, of a stem that leaves the middle of the one below.
    [[nodiscard]] double radiusAt(std::size_t level) const
    {
        double radius = m_level[0].radius;
        for (std::size_t i = 1; i <= level; ++i)
            radius *= m_level[i].radius * std::max(1.0 - 0.5 * m_level[i - 1].taper, 0.05);
        return radius;
    }

    void setLevel(std::size_t i)
    {
        const Level& from = m_level[i];
        WeberPennLevel& level = m_sheet.params.weberPenn.level[i];
        level = {};
        const std::string n = std::to_string(i), key = "weberPenn.level" + n + '.';
        // Of stems from the second level on, the paper shortens those near the tip of the one below.
        const double shortened = i < 2 ? 1.0 : 0.7;
        if (i > 0) {
            fit(key + "length", "branch.length." + n, m_whole[i] / m_whole[i - 1] / shortened);
            fit(key + "downAngle", "branch.angle." + n, from.angle * oneDegree);
            set(key + "branches", "branch.children." + std::to_string(i - 1), from.children);
            level.rotate = 137.5 * oneDegree;
            level.rotateV = 20.0 * oneDegree;
        }
        fit(key + "curveRes", "branch.sections." + n, from.sections);
        const double gnarl = std::abs(from.gnarliness) * std::max(1.0, 1.0 / std::sqrt(radiusAt(i)));
        level.curveV = std::min(gnarl * from.sections, 2.0 * pi);
    }

    void dress()
    {
        const std::string leaf = text("leaves.type");
        m_sheet.dressAs(leaf == "pine" ? "scots pine" : leaf);
        const std::string bark = text("bark.type");
        if (bark == "birch")
            m_sheet.params.bark.family = BarkFamily::Ringed;
        else if (bark == "pine")
            m_sheet.params.bark.family = BarkFamily::Plated;
        else if (bark != "oak" && bark != "willow" && !bark.empty())
            m_sheet.note(RAMURE_NOOP("%1 has no counterpart"), {bark});
        const double count = number("leaves.count", 1);
        fit("foliage.leafAngle", "leaves.angle", number("leaves.angle", 10) * oneDegree);
        fit("foliage.leafVariation", "leaves.sizeVariance",
            std::clamp(number("leaves.sizeVariance", 0.7), 0.0, 0.9));
        const double size = number("leaves.size", 2.5);
        m_sheet.standAt("leaves.count");
        keep(m_sheet.setLeaves(leavesOfPicture * count, size / leavesAcross));
        if (count > 0.0)
            m_sheet.note(RAMURE_NOOP("for a picture of many leaves, %1 of them grow, each %2 times shorter"),
                         {numberText(leavesOfPicture), numberText(leavesAcross)});
    }

    void noteTheRest()
    {
        m_sheet.standAt("branch.length");
        m_sheet.note(RAMURE_NOOP("a unit of length is taken as a metre"));
        if (!m_isConifer && m_last > 0) {
            m_sheet.standAt("branch.taper");
            m_sheet.note(
                RAMURE_NOOP("stems end in points, and are longer by the ones that went on from their ends"));
        }
        for (const char* path : {"branch.twist.0", "branch.twist.1", "branch.twist.2", "branch.twist.3",
                                 "branch.start.2", "branch.start.3", "branch.force.direction.x",
                                 "branch.force.direction.z", "branch.segments", "leaves.start", "leaves.tint",
                                 "leaves.billboard", "bark.tint", "bark.textureScale", "trellis.enabled"})
            if (const Json* value = find(path); value && *value != 0 && *value != false && *value != 0xFFFFFF)
                m_sheet.note(RAMURE_NOOP("%1 has no counterpart"), {value->dump()});
    }

    TreeSheet& m_sheet;
    const Json& m_root;
    bool m_isConifer = false;
    std::size_t m_last = 0; ///< level
    std::array<Level, mostLevels> m_level{};
    std::array<double, mostLevels> m_whole{}; ///< m, a stem with what goes on from its end
    std::optional<Error> m_problem;
};

/// As the library says where it stopped: by bytes.
tl::unexpected<Error> syntaxError(const std::string& path, const std::string& text, std::size_t byte)
{
    const std::string_view before = std::string_view(text).substr(0, byte > 0 ? byte - 1 : 0);
    auto error = fail(ErrorCode::Syntax, RAMURE_NOOP("the JSON is broken or cut off"));
    error.value().file = path;
    error.value().line = 1 + static_cast<int>(std::ranges::count(before, '\n'));
    error.value().column = static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1;
    return error;
}

/// Nested deeper than any such file, which would use up the stack.
bool isTooDeep(std::string_view text)
{
    int depth = 0;
    return std::ranges::any_of(text, [&depth](char c) {
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        return depth > 64;
    });
}

Expected<BlenderImport> importEzTree(const std::string& path, const ImportOptions& options, const Progress&)
{
    const auto text = readSheet(path, options);
    RAMURE_TRY(text);
    TreeSheet sheet(path);
    if (isTooDeep(*text))
        return sheet.refuse(ErrorCode::Invalid, RAMURE_NOOP("no \"branch\": not a tree of ez-tree"));
    Json root;
    try {
        root = Json::parse(*text);
    } catch (const Json::parse_error& problem) {
        return syntaxError(path, *text, problem.byte);
    } catch (const Json::exception&) { // a number too large for any type
        return syntaxError(path, *text, 0);
    }
    const auto branch = root.is_object() ? root.find("branch") : root.end();
    if (branch == root.end() || !branch->is_object())
        return sheet.refuse(ErrorCode::Invalid, RAMURE_NOOP("no \"branch\": not a tree of ez-tree"));
    RAMURE_TRY(EzTree(sheet, root).run());
    return std::move(sheet).finish(std::filesystem::path(path).stem().string());
}

} // namespace

extern const FileFormat ezTreeFormat;
const FileFormat ezTreeFormat = {
    .id = "ez-tree",
    .ending = "json",
    .name = RAMURE_NOOP("Tree of ez-tree"),
    .import = &importEzTree,
};

} // namespace ramure
