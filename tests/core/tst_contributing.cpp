#include "tests/support/suite.h"
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace tst_contributing {

/// The pages for people who work on the program name files and folders: all of them exist.
class TestContributing : public QObject
{
    Q_OBJECT
private slots:
    void init() { ramure::test::failOnAnyWarning(); }
    void aWrongPathIsSeen();
    void everyPathExists_data();
    void everyPathExists();
};

namespace {

/// A page, and where the paths that it names begin.
struct Page
{
    const char* file;
    const char* base;
    std::size_t least; ///< as many paths it names at least: the pattern below still finds them
};

constexpr Page pages[] = {
    {"CONTRIBUTING.md", "", 30},
    {"core/README.md", "core/", 10},
    {"widgets/README.md", "widgets/", 8},
    {"tests/README.md", "tests/", 6},
    {"README.md", "", 5},
};

std::string read(const std::filesystem::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// What stands in backquotes and looks like a path of the sources (`core/base/error.h`, `surface/mesher`),
/// what links lead to, and the rooms that begin the rows of an overview.
std::vector<std::string> pathsIn(const std::string& text)
{
    static const std::regex pattern(R"(`([a-z_]+(?:/[a-z_0-9]+)+(?:\.[a-z]+)?)`|\]\(([\w./-]+\.md)\))");
    static const std::regex row(R"( {4}((?:[a-z_/]+(?:/\.{3})? {2,})+)\S.*)"), room("[a-z_/]+");
    std::vector<std::string> found;
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it)
            found.push_back((*it)[1].matched ? (*it)[1].str() : "/" + (*it)[2].str());
        if (!std::regex_match(line, match, row))
            continue;
        for (std::sregex_iterator it(match[1].first, match[1].second, room), end; it != end; ++it)
            found.push_back(it->str());
    }
    return found;
}

/// A path may be given from the top or from the folder of the page; a suite without its ending.
bool exists(const std::string& path, const std::string& base)
{
    const std::filesystem::path top(RAMURE_SOURCE_DIR);
    if (path.front() == '/')
        return std::filesystem::exists(top / base / path.substr(1));
    for (const std::string& from : {std::string(), base})
        for (const char* ending : {"", ".h", ".cpp"})
            if (std::filesystem::exists(top / (from + path + ending)))
                return true;
    return path.starts_with("build/");
}

} // namespace

void TestContributing::aWrongPathIsSeen()
{
    QCOMPARE(pathsIn("`core/base/error.h` and `tr()`, `./dev test`, [x](core/README.md)").size(), 2U);
    QCOMPARE(
        pathsIn("    math  base    numbers\n    view/...  one each\n    ./dev run  # starts\n  no room\n"),
        (std::vector<std::string>{"math", "base", "view/"}));
    QVERIFY(exists("core/base/error.h", ""));
    QVERIFY(exists("base/error.h", "core/"));
    QVERIFY(!exists("core/base/no_such_file.h", ""));
    QVERIFY(!exists("/no_such_page.md", ""));
}

void TestContributing::everyPathExists_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(std::size(pages)); ++i)
        QTest::newRow(pages[i].file) << i;
}

void TestContributing::everyPathExists()
{
    QFETCH(int, number);
    const Page& page = pages[number];
    const std::vector<std::string> paths =
        pathsIn(read(std::filesystem::path(RAMURE_SOURCE_DIR) / page.file));
    QVERIFY2(paths.size() >= page.least, std::to_string(paths.size()).c_str());
    std::string missing;
    for (const std::string& path : paths)
        if (!exists(path, page.base))
            missing += "\n  " + path;
    QVERIFY2(missing.empty(), missing.c_str());
}

RAMURE_SUITE(TestContributing)

} // namespace tst_contributing

#include "tst_contributing.moc"
