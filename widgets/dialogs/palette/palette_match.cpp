#include "widgets/dialogs/palette/palette_match.h"

#include "widgets/base/texts/search_text.h"
#include <algorithm>
#include <tuple>

namespace ramure {
namespace {

/// The best of all places where \p word stands in \p title; nothing where it does not.
std::optional<MatchRank> rankIn(const QString& title, const QString& word)
{
    std::optional<MatchRank> best;
    for (qsizetype at = title.indexOf(word); at >= 0; at = title.indexOf(word, at + 1)) {
        if (at == 0)
            return MatchRank::Prefix;
        if (isWordStart(title, at))
            best = MatchRank::WordStart;
        else if (!best)
            best = MatchRank::Inside;
    }
    return best;
}

bool hasWholeWord(const QString& text, const QString& word)
{
    for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
        const qsizetype end = at + word.size();
        if (isWordStart(text, at) && (end == text.size() || !text[end].isLetterOrNumber()))
            return true;
    }
    return false;
}

/// Whether what is typed, with \p best as the best of all ranks, is answered by this rank as well.
bool isGiven(MatchRank rank, MatchRank best)
{
    if (rank == MatchRank::Letters)
        return best == MatchRank::Letters;
    return best > MatchRank::WordStart || (rank != MatchRank::Inside && rank != MatchRank::Within);
}

bool hasLetters(const QString& title, const QStringList& words)
{
    qsizetype at = 0;
    for (const QChar letter : words.join(QString())) {
        at = title.indexOf(letter, at) + 1;
        if (at == 0)
            return false;
    }
    return true;
}

} // namespace

QString paletteName(const PaletteItem& item)
{
    static constexpr const char* kinds[] = {"command:", "parameter:", "page:"};
    return QLatin1String(kinds[item.kind]) + item.id;
}

std::optional<MatchRank> matchRank(const PaletteItem& item, const QStringList& words)
{
    const QString title = searchable(item.title);
    const QString around = searchable(item.place + u' ' + item.words + u' ' + item.keys);
    bool first = words.isEmpty();
    MatchRank worst = MatchRank::Prefix;
    for (const QString& word : words) {
        const auto inTitle = rankIn(title, word);
        if (!inTitle && !around.contains(word)) // a short word's letters stand nearly everywhere
            return words.join(QString()).size() > 2 && hasLetters(title, words)
                       ? std::optional(MatchRank::Letters)
                       : std::nullopt;
        first = first || inTitle == MatchRank::Prefix;
        const MatchRank beside = hasWholeWord(around, word) ? MatchRank::Around : MatchRank::Within;
        worst = std::max(worst, inTitle.value_or(beside));
    }
    return worst == MatchRank::Prefix || (worst == MatchRank::WordStart && first) ? MatchRank::Prefix : worst;
}

std::vector<std::size_t> rankedItems(const std::vector<PaletteItem>& items, const QString& typed,
                                     const QStringList& recent)
{
    const QStringList words = searchWords(typed);
    using Place = std::tuple<MatchRank, qsizetype, bool, std::size_t>;
    std::vector<Place> places;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto rank = matchRank(items[i], words);
        if (!rank)
            continue;
        const qsizetype used = recent.indexOf(paletteName(items[i]));
        places.emplace_back(*rank, used < 0 ? recent.size() : used, !items[i].enabled, i);
    }
    std::ranges::sort(places);
    std::vector<std::size_t> ranked;
    for (const auto& [rank, used, disabled, index] : places)
        if (isGiven(rank, std::get<MatchRank>(places.front())))
            ranked.push_back(index);
    return ranked;
}

} // namespace ramure
