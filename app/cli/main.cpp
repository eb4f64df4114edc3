#include "app/cli/commands.h"
#include "core/base/kept_memory.h"
#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <new>

using namespace ramure;
using namespace ramure::cli;

namespace {

struct Command
{
    const char* name;
    const char* summary;
    Expected<int> (*run)(const QStringList& arguments);
    bool startsApplication; ///< the command does it itself
};
constexpr Command commands[] = {
    {"list", "the trees that ship with the program; every parameter", &runList, false},
    {"info", "counts and measures of a tree or mesh", &runInfo, false},
    {"import", "makes a project of what a script for Blender wrote", &runImport, false},
    {"export", "writes OBJ and PLY", &runExport, false},
    {"validate", "is the mesh closed and manifold?", &runValidate, false},
    {"simulate", "lets a tree move", &runSimulate, false},
    {"ik", "turns the joints of an arm to a target", &runIk, false},
    {"render", "draws a picture", &runRender, true},
};

QString helpText()
{
    QString out =
        QStringLiteral("Usage: ramure-cli COMMAND [ARGUMENTS] [OPTIONS]\n\n"
                       "Grows, checks, moves, exports and draws trees without a window.\n\nCommands:\n");
    for (const Command& command : commands)
        out += QStringLiteral("  %1 %2\n")
                   .arg(QLatin1String(command.name), -10)
                   .arg(QLatin1String(command.summary));
    return out +
           QStringLiteral("\nOptions:\n"
                          "  --help, -h\n      Shows this text; behind a command, that command's.\n"
                          "  --version\n      Shows the version of the program.\n\n"
                          "INPUT of a command is preset:NAME, demo:NAME or a file .ramure, .obj or .ply.\n"
                          "Exit codes: 0 good, 1 the check failed, 2 bad usage or input.\n");
}

Expected<int> runProgram(int& argc, char** argv)
{
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    const QString first = arguments.isEmpty() ? QString() : arguments.takeFirst();
    const bool wantsHelp =
        first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("help");
    if (wantsHelp || first == QLatin1String("--version")) {
        const auto printed = print(wantsHelp ? helpText() : versionText());
        return printed ? Expected<int>(exitGood) : fail(printed.error());
    }
    const auto* const command = std::find_if(std::begin(commands), std::end(commands), [&](const Command& c) {
        return first == QLatin1String(c.name);
    });
    if (command == std::end(commands)) {
        QStringList names;
        for (const Command& known : commands)
            names << QLatin1String(known.name);
        if (first.isEmpty())
            return fail(ErrorCode::Invalid, "missing command: %1 expected", {commaList(names).toStdString()});
        return fail(ErrorCode::Unknown, "unknown command \"%1\": %2 expected",
                    {first.toStdString(), commaList(names).toStdString()});
    }
    if (command->startsApplication)
        return command->run(arguments);
    const QCoreApplication application(argc, argv);
    return command->run(arguments);
}

/// Errors are told once, by us: warnings of the libraries are not.
void dropMessage(QtMsgType, const QMessageLogContext&, const QString&)
{
}

} // namespace

int main(int argc, char** argv)
{
    keepFreedMemory();
    qInstallMessageHandler(dropMessage);
    try {
        const auto code = runProgram(argc, argv);
        if (code)
            return *code;
        printError(fromText(code.error().message()));
    } catch (const std::bad_alloc&) {
        printError(QStringLiteral("out of memory"));
    }
    return exitBad;
}
