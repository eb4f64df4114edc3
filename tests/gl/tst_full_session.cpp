// One session of an artist, from outside: a new tree, another number, a branch chosen by a click, rolled,
// undone, saved, opened again, exported; and the exported file is what the command line makes of the saved
// project.
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_file.h"
#include "tests/gl/desk.h"
#include "tests/support/cannot_run.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/preset_title.h"
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <numbers>

namespace tst_full_session {

using namespace ramure;
using test::Editor;
using test::eventually;

namespace {

const QString mainWindow = QStringLiteral("Ramure$");

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A pixel of bark: the lowest one that is brown on both sides, hence of the trunk.
std::optional<QPoint> trunkIn(const QImage& picture)
{
    const auto isBark = [&picture](int x, int y) {
        const QColor colour = picture.pixelColor(x, y);
        return colour.red() > colour.green() + 4 && colour.green() > colour.blue() + 3 && colour.red() < 190;
    };
    constexpr int half = 4;
    for (int y = picture.height() - 1; y >= 0; --y)
        for (int x = half; x + half < picture.width(); ++x) {
            bool all = true;
            for (int dx = -half; dx <= half; ++dx)
                all = all && isBark(x + dx, y) && isBark(x + dx, std::max(0, y - half));
            if (all)
                return QPoint(x, y - half / 2);
        }
    return std::nullopt;
}

} // namespace

class TestFullSession : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_home;
    QTemporaryDir m_work;
    std::unique_ptr<test::Desk> m_desk;

    QString file(const char* name) { return m_work.filePath(QLatin1String(name)); }
    /// The first node of a project.
    static std::optional<Node> tree(const QString& path)
    {
        auto project = loadProjectFile(path);
        if (!project || project->scene.empty())
            return std::nullopt;
        return project->scene.nodes().front();
    }
    /// The upper left part of the window: in the default layout nothing but the view.
    static QRect viewOf(const QRect& window)
    {
        return window.adjusted(8, 110, -window.width() / 3, -window.height() / 4);
    }
    static QRect panelsOf(const QRect& window)
    {
        return window.adjusted(window.width() * 7 / 10, 60, 0, -45);
    }

    /// By the menus, with the keyboard: species come first, then the other groups, each by the alphabet.
    static bool newFromPreset(Editor& editor, const char* name)
    {
        QStringList species, others, names;
        const auto wanted = std::ranges::find_if(
            presets(), [&](const Preset& preset) { return std::string_view(preset.name) == name; });
        for (const Preset& preset : presets()) {
            QStringList& groups = isSpecies(preset) ? species : others;
            if (const QString group = QString::fromUtf8(preset.group); !groups.contains(group))
                groups += group;
            if (std::string_view(preset.group) == wanted->group)
                names += QString::fromLatin1(preset.name);
        }
        names.sort();
        const auto down = [](qsizetype rows) { return QStringList(rows, QStringLiteral("Down")); };
        const qsizetype before = editor.windowCount();
        const auto menus = [&](int count) {
            return [&, count] { return editor.windowCount() == before + count; };
        };
        if (!Editor::keysUntil({QStringLiteral("alt+f")}, menus(1)))
            return false;
        Editor::keys(down(1)); // below the empty scene
        if (!Editor::keysUntil({QStringLiteral("Right")}, menus(2)))
            return false;
        Editor::keys(down((species + others).indexOf(QString::fromUtf8(wanted->group))));
        if (!Editor::keysUntil({QStringLiteral("Right")}, menus(3)))
            return false;
        Editor::keys(down(names.indexOf(QLatin1String(name))) + QStringList{QStringLiteral("Return")});
        return eventually(menus(0));
    }
    static void setParam(const QString& key, const QString& text)
    {
        Editor::keys({QStringLiteral("ctrl+f")});
        Editor::type(key);
        Editor::keys({QStringLiteral("Return")});
        Editor::type(text);
        Editor::keys({QStringLiteral("Return")});
    }
    /// Calls a file dialog up and answers it, until the window bears the file's name. A dialog that has just
    /// opened loses keys while it reads its folder: then once more, as a person would.
    static bool answerWithPath(Editor& editor, const QString& keys, const QString& dialog,
                               const QString& path)
    {
        constexpr int tries = 4;
        constexpr int aMomentMs = 8000;
        const QString wanted = u'^' + QFileInfo(path).fileName() + u' ';
        const auto isDone = [&] {
            return editor.window(dialog).isEmpty() && !editor.window(wanted).isEmpty();
        };
        for (int i = 0; i < tries && !isDone(); ++i) {
            Editor::keys({keys});
            if (!editor.waitForWindow(dialog))
                return false;
            test::stillPicture(editor.place(dialog));
            Editor::keys({QStringLiteral("ctrl+a")});
            Editor::type(path);
            Editor::keys({QStringLiteral("Return")});
            if (eventually(isDone, aMomentMs))
                break;
            // Away with it and with what it asks or complains about.
            if (!Editor::keysUntil({QStringLiteral("Escape")},
                                   [&] { return editor.window(dialog).isEmpty(); }))
                return false;
        }
        return isDone() && editor.waitForWindow(wanted);
    }

private slots:
    void initTestCase()
    {
        if (const QString missing = test::Desk::missing(); !missing.isEmpty())
            RAMURE_CANNOT_RUN(qPrintable(missing + QStringLiteral(" is not installed")));
        test::prepareHome(m_home);
        m_desk = std::make_unique<test::Desk>();
    }
    void init() { test::failOnAnyWarning(); }
    void cleanupTestCase() { m_desk.reset(); }

