/// \file
/// Trees of Arbaro (Wolfram Diestel): an XML file with the parameters of Weber and Penn by their names in the
/// paper, angles in degrees.

#include "core/io/formats/file_format.h"
#include "core/io/formats/text/tree_sheet.h"
#include "core/math/angle.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <expat.h>
#include <map>
#include <memory>

namespace ramure {
namespace {

struct Given
{
    std::string text;
    int line = 0;
};

/// The parameters of one file by their names.
class ArbaroReader
{
public:
    explicit ArbaroReader(TreeSheet& sheet)
        : m_sheet(sheet)
    {
    }

    Expected<void> read(const std::string& text)
    {
        XML_SetUserData(m_parser.get(), this);
        XML_SetElementHandler(m_parser.get(), &ArbaroReader::begin, nullptr);
        const auto status = XML_Parse(m_parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
        if (!m_problem && status == XML_STATUS_OK && !m_isArbaro) {
            m_sheet.standAt({}, 1);
            m_problem = m_sheet
                            .refuse(ErrorCode::Invalid,
                                    RAMURE_NOOP("no <arbaro> with a <species>: not a tree of Arbaro"))
                            .value();
        }
        if (m_problem)
            return fail(*m_problem);
        if (status == XML_STATUS_OK)
            return {};
        m_sheet.standAt({}, line());
        auto error = m_sheet.refuse(ErrorCode::Syntax, RAMURE_NOOP("the XML is broken or cut off (%1)"),
                                    {XML_ErrorString(XML_GetErrorCode(m_parser.get()))});
        error.value().column = static_cast<int>(XML_GetCurrentColumnNumber(m_parser.get())) + 1;
        return error;
    }

    [[nodiscard]] const std::string& species() const { return m_species; }
    std::map<std::string, Given, std::less<>>& params() { return m_params; }

private:
    [[nodiscard]] int line() const { return static_cast<int>(XML_GetCurrentLineNumber(m_parser.get())); }

    static void begin(void* self, const char* element, const char** attributes)
    {
        static_cast<ArbaroReader*>(self)->begin(element, attributes);
    }

    void begin(std::string_view element, const char** attributes)
    {
        std::map<std::string_view, const char*> values;
        for (; *attributes; attributes += 2)
            values[attributes[0]] = attributes[1];
        if (element == "species") {
            m_isArbaro = m_isInside;
            if (const auto name = values.find("name"); name != values.end())
                m_species = name->second;
        } else if (element == "arbaro") {
            m_isInside = true;
        } else if (element == "param") {
            add(values);
        }
    }

    void add(const std::map<std::string_view, const char*>& values)
    {
        const auto name = values.find("name"), value = values.find("value");
        m_sheet.standAt({}, line());
        if (name == values.end() || value == values.end())
            stop(
                m_sheet.refuse(ErrorCode::Syntax, RAMURE_NOOP("a <param> needs a name and a value")).value());
        else if (!m_params.emplace(name->second, Given{value->second, line()}).second)
            stop(m_sheet.refuse(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" stands here twice"), {name->second})
                     .value());
    }

    void stop(Error error)
    {
        m_problem = std::move(error);
        XML_StopParser(m_parser.get(), XML_FALSE);
    }

    TreeSheet& m_sheet;
    std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_parser{XML_ParserCreate(nullptr),
                                                                          &XML_ParserFree};
    std::map<std::string, Given, std::less<>> m_params;
    std::string m_species;
    std::optional<Error> m_problem;
    bool m_isInside = false, m_isArbaro = false;
};

struct Counterpart
{
    const char* name; ///< behind the number of the level, where there is one
    const char* key;
    double factor = 1.0;
    bool isSpread =
        false; ///< to both sides of an angle: the sign says nothing, nor does more than half a turn
};

constexpr std::array wholeTree{
    Counterpart{"Shape", "shape"},
    Counterpart{"ScaleV", "scaleV"},
    Counterpart{"BaseSize", "baseSize"},
    Counterpart{"Ratio", "ratio"},
    Counterpart{"RatioPower", "ratioPower"},
    Counterpart{"Flare", "flare"},
    Counterpart{"Lobes", "lobes"},
    Counterpart{"LobeDepth", "lobeDepth"},
    Counterpart{"AttractionUp", "attractionUp"},
    Counterpart{"PruneRatio", "pruneRatio"},
    Counterpart{"PruneWidth", "pruneWidth"},
    Counterpart{"PruneWidthPeak", "pruneWidthPeak"},
    Counterpart{"PrunePowerLow", "prunePowerLow"},
    Counterpart{"PrunePowerHigh", "prunePowerHigh"},
};
constexpr std::array ofLevel{
    Counterpart{"Length", "length"},
    Counterpart{"LengthV", "lengthV"},
    Counterpart{"Taper", "taper"},
    Counterpart{"SegSplits", "segSplits"},
    Counterpart{"SplitAngle", "splitAngle", oneDegree},
    Counterpart{"SplitAngleV", "splitAngleV", oneDegree},
    Counterpart{"CurveRes", "curveRes"},
    Counterpart{"Curve", "curve", oneDegree},
    Counterpart{"CurveBack", "curveBack", oneDegree},
    Counterpart{"CurveV", "curveV", oneDegree},
    Counterpart{"DownAngle", "downAngle", oneDegree},
    Counterpart{"DownAngleV", "downAngleV", oneDegree},
    Counterpart{"Rotate", "rotate", oneDegree},
    Counterpart{"RotateV", "rotateV", oneDegree, true},
    Counterpart{"Branches", "branches"},
};

/// Takes the parameters one after another out of what a file gave.
class ArbaroTree
{
public:
    ArbaroTree(TreeSheet& sheet, std::map<std::string, Given, std::less<>>& given)
        : m_sheet(sheet)
        , m_given(given)
    {
    }

