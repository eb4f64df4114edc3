/// \file
/// Scripts of edits: a JSON object a line, each as if a hand had made it (project_edits.h).
#pragma once

#include "core/qt/document/document.h"

#include <QByteArray>

namespace ramure {

/// Makes the edits of a script on a tree, all as one step. Each is prepared on the result of those before it.
/// Errors, after which nothing is changed: Syntax (no JSON object), Unknown (operation, limb, key), Invalid
/// (a value; an edit that cannot be made), those of a tree that does not grow; with the line.
Expected<void> replayEdits(Document& document, NodeId tree, const QByteArray& script);

} // namespace ramure
