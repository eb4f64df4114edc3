#include "app/cli/commands/reference.h"
#include "app/cli/commands/commands.h"
#include "app/cli/editor_options.h"
#include "core/base/version.h"
#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/scene/demo_scenes.h"
#include <QRegularExpression>

namespace ramure::cli {

namespace {

constexpr const char* summary = "Grows, checks, moves, exports and draws trees without a window.";
constexpr const char* inputForms = "INPUT of a command is preset:NAME, demo:NAME or a file .ramure, {read}.";
constexpr const char* exits =
    "Exit codes: 0 good, 1 the check failed, 2 bad usage or input, 5 the disk is full; of batch also 3 some "
    "rows failed, 4 out of memory, 130 and 143 stopped.";

/// Text as man(7) reads it: nothing in it is a macro, what stands between ` and ` is bold.
QString roff(QString text)
{
    text.replace(QLatin1Char('\\'), QStringLiteral("\\e")).replace(QLatin1Char('-'), QStringLiteral("\\-"));
    static const QRegularExpression quoted(QStringLiteral("`([^`]*)`"));
    text.replace(quoted, QStringLiteral("\\fB\\1\\fR"));
    static const QRegularExpression control(QStringLiteral("^(?=[.'])"), QRegularExpression::MultilineOption);
    return text.replace(control, QStringLiteral("\\&"));
}

QString roffOption(const QString& head, const QString& description)
{
    return QStringLiteral(".TP\n\\fB%1\\fR\n%2\n").arg(roff(head), roff(description));
}

QString roffHead(const QString& program, const QString& brief)
{
    return QStringLiteral(".TH %1 1 \"\" \"Ramure %2\" \"User Commands\"\n.SH NAME\n%3 \\- %4\n")
        .arg(program.toUpper(), QLatin1String(RAMURE_VERSION), roff(program),
             roff(brief.section(QLatin1Char('.'), 0, 0)));
}

QString roffCommand(const Command& command)
{
    CommandLine line(command.text);
    command.addOptions(line);
    QString out =
        QStringLiteral(".SS %1 %2 [OPTIONS]\n%3\n")
            .arg(roff(QLatin1String(command.text.name)), roff(QLatin1String(command.text.arguments)),
                 roff(QString::fromUtf8(command.text.summary)));
    for (const QString& paragraph :
         withFormats(command.text.details).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        out += QStringLiteral(".PP\n%1\n").arg(roff(paragraph.trimmed()));
    for (const QCommandLineOption& option : line.options())
        out += roffOption(optionHead(option), option.description());
    return out;
}

/// Words to choose from, where a value's name lists them; what is in capitals stands for something to type.
QStringList choicesOf(const QString& valueName)
{
    QStringList out = valueName.split(QLatin1Char('|'));
    out.removeIf([](const QString& word) { return word.isEmpty() || word != word.toLower(); });
    return out;
}

QStringList setWords()
{
    QStringList out;
    for (const ParamDef& def : allParams())
        out << QLatin1String(def.key) + QLatin1Char('=');
    return out;
}

QStringList treeWords()
{
    QStringList out;
    for (const Preset& preset : presets())
        out << QStringLiteral("preset:") + QLatin1String(preset.name);
    for (const DemoScene& scene : demoScenes())
        out << QStringLiteral("demo:") + QLatin1String(scene.name);
    return out;
}

/// A branch of the script's case: what is offered where the pattern fits.
QString offer(const QStringList& patterns, const QStringList& words, bool files)
{
    return QStringLiteral("    %1) choices='%2' files=%3 ;;\n")
        .arg(patterns.join(QLatin1Char('|')), words.join(QLatin1Char(' ')), QLatin1String(files ? "1" : ""));
}

/// The branches of one command: values of its options, its options, its argument.
QString offersOf(const QString& command, const QList<QCommandLineOption>& options, const QString& arguments)
{
    QString values;
    QStringList names;
    for (const QCommandLineOption& option : options) {
        QStringList patterns;
        for (const QString& name : option.names()) {
            names << (name.size() == 1 ? QLatin1String("-") : QLatin1String("--")) + name;
            patterns << QStringLiteral("%1,%2,*").arg(command, names.back());
        }
        const QString value = option.valueName();
        if (!value.isEmpty())
            values += offer(patterns, value == QLatin1String("KEY=VALUE") ? setWords() : choicesOf(value),
                            value.contains(QLatin1String("FILE")));
    }
    const QStringList choices = choicesOf(arguments);
    return values + offer({command + QLatin1String(",*,-*")}, names, false) +
           offer({command + QLatin1String(",*")}, choices.isEmpty() ? treeWords() : choices,
                 choices.isEmpty());
}

QList<QCommandLineOption> optionsOfEditor()
{
    QList<QCommandLineOption> out{{QStringLiteral("help"), QStringLiteral("Shows the options.")},
                                  {QStringLiteral("version"), QStringLiteral("Shows the version.")}};
    for (const EditorOption& option : editorOptions)
        out << QCommandLineOption(QLatin1String(option.name), QLatin1String(option.description),
                                  QLatin1String(option.value));
    return out;
}

} // namespace

QString helpText()
{
    QString out = QStringLiteral("Usage: ramure-cli COMMAND [ARGUMENTS] [OPTIONS]\n\n%1\n\nCommands:\n")
                      .arg(QLatin1String(summary));
    for (const Command* command : allCommands)
        out += QStringLiteral("  %1 %2\n")
                   .arg(QLatin1String(command->text.name), -10)
                   .arg(QLatin1String(command->text.brief));
    out += QStringLiteral("\nOptions:\n");
    for (const ProgramOption& option : programOptions)
        out += QStringLiteral("  %1\n%2")
                   .arg(QLatin1String(option.name), wrapped(QLatin1String(option.description), 6));
    return out + QStringLiteral("\n%1\n%2\n").arg(withFormats(inputForms), QLatin1String(exits));
}

QString manualText()
{
    QString out = roffHead(QStringLiteral("ramure-cli"), QLatin1String(summary)) +
                  QStringLiteral(".SH SYNOPSIS\n\\fBramure\\-cli\\fR COMMAND [ARGUMENTS] [OPTIONS]\n"
                                 ".SH DESCRIPTION\n%1\n.SH OPTIONS\n")
                      .arg(roff(withFormats(inputForms)));
    for (const ProgramOption& option : programOptions)
        out += roffOption(QLatin1String(option.name), QLatin1String(option.description));
    out += QStringLiteral(".SH COMMANDS\n");
    for (const Command* command : allCommands)
        out += roffCommand(*command);
    return out + QStringLiteral(".SH EXIT STATUS\n%1\n.SH SEE ALSO\n\\fBramure\\fR(1)\n")
                     .arg(roff(QLatin1String(exits)));
}

QString editorManualText()
{
    QString out =
        roffHead(QStringLiteral("ramure"), QLatin1String(editorSummary)) +
        QStringLiteral(".SH SYNOPSIS\n\\fBramure\\fR [OPTIONS] %1\n.SH DESCRIPTION\n%2\n.SH OPTIONS\n")
            .arg(roff(QLatin1String(editorInput)), roff(QLatin1String(editorSummary)));
    for (const QCommandLineOption& option : optionsOfEditor())
        out += roffOption(optionHead(option), option.description());
    return out + QStringLiteral(".SH SEE ALSO\n\\fBramure\\-cli\\fR(1)\n");
}

QString completionText()
{
    QStringList first;
    QString offers;
    for (const Command* command : allCommands) {
        CommandLine line(command->text);
        command->addOptions(line);
        first << QLatin1String(command->text.name);
        offers += offersOf(first.back(), line.options(), QLatin1String(command->text.arguments));
    }
    for (const ProgramOption& option : programOptions)
        first << QLatin1String(option.name);
    offers += offersOf(QStringLiteral("ramure"), optionsOfEditor(), QLatin1String(editorInput)) +
              offer({QStringLiteral("ramure-cli,*")}, first, false);
    return QStringLiteral("# Made by `ramure-cli --completion`.\n"
                          "_ramure()\n{\n"
                          "    local cur prev words cword choices= files= command=${1##*/}\n"
                          "    _init_completion -n := || return\n"
                          "    [[ $command != ramure-cli || $cword -eq 1 ]] || command=${words[1]}\n"
                          "    case $command,$prev,$cur in\n%1    esac\n"
                          "    COMPREPLY=($(compgen -W \"$choices\" -- \"$cur\"))\n"
                          "    [ -z \"$files\" ] || _filedir\n"
                          "    [[ ${COMPREPLY-} != *= ]] || compopt -o nospace\n"
                          "    __ltrim_colon_completions \"$cur\"\n"
                          "} &&\n    complete -F _ramure ramure-cli ramure\n")
        .arg(offers);
}

} // namespace ramure::cli