    void anArtistsSession()
    {
        const QString project = file("oak.ramure");
        QString branchName;
        {
            Editor editor(m_home.path());
            editor.start();
            QVERIFY(editor.waitForWindow(mainWindow));
            const QRect window = editor.place(mainWindow);
            const QImage small = test::stillView(viewOf(window));
            QVERIFY(newFromPreset(editor, "TinyTree"));
            QVERIFY(eventually([&] { return test::screenPicture(viewOf(window)) != small; }));
            setParam(QStringLiteral("radialDivisions"), QStringLiteral("11"));
            QVERIFY(eventually([&] { return !editor.window(QStringLiteral("\\*")).isEmpty(); })); // unsaved
            setParam(QStringLiteral("lengthDivisions"), QStringLiteral("2+3"));

            // A branch by a click.
            const QRect view = viewOf(window);
            QImage before;
            QVERIFY(eventually([&] { return trunkIn(before = test::stillView(view)).has_value(); }));
            const QImage panels = test::stillPicture(panelsOf(window));
            const auto trunk = trunkIn(before);
            QVERIFY(trunk);
            Editor::click(view.topLeft() + *trunk);
            QVERIFY(eventually([&] { return test::screenPicture(view) != before; }));
            QVERIFY(eventually([&] { return test::screenPicture(panelsOf(window)) != panels; }));
            QGuiApplication::clipboard()->clear();
            Editor::keys({QStringLiteral("ctrl+shift+n")});
            QVERIFY(eventually([&] {
                branchName = QGuiApplication::clipboard()->text();
                return !branchName.isEmpty();
            }));

            // Its frames rolled by hand, then one change too many, which is undone.
            // What lies under the mouse would have another tint, and buttons their tips.
            Editor::moveMouse(view.topLeft() + QPoint(view.width() / 6, view.height() / 10));
            const QImage unrolled = test::stillView(view);
            const QRect otherLimbs(0, 0, view.width() * 2 / 5,
                                   view.height()); // the line around its axis apart
            Editor::keys({QStringLiteral("shift+r")});
            Editor::type(QStringLiteral("30"));
            Editor::keys({QStringLiteral("Return")});
            QVERIFY(eventually(
                [&] { return test::screenPicture(view).copy(otherLimbs) != unrolled.copy(otherLimbs); }));
            Editor::keys(
                {QStringLiteral("ctrl+f")}); // the inspector, and with it the section in the view, leaves
            QVERIFY(eventually([&] { return test::screenPicture(view) != unrolled; }));
            const QImage rolled = test::stillView(view);
            setParam(QStringLiteral("turtle.alpha"), QStringLiteral("45cm"));
            QVERIFY(eventually([&] { return test::screenPicture(view) != rolled; }));
            Editor::keys({QStringLiteral("ctrl+z")});
            QVERIFY(eventually([&] { return test::screenPicture(view) == rolled; }));

            QVERIFY(answerWithPath(editor, QStringLiteral("ctrl+s"), QStringLiteral("^Save as"), project));
            QVERIFY(editor.quit());
        }
        const auto saved = tree(project);
        QVERIFY(saved);
        QCOMPARE(saved->name, std::string("TinyTree"));
        NodeParams expected = *presetParams("TinyTree");
        expected.sections.radialDivisions = 11;
        expected.sections.lengthDivisions = 5;
        expected.edits = saved->params.edits;
        QVERIFY(saved->params == expected);
        QCOMPARE(expected.edits.size(), std::size_t{1});
        QVERIFY(std::abs(expected.edits.front().angleRad - std::numbers::pi / 6.0) < 1e-12);
        // The limb that was clicked is the one whose name the panel gave, and the one that was rolled.
        const auto grown = TreePipeline().evaluate(saved->params);
        QVERIFY(grown);
        const BranchRows rows(*grown);
        const Index rolled = grown->simplified->skeleton.rolls.front().first;
        QCOMPARE(branchName.section(u'\n', -1),
                 BranchNames().axis(rows, rows.axisOf(rolled))); // below its tree's name
    }

