#include "tests/support/house_sources.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace tst_layers {

using namespace ramure::test;

/// The fence between the layers, and the few rules of the house that a machine can see. Reads the sources.
class TestLayers : public QObject
{
    Q_OBJECT
private slots:
    void init() { ramure::test::failOnAnyWarning(); }
    void initTestCase();
    void stripsCommentsAndTexts();
    void everyFolderHasItsFloor();
    void arrowsPointDown();
    void arrowsUpwardsAreSeen();
    void includesKeepTheFence_data();
    void includesKeepTheFence();
    void theFenceWouldHold_data();
    void theFenceWouldHold();
    void codeKeepsTheRules_data();
    void codeKeepsTheRules();
    void sinesAreSeen();
    void filesAreOfReadableLength();
    void foldersCanBeOverlooked();
    void functionsFitOnAScreen();
    void headersBeginWithWhatTheyPromise();
};

namespace {

/// Where \p files matches the path (and \p exceptFiles does not), no include may match \p include.
struct Fence
{
    const char* name;
    const char* files;
    const char* exceptFiles;
    const char* include;
};

constexpr const char* widgetClasses =
    R"(<(QtWidgets/.*|QtWidgets|QApplication|Q\w*Widget|QMainWindow|QDialog|QLabel|QMenu\w*|QToolB\w*|QDock\w*|)"
    R"(Q\w*Layout|Q\w*SpinBox|Q\w*Slider|QComboBox|QLineEdit|QMessageBox|QFileDialog|QScroll\w*|QOpenGLWidget|QStyle\w*)>)";

constexpr Fence fences[] = {
    {"the core knows no Qt", "core/.*", "core/qt/.*", R"(<Q\w*(/.*)?>)"},
    {"OpenMesh only in the proof and where prints are thinned out", "(core|widgets|app)/.*",
     R"(core/(surface/proof/validate\w*|print/thinned_mesh)\.cpp)", "<OpenMesh/.*>"},
    {"OpenVDB only behind one header", ".*", R"(core/print/united_surface\.cpp)", "<openvdb/.*>"},
    {"libzip only behind one header", ".*", R"(core/io/zip_file\.cpp)", "<zip\\.h>"},
    {"Nettle only behind one header", ".*", R"(app/cli/batch/file_hash\.cpp)", "<nettle/.*>"},
    {"SLEEF only behind one header", ".*", R"(core/math/reproducible\.cpp)", "<sleef.*>"},
    {"CGAL only behind one header of the tests", ".*", R"(tests/support/self_intersections\.cpp)",
     "<CGAL/.*>"},
    {"the core uses nothing above it", "core/.*", "", R"("(widgets|app|tests)/.*")"},
    {"the document has no widgets", "core/qt/.*", "", widgetClasses},
    {"the renderer has no document", "widgets/view/render/.*", "", R"("core/qt/(document|session)/.*")"},
    {"the renderer uses no widget class", "widgets/view/render/.*", "", widgetClasses},
    {"widgets do not use the programs", "widgets/.*", "", R"("(app|tests)/.*")"},
    {"the Python module needs no display", "app/python/.*", "",
     R"("(widgets|app/cli/(commands|batch|painter))[/.].*")"},
    {"the interpreter only in its module", ".*", R"(app/python/.*)", R"(<(pybind11/.*|Python\.h)>)"},
    {"the command line opens no window", "app/(cli/.*|ramure_cli\\.cpp)", "",
     R"("widgets/(?!view/render/).*")"},
    {"programs do not use the tests", "app/.*", "", R"("tests/.*")"},
    {"no header takes in a whole Qt module", R"(.*\.h)", "",
     R"(<Qt(Core|Gui|Widgets|OpenGL|OpenGLWidgets|Svg|Test)>)"},
    {"tests of the core know no widgets", "tests/core/.*", "", R"("(widgets|app)/.*")"},
};

/// The rooms from the ground up: a folder uses those that stand before it, and itself.
constexpr const char* floors[] = {
    "core/base",
    "core/math",
    "core/params",
    "core/presets",
    "core/skeleton",
    "core/surface/mesh",
    "core/surface/proof",
    "core/surface/mesher",
    "core/surface/texture",
    "core/surface/foliage",
    "core/surface/season",
    "core/surface/bark",
    "core/surface/primitives",
    "core/surface/check",
    "core/generators/grammar",
    "core/generators/parametric",
    "core/generators/colonisation",
    "core/generators/weber_penn",
    "core/generators/growth",
    "core/generators",
    "core/recipe",
    "core/pipeline",
    "core/signs",
    "core/print",
    "core/rig/pose",
    "core/rig/tracks",
    "core/rig/physics",
    "core/rig/arm",
    "core/lod",
    "core/game_wind",
    "core/scene/kinds",
    "core/scene",
    "core/evaluate",
    "core/io",
    "core/scatter",
    "core/io/formats",
    "core/io/formats/text",
    "core/io/formats/print",
    "core/io/formats/glb",
    "core/io/formats/usd",
    "core/qt/base",
    "core/qt/document/project",
    "core/qt/document",
    "core/qt/session/jobs",
    "core/qt/session/export",
    "core/qt/session/motion",
    "core/qt/session/arm",
    "widgets/view/render/light",
    "widgets/view/render/crowd",
    "widgets/view/render",
    "widgets/view/render/stream",
    "widgets/view/render/passes",
    "widgets/view/render/pick",
    "widgets/base/texts",
    "widgets/base/theme",
    "widgets/base",
    "widgets/base/fields",
    "widgets/view/tools",
    "widgets/view/tools/gizmo",
    "widgets/view/tools/hand",
    "widgets/view/tools/arm",
    "widgets/view",
    "widgets/panels/", // all of them: no panel knows another
    "widgets/help",
    "widgets/dialogs",
    "widgets/dialogs/export",
    "widgets/dialogs/palette",
    "widgets/dialogs/variations",
    "widgets/actions",
    "widgets/window",
    "app/cli",
    "app/cli/batch",
    "app/cli/commands",
    "app/python",
    "app",
};

/// The number of the floor that a path stands on, or -1.
int floorOf(const std::string& path)
{
    const std::string folder = path.substr(0, path.rfind('/') + 1);
    for (int i = 0; i < static_cast<int>(std::size(floors)); ++i) {
        const std::string floor = floors[i];
        if (floor.back() == '/' ? folder.starts_with(floor) : folder == floor + "/")
            return i;
    }
    return -1;
}

/// widgets/panels/scene/x.h -> scene; empty elsewhere.
std::string panelOf(const std::string& path)
{
    static const std::string panels = "widgets/panels/";
    return path.starts_with(panels)
               ? path.substr(panels.size(), path.find('/', panels.size()) - panels.size())
               : std::string();
}

/// \param include with its quotes or brackets
bool pointsUp(const std::string& path, const std::string& include)
{
    if (include.front() != '"' || include.starts_with("\"moc_"))
        return false;
    const std::string used = include.substr(1, include.size() - 2);
    const int from = floorOf(path), to = floorOf(used);
    return from >= 0 &&
           (to < 0 || to > from || panelOf(path) != (to == from ? panelOf(used) : panelOf(path)));
}

bool breaks(const Fence& fence, const std::string& path, const std::string& include)
{
    return std::regex_match(path, std::regex(fence.files)) &&
           !std::regex_match(path, std::regex(fence.exceptFiles)) &&
           std::regex_match(include, std::regex(fence.include));
}

/// Where \p files matches the path, the code (comments and texts aside) may not contain \p pattern.
struct Rule
{
    const char* name;
    const char* files;
    const char* pattern;
};

/// Those of the C library, of GLM on top of them, and any that are found without saying whose they are.
constexpr const char* sines =
    R"(((std|glm)::|(^|[^\w:.>]))(a?(sin|cos|tan)h?|sincos|atan2|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|)"
    R"(erfc?|[lt]gamma)f?\s*\(|glm::(angle|angleAxis|rotate|rotation|slerp|eulerAngles|pitch|yaw|roll)\s*\(|)"
    R"(\bstd::(polar|arg|complex)\b)";

constexpr Rule rules[] = {
    {"no singletons", "(core|widgets|app)/.*", R"((^|[^:\w])instance\s*\()"},
    {"no nested event loops by hand", "(core|widgets|app)/.*", R"(\bprocessEvents\b)"},
    {"no libc function with a hidden state", "(core|widgets|app)/.*", R"(\b(strtok|setlocale|s?rand)\s*\()"},
    {"no random generator but our own", "core/.*", R"(std::(mt19937|random_device|\w+_distribution)\b)"},
    {"the same bytes on every processor: sines are of core/math/reproducible.h",
     R"(core/(?!math/reproducible\.).*)", sines},
    {"what a scene looks like at a time is asked of core/evaluate",
     R"((core/(?!(scene|rig|evaluate)/)|widgets/|app/).*)",
     R"(\b(paramsAt|worldTransforms?At|objectSolid)\s*\()"},
    // Memory that runs out is the one thing the language itself throws for.
    {"no exceptions across modules", "core/.*", R"(\bthrow\b(?!\s+std::bad_alloc))"},
    {"work on another thread is a Job's",
     R"((core/(?!qt/session/jobs/job\.|base/parallel)|widgets/|app/(?!cli/work\.)).*)",
     R"(std::(jthread|async|thread(?!::))\b)"},
    {"only the history of the document makes, undoes and redoes steps",
     R"((core/(?!qt/document/undo_history\.)|widgets/|app/).*)",
     R"(\bQUndo(View|Group)\b|\bnew (QUndo\w+|UndoStep)\b|\b(begin|end)Macro\b|)"
     R"([uU]ndo[sS]tack(\(\))?\s*(\.|->)\s*(push|undo|redo|setIndex)\b|QUndoStack::(push|undo|redo|setIndex)\b)"},
    {"tests wait for what is to happen, not for a time", R"(tests/(?!support/waits\.h).*)",
     R"((qWait|[sS]leep(_for|_until)?)\()"},
    // Clang 14, which builds what the sanitizers watch, stops at the views of libstdc++ 12.
    {"no views of the standard library", "(core|widgets|app|tests)/.*",
     R"(\bviews::|\branges::(unique|remove(_if)?|rotate|partition|stable_partition|search|equal_range|subrange)\b)"},
    {"suites skip through RAMURE_CANNOT_RUN", R"(tests/(?!support/cannot_run\.h).*)", R"(\bQSKIP\b)"},
};

std::vector<Source> sources;

} // namespace

