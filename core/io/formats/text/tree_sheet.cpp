#include "core/io/formats/text/tree_sheet.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include "core/params/source_facts.h"
#include "core/presets/presets.h"
#include "core/presets/species.h"
#include "core/surface/foliage/leaf_table.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace ramure {
namespace {

constexpr std::size_t mostBytesOfSheet = std::size_t(4) << 20;

/// "ca_black_oak", "CaBlackOak": "cablackoak".
std::string lettersOf(std::string_view name)
{
    std::string letters;
    for (const char c : name)
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))
            letters += static_cast<char>(c | 0x20);
    return letters;
}

/// The longest name of a plant that is part of the letters: "redOak" rather than "oak".
const EnumItem* plantIn(const std::string& letters)
{
    const EnumItem* best = nullptr;
    std::size_t most = 0;
    for (const EnumItem& item : findParam("foliage.leaf")->items) {
        const std::string plant = lettersOf(item.name);
        if (plant.size() > most && letters.find(plant) != std::string::npos) {
            best = &item;
            most = plant.size();
        }
    }
    return best;
}

} // namespace

Expected<std::string> readSheet(const std::string& path, const ImportOptions& options)
{
    const auto refuse = [&path](ErrorCode code, const char* text) {
        auto error = fail(code, text);
        error.value().file = path;
        return error;
    };
    if (options.space)
        return refuse(ErrorCode::Invalid, RAMURE_NOOP("a file of parameters has no axes and no unit"));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return refuse(ErrorCode::Io, RAMURE_NOOP("the file cannot be opened"));
    std::string text(mostBytesOfSheet + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad())
        return refuse(ErrorCode::Io, RAMURE_NOOP("the file cannot be read"));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > mostBytesOfSheet)
        return refuse(ErrorCode::Limit, RAMURE_NOOP("larger than 4 MiB: that is no file of parameters"));
    return std::string(PlainText(text).view());
}

TreeSheet::TreeSheet(std::string file)
    : params(speciesParams({}))
    , m_file(std::move(file))
{
    params.weberPenn = {}; // the angles of a species are in degrees
    params.bark.family = BarkFamily::Furrowed;
}

void TreeSheet::standAt(std::string_view path, int line)
{
    m_path = path;
    m_line = line;
}

Error TreeSheet::placed(Error error) const
{
    error.file = m_file;
    error.path = m_path;
    error.line = m_line;
    return error;
}

void TreeSheet::note(const char* text, std::vector<std::string> args)
{
    m_notes.push_back(placed(fail(ErrorCode::Invalid, text, std::move(args)).value()));
}

tl::unexpected<Error> TreeSheet::refuse(ErrorCode code, const char* text, std::vector<std::string> args) const
{
    return fail(placed(fail(code, text, std::move(args)).value()));
}

Expected<void> TreeSheet::set(std::string_view key, double value)
{
    const ParamDef& def = *findParam(key);
    ParamValue given = value;
    if (def.type != ParamType::Real) {
        if (!(std::abs(value) < 1e15) || value != std::floor(value))
            return refuse(ErrorCode::Invalid, RAMURE_NOOP("%1 is no whole number"), {numberText(value)});
        const auto whole = static_cast<std::int64_t>(value);
        if (def.type == ParamType::Int)
            given = whole;
        else if (whole >= 0 && whole < static_cast<std::int64_t>(def.items.size()))
            given = EnumValue{def.items[static_cast<std::size_t>(whole)].name};
        else
            return refuse(ErrorCode::Invalid, RAMURE_NOOP("%1 is none of its choices"), {numberText(value)});
    }
    if (auto done = setParam(params, def, given); !done)
        return fail(placed(std::move(done.error())));
    return {};
}

Expected<void> TreeSheet::fit(std::string_view key, double value, double factor, bool matters)
{
    const ParamDef& def = *findParam(key);
    const double given = value * factor;
    if (def.type == ParamType::Enum || !std::isfinite(given) ||
        (given >= def.hardMin && given <= def.hardMax))
        return set(key, given);
    const double nearest = std::clamp(given, def.hardMin, def.hardMax);
    if (matters)
        note(RAMURE_NOOP("%1 is out of range: %2 is used instead"),
             {numberText(value), numberText(nearest / factor)});
    return set(key, nearest);
}

void TreeSheet::dressAs(std::string_view species)
{
    const std::string letters = lettersOf(species);
    for (const Preset& preset : presets()) {
        if (*preset.latin == '\0' || lettersOf(preset.name) != letters)
            continue;
        params.leaf = preset.params.leaf;
        params.bark = preset.params.bark;
        note(RAMURE_NOOP("leaves and bark are those of the preset %1"), {preset.name});
        return;
    }
    if (const EnumItem* plant = plantIn(letters)) {
        [[maybe_unused]] const auto done =
            setParam(params, *findParam("foliage.leaf"), EnumValue{plant->name});
        note(RAMURE_NOOP("the leaves are those of \"%1\", by the name"), {plant->name});
    } else {
        note(RAMURE_NOOP("the plant is not known: the leaves are those of a beech"));
    }
}

Expected<void> TreeSheet::setLeaves(double perStem, std::optional<double> length)
{
    if (!(perStem > 0.0))
        return set("foliage.leafSize", 0.0);
    const WeberPennParams& tree = params.weberPenn;
    double share = 1.0; // of the last level's length, of the trunk's
    for (std::int64_t i = 1; i < tree.levels; ++i)
        share *= tree.level[static_cast<std::size_t>(i)].length;
    const LeafRow& plant = leafRow(params.leaf.shape);
    const double trunk = trunkRadius(params), stem = share * tree.scale * tree.level[0].length;
    params.foliage.leavesCutoff = std::clamp(maths::pow(share, tree.ratioPower), 0.001, 10.0);
    params.leaf.internode = std::clamp(stem / perStem / (plant.internode * trunk), 0.01, 1000.0);
    return length ? fit("foliage.leafSize", *length / (plant.length * trunk)) : Expected<void>();
}

BlenderImport TreeSheet::finish(std::string name) &&
{
    BlenderImport import;
    Node tree;
    tree.id = 1;
    tree.kind = NodeKind::Tree;
    tree.name = std::move(name);
    tree.params = std::move(params);
    import.nodes.push_back(std::move(tree));
    import.notes = std::move(m_notes);
    return import;
}

} // namespace ramure
