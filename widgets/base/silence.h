/// \file
/// The end of windows whose children speak.
#pragma once

#include <QObject>

namespace ramure {

/// Silences children for a destructor: their signals no longer reach \p parent. They go after its own part
/// has gone, and losing the focus or hiding lets some of them emit signals.
inline void silenceChildren(QObject* parent)
{
    for (QObject* child : parent->findChildren<QObject*>())
        child->disconnect(parent);
}

} // namespace ramure
