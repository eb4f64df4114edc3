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

/// Printable text of an Expected's error, for QVERIFY2.
template <class T> QByteArray why(const T& expected)
{
    return expected ? QByteArray("no error") : QByteArray::fromStdString(expected.error().message());
}

} // namespace ramure::test