    void openedAgainAndExported()
    {
        const QString project = file("oak.ramure");
        const QByteArray before = bytesOf(project);
        QVERIFY(!before.isEmpty());
        Editor editor(m_home.path());
        editor.start();
        QVERIFY(editor.waitForWindow(mainWindow));
        test::stillPicture(editor.place(mainWindow));
        QVERIFY(answerWithPath(editor, QStringLiteral("ctrl+o"), QStringLiteral("^Open$"), project));
        Editor::keys({QStringLiteral("ctrl+e")});
        QVERIFY(editor.waitForWindow(QStringLiteral("^Export$")));
        test::stillPicture(editor.place(QStringLiteral("^Export$")));
        Editor::keys({QStringLiteral("Return")}); // a GLB beside the project
        QVERIFY(editor.waitUntilGone(QStringLiteral("^Export$")));
        QVERIFY(editor.waitForWindow(QStringLiteral("^oak.ramure ")));
        QVERIFY(editor.quit());
        QCOMPARE(bytesOf(project), before);

        QVERIFY(QDir(m_work.path()).mkdir(QStringLiteral("cli")));
        QProcess cli;
        cli.start(QStringLiteral(RAMURE_CLI),
                  {QStringLiteral("export"), project, QStringLiteral("-o"), file("cli/oak.glb")});
        QVERIFY(cli.waitForFinished(test::deskPatienceMs));
        QCOMPARE(cli.exitCode(), 0);
        const QByteArray byHand = bytesOf(file("oak.glb"));
        QVERIFY(byHand.size() > 100);
        QVERIFY(byHand == bytesOf(file("cli/oak.glb")));
        // Nothing else lies about.
        QCOMPARE(
            QDir(m_work.path()).entryList({QStringLiteral("oak*")}, QDir::Files | QDir::Hidden, QDir::Name),
            (QStringList{QStringLiteral("oak.glb"), QStringLiteral("oak.ramure")}));
    }
};

RAMURE_SUITE(TestFullSession)

} // namespace tst_full_session

#include "tst_full_session.moc"