void TestLayers::initTestCase()
{
    sources = readSources();
    QVERIFY(sources.size() > 20);
}

void TestLayers::stripsCommentsAndTexts()
{
    QCOMPARE(stripped("a; // throw\nb;"), std::string("a;         \nb;"));
    QVERIFY(stripped("/* rand() */ x").find("rand") == std::string::npos);
    QVERIFY(stripped("f(\"rand( \\\" rand\"); g();").find("rand") == std::string::npos);
    QVERIFY(stripped("f(\"a\"); g();").find("g()") != std::string::npos);
    QVERIFY(stripped("R\"x(rand \" )\" )x\"; g();").find("rand") == std::string::npos);
    QVERIFY(stripped("R\"x(rand \" )\" )x\"; g();").find("g()") != std::string::npos);
    QVERIFY(stripped("n = 64'000'000; rand();").find("rand()") != std::string::npos);
    QVERIFY(stripped("c = '\"'; rand();").find("rand()") != std::string::npos);
}

void TestLayers::everyFolderHasItsFloor()
{
    std::string without;
    for (const Source& source : sources)
        if (!source.path.starts_with("tests/") && floorOf(source.path) < 0)
            without += "\n  " + source.path;
    QVERIFY2(without.empty(), without.c_str());
}

void TestLayers::arrowsPointDown()
{
    std::string broken;
    for (const Source& source : sources)
        for (const std::string& include : source.includes)
            if (pointsUp(source.path, include))
                broken += "\n  " + source.path + " includes " + include;
    QVERIFY2(broken.empty(), broken.c_str());
}

