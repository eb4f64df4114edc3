/// \file
/// The program's own icons (resources/icons), in the variant that fits the theme.
#pragma once

#include <QIcon>

namespace ramure {

/// \param name file name in resources/icons without its ending. Follows a change of the theme by itself.
QIcon icon(const char* name);

} // namespace ramure
