/// \file
/// Short ways to make widgets and layouts.
#pragma once

#include <QMargins>
#include <QObject>
#include <QString>

class QWidget;

namespace ramure {

/// Gives a new object the name by which the style sheet and the tests find it.
template <class T> T* named(T* object, const char* name)
{
    object->setObjectName(QLatin1String(name));
    return object;
}

/// A layout without the margins of the style. \param spacing below 0: that of the style
template <class Layout>
Layout* layoutOf(QWidget* parent = nullptr, int spacing = -1, const QMargins& margins = {})
{
    auto* layout = parent ? new Layout(parent) : new Layout;
    layout->setContentsMargins(margins);
    if (spacing >= 0)
        layout->setSpacing(spacing);
    return layout;
}

} // namespace ramure
