/// \file
/// What every suite starts from: warnings are failures.
#pragma once

#include <QRegularExpression>
#include <QTest>

namespace ramure::test {

/// Call from init() of every suite. The offscreen platform tells at every window it shows that it has no size
/// hints: that says nothing about the program.
inline void failOnAnyWarning()
{
    QTest::failOnWarning(
        QRegularExpression(QStringLiteral("^(?!This plugin does not support propagateSizeHints)")));
}

/// A sanitizer is ten times as slow, and looks for faults of memory, not for rare shapes.
#ifdef RAMURE_SANITIZED
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

/// \p count runs, or a twentieth of them under a sanitizer.
constexpr int runs(int count)
{
    return isSanitized ? (count + 19) / 20 : count;
}

/// How long a condition may take, ms: under a sanitizer, on a machine that does something else, eight times
/// as long.
constexpr int patience(int ms)
{
    return isSanitized ? 8 * ms : ms;
}

/// One suite of a program that holds many: `PROGRAM tst_name [OPTION OF QTEST]...` runs it.
struct Suite
{
    using Run = int (*)(int argc, char** argv);
    /// \param file of the suite, whose name without folder and ending is that of the suite
    Suite(const char* file, Run run);
};

/// Printable text of an Expected's error, for QVERIFY2.
template <class T> QByteArray why(const T& expected)
{
    return expected ? QByteArray("no error") : QByteArray::fromStdString(expected.error().message());
}

} // namespace ramure::test

#ifdef QT_WIDGETS_LIB
#define RAMURE_APPLICATION QApplication
#else
#define RAMURE_APPLICATION QCoreApplication
#endif

/// In place of QTEST_MAIN, in a namespace named after the file: several suites are compiled together, and all
/// of a kind are linked into one program. A suite that needs a main() of its own, or replaces a table of the
/// program, keeps QTEST_MAIN and is a program alone.
#define RAMURE_SUITE(Type)                                                                                   \
    static const ramure::test::Suite registered##Type(__FILE__, [](int argc, char** argv) {                  \
        QTest::Internal::callInitMain<Type>();                                                               \
        QTEST_QAPP_SETUP(RAMURE_APPLICATION)                                                                 \
        Type suite;                                                                                          \
        return QTest::qExec(&suite, argc, argv);                                                             \
    });
