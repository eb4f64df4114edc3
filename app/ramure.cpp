// The editor: ramure [FILE|FOLDER|preset:NAME|demo:NAME] [--screenshot FILE.png] [--export FILE]...
#include "app/cli/editor_options.h"
#include "core/base/file_writer.h"
#include "core/base/kept_memory.h"
#include "core/base/utf8.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/qt/session/export/document_source.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/jobs/job.h"
#include "core/qt/session/jobs/recompute.h"
#include "widgets/actions/dialog_chooser.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/base/message_banner.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/dialogs/recovery.h"
#include "widgets/help/tour.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/picture_file.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QFileInfo>
#include <QIcon>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <utility>

using namespace ramure;

namespace {

constexpr int fullResultMs = 120'000;
constexpr int layoutDepth = 10; ///< at most so many layouts in each other
constexpr int paintMs = 20'000;
constexpr const char* measureStartName = "measure-start";

struct Arguments
{
    QString input;
    QString screenshot;
    QStringList exports;
    QSize size;
    bool measureStart = false; ///< for developers

    [[nodiscard]] bool isBatch() const { return !screenshot.isEmpty() || !exports.isEmpty(); }
};

void say(const QString& text)
{
    std::fprintf(stdout, "%s\n", qPrintable(text));
    std::fflush(stdout);
}

void complain(const QString& text)
{
    std::fprintf(stderr, "ramure: %s\n", qPrintable(text));
}

/// Listens while Qt looks for a display. Where it finds none, it warns of the reason, explains at length and
/// aborts: here that is one sentence and an exit code.
void sayWhyNoWindow(QtMsgType type, const QMessageLogContext&, const QString& text)
{
    static QString reason;
    if (type != QtFatalMsg) {
        if (type == QtWarningMsg || type == QtCriticalMsg)
            reason = text.simplified();
        return;
    }
    const bool isPlatformSet = !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
    const char* const variable = isPlatformSet ? "QT_QPA_PLATFORM" : "DISPLAY";
    const QString value = qEnvironmentVariableIsSet(variable)
                              ? QLatin1Char('=') + qEnvironmentVariable(variable)
                              : QStringLiteral(" is not set");
    complain(QStringLiteral("no window can be opened: %1 (%2%3); ramure-cli needs no display")
                 .arg(reason.isEmpty() ? text.section(QLatin1Char('\n'), 0, 0) : reason,
                      QLatin1String(variable), value));
    std::_Exit(2);
}

/// The names of files reach a window as texts, and not every name is one.
void checkNames(int argc, char** argv)
{
    for (int i = 1; i < argc; ++i)
        if (!isUtf8(argv[i])) {
            complain(
                QStringLiteral("\"%1\": the name is no UTF-8; rename it, or use ramure-cli, which takes it")
                    .arg(QString::fromUtf8(argv[i])));
            std::exit(2);
        }
}

/// Those of the whole program: they are asked for where there is no screen as well.
void tellAndLeave(QCommandLineParser& parser, int argc, char** argv)
{
    for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i)
        if (const std::string_view option = argv[i]; option == "--help" || option == "-h" ||
                                                     option == "--help-all" || option == "--version" ||
                                                     option == "-v") {
            const QCoreApplication plain(argc, argv);
            parser.process(plain);
        }
}

void describe(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QLatin1String(editorSummary));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("input"),
        QString::fromLatin1(editorInputText).arg(QString::fromStdString(endingList(FormatUse::Import))),
        QLatin1String(editorInput));
    for (const EditorOption& option : editorOptions)
        parser.addOption(
            {QLatin1String(option.name), QLatin1String(option.description), QLatin1String(option.value)});
    QCommandLineOption measureStart{QLatin1String(measureStartName)}; // see tests/bench/interaction
    measureStart.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(measureStart);
}

Arguments readArguments(QCommandLineParser& parser, const QApplication& application)
{
    parser.process(application);
    Arguments arguments;
    if (parser.positionalArguments().size() > 1) {
        complain(QStringLiteral("one file at a time, please"));
        std::exit(2);
    }
    if (!parser.positionalArguments().isEmpty())
        arguments.input = parser.positionalArguments().constFirst();
    arguments.screenshot = parser.value(QLatin1String(screenshotOption.name));
    arguments.exports = parser.values(QLatin1String(exportOption.name));
    arguments.measureStart = parser.isSet(QLatin1String(measureStartName));
    const QStringList sides = parser.value(QLatin1String(sizeOption.name)).split(u'x');
    if (sides.size() == 2)
        arguments.size = {sides[0].toInt(), sides[1].toInt()};
    return arguments;
}

bool openInput(FileActions& files, const QString& input)
{
    const QString prefix = QStringLiteral("preset:"), demoPrefix = QStringLiteral("demo:");
    if (input.startsWith(demoPrefix))
        return files.newFromDemo(input.mid(demoPrefix.size()));
    if (input.isEmpty())
        return files.newFromPreset(QStringLiteral("SmallTree"));
    if (input.startsWith(prefix))
        return files.newFromPreset(input.mid(prefix.size()));
    // Objects are read on another thread.
    bool opened = false;
    QEventLoop loop;
    QObject::connect(&files, &FileActions::openEnded, &loop, [&](bool done) {
        opened = done;
        loop.quit();
    });
    files.openFile(input);
    if (files.isOpening())
        loop.exec();
    return opened;
}

/// Lets the window show what is there: until the view has drawn once more, or at most a while.
void waitForPicture(const MainWindow& window)
{
    QEventLoop loop;
    QTimer::singleShot(paintMs, &loop, &QEventLoop::quit);
    if (Viewport* view = window.viewportHost()->viewport()) {
        QObject::connect(view, &Viewport::frameDrawn, &loop, [&loop, view] {
            if (!view->work().picture)
                QTimer::singleShot(200, &loop, &QEventLoop::quit);
        });
        view->update();
    } else {
        QTimer::singleShot(200, &loop, &QEventLoop::quit);
    }
    loop.exec();
}

