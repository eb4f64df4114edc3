#include "app/cli/commands/commands.h"
#include "app/cli/commands/reference.h"
#include "core/base/file_writer.h"
#include "core/base/kept_memory.h"
#include <QCoreApplication>
#include <algorithm>
#include <cstdlib>
#include <new>
#include <optional>

using namespace ramure;
using namespace ramure::cli;

namespace {

/// What an option in a command's place prints, or nothing where \p word is none.
std::optional<QString> programText(const QString& word)
{
    if (word == QLatin1String("--help") || word == QLatin1String("-h") || word == QLatin1String("help"))
        return helpText();
    if (word == QLatin1String("--version"))
        return versionText();
    if (word == QLatin1String("--manual"))
        return manualText();
    if (word == QLatin1String("--manual-editor"))
        return editorManualText();
    if (word == QLatin1String("--completion"))
        return completionText();
    return std::nullopt;
}

Expected<int> runCommand(const Command& command, const QStringList& arguments)
{
    CommandLine line(command.text);
    command.addOptions(line);
    const auto done = line.parse(arguments);
    RAMURE_TRY(done);
    return *done ? Expected<int>(**done) : command.run(line);
}

Expected<int> runProgram(int& argc, char** argv)
{
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << pathText(argv[i]);
    const QString first = arguments.isEmpty() ? QString() : arguments.takeFirst();
    if (const auto text = programText(first)) {
        const auto printed = print(*text);
        return printed ? Expected<int>(exitGood) : fail(printed.error());
    }
    const auto* const command = std::find_if(allCommands.begin(), allCommands.end(), [&](const Command* c) {
        return first == QLatin1String(c->text.name);
    });
    if (command == allCommands.end()) {
        QStringList names;
        for (const Command* known : allCommands)
            names << QLatin1String(known->text.name);
        if (first.isEmpty())
            return fail(ErrorCode::Invalid, "missing command: %1 expected", {commaList(names).toStdString()});
        return fail(ErrorCode::Unknown, "unknown command \"%1\": %2 expected",
                    {first.toStdString(), commaList(names).toStdString()});
    }
    if ((*command)->startsApplication)
        return runCommand(**command, arguments);
    const QCoreApplication application(argc, argv);
    return runCommand(**command, arguments);
}

/// Errors are told once, by us: warnings of the libraries are not, but what makes them end the program is.
void dropMessage(QtMsgType type, const QMessageLogContext&, const QString& text)
{
    if (type != QtFatalMsg)
        return;
    printError(text);
    std::_Exit(exitBad);
}

} // namespace

int main(int argc, char** argv)
{
    keepFreedMemory();
    makeFileLimitAnError();
    qInstallMessageHandler(dropMessage);
    try {
        const auto code = runProgram(argc, argv);
        if (code)
            return *code;
        printError(fromText(code.error().message()));
        if (isDiskFull(code.error()))
            return exitDiskFull;
    } catch (const std::bad_alloc&) {
        printError(QStringLiteral("out of memory"));
    }
    return exitBad;
}
