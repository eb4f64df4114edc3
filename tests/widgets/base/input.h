/// \file
/// What a hand does to a field: types, turns the wheel, drops files.
#pragma once

#include <QClipboard>
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>

namespace ramure::test {

/// Into the line of an editor, in place of what is there.
inline void typeLine(QWidget* editor, const char* text)
{
    auto* field = editor->findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(text));
    QTest::keyClick(field, Qt::Key_Return);
}

/// As its menu and then a click elsewhere do.
inline void pasteLine(QWidget* editor, const QString& text)
{
    auto* field = editor->findChild<QLineEdit*>();
    QGuiApplication::clipboard()->setText(text);
    field->paste();
    emit field->editingFinished();
}

/// \param turn in eighths of a degree: 120 is one step up
inline void turnWheel(QWidget* field, int turn)
{
    QWheelEvent wheel(QPointF(5, 5), field->mapToGlobal(QPointF(5, 5)), {}, {0, turn}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(field, &wheel);
}

/// \returns whether it takes them
inline bool dropFiles(QWidget* target, const QList<QUrl>& files)
{
    QMimeData data;
    data.setUrls(files);
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(target, &enter);
    QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &event);
    return enter.isAccepted();
}

} // namespace ramure::test
