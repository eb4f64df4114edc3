/// \file
/// The files of billboards.
#pragma once

#include "widgets/view/render/billboard_baker.h"
#include <QJsonObject>

namespace ramure::cli {

/// atlas_colour.png, atlas_normal.png and atlas.json, which says how they are read, into a folder that is
/// there. \returns their names. Errors: Io.
Expected<QStringList> writeAtlas(const BillboardAtlas& atlas, const QString& folder);
/// One GLB with its pictures inside. Errors: Io.
Expected<void> writeCards(const BillboardCards& cards, const QString& file);
/// cards.glb, and beside it its pictures as cards_colour.png and cards_normal.png, into a folder that is
/// there. \returns their names. Errors: Io.
Expected<QStringList> writeCardFiles(const BillboardCards& cards, const QString& folder);

/// How atlas.json tells an atlas.
QJsonObject atlasJson(const BillboardAtlas& atlas);

} // namespace ramure::cli
