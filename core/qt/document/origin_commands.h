/// \file
/// Where a node came from.
#pragma once

#include "core/qt/document/document.h"

namespace ramure::edit {

/// What a node is called, and the preset that its parameters go back to. One step of undo with this text.
/// Errors: as of setNodeName.
Expected<void> setNodeOrigin(Document& document, NodeId node, const std::string& name,
                             const std::string& preset, const QString& text);

} // namespace ramure::edit
