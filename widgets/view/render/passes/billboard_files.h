/// \file
/// Options of billboards, and their files.
#pragma once

#include "widgets/view/render/passes/billboard_baker.h"
#include <QJsonObject>
#include <QStringList>

namespace ramure {

inline constexpr int leastBillboardSize = 64, mostBillboardSize = 8192; ///< pixels a side
inline constexpr int leastViewSize = 16; ///< pixels of one view of an atlas, each way

/// Crossed cards, or an atlas of views.
struct BillboardWish
{
    bool isAtlas = false;
    int size = 2048;    ///< pixels a side of the pictures
    int cards = 2;      ///< number of upright cards
    bool lying = false; ///< one more card lies
    int views = 8;      ///< views of an atlas, each way
};
/// Whether an atlas of that size has whole views, each large enough.
bool holdsViews(int size, int views);

/// Whether cards go into this one file: its ending is .glb. Else the place is a folder.
bool isCardFile(const QString& place);
/// The names of the files that a billboard has in a folder.
QStringList billboardFiles(bool isAtlas);

/// atlas_colour.png, atlas_normal.png and atlas.json, which says how they are read, into a folder that is
/// there. \returns their names. Errors: Io.
Expected<QStringList> writeAtlas(const BillboardAtlas& atlas, const QString& folder);
/// One GLB with its pictures inside; or into a folder that is there cards.glb, and beside it its pictures as
/// cards_colour.png and cards_normal.png. \returns the names. Errors: Io.
Expected<QStringList> writeCards(const BillboardCards& cards, const QString& place);

/// How atlas.json tells an atlas.
QJsonObject atlasJson(const BillboardAtlas& atlas);

} // namespace ramure
