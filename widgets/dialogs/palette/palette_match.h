/// \file
/// How well an item of the palette answers what was typed.
#pragma once

#include "widgets/dialogs/palette/palette_item.h"
#include <QStringList>
#include <optional>
#include <vector>

namespace ramure {

/// The better ones first. The words may come in any order; the worst of them counts.
enum class MatchRank {
    Prefix,    ///< the title begins with one of the words, the others begin words of it
    WordStart, ///< every word begins a word of the title
    Inside,    ///< every word stands somewhere in the title
    Around,    ///< some stand only in the place or in the words beside the title
    Within,    ///< as Around, but as a part of a longer word
    Letters,   ///< the letters stand in the title in this order, with others between
};

/// \param words of searchWords(). Nothing: the item does not fit. Without words everything fits.
std::optional<MatchRank> matchRank(const PaletteItem& item, const QStringList& words);

/// Indices into \p items, the best first; equals in the order of \p recent (paletteName, the latest first),
/// then what is enabled, then in their own order. What stands inside longer words is given only where no
/// title has a word that begins so; items that fit only by their letters, where no other fits.
std::vector<std::size_t> rankedItems(const std::vector<PaletteItem>& items, const QString& typed,
                                     const QStringList& recent);

} // namespace ramure
