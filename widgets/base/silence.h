/// \file
/// The end of windows whose children speak.
#pragma once

#include <QObject>

namespace ramure {

/// For destructors: what children say from now on does not reach \p parent. They go after its own part has
/// gone, and losing the focus or hiding lets some of them emit signals.
inline void silenceChildren(QObject* parent)
{
    for (QObject* child : parent->findChildren<QObject*>())
        child->disconnect(parent);
}

} // namespace ramure
