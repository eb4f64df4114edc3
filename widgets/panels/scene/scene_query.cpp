#include "widgets/panels/scene/scene_query.h"

#include "core/generators/parametric/quantity.h"
#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <optional>

namespace ramure {
namespace {

struct QuantityWord
{
    BranchQuantity quantity;
    const char* english;
};
constexpr QuantityWord quantityWords[] = {
    {BranchQuantity::Length, QT_TRANSLATE_NOOP("SceneQuery", "length")},
    {BranchQuantity::Radius, QT_TRANSLATE_NOOP("SceneQuery", "radius")},
    {BranchQuantity::Order, QT_TRANSLATE_NOOP("SceneQuery", "order")},
    {BranchQuantity::Children, QT_TRANSLATE_NOOP("SceneQuery", "children")},
    {BranchQuantity::Number, QT_TRANSLATE_NOOP("SceneQuery", "number")},
};
constexpr const char* terminalWord = QT_TRANSLATE_NOOP("SceneQuery", "terminal");

QString translated(const char* english)
{
    return QCoreApplication::translate("SceneQuery", english);
}

std::optional<BranchQuantity> quantityOf(const QString& word)
{
    const QString lower = word.toLower();
    for (const auto& [quantity, english] : quantityWords) {
        if (QLatin1String(english).startsWith(lower) || translated(english).toLower().startsWith(lower))
            return quantity;
    }
    return std::nullopt;
}

bool isTerminal(const QString& word)
{
    return word.compare(QLatin1String(terminalWord), Qt::CaseInsensitive) == 0 ||
           word.compare(terminalName(), Qt::CaseInsensitive) == 0;
}

/// "order 2" is "order = 2": of whole words only, for names of nodes may have both.
QString withEquals(const QString& text)
{
    QStringList words;
    for (const BranchQuantity counted : {BranchQuantity::Order, BranchQuantity::Children}) {
        const char* english = quantityWords[static_cast<int>(counted)].english;
        for (const QString& word : {QString::fromLatin1(english), translated(english)})
            words += QRegularExpression::escape(word);
    }
    const QRegularExpression counts(QStringLiteral("(?<!\\S)(%1)\\s+([0-9]+)(?!\\S)").arg(words.join(u'|')),
                                    QRegularExpression::CaseInsensitiveOption |
                                        QRegularExpression::UseUnicodePropertiesOption);
    return QString(text).replace(counts, QStringLiteral("\\1 = \\2"));
}

/// Lengths are typed with a few digits: equal means equal in what is shown.
constexpr double sameLength = 5e-4;

} // namespace

QString quantityName(BranchQuantity quantity)
{
    return translated(quantityWords[static_cast<int>(quantity)].english);
}

QString terminalName()
{
    return translated(terminalWord);
}

Expected<SceneQuery> SceneQuery::parse(const QString& typed)
{
    const QString text = withEquals(typed);
    static const QRegularExpression comparison(
        QStringLiteral("([^\\s<>=!≤≥≠]*)\\s*(<=|>=|!=|==|<|>|=|≤|≥|≠)\\s*"
                       "([-+]?[0-9.,][^\\s<>=!≤≥≠]*(?:\\s*(?:mm|cm|km|m|in|ft)\\b)?)?"),
        QRegularExpression::CaseInsensitiveOption);
    SceneQuery query;
    QString rest;
    qsizetype from = 0;
    for (auto it = comparison.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        rest += text.mid(from, match.capturedStart() - from) + u' ';
        from = match.capturedEnd();
        const QString word = match.captured(1), sign = match.captured(2), number = match.captured(3);
        const auto quantity = word.isEmpty() ? std::nullopt : quantityOf(word);
        if (!quantity)
            return fail(ErrorCode::Syntax, RAMURE_NOOP("“%1” cannot be compared"), {word.toStdString()});
        const bool metres = *quantity == BranchQuantity::Length || *quantity == BranchQuantity::Radius;
        const auto value =
            evaluateQuantity(number.toStdString(), metres ? ParamUnit::Metre : ParamUnit::None);
        if (number.isEmpty() || !value)
            return fail(ErrorCode::Syntax, RAMURE_NOOP("a number is missing after “%1”"),
                        {(word + u' ' + sign).toStdString()});
        Comparison kind = Comparison::Equal;
        if (sign == u"<")
            kind = Comparison::Less;
        else if (sign == u"<=" || sign == u"≤")
            kind = Comparison::LessEqual;
        else if (sign == u">")
            kind = Comparison::Greater;
        else if (sign == u">=" || sign == u"≥")
            kind = Comparison::GreaterEqual;
        else if (sign == u"!=" || sign == u"≠")
            kind = Comparison::NotEqual;
        query.m_conditions.push_back({*quantity, kind, *value});
    }
    rest += text.mid(from);
    for (const QString& word : rest.split(u' ', Qt::SkipEmptyParts)) {
        if (isTerminal(word))
            query.m_conditions.push_back({BranchQuantity::Children, Comparison::Equal, 0.0});
        else
            query.m_words += word;
    }
    return query;
}

bool SceneQuery::Condition::holds(const BranchRows& rows, Index branch) const
{
    const Skeleton& bones = rows.skeleton();
    double have = 0.0;
    double same = 0.0;
    switch (quantity) {
    case BranchQuantity::Length:
        have = rows.length(rows.axisOf(branch));
        same = sameLength;
        break;
    case BranchQuantity::Radius:
        have = bones.a0[branch];
        same = sameLength;
        break;
    case BranchQuantity::Order:
        have = bones.level[branch];
        break;
    case BranchQuantity::Children:
        have = rows.forks(branch);
        break;
    case BranchQuantity::Number:
        have = branch;
        break;
    }
    switch (comparison) {
    case Comparison::Less:
        return have < number;
    case Comparison::LessEqual:
        return have <= number;
    case Comparison::Equal:
        return std::abs(have - number) <= same;
    case Comparison::NotEqual:
        return std::abs(have - number) > same;
    case Comparison::GreaterEqual:
        return have >= number;
    case Comparison::Greater:
        return have > number;
    }
    return false;
}

bool SceneQuery::hasWords(const QString& name) const
{
    return std::ranges::all_of(m_words,
                               [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

bool SceneQuery::matchesNode(const QString& name) const
{
    return !isEmpty() && m_conditions.empty() && hasWords(name);
}

std::vector<Index> SceneQuery::matches(const BranchRows& rows, const BranchNames& names) const
{
    std::vector<Index> found;
    if (isEmpty())
        return found;
    if (!findsBranches()) {
        for (Index axis = 0; axis < rows.axisCount(); ++axis) {
            if (hasWords(names.axis(rows, axis)))
                found.push_back(axis);
        }
        return found;
    }
    for (Index branch = 0; branch < rows.skeleton().size(); ++branch) {
        const bool fits = std::ranges::all_of(
            m_conditions, [&](const Condition& condition) { return condition.holds(rows, branch); });
        if (fits && (m_words.isEmpty() || hasWords(names.branch(rows, branch))))
            found.push_back(branch);
    }
    return found;
}

} // namespace ramure