void TestLayers::arrowsUpwardsAreSeen()
{
    QVERIFY(pointsUp("core/skeleton/bend.h", "\"core/surface/foliage/foliage.h\""));
    QVERIFY(pointsUp("core/qt/document/commands.cpp", "\"core/qt/session/motion/player.h\""));
    QVERIFY(pointsUp("widgets/view/render/passes/renderer.h", "\"widgets/view/viewport.h\""));
    QVERIFY(pointsUp("widgets/view/tools/gizmo/gizmo_drag.h", "\"widgets/view/viewport.h\""));
    QVERIFY(pointsUp("widgets/panels/scene/scene_panel.h", "\"widgets/panels/timeline/play_actions.h\""));
    QVERIFY(pointsUp("widgets/panels/scene/scene_panel.h", "\"widgets/window/main_window.h\""));
    QVERIFY(pointsUp("core/base/error.h", "\"nowhere/error.h\""));
    QVERIFY(!pointsUp("core/base/error.h", "<vector>"));
    QVERIFY(!pointsUp("widgets/panels/scene/scene_panel.h", "\"widgets/panels/scene/isolation.h\""));
    QVERIFY(!pointsUp("widgets/panels/scene/scene_panel.h", "\"widgets/base/action_set.h\""));
    QVERIFY(!pointsUp("core/surface/mesher/branch_mesh.h", "\"core/surface/proof/validate.h\""));
}

