#include "core/qt/session/jobs/variations.h"

#include "core/base/file_writer.h"
#include "core/generators/variety.h"
#include "core/io/csv_table.h"
#include "core/math/random.h"
#include "core/params/param_relevance.h"
#include "core/qt/document/project/project_file.h"
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace ramure {
namespace {

constexpr double aroundShare = 0.25; ///< of the value, to both sides

/// To five digits, so that tables can be read.
double fiveDigits(double value)
{
    constexpr int digits = 5;
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific, digits - 1).ptr;
    std::from_chars(text.data(), end, value);
    return value;
}

double numberOf(const ParamValue& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return double(*whole);
    const auto* real = std::get_if<double>(&value);
    return real ? *real : 0.0;
}

/// \param share of the way through the range, 0 to 1, 1 not among them
ParamValue valueAt(const VariedParam& param, double share)
{
    const double low = std::min(param.from, param.to), high = std::max(param.from, param.to);
    switch (param.def->type) {
    case ParamType::Bool:
        return share >= 0.5;
    case ParamType::Enum:
        return EnumValue{param.def->items[std::size_t(share * double(param.def->items.size()))].name};
    case ParamType::Int: // each of them as often
        return std::int64_t(std::floor(std::round(low) + share * (std::round(high) - std::round(low) + 1.0)));
    default:
        return std::clamp(fiveDigits(low + share * (high - low)), low, high);
    }
}

/// Of a key, the same on every machine.
std::uint64_t numberOf(const char* key)
{
    std::uint64_t sum = 0;
    for (; *key; ++key)
        sum = mixBits(sum + std::uint64_t(static_cast<unsigned char>(*key)));
    return sum;
}

/// 0 to count - 1 in an order by chance.
std::vector<int> shuffled(int count, Random& random)
{
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    return order;
}

/// "oak-tree.ramure", "oak-tree-2.ramure" ...
QString freeTreeFile(const QString& table)
{
    const QFileInfo info(table);
    const QString start = info.path() + u'/' + info.completeBaseName() + QStringLiteral("-tree");
    QString file = start + QStringLiteral(".ramure");
    for (int i = 2; QFileInfo::exists(file); ++i)
        file = QStringLiteral("%1-%2.ramure").arg(start).arg(i);
    return file;
}

std::string tableOf(const std::vector<Variation>& variations, const std::string& input)
{
    const std::vector<const ParamDef*> columns = paramsOf(variations);
    std::string text = "input,seed";
    for (const ParamDef* def : columns)
        text.append(",").append(csvCell(def->key));
    text += '\n';
    for (const Variation& variation : variations) {
        text.append(csvCell(input)).append(",").append(std::to_string(variation.seed));
        for (const ParamDef* def : columns) {
            const auto found =
                std::ranges::find(variation.values, def, [](const auto& each) { return each.first; });
            text += ',';
            if (found != variation.values.end())
                text += csvCell(formatValue(found->second));
        }
        text += '\n';
    }
    return text;
}

} // namespace

bool canVary(const NodeParams& params, const ParamDef& def)
{
    const bool isKind = def.type == ParamType::Int || def.type == ParamType::Real ||
                        def.type == ParamType::Bool || def.type == ParamType::Enum;
    return isKind && hasParam(NodeKind::Tree, def) && (def.flags & paramSeed) == 0 && isRelevant(params, def);
}

VariedParam usualRange(const NodeParams& params, const ParamDef& def)
{
    const double value = numberOf(def.get(params));
    const double low = std::min(def.softMin, value), high = std::max(def.softMax, value);
    const double reach = value != 0.0 ? aroundShare * std::abs(value) : aroundShare * (high - low);
    double from = std::clamp(value - reach, low, high), to = std::clamp(value + reach, low, high);
    if (def.type == ParamType::Int) { // to its neighbours at least
        from = std::max(std::min(std::round(from), value - 1.0), low);
        to = std::min(std::max(std::round(to), value + 1.0), high);
    }
    return {&def, def.type == ParamType::Real ? fiveDigits(from) : from,
            def.type == ParamType::Real ? fiveDigits(to) : to};
}

std::vector<Variation> spreadVariations(const std::vector<VariedParam>& params, std::int64_t firstSeed,
                                        int count)
{
    std::vector<Variation> out(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].seed = firstSeed + std::int64_t(i);
    for (const VariedParam& param : params) {
        Random random(static_cast<std::uint64_t>(firstSeed), RandomStream::Preset, numberOf(param.def->key));
        const std::vector<int> order = shuffled(count, random);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i].values.emplace_back(param.def,
                                       valueAt(param, (double(order[i]) + random.unit()) / double(count)));
    }
    return out;
}

Expected<NodeParams> variedParams(const NodeParams& like, const Variation& variation)
{
    NodeParams params = reseeded(like, variation.seed);
    for (const auto& [def, value] : variation.values)
        RAMURE_TRY(setParam(params, *def, value));
    return params;
}

std::vector<const ParamDef*> paramsOf(const std::vector<Variation>& variations)
{
    std::vector<const ParamDef*> columns;
    for (const Variation& variation : variations)
        for (const auto& [def, value] : variation.values)
            if (std::ranges::find(columns, def) == columns.end())
                columns.push_back(def);
    return columns;
}

std::vector<std::pair<const ParamDef*, ParamValue>>
valuesOf(const NodeParams& like, const Variation& variation, const std::vector<const ParamDef*>& touched)
{
    const auto params = variedParams(like, variation);
    std::vector<const ParamDef*> all{findParam("grammar.stochastic"), findParam("grammar.seed"),
                                     findParam("foliage.seed")};
    all.insert(all.end(), touched.begin(), touched.end());
    std::vector<std::pair<const ParamDef*, ParamValue>> values;
    for (const ParamDef* def : all)
        values.emplace_back(def, def->get(params ? *params : like));
    return values;
}

Expected<void> saveVariations(const Node& like, const std::vector<Variation>& variations, const QString& path)
{
    Node tree = like;
    tree.id = 1;
    tree.parent = noNode;
    tree.visible = true;
    tree.locked = false;
    tree.animation = {};
    tree.params.tree = {};
    auto scene = Scene::fromNodes({std::move(tree)});
    RAMURE_TRY(scene);
    const QString file = freeTreeFile(path);
    if (auto saved = saveProjectFile({std::move(*scene), {}}, file); !saved)
        return saved;
    return writeFile(QFile::encodeName(path).toStdString(),
                     tableOf(variations, QFileInfo(file).fileName().toStdString()));
}

} // namespace ramure
