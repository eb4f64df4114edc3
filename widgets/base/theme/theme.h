/// \file
/// The look of the program: a light and a dark palette, one style sheet over the Fusion style, two sets of
/// icons.
#pragma once

#include "widgets/base/theme/preferences.h"
#include <QObject>
#include <QPalette>

class QApplication;

namespace ramure {

/// Is this palette's text lighter than its window?
bool isDark(const QPalette& palette);
/// Returns the colour of messages about errors and of marks on them. It is readable on the palette's window.
QColor errorColour(const QPalette& palette);
QColor goodColour(const QPalette& palette);
QColor warningColour(const QPalette& palette);
/// From \p a, share 0, to \p b, share 1.
QColor blended(const QColor& a, const QColor& b, double share);

QPalette themePalette(bool dark);

/// Keeps the application's look in step with the preferences and the system.
class Theme : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive the theme.
    Theme(QApplication* application, Preferences* preferences);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void apply();
    [[nodiscard]] bool systemIsDark() const;

    QApplication* m_application;
    Preferences* m_preferences;
    bool m_dark = false;
    bool m_systemDark = false;
    bool m_applied = false;
    bool m_applying = false;
};

/// The style sheet with the palette's colours filled in.
QString themeStyleSheet(const QPalette& palette);

} // namespace ramure
