#include "widgets/dialogs/variations/variations_model.h"

#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/number_format.h"
#include <algorithm>

namespace ramure {
namespace {

QString valueText(const ParamDef& def, const ParamValue& value, bool degrees)
{
    const NumberFormat format = numberFormat(def, degrees ? AngleUnit::Degrees : AngleUnit::Radians);
    if (const auto* real = std::get_if<double>(&value))
        return format.text(*real) + format.suffix;
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return format.text(double(*whole)) + format.suffix;
    if (const auto* item = std::get_if<EnumValue>(&value)) {
        const auto found = std::ranges::find(
            def.items, item->name, [](const EnumItem& each) { return std::string_view(each.name); });
        return found == def.items.end() ? QString() : coreText(found->label);
    }
    return std::get<bool>(value) ? VariationsModel::tr("on") : VariationsModel::tr("off");
}

} // namespace

void VariationsModel::clear()
{
    beginResetModel();
    m_items.clear();
    endResetModel();
}

void VariationsModel::offer(const std::vector<Variation>& variations)
{
    beginResetModel();
    std::erase_if(m_items, [](const Item& item) { return !item.starred; });
    const std::size_t kept = m_items.size();
    for (const Variation& variation : variations) {
        const auto end = m_items.begin() + std::ptrdiff_t(kept);
        if (std::none_of(m_items.begin(), end, [&](const Item& item) { return item.variation == variation; }))
            m_items.push_back({variation, {}, {}, false});
    }
    endResetModel();
}

std::vector<Variation> VariationsModel::chosen(Choice choice) const
{
    std::vector<Variation> out;
    for (const Item& item : m_items)
        if (choice == Choice::All || item.starred == (choice == Choice::Starred))
            out.push_back(item.variation);
    return out;
}

void VariationsModel::setStarred(int row, bool starred)
{
    m_items[std::size_t(row)].starred = starred;
    emit dataChanged(index(row), index(row), {StarRole});
}

/// Where ages vary.
static std::optional<double> ageOf(const Variation& variation)
{
    const auto age = std::ranges::find(variation.values, findParam("growth.age"),
                                       &std::pair<const ParamDef*, ParamValue>::first);
    return age == variation.values.end() ? std::nullopt : std::optional(std::get<double>(age->second));
}

int VariationsModel::nextUndrawn(bool oldest) const
{
    int next = -1;
    for (int row = 0; row < rowCount(); ++row) {
        const Item& item = m_items[std::size_t(row)];
        if (!item.picture.isNull() || !item.problem.isEmpty())
            continue;
        if (next < 0 || (oldest && ageOf(item.variation) > ageOf(at(next))))
            next = row;
    }
    return next;
}

int VariationsModel::drawn() const
{
    return int(std::ranges::count_if(
        m_items, [](const Item& item) { return !item.picture.isNull() || !item.problem.isEmpty(); }));
}

void VariationsModel::setPicture(int row, const QPixmap& picture)
{
    m_items[std::size_t(row)].picture = picture;
    emit dataChanged(index(row), index(row), {Qt::DecorationRole});
}

void VariationsModel::setProblem(int row, const QString& problem)
{
    m_items[std::size_t(row)].problem = problem;
    emit dataChanged(index(row), index(row), {ProblemRole, Qt::ToolTipRole});
}

int VariationsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_items.size());
}

/// The seed, then a line for each parameter.
QString VariationsModel::tipOf(const Item& item) const
{
    QStringList lines{tr("Seed %1").arg(item.variation.seed)};
    for (const auto& [def, value] : item.variation.values)
        lines << tr("%1: %2", "Length: 3 m").arg(coreText(def->label), valueText(*def, value, m_degrees));
    if (!item.problem.isEmpty())
        lines << item.problem;
    return lines.join(u'\n');
}

QVariant VariationsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const Item& item = m_items[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        if (const auto age = ageOf(item.variation))
            return tr("Seed %1, %2", "2, 40 years")
                .arg(item.variation.seed)
                .arg(valueText(*findParam("growth.age"), *age, false));
        return tr("Seed %1").arg(item.variation.seed);
    case Qt::DecorationRole:
        return item.picture;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return tipOf(item);
    case StarRole:
        return item.starred;
    case ProblemRole:
        return item.problem;
    default:
        return {};
    }
}

} // namespace ramure
