/// \file
/// The language of the interface, from the start of the program to its end: widgets take their texts when
/// they are made.
#pragma once

#include "widgets/base/theme/preferences.h"
#include <QList>
#include <QTranslator>
#include <utility>

namespace ramure {

class Language
{
public:
    /// Installs the translators for the preferred language.
    explicit Language(const Preferences& preferences);
    ~Language();
    Language(const Language&) = delete;
    Language& operator=(const Language&) = delete;

    /// Code and own name of each language there is: ("en", "English"), ("fr", "Français").
    static QList<std::pair<QString, QString>> available();
    /// The code in use.
    [[nodiscard]] QString current() const { return m_current; }

private:
    QTranslator m_program; ///< English too has a file: plurals
    QTranslator m_qt;      ///< Qt's own dialogs
    QString m_current;
};

} // namespace ramure
