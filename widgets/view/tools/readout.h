/// \file
/// The values of a gesture, shown beside the hand.
#pragma once

#include <QPointF>
#include <QSize>
#include <QString>

class QPainter;

namespace ramure {

/// Beside the cursor, on a ground of its own: readable on any picture.
void paintReadout(QPainter& painter, QPointF at, QSize picture, const QString& text);

} // namespace ramure
