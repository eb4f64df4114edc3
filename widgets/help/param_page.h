/// \file
/// The handbook's page of the parameters, made from their table in the language of the interface.
#pragma once

#include "widgets/help/handbook.h"

namespace ramure {

/// In Markdown. A parameter's paragraph begins with its name in bold and its key as code.
QString paramPage();
/// The page's title and the groups.
std::vector<HandbookHeading> paramPageHeadings();

} // namespace ramure
