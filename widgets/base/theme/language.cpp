#include "widgets/base/theme/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <algorithm>

namespace ramure {

QList<std::pair<QString, QString>> Language::available()
{
    return {{QStringLiteral("en"), QStringLiteral("English")},
            {QStringLiteral("fr"), QStringLiteral("Français")}};
}

Language::Language(const Preferences& preferences)
    : m_current(preferences.language())
{
    const QString system = QLocale::system().name().section(u'_', 0, 0);
    if (m_current.isEmpty())
        m_current = system;
    const auto languages = available();
    if (std::ranges::none_of(languages, [&](const auto& language) { return language.first == m_current; }))
        m_current = QStringLiteral("en");
    // Numbers look as the language writes them.
    QLocale::setDefault(m_current == system ? QLocale::system() : QLocale(m_current));
    if (m_qt.load(QStringLiteral("qtbase_") + m_current, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_program.load(QStringLiteral(":/i18n/ramure_") + m_current))
        QCoreApplication::installTranslator(&m_program);
}

Language::~Language()
{
    QCoreApplication::removeTranslator(&m_program);
    QCoreApplication::removeTranslator(&m_qt);
}

} // namespace ramure
