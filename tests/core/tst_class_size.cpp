#include "tests/support/house_sources.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <regex>

namespace tst_class_size {

using namespace ramure::test;

/// A class has fewer than 40 public functions, signals included, and fewer than 40 fields: one with more does
/// several jobs.
class TestClassSize : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void membersAreCounted_data();
    void membersAreCounted();
    void classesAreOfReadableSize();
};

namespace {

struct ClassSize
{
    std::string name;
    int functions = 0; ///< public ones
    int fields = 0;
};

/// The text between the brace at \p open and the one that closes it; insides of inner braces and parentheses
/// are left out.
std::string outline(const std::string& code, std::size_t open)
{
    std::string kept;
    int depth = 0;
    for (std::size_t i = open + 1; i < code.size() && depth >= 0; ++i) {
        const char c = code[i];
        if (c == '}' || c == ')')
            --depth;
        if (depth == 0)
            kept += c == '\n' ? ' ' : c;
        if (c == '{' || c == '(')
            ++depth;
    }
    return kept;
}

std::string without(std::string text, const char* pattern)
{
    const std::regex regex(pattern);
    for (std::string next; text != (next = std::regex_replace(text, regex, " "));)
        text = next;
    return text;
}

/// A function has its parentheses before its body and before any value.
bool isFunction(const std::string& declared)
{
    static const std::regex operators(R"(operator[^\w\s(]+)");
    const std::string member = std::regex_replace(declared, operators, "operator");
    const std::size_t parentheses = member.find("()");
    return parentheses != std::string::npos && parentheses < member.find_first_of("={");
}

void count(std::string member, bool isPublic, ClassSize& size)
{
    static const std::regex none(
        R"(\s*(using|friend|static_assert|typedef|enum|static constexpr|constexpr)\b.*)");
    static const std::regex type(R"(\s*(class|struct|union)\b[^(]*)");
    member = without(without(member, R"(\[\[\w+\]\]|\bQ_(OBJECT|GADGET)\b)"), "<[^<>]*>");
    if (isFunction(member) && !std::regex_match(member, std::regex(R"(\s*(using|friend)\b.*)")))
        size.functions += isPublic ? 1 : 0;
    else if (std::regex_match(member, type))
        size.fields += std::regex_match(member, std::regex(R"(.*\}\s*\w+.*)")) ? 1 : 0;
    else if (!std::regex_match(member, none) && member.find_first_not_of(' ') != std::string::npos)
        size.fields +=
            1 + static_cast<int>(std::ranges::count(without(member, R"(\{[^{}]*\}|\([^()]*\))"), ','));
}

std::vector<ClassSize> classesIn(const std::string& code)
{
    static const std::regex head(
        R"(\b(enum\s+)?(class|struct)\s+([\w:]+)(\s+final)?(\s*:\s*[^{};()]*)?\s*\{)");
    static const std::regex access(R"(^\s*(public|protected|private|signals)(\s+slots)?\s*:)");
    std::vector<ClassSize> found;
    for (std::sregex_iterator it(code.begin(), code.end(), head), end; it != end; ++it) {
        if ((*it)[1].matched)
            continue;
        ClassSize size{(*it)[3]};
        bool isPublic = (*it)[2] == "struct";
        std::string member;
        for (const char c : outline(code, static_cast<std::size_t>(it->position() + it->length()) - 1)) {
            member += c;
            std::smatch label;
            if (c == ':' && std::regex_search(member, label, access)) {
                isPublic = label[1] == "public" || label[1] == "signals";
                member.clear();
            } else if (c == ';' || (c == '}' && isFunction(without(member, "<[^<>]*>")))) {
                if (c == ';')
                    member.pop_back();
                count(std::exchange(member, {}), isPublic, size);
            }
        }
        found.push_back(size);
    }
    return found;
}

} // namespace

void TestClassSize::membersAreCounted_data()
{
    QTest::addColumn<QString>("code");
    QTest::addColumn<int>("functions");
    QTest::addColumn<int>("fields");
    QTest::newRow("nothing") << "struct A\n{\n};" << 0 << 0;
    QTest::newRow("fields") << "struct A\n{\n int a, b = 2;\n std::map<int, B<C>> c{1, 2};\n QSize d{};\n};"
                            << 0 << 4;
    QTest::newRow("functions")
        << "struct A : B\n{\n A() : B(), c(2) { f(); g(); }\n [[nodiscard]] int h() const { return c; }\n "
           "A(const A&) = delete;\n bool operator==(const A&) const = default;\n};"
        << 4 << 0;
    QTest::newRow("access")
        << "class A\n{\n Q_OBJECT\n void a();\npublic:\n void b();\npublic slots:\n void c();\nsignals:\n "
           "void d();\nprivate:\n void e();\n int m_f = g();\n};"
        << 3 << 1;
    QTest::newRow("no members") << "struct A\n{\n using B = int;\n enum class C { D };\n friend class E;\n "
                                   "static constexpr int f = 1;\n};"
                                << 0 << 0;
    QTest::newRow("inner")
        << "struct A\n{\n struct B\n {\n int c;\n };\n struct\n {\n int e;\n int g;\n } d;\n "
           "std::function<void(int)> f;\n};"
        << 0 << 2;
}

void TestClassSize::membersAreCounted()
{
    QFETCH(const QString, code);
    const std::vector<ClassSize> sizes = classesIn(code.toStdString());
    QVERIFY(!sizes.empty());
    QTEST(sizes.front().functions, "functions");
    QTEST(sizes.front().fields, "fields");
}

/// Parameters are the rows of a table: as many as there are.
void TestClassSize::classesAreOfReadableSize()
{
    std::string broken;
    int seen = 0;
    for (const Source& source : readSources()) {
        if (source.path.starts_with("tests/"))
            continue;
        for (const ClassSize& size : classesIn(source.code)) {
            ++seen;
            if ((size.functions >= 40 || size.fields >= 40) && !size.name.ends_with("Params"))
                broken += "\n  " + source.path + ": " + size.name + " has " + std::to_string(size.functions) +
                          " public functions and " + std::to_string(size.fields) + " fields";
        }
    }
    QVERIFY(seen > 1000);
    QVERIFY2(broken.empty(), broken.c_str());
}

RAMURE_SUITE(TestClassSize)

} // namespace tst_class_size

#include "tst_class_size.moc"
