// Parameters of nodes.
#include "core/generators/variety.h"
#include "core/presets/presets.h"
#include "core/qt/document/document_command.h"
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {

namespace {

struct ParamTarget
{
    using Value = ParamValue;

    NodeId node;
    const ParamDef* def;

    [[nodiscard]] Value get(const Node& from) const { return def->get(from.params); }
    void set(Node& into, const Value& value) const { def->assign(into.params, value); }
    void describe(Change& change) const
    {
        change.firstStale = change.kinds == 0 ? def->stage : std::min(change.firstStale, def->stage);
        change.kinds |= changeParams;
        addOnce(change.nodes, node);
        addOnce(change.params, paramId(*def));
    }
    static void count(MemoryCount& memory, const Value& value)
    {
        if (const auto* text = std::get_if<std::string>(&value))
            memory.add(text->capacity());
    }
    bool operator==(const ParamTarget&) const = default;
};
using ParamEntry = SetCommand<ParamTarget>::Entry;

Expected<void> checkParam(const Scene& scene, NodeId id, const ParamDef& def, const ParamValue& value)
{
    if (hasParam(scene.find(id)->kind, def))
        return checkValue(def, value);
    auto error =
        fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" has no such parameter"), {scene.find(id)->name});
    error.value().path = def.key;
    return error;
}

struct ShownUnit
{
    double factor = 1.0; ///< shown = value * factor
    const char* suffix = "";
};

/// As the fields show it, angles in degrees.
ShownUnit shownUnit(ParamUnit unit)
{
    switch (unit) {
    case ParamUnit::Metre:
        return {1.0, " m"};
    case ParamUnit::Radian:
        return {180.0 / std::numbers::pi, "°"};
    case ParamUnit::Degree:
        return {1.0, "°"};
    case ParamUnit::Second:
        return {1.0, " s"};
    case ParamUnit::Share:
        return {100.0, " %"};
    case ParamUnit::Kilogram:
        return {1.0, " kg"};
    case ParamUnit::Factor:
        return {1.0, " ×"};
    case ParamUnit::Year:
    case ParamUnit::Day:
    case ParamUnit::None:
    case ParamUnit::Ratio:
    case ParamUnit::Count:
        break;
    }
    return {};
}

/// In a line of the history; empty where the value is too long for one.
QString shownValue(const ParamDef& def, const ParamValue& value)
{
    if (const auto* on = std::get_if<bool>(&value))
        return *on ? DocumentCommand::tr("on") : DocumentCommand::tr("off");
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return QString::number(*whole);
    if (const auto* choice = std::get_if<EnumValue>(&value)) {
        const auto item = std::ranges::find(def.items, choice->name, &EnumItem::name);
        return item == def.items.end() ? QString() : QCoreApplication::translate("core", item->label);
    }
    const auto* real = std::get_if<double>(&value);
    if (!real || !std::isfinite(*real))
        return {};
    constexpr int digits = 4; // what a hand on a slider tells apart
    const ShownUnit unit = shownUnit(def.unit);
    return QLocale().toString(*real * unit.factor, 'g', digits) + QString::fromUtf8(unit.suffix);
}

QString changeText(const QString& label, const QString& value)
{
    return value.isEmpty()
               ? DocumentCommand::tr("Change %1").arg(label)
               : DocumentCommand::tr("Change %1 to %2", "a parameter, its value").arg(label, value);
}

/// The seed after this one: a linear congruential step modulo 2^31 of full period (Hull and Dobell 1962: odd
/// increment, multiplier 1 modulo 4), so that pressing Space shows no tree twice for a long time.
std::int64_t nextSeed(std::int64_t seed)
{
    constexpr std::uint64_t modulus = 1ull << 31;
    return static_cast<std::int64_t>((static_cast<std::uint64_t>(seed) * 1103515245u + 12345u) % modulus);
}

} // namespace

Expected<void> edit::setParam(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                              const ParamValue& value, GestureId gesture)
{
    const QString label = QCoreApplication::translate("core", def.label);
    return setParams(document, nodes, {{&def, value}}, changeText(label, shownValue(def, value)), gesture);
}