void TestLayers::includesKeepTheFence_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(std::size(fences)); ++i)
        QTest::newRow(fences[i].name) << i;
}

void TestLayers::includesKeepTheFence()
{
    QFETCH(int, number);
    std::string broken;
    for (const Source& source : sources)
        for (const std::string& include : source.includes)
            if (breaks(fences[number], source.path, include))
                broken += "\n  " + source.path + " includes " + include;
    QVERIFY2(broken.empty(), broken.c_str());
}

void TestLayers::theFenceWouldHold_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("include");
    QTest::addColumn<bool>("allowed");
    const auto row = [](const char* path, const char* include, bool allowed) {
        QTest::addRow("%s %s", path, include) << path << include << allowed;
    };
    row("core/surface/mesh/normals.cpp", "<QString>", false);
    row("core/surface/mesh/normals.cpp", "<QtCore/QString>", false);
    row("core/surface/mesh/normals.cpp", "<vector>", true);
    row("core/surface/mesh/normals.cpp", "<OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>", false);
    row("core/surface/proof/validate.cpp", "<OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>", true);
    row("core/surface/proof/validate.h", "<OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>", false);
    row("core/qt/document/document.h", "<QObject>", true);
    row("core/qt/document/document.h", "<QUndoStack>", true);
    row("core/qt/document/document.h", "<QWidget>", false);
    row("core/qt/document/document.h", "\"widgets/viewport.h\"", false);
    row("core/base/error.h", "\"app/main_window.h\"", false);
    row("widgets/viewport.h", "<QtWidgets>", false);
    row("widgets/viewport.cpp", "<QtWidgets>", true);
    row("widgets/viewport.h", "<QOpenGLWidget>", true);
    row("widgets/viewport.cpp", "\"app/main_window.h\"", false);
    row("widgets/view/render/passes/renderer.h", "\"core/qt/session/motion/player.h\"", false);
    row("widgets/view/render/passes/renderer.h", "<QOpenGLWidget>", false);
    row("widgets/view/render/passes/renderer.h", "<QOpenGLFunctions_3_3_Core>", true);
    row("app/ramure_cli.cpp", "\"widgets/view/render/passes/renderer.h\"", true);
    row("app/ramure_cli.cpp", "\"widgets/viewport.h\"", false);
    row("tests/core/surface/tst_x.cpp", "<CGAL/Epick.h>", false);
    row("app/cli/input.cpp", "<pybind11/pybind11.h>", false);
    row("app/python/work.h", "\"widgets/view/render/surface_images.h\"", false);
    row("app/python/work.h", "\"app/cli/painter.h\"", false);
    row("app/python/work.h", "\"app/cli/input.h\"", true);
}

void TestLayers::theFenceWouldHold()
{
    QFETCH(QString, path);
    QFETCH(QString, include);
    QFETCH(bool, allowed);
    const bool broken = std::any_of(std::begin(fences), std::end(fences), [&](const Fence& fence) {
        return breaks(fence, path.toStdString(), include.toStdString());
    });
    QCOMPARE(!broken, allowed);
}

