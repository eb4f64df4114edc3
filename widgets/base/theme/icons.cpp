#include "widgets/base/theme/icons.h"

#include <QString>

namespace ramure {

QIcon icon(const char* name)
{
    return QIcon::fromTheme(QStringLiteral("ramure-") + QString::fromLatin1(name));
}

} // namespace ramure
