#include "core/io/formats/file_format.h"
#include "core/qt/session/export/export_option.h"
#include "tests/support/suite.h"
#include <QStringList>
#include <algorithm>
#include <set>

namespace tst_export_option {

using namespace ramure;

/// The table of export options: each row reads what it says, refuses the rest, and gives back what it read.
class TestExportOption : public QObject
{
    Q_OBJECT

    static const ExportOption& named(const char* name)
    {
        return *std::ranges::find(exportOptions(), std::string_view(name), &ExportOption::name);
    }
    static QString refusal(const char* name, const char* text)
    {
        ExportOptions options;
        const auto read = readOption(named(name), options, text);
        return read ? QString() : QString::fromStdString(read.error().message());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongValuesAreRefused()
    {
        QVERIFY(refusal("wind", "godot").contains("none, plain, crysis, unity, pivot-painter expected"));
        QVERIFY(refusal("print", "wood").contains("--print \"wood\": fdm, resin, powder expected"));
        QVERIFY(refusal("print-leaves", "paper").contains("off or shells"));
        for (const char* size : {"", "-1", "15", "8193", "64.5", "1e3", "big"})
            QVERIFY2(refusal("map-size", size).contains("0, or 16 to 8192 pixels expected"), size);
        for (const char* joints : {"0", "65536", "none"})
            QVERIFY2(refusal("joints", joints).contains("all, or 1 to 65535 expected"), joints);
        QVERIFY(refusal("budget", "1000,").contains("separated by commas"));
        QVERIFY(refusal("scale", "nan").contains("the scale must be from"));
        QVERIFY(refusal("part", "roots").contains("branches, leaves, fruit, all expected"));
        QVERIFY(refusal("part", "apples").isEmpty()); // the old name of fruit
    }
    /// Names and keys are there once, and a row says all that its places need.
    void rowsAreWhole()
    {
        std::set<std::string> names, keys;
        for (const ExportOption& option : exportOptions()) {
            QVERIFY2(*option.name != '\0' && names.insert(option.name).second, option.name);
            QVERIFY2(*option.help != '\0', option.name);
            QCOMPARE(QString::fromUtf8(option.help).contains("%1"), *option.inExport != '\0');
            if (*option.key == '\0')
                continue;
            QVERIFY2(keys.insert(option.key).second, option.key);
            QVERIFY2(*option.label != '\0' && option.uses != 0 && option.place.get, option.key);
        }
    }
    /// Every word of the help can be said, and is what is said of the options afterwards.
    void wordsAreReadAndGivenBack()
    {
        for (const ExportOption& option : exportOptions())
            for (const QString& word : QString::fromUtf8(option.values).split('|', Qt::SkipEmptyParts)) {
                if (word != word.toLower())
                    continue;
                ExportOptions options;
                QVERIFY2(readOption(option, options, word.toStdString()), qPrintable(word));
                QCOMPARE(optionText(option, options), word.toStdString());
            }
    }
    void numbersAreReadAndGivenBack()
    {
        ExportOptions options;
        for (const auto& [name, text] :
             {std::pair("map-size", "64"), std::pair("joints", "100"), std::pair("levels", "3"),
              std::pair("budget", "9000,300"), std::pair("switch", "20; 60"), std::pair("scale", "0.5")}) {
            QVERIFY2(isUsual(named(name), options), name);
            QVERIFY2(readOption(named(name), options, text), name);
            QCOMPARE(optionText(named(name), options), std::string(text));
            QVERIFY2(!isUsual(named(name), options), name);
        }
        QCOMPARE(options.write.mapSize, 64);
        QCOMPARE(options.write.joints, 100);
        QVERIFY((options.levels == LevelOptions{3, {9000, 300}, {20.0, 60.0}, {}}));
        QVERIFY(readOption(named("joints"), options, "all"));
        QCOMPARE(options.write.joints, 0);
        QVERIFY(readOption(named("height"), options, "7in"));
        QCOMPARE(options.print.height, 7 * 0.0254);
    }
    /// The editor asks for what use and format can have.
    void isOfferedWhereItHasASay()
    {
        const FileFormat& glb = **findFormat("t.glb", FormatUse::Write);
        const FileFormat& obj = **findFormat("t.obj", FormatUse::Write);
        QVERIFY(isOffered(named("wind"), {ExportUse::Game, &glb}));
        QVERIFY(!isOffered(named("wind"), {ExportUse::Web, &glb}));
        QVERIFY(!isOffered(named("wind"), {ExportUse::Game, &obj}));
        QVERIFY(!isOffered(named("joints"), {ExportUse::Game, &glb}));
        QVERIFY(isOffered(named("joints"), {ExportUse::Game, &glb, false, true}));
        QVERIFY(!isOffered(named("map-size"), {ExportUse::Pictures, nullptr}));
        QVERIFY(!isOffered(named("up"), {ExportUse::Web, nullptr}));
    }
};

RAMURE_SUITE(TestExportOption)

} // namespace tst_export_option

#include "tst_export_option.moc"