    Expected<void> run(const std::string& species)
    {
        takeLevels();
        // All that a tree is follows from its height: another one would be another tree.
        if (const auto height = number("Scale"))
            keep(m_sheet.set("weberPenn.scale", *height));
        for (const Counterpart& part : wholeTree)
            take(part, part.name, "weberPenn.", true);
        for (int level = 0; level < int(weberPennLevels); ++level)
            for (const Counterpart& part : ofLevel)
                take(part, std::to_string(level) + part.name, "weberPenn.level" + std::to_string(level) + '.',
                     level < m_sheet.params.weberPenn.levels);
        if (const auto splits = number("0BaseSplits"))
            keep(m_sheet.fit("weberPenn.level0.baseSplits", *splits));
        if (const auto wider = number("0Scale"))
            keep(m_sheet.fit("weberPenn.ratio", m_sheet.params.weberPenn.ratio * *wider));
        m_sheet.standAt({});
        m_sheet.dressAs(species);
        takeLeaves();
        noteTheRest();
        return m_problem ? fail(*m_problem) : Expected<void>();
    }

private:
    void keep(const Expected<void>& done)
    {
        if (!done && !m_problem)
            m_problem = done.error();
    }

    std::optional<double> number(std::string_view name)
    {
        const auto found = m_given.find(name);
        if (found == m_given.end())
            return std::nullopt;
        const Given given = std::move(found->second);
        m_given.erase(found);
        m_sheet.standAt(name, given.line);
        double value = 0.0;
        const char* end = given.text.data() + given.text.size();
        const auto read = std::from_chars(given.text.data(), end, value);
        if (read.ec == std::errc() && read.ptr == end)
            return value;
        keep(m_sheet.refuse(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is no number"), {given.text}));
        return std::nullopt;
    }

    /// \param matters the level grows
    void take(const Counterpart& part, const std::string& name, const std::string& group, bool matters)
    {
        auto value = number(name);
        if (value && part.isSpread)
            value = std::min(std::abs(*value), 180.0);
        if (value)
            keep(m_sheet.fit(group + part.key, *value, part.factor, matters));
    }

    /// Arbaro knows more of them; from the fourth on they are alike.
    void takeLevels()
    {
        const auto levels = number("Levels");
        if (!levels)
            return;
        constexpr auto most = double(weberPennLevels);
        if (*levels > most)
            m_sheet.note(RAMURE_NOOP("%1 levels: only %2 grow"), {std::to_string(int(*levels)), "4"});
        keep(m_sheet.set("weberPenn.levels", std::min(*levels, most)));
    }

    void takeLeaves()
    {
        const double count = number("Leaves").value_or(0.0);
        const auto length = number("LeafScale");
        // Negative: they stand in a fan at the tip.
        if (count < 0.0)
            m_sheet.note(RAMURE_NOOP("leaves in a fan stand along the twig instead"));
        keep(m_sheet.setLeaves(std::abs(count), length));
    }

    /// In the order of the file. Those whose value says nothing are passed over.
    void noteTheRest()
    {
        std::vector<std::pair<int, std::string>> rest;
        for (const auto& [name, given] : m_given)
            rest.emplace_back(given.line, name);
        std::ranges::sort(rest);
        for (const auto& [line, name] : rest) {
            const std::string text = m_given.find(name)->second.text;
            const bool isOneUsual =
                name.ends_with("BranchDist") || name == "LeafScaleX" || name == "LeafQuality";
            double value = 1.0;
            std::from_chars(text.data(), text.data() + text.size(), value);
            m_sheet.standAt(name, line);
            if (value != (isOneUsual ? 1.0 : 0.0))
                m_sheet.note(RAMURE_NOOP("%1 has no counterpart"), {text});
        }
    }

    TreeSheet& m_sheet;
    std::map<std::string, Given, std::less<>>& m_given;
    std::optional<Error> m_problem;
};

Expected<BlenderImport> importArbaro(const std::string& path, const ImportOptions& options, const Progress&)
{
    const auto text = readSheet(path, options);
    RAMURE_TRY(text);
    TreeSheet sheet(path);
    ArbaroReader reader(sheet);
    RAMURE_TRY(reader.read(*text));
    RAMURE_TRY(ArbaroTree(sheet, reader.params()).run(reader.species()));
    return std::move(sheet).finish(reader.species().empty() ? "Tree" : reader.species());
}

} // namespace

extern const FileFormat arbaroFormat;
const FileFormat arbaroFormat = {
    .id = "arbaro",
    .ending = "xml",
    .name = RAMURE_NOOP("Tree of Arbaro"),
    .import = &importArbaro,
};

} // namespace ramure
