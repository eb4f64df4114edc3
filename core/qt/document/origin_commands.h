/// \file
/// Commands that change where a node came from.
#pragma once

#include "core/qt/document/document.h"

namespace ramure::edit {

/// Sets a node's name and the preset that its parameters can be reset to. One step of undo with this text.
/// Errors: as of setNodeName.
Expected<void> setNodeOrigin(Document& document, NodeId node, const std::string& name,
                             const std::string& preset, const QString& text);

} // namespace ramure::edit
