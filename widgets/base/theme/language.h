/// \file
/// The language of the interface. Widgets react to QEvent::LanguageChange, so it can change while the program
/// runs.
#pragma once

#include "widgets/base/theme/preferences.h"
#include <QList>
#include <QTranslator>
#include <utility>

namespace ramure {

class Language : public QObject
{
    Q_OBJECT
public:
    /// Installs the translators for the preferred language and follows the preference.
    /// \p preferences is not owned and must outlive the object.
    explicit Language(Preferences* preferences, QObject* parent = nullptr);
    ~Language() override;

    /// Code and own name of each language there is: ("en", "English"), ("fr", "Français").
    static QList<std::pair<QString, QString>> available();
    /// The code in use now.
    [[nodiscard]] QString current() const { return m_current; }

private:
    void apply();

    Preferences* m_preferences;
    QTranslator m_program; ///< English too has a file: plurals
    QTranslator m_qt;      ///< Qt's own dialogs
    QString m_current;
};

} // namespace ramure
