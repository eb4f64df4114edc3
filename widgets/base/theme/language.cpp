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

Language::Language(Preferences* preferences, QObject* parent)
    : QObject(parent)
    , m_preferences(preferences)
{
    connect(preferences, &Preferences::changed, this, &Language::apply);
    apply();
}

Language::~Language()
{
    QCoreApplication::removeTranslator(&m_program);
    QCoreApplication::removeTranslator(&m_qt);
}

void Language::apply()
{
    QString code = m_preferences->language();
    if (code.isEmpty())
        code = QLocale::system().name().section(u'_', 0, 0);
    const auto languages = available();
    if (std::ranges::none_of(languages, [&](const auto& language) { return language.first == code; }))
        code = QStringLiteral("en");
    if (code == m_current)
        return;
    m_current = code;
    // Numbers look as the language writes them.
    QLocale::setDefault(code == QLocale::system().name().section(u'_', 0, 0) ? QLocale::system()
                                                                             : QLocale(code));
    QCoreApplication::removeTranslator(&m_qt);
    QCoreApplication::removeTranslator(&m_program);
    if (m_qt.load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_program.load(QStringLiteral(":/i18n/ramure_") + code))
        QCoreApplication::installTranslator(&m_program);
}

} // namespace ramure