Expected<void> edit::setParams(Document& document, const std::vector<NodeId>& nodes,
                               const std::vector<std::pair<const ParamDef*, ParamValue>>& values,
                               const QString& text, GestureId gesture)
{
    const auto ids = editable(document.scene(), nodes);
    RAMURE_TRY(ids);
    std::vector<ParamEntry> entries;
    for (const NodeId id : *ids)
        for (const auto& [def, value] : values) {
            if (const auto allowed = checkParam(document.scene(), id, *def, value); !allowed)
                return allowed;
            const ParamTarget target{id, def};
            std::erase_if(entries, [&target](const ParamEntry& entry) { return entry.target == target; });
            entries.push_back({target, value});
        }
    pushSet<ParamTarget>(document, std::move(entries), text, gesture);
    return {};
}

Expected<void> edit::resetParams(Document& document, const std::vector<NodeId>& nodes,
                                 const std::vector<const ParamDef*>& params, const QString& text)
{
    const auto ids = editable(document.scene(), nodes);
    RAMURE_TRY(ids);
    std::vector<ParamEntry> entries;
    for (const NodeId id : *ids)
        for (const ParamDef* def : params) {
            ParamValue value = presetValue(document.scene().find(id)->preset, *def);
            if (const auto allowed = checkParam(document.scene(), id, *def, value); !allowed)
                return allowed;
            entries.push_back({{id, def}, std::move(value)});
        }
    pushSet<ParamTarget>(document, std::move(entries), text);
    return {};
}

Expected<void> edit::setComponent(Document& document, const std::vector<NodeId>& nodes, const ParamDef& def,
                                  int axis, double value, GestureId gesture)
{
    const auto ids = editable(document.scene(), nodes);
    RAMURE_TRY(ids);
    std::vector<ParamEntry> entries;
    for (const NodeId id : *ids) {
        auto vector = std::get<glm::dvec3>(def.get(document.scene().find(id)->params));
        vector[axis] = value;
        if (const auto allowed = checkParam(document.scene(), id, def, vector); !allowed)
            return allowed;
        entries.push_back({{id, &def}, vector});
    }
    const QString label = QCoreApplication::translate("core", def.label) + u' ' + QChar(u'X' + axis);
    pushSet<ParamTarget>(document, std::move(entries), changeText(label, shownValue(def, ParamValue(value))),
                         gesture);
    return {};
}

namespace {
void addSeed(std::vector<ParamEntry>& entries, const Node& tree, std::int64_t seed)
{
    const NodeParams wanted = reseeded(tree.params, seed);
    for (const char* key : {"grammar.stochastic", "grammar.seed", "foliage.seed"}) {
        const ParamDef* def = findParam(key);
        if (def->get(wanted) != def->get(tree.params))
            entries.push_back({{tree.id, def}, def->get(wanted)});
    }
}
} // namespace

Expected<void> edit::newTree(Document& document, const std::vector<NodeId>& nodes)
{
    std::vector<NodeId> trees;
    for (const NodeId id : nodes)
        if (const Node* node = document.scene().find(id); node && node->kind == NodeKind::Tree)
            trees.push_back(id);
    const auto ids = editable(document.scene(), trees);
    RAMURE_TRY(ids);
    if (ids->empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no tree that could be drawn anew"));
    std::vector<NodeId> varied = *ids;
    std::erase_if(varied, [&](NodeId id) { return !variesByChance(document.scene().find(id)->params); });
    if (varied.empty())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("nothing can vary: no rule has chances, and the variation of "
                                "angles, lengths and radii is 0 %"));
    std::vector<ParamEntry> entries;
    std::vector<std::int64_t> given;
    for (const NodeId id : varied) {
        const NodeParams& params = document.scene().find(id)->params;
        std::int64_t seed = nextSeed(params.grammar.seed);
        while (std::find(given.begin(), given.end(), seed) != given.end())
            seed = nextSeed(seed);
        given.push_back(seed);
        addSeed(entries, *document.scene().find(id), seed);
    }
    pushSet<ParamTarget>(document, std::move(entries), DocumentCommand::tr("New tree"));
    return {};
}

} // namespace ramure
