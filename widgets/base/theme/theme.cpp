#include "widgets/base/theme/theme.h"

#include "widgets/base/theme/ramure_style.h"
#include <QApplication>
#include <QEvent>
#include <QIcon>
#include <QStyle>

namespace ramure {
namespace {

struct Tones
{
    QColor window, base, alternate, button, text, disabledText, highlight, highlightedText, light, mid, dark,
        link;
};

const Tones& tones(bool dark)
{
    static const Tones lightTones{.window = 0xf3f4f2,
                                  .base = 0xffffff,
                                  .alternate = 0xf7f8f6,
                                  .button = 0xe9ebe8,
                                  .text = 0x20241f,
                                  .disabledText = 0x878d85,
                                  .highlight = 0x3d7a4e,
                                  .highlightedText = 0xffffff,
                                  .light = 0xffffff,
                                  .mid = 0xc6cbc4,
                                  .dark = 0x9ba199,
                                  .link = 0x2b6a8f};
    static const Tones darkTones{.window = 0x262a27,
                                 .base = 0x1c1f1d,
                                 .alternate = 0x212522,
                                 .button = 0x363b37,
                                 .text = 0xdfe3de,
                                 .disabledText = 0x7f8781,
                                 .highlight = 0x427f54,
                                 .highlightedText = 0xffffff,
                                 .light = 0x454b46,
                                 .mid = 0x141715,
                                 .dark = 0x0f110f,
                                 .link = 0x86bfe0};
    return dark ? darkTones : lightTones;
}

/// Less important than other text, yet of a contrast of 4.5 : 1 on all that texts stand on.
QColor dimmed(const QColor& window, const QColor& text)
{
    return blended(window, text, 0.74);
}

} // namespace

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

QColor errorColour(const QPalette& palette)
{
    return isDark(palette) ? QColor(0xf5, 0x96, 0x8a) : QColor(0x9f, 0x24, 0x17);
}

QColor goodColour(const QPalette& palette)
{
    return isDark(palette) ? QColor(0x7c, 0xc8, 0x8e) : QColor(0x25, 0x66, 0x3a);
}

QColor warningColour(const QPalette& palette)
{
    return isDark(palette) ? QColor(0xe3, 0xb3, 0x5c) : QColor(0x7a, 0x52, 0x04);
}

QPalette themePalette(bool dark)
{
    const Tones& tone = tones(dark);
    QPalette palette;
    palette.setColor(QPalette::Window, tone.window);
    palette.setColor(QPalette::WindowText, tone.text);
    palette.setColor(QPalette::Base, tone.base);
    palette.setColor(QPalette::AlternateBase, tone.alternate);
    palette.setColor(QPalette::Text, tone.text);
    palette.setColor(QPalette::PlaceholderText, dimmed(tone.window, tone.text));
    palette.setColor(QPalette::Button, tone.button);
    palette.setColor(QPalette::ButtonText, tone.text);
    palette.setColor(QPalette::BrightText, QColor(0xff, 0xff, 0xff));
    palette.setColor(QPalette::ToolTipBase, dark ? QColor(0x3a, 0x40, 0x3b) : QColor(0xff, 0xff, 0xff));
    palette.setColor(QPalette::ToolTipText, tone.text);
    palette.setColor(QPalette::Highlight, tone.highlight);
    palette.setColor(QPalette::HighlightedText, tone.highlightedText);
    palette.setColor(QPalette::Light, tone.light);
    palette.setColor(QPalette::Midlight, tone.button);
    palette.setColor(QPalette::Mid, tone.mid);
    palette.setColor(QPalette::Dark, tone.dark);
    palette.setColor(QPalette::Shadow, QColor(0, 0, 0));
    palette.setColor(QPalette::Link, tone.link);
    palette.setColor(QPalette::LinkVisited, tone.link);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, tone.disabledText);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tone.mid);
    return palette;
}

Theme::Theme(QApplication* application, Preferences* preferences)
    : QObject(application)
    , m_application(application)
    , m_preferences(preferences)
{
    m_systemDark = systemIsDark();
    QIcon::setThemeSearchPaths(QIcon::themeSearchPaths() << QStringLiteral(":/icons"));
    m_application->setStyle(new RamureStyle);
    m_application->installEventFilter(this);
    connect(m_preferences, &Preferences::changed, this, &Theme::apply);
    apply();
}

bool Theme::systemIsDark() const
{
    // Our own palette hides that of the system: look at what there is without it.
    const QPalette own = QApplication::palette();
    QApplication::setPalette(QPalette());
    const bool dark = isDark(QApplication::palette());
    QApplication::setPalette(own);
    return dark;
}

bool Theme::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ThemeChange && watched->isWindowType() && !m_applying) {
        m_applying = true;
        m_systemDark = systemIsDark();
        m_applying = false;
        m_applied = false;
        apply();
    }
    return QObject::eventFilter(watched, event);
}

void Theme::apply()
{
    const ThemeChoice choice = m_preferences->theme();
    const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && m_systemDark);
    if (m_applied && dark == m_dark)
        return;
    m_applied = true;
    m_dark = dark;
    const QPalette palette = themePalette(dark);
    QIcon::setThemeName(dark ? QStringLiteral("ramure-dark") : QStringLiteral("ramure-light"));
    QApplication::setPalette(palette);
    m_application->setStyleSheet(themeStyleSheet(palette));
}

} // namespace ramure