void TestLayers::codeKeepsTheRules_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(std::size(rules)); ++i)
        QTest::newRow(rules[i].name) << i;
}

void TestLayers::codeKeepsTheRules()
{
    QFETCH(int, number);
    const std::regex files(rules[number].files), pattern(rules[number].pattern);
    std::string broken;
    for (const Source& source : sources) {
        if (!std::regex_match(source.path, files))
            continue;
        std::istringstream lines(source.code);
        std::string line;
        for (int at = 1; std::getline(lines, line); ++at)
            if (std::regex_search(line, pattern))
                broken += "\n  " + source.path + ":" + std::to_string(at) + ": " + line;
    }
    QVERIFY2(broken.empty(), broken.c_str());
}

void TestLayers::sinesAreSeen()
{
    const std::regex pattern(sines);
    for (const char* line : {"x = std::sin(a);", "return cos(a);", "-atan2f (y, x)", "glm::slerp(a, b, t)",
                             "std::exp2(3)", "acosh(1)", "glm::pow(a, b)", "std::complex<double> z;"})
        QVERIFY2(std::regex_search(line, pattern), line);
    for (const char* line : {"maths::sin(a)", "m_chain.exp(a)", "cosine(a)", "std::expected(1)",
                             "std::sqrt(2.0)", "std::remainder(a, b)", "using(a)", "m_log(a)"})
        QVERIFY2(!std::regex_search(line, pattern), line);
}

void TestLayers::filesAreOfReadableLength()
{
    std::string broken;
    for (const Source& source : sources) {
        const auto lines = std::count(source.text.begin(), source.text.end(), '\n');
        if (lines > 600)
            broken += "\n  " + source.path + ": " + std::to_string(lines) + " lines";
    }
    QVERIFY2(broken.empty(), broken.c_str());
}

void TestLayers::foldersCanBeOverlooked()
{
    std::map<std::string, int> files;
    for (const Source& source : sources)
        ++files[source.path.substr(0, source.path.rfind('/'))];
    std::string broken;
    for (const auto& [folder, count] : files)
        if (count > 50)
            broken += "\n  " + folder + ": " + std::to_string(count) + " files";
    QVERIFY2(broken.empty(), broken.c_str());
}

/// The line on which a function whose brace stands at \p open begins to do something: that of its first
/// initialiser where it is a constructor with some, else that of the brace.
static std::size_t firstLineOf(const std::string& code, std::size_t open)
{
    std::size_t at = open;
    while (at > 0) {
        const std::size_t line = code.rfind('\n', at - 1) + 1;
        if (code.compare(line, 6, "    : ") == 0)
            return lineOf(code, line);
        if (line == 0 || code.compare(line, 1, " ") != 0)
            break;
        at = line - 1;
    }
    return lineOf(code, open + 1);
}

/// A function of namespace level begins with a brace alone in the first column and ends with one:
/// clang-format sees to it. Sixty lines between them are a screen; the initialisers of a constructor count.
void TestLayers::functionsFitOnAScreen()
{
    std::string broken;
    for (const Source& source : sources) {
        if (source.path.starts_with("tests/"))
            continue;
        for (std::size_t open = source.code.find("\n{\n"); open != std::string::npos;
             open = source.code.find("\n{\n", open + 1)) {
            const std::size_t close = source.code.find("\n}", open + 1);
            if (close == std::string::npos || source.code[close + 2] == ';')
                continue;
            const std::size_t first = firstLineOf(source.code, open), last = lineOf(source.code, close + 1);
            if (last - first - 1 > 60)
                broken += "\n  " + source.path + ":" + std::to_string(first) + ": a function of " +
                          std::to_string(last - first - 1) + " lines";
        }
    }
    QVERIFY2(broken.empty(), broken.c_str());
}

void TestLayers::headersBeginWithWhatTheyPromise()
{
    std::string broken;
    for (const Source& source : sources)
        if (source.path.ends_with(".h") && (!source.text.starts_with("/// \\file\n/// ") ||
                                            source.code.find("#pragma once") == std::string::npos))
            broken += "\n  " + source.path;
    QVERIFY2(broken.empty(), broken.c_str());
}

RAMURE_SUITE(TestLayers)

} // namespace tst_layers

#include "tst_layers.moc"
