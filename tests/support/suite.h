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

/// Printable text of an Expected's error, for QVERIFY2.
template <class T> QByteArray why(const T& expected)
{
    return expected ? QByteArray("no error") : QByteArray::fromStdString(expected.error().message());
}

} // namespace ramure::test
