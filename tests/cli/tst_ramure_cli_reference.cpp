#include "app/cli/editor_options.h"
#include "core/params/param_def.h"
#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "tests/cli/cli_support.h"

namespace tst_ramure_cli_reference {

using namespace ramure;
using test::runCli;

namespace {

/// The parts of bash-completion that the script calls, as plain as they can be.
constexpr const char* completionBench = R"(
_init_completion() { words=("${COMP_WORDS[@]}") cword=$COMP_CWORD cur=${words[cword]} prev=${words[cword-1]}; }
_filedir() { COMPREPLY+=(FILES); }
__ltrim_colon_completions() { :; }
compopt() { :; }
source "$1"
shift
COMP_WORDS=("$@") COMP_CWORD=$(($#-1))
_ramure "$1"
printf '%s\n' "${COMPREPLY[@]}"
)";

/// One line of a help text.
struct Option
{
    QStringList names; ///< with dashes
    QString value;
};

/// The options that a help text lists: lines of two spaces and a dash.
QList<Option> optionsIn(const QString& help)
{
    QList<Option> out;
    const QStringList lines = help.split(QLatin1Char('\n'));
    for (const QString& line : lines) {
        if (!line.startsWith(QLatin1String("  -")))
            continue;
        Option option;
        for (const QString& word : line.trimmed().split(QLatin1Char(' ')))
            if (word.startsWith(QLatin1Char('-')))
                option.names << QString(word).remove(QLatin1Char(','));
            else
                option.value = word;
        out << option;
    }
    return out;
}

} // namespace

/// The manual page and the completion of the shell say what the program says.
class TestRamureCliReference : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QStringList m_commands;

    [[nodiscard]] QStringList completed(const QStringList& words) const
    {
        QProcess bash;
        bash.start(QStringLiteral("bash"), QStringList{"-c", QLatin1String(completionBench), "bash",
                                                       m_folder.filePath("completion")} +
                                               words);
        if (!bash.waitForFinished() || bash.exitCode() != 0)
            qFatal("bash: %s", bash.readAllStandardError().constData());
        return QString::fromUtf8(bash.readAllStandardOutput()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void initTestCase()
    {
        test::write(m_folder.filePath("completion"), runCli({"--completion"}).out.toUtf8());
        const QString help = runCli({"--help"}).out;
        const QString list =
            help.section(QStringLiteral("Commands:\n"), 1).section(QStringLiteral("\n\n"), 0, 0);
        for (const QString& line : list.split(QLatin1Char('\n')))
            m_commands << line.trimmed().section(QLatin1Char(' '), 0, 0);
        QVERIFY(m_commands.contains(QStringLiteral("export")));
    }

    void manualHoldsEveryCommandAndOption()
    {
        const QString manual = runCli({"--manual"}).out;
        QVERIFY(manual.startsWith(QStringLiteral(".TH RAMURE-CLI 1 ")));
        for (const QString& command : m_commands) {
            const QString part = manual.section(QStringLiteral(".SS %1 ").arg(command), 1)
                                     .section(QRegularExpression(QStringLiteral("\\n\\.S[SH] ")), 0, 0);
            const QList<Option> options = optionsIn(runCli({command, "--help"}).out);
            QVERIFY(options.size() > 2);
            for (const Option& option : options) {
                const QString name =
                    QString(option.names.back()).replace(QLatin1String("-"), QLatin1String("\\-"));
                QVERIFY2(part.contains(name), qPrintable(command + QLatin1Char(' ') + option.names.back()));
            }
            QCOMPARE(part.count(QStringLiteral(".TP\n")), options.size());
        }
        for (const QString& line : manual.split(QLatin1Char('\n')))
            QVERIFY2(!line.startsWith(QLatin1Char('\'')), qPrintable(line)); // would be a macro
    }

    void manualOfTheEditorHoldsItsOptions()
    {
        const QString manual = runCli({"--manual-editor"}).out;
        QVERIFY(manual.startsWith(QStringLiteral(".TH RAMURE 1 ")));
        for (const EditorOption& option : editorOptions)
            QVERIFY(manual.contains(QStringLiteral("\\fB\\-\\-%1 ").arg(QLatin1String(option.name))));
    }

    void everyCommandIsCompleted()
    {
        QStringList expected = m_commands;
        for (const Option& option : optionsIn(runCli({"--help"}).out))
            expected << option.names.front();
        QCOMPARE(completed({"ramure-cli", ""}), expected);
        QCOMPARE(completed({"ramure-cli", "val"}), QStringList{"validate"});
    }

    void everyOptionIsCompleted()
    {
        for (const QString& command : m_commands) {
            QStringList expected;
            for (const Option& option : optionsIn(runCli({command, "--help"}).out)) {
                expected << option.names;
                if (option.value.contains(QLatin1String("FILE")))
                    QCOMPARE(completed({"ramure-cli", command, option.names.front(), ""}),
                             QStringList{"FILES"});
                else if (option.value.contains(QLatin1Char('|'))) {
                    QStringList words = option.value.split(QLatin1Char('|'));
                    words.removeAll(QStringLiteral("NUMBER")); // any
                    QCOMPARE(completed({"ramure-cli", command, "x", option.names.front(), ""}), words);
                }
            }
            QCOMPARE(completed({"ramure-cli", command, "-"}), expected);
        }
    }

    void inputsAndKeysAreCompleted()
    {
        QStringList presetsWithS;
        for (const Preset& preset : presets())
            if (*preset.name == 'S')
                presetsWithS << QStringLiteral("preset:") + QLatin1String(preset.name);
        QVERIFY(presetsWithS.size() > 5);
        QCOMPARE(completed({"ramure-cli", "info", "preset:S"}), presetsWithS << QStringLiteral("FILES"));
        QCOMPARE(completed({"ramure-cli", "list", "pa"}), QStringList{"params"});
        QCOMPARE(completed({"ramure-cli", "export", "x", "--set", "grammar.see"}),
                 QStringList{"grammar.seed="});
        QCOMPARE(completed({"ramure-cli", "info", "x", "--set", ""}).size(), qsizetype(allParams().size()));
        QCOMPARE(completed({"ramure-cli", "info", "x", "--time", ""}), QStringList());
    }

    void editorIsCompleted()
    {
        QStringList expected{"--help", "--version"};
        for (const EditorOption& option : editorOptions)
            expected << QStringLiteral("--") + QLatin1String(option.name);
        QCOMPARE(completed({"/usr/bin/ramure", "-"}), expected);
        QCOMPARE(completed({"ramure", "--export", ""}), QStringList{"FILES"});
        QVERIFY(completed({"ramure", ""}).contains(QStringLiteral("demo:Arm")));
    }
};

RAMURE_SUITE(TestRamureCliReference)

} // namespace tst_ramure_cli_reference

#include "tst_ramure_cli_reference.moc"
