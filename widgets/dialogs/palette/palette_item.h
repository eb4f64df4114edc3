/// \file
/// What the palette finds: commands, parameters and places of the handbook, in one form.
#pragma once

#include <QIcon>
#include <QString>

namespace ramure {

struct PaletteItem
{
    enum Kind { Command, Parameter, Page };

    Kind kind = Command;
    QString id;     ///< of the action; key of the parameter; "page#anchor" of the handbook
    QString title;  ///< in the interface's language
    QString place;  ///< where it stands: "View › Panels"
    QString words;  ///< also searched, not shown: the id, the description
    QString keys;   ///< the shortcut, as the user reads it; empty: none
    QString reason; ///< why it cannot be done now; may be empty
    bool enabled = true;
    QIcon icon;
};

/// The same in all runs of the program, for the list of what was used last.
QString paletteName(const PaletteItem& item);

} // namespace ramure