bool exportTo(const QString& path, const Document& document)
{
    ExportOptions options;
    options.texture = true;
    if (const auto format = findFormat(path.toStdString(), FormatUse::Write))
        options.parts = usualParts(**format);
    const auto done =
        exportScene(Evaluator(documentSource(document)).at(document.scene()), options, path.toStdString());
    if (!done) {
        complain(QString::fromStdString(done.error().message()));
        return false;
    }
    say(QStringLiteral("Exported %1").arg(QFileInfo(path).absoluteFilePath()));
    return true;
}

/// Writes what the command line asks for. Returns the exit code.
int runBatch(const Arguments& arguments, MainWindow& window, const Document& document, Recompute& recompute)
{
    if (!recompute.waitForFull(fullResultMs)) {
        complain(QStringLiteral("the tree was not computed in time"));
        return 1;
    }
    bool good = true;
    for (const QString& path : arguments.exports)
        good = exportTo(path, document) && good;
    if (!arguments.screenshot.isEmpty()) {
        waitForPicture(window);
        // Texts of the last moment have room: each layout asks the one around it, which a pass does not see.
        for (int depth = 0; depth < layoutDepth; ++depth)
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const auto saved =
            savePicture(window.grab().toImage(), QFile::encodeName(arguments.screenshot).toStdString());
        if (saved)
            say(QStringLiteral("Screenshot %1").arg(QFileInfo(arguments.screenshot).absoluteFilePath()));
        else
            complain(QString::fromStdString(saved.error().message()));
        good = good && saved.has_value();
    }
    return good ? 0 : 1;
}

/// Says how much time of the processor it took until a tree, and until the full one, was on the screen, and
/// quits.
void measureStart(const MainWindow& window, const Document& document)
{
    Viewport* view = window.viewportHost()->viewport();
    if (!view)
        return QCoreApplication::exit(1);
    const auto tell = [view, &document, drawn = false]() mutable {
        if (document.scene().nodes().empty() || view->frameTimes().revision > document.revision())
            return; // nothing in the picture yet
        const double ms = 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
        if (!std::exchange(drawn, true))
            say(QStringLiteral("first %1").arg(ms));
        if (!document.isCurrent(document.scene().nodes().front().id) || view->work().picture)
            return;
        say(QStringLiteral("full %1").arg(ms));
        QCoreApplication::exit(0);
    };
    QObject::connect(view, &QOpenGLWidget::frameSwapped, view, tell);
}

/// The start of a session at the desk: what a crash left, else the tour the first time, and the welcome page.
void greet(MainWindow& window, Recovery& recovery, const Preferences& preferences, const Arguments& arguments)
{
    if (recovery.offer())
        return;
    const auto welcome = [&window, wanted = arguments.input.isEmpty() && preferences.welcomeAtStart()] {
        if (wanted)
            window.showWelcome();
    };
    if (window.help()->startTourOnce()) // one thing at a time
        QObject::connect(window.help()->tour(), &Tour::finished, &window, welcome, Qt::SingleShotConnection);
    else
        welcome();
}

/// From the first window to the last.
int edit(QApplication& application, const Arguments& arguments)
{
    Preferences preferences;
    const Language language(preferences);
    new Theme(&application, &preferences);
    QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/theme/org.ramure.Ramure.svg")));
    Document document;
    Recompute recompute(&document);
    DialogChooser chooser;
    MainWindow window(&document, &recompute, &preferences, &chooser);
    chooser.setWindow(&window, window.banner());
    if (!arguments.size.isEmpty())
        window.resize(arguments.size);
    window.show();
    if (!openInput(*window.files(), arguments.input)) {
        if (arguments.isBatch()) {
            complain(window.banner()->text());
            return 2;
        }
        window.files()->newFromPreset(QStringLiteral("SmallTree"));
    }
    if (!window.isVisible()) // closed while the file was read
        return 0;
    if (arguments.measureStart) {
        measureStart(window, document);
        return QApplication::exec();
    }
    if (!arguments.isBatch()) {
        Recovery recovery(&document, &preferences, &chooser);
        QTimer::singleShot(0, &window, [&] { greet(window, recovery, preferences, arguments); });
        return QApplication::exec();
    }
    int code = 0;
    QTimer::singleShot(0, &window, [&] {
        code = runBatch(arguments, window, document, recompute);
        QCoreApplication::exit(code);
    });
    QApplication::exec();
    return code;
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("ramure"));
    QCoreApplication::setOrganizationName(QStringLiteral("Ramure"));
    QCoreApplication::setApplicationVersion(QStringLiteral(RAMURE_VERSION));
    QCommandLineParser parser;
    describe(parser);
    tellAndLeave(parser, argc, argv);
    keepFreedMemory();
    makeFileLimitAnError();
    prepareOpenGl();
    checkNames(argc, argv);
    qInstallMessageHandler(&sayWhyNoWindow);
    QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    QGuiApplication::setApplicationDisplayName(QString());
    QGuiApplication::setDesktopFileName(QStringLiteral("org.ramure.Ramure"));
    // What runs in the background ends all at once when the last window is closed, not one after the other.
    QObject::connect(&application, &QCoreApplication::aboutToQuit, &Job::stopAll);
    const Arguments arguments = readArguments(parser, application);
    const int code = edit(application, arguments);
    if (Job::abandonedCount() > 0) { // it uses what the end of the program takes apart
        std::fflush(nullptr);
        std::_Exit(code);
    }
    return code;
}
