#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/language.h"
#include <QProcess>
#include <QXmlStreamReader>
#include <map>

namespace tst_translations {

using namespace ramure;

namespace {

struct Message
{
    QString source;
    QStringList translations; ///< one, or one per plural form
    bool finished = true;
};
using Messages = std::map<QString, Message>; ///< by context and source

Messages readTs(const QString& path)
{
    Messages messages;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    Message message;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::EndElement && xml.name() == u"message")
            messages[context + u'|' + message.source] = message;
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"message") {
            message = {};
        } else if (xml.name() == u"source") {
            message.source = xml.readElementText();
        } else if (xml.name() == u"translation") {
            message.finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            QString text;
            while (xml.readNext() != QXmlStreamReader::EndElement || xml.name() != u"translation") {
                if (xml.isStartElement() && xml.name() == u"numerusform")
                    message.translations += xml.readElementText();
                else if (xml.isCharacters())
                    text += xml.text();
            }
            if (message.translations.isEmpty())
                message.translations += text;
        }
    }
    return messages;
}

QString tsPath(const QString& language)
{
    return QStringLiteral(RAMURE_SOURCE_DIR "/translations/ramure_%1.ts").arg(language);
}

/// "%1", "%n" ...; a translation must have the same.
QStringList places(const QString& text)
{
    QStringList found;
    static const QRegularExpression place(QStringLiteral("%[1-9n]"));
    for (auto it = place.globalMatch(text); it.hasNext();)
        found += it.next().captured();
    found.sort();
    found.removeDuplicates();
    return found;
}

} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void everyEntryIsFinished_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("en") << "en";
        QTest::newRow("fr") << "fr";
    }
    void everyEntryIsFinished()
    {
        QFETCH(const QString, language);
        const Messages messages = readTs(tsPath(language));
        QVERIFY(!messages.empty());
        for (const auto& [key, message] : messages) {
            QVERIFY2(message.finished, qPrintable(key));
            for (const QString& text : message.translations) {
                QVERIFY2(!text.isEmpty(), qPrintable(key));
                if (message.translations.size() == 1)
                    QVERIFY2(places(text) == places(message.source), qPrintable(key));
            }
        }
    }

    void everyTextOfTheSourcesIsThere()
    {
        const QString script = QStringLiteral(RAMURE_SOURCE_DIR "/translations/update");
        QTemporaryDir folder;
        for (const char* language : {"en", "fr"}) {
            const QString name = QStringLiteral("/ramure_%1.ts").arg(QLatin1String(language));
            QVERIFY(QFile::copy(tsPath(QLatin1String(language)), folder.path() + name));
        }
        QProcess process;
        process.start(script, {folder.path()});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 0);
        for (const char* language : {"en", "fr"}) {
            const Messages known = readTs(tsPath(QLatin1String(language)));
            const Messages fresh =
                readTs(folder.path() + QStringLiteral("/ramure_%1.ts").arg(QLatin1String(language)));
            for (const auto& [key, message] : fresh)
                QVERIFY2(known.contains(key),
                         qPrintable(QStringLiteral("new text, run translations/update: ") + key));
            for (const auto& [key, message] : known)
                QVERIFY2(fresh.contains(key), qPrintable(QStringLiteral("text is gone: ") + key));
        }
    }

    void theLanguageIsThatOfThePreferencesAtTheStart()
    {
        const test::OwnSettings settings;
        Preferences preferences;
        preferences.language.set(QStringLiteral("fr"));
        {
            const Language language(preferences);
            QCOMPARE(language.current(), QStringLiteral("fr"));
            QCOMPARE(QCoreApplication::translate("core", "Grammar"), QStringLiteral("Grammaire"));
            preferences.language.set(QStringLiteral("en"));
            QCOMPARE(language.current(), QStringLiteral("fr"));
            QCOMPARE(QCoreApplication::translate("core", "Grammar"), QStringLiteral("Grammaire"));
        }
        const Language english(preferences);
        QCOMPARE(QCoreApplication::translate("core", "Grammar"), QStringLiteral("Grammar"));
        QCOMPARE(QCoreApplication::translate("ramure::PropertiesPanel", "%n node(s) selected", nullptr, 1),
                 QStringLiteral("1 node selected"));
        preferences.language.set(QStringLiteral("xx")); // not there: English
        QCOMPARE(Language(preferences).current(), QStringLiteral("en"));
    }
};

RAMURE_SUITE(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
