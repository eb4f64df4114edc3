/// \file
/// What the suites of the editor share: settings of their own, documents, a chooser that knows its answers.
#pragma once

#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include "tests/support/suite.h"
#include "widgets/base/chooser.h"
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QWidget>

namespace ramure::test {

/// Every warning but those of the offscreen platform about what it has not (limits of sizes, grabbing).
inline void failOnWidgetWarning()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin does not support )")));
}

/// The settings of this object's life time lie in a folder of its own.
class OwnSettings
{
public:
    OwnSettings()
    {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        QCoreApplication::setOrganizationName(QStringLiteral("Ramure"));
        QCoreApplication::setApplicationName(QStringLiteral("ramure-test"));
        QLocale::setDefault(QLocale::c());
    }

private:
    QTemporaryDir m_folder;
};

/// A press, moves and a release. QTest::mouseMove moves the cursor of the screen instead, which not every
/// platform has.
inline void drag(QWidget* widget, const QPoint& from, const QPoint& to)
{
    const auto send = [widget](QEvent::Type type, const QPoint& at, Qt::MouseButton button,
                               Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(at), widget->mapToGlobal(QPointF(at)), button, buttons,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(widget, &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    constexpr int steps = 5;
    for (int i = 1; i <= steps; ++i)
        send(QEvent::MouseMove, from + (to - from) * i / steps, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
}

/// Answers as the test says and remembers what it was told.
class FakeChooser : public Chooser
{
public:
    QString openFile(const QString&, const QString&, const QString&) override
    {
        ++opens;
        return answer;
    }
    QString openFolder(const QString&, const QString&) override { return folderAnswer; }
    QString saveFile(const QString&, const QString& suggestion, const QString&, const QString&) override
    {
        ++saves;
        lastSuggestion = suggestion;
        return answer;
    }
    Unsaved unsavedChanges(const QString&) override
    {
        ++questions;
        return unsaved;
    }
    bool agrees(const QString&, const QString&, const QString& why, const QString&) override
    {
        reasons += why;
        return agreed;
    }
    void report(Severity, const QString& text) override { reports += text; }

    QString answer, folderAnswer;
    Unsaved unsaved = Unsaved::Cancel;
    int opens = 0, saves = 0, questions = 0;
    QString lastSuggestion;
    QStringList reports, reasons;
    bool agreed = true;
};

inline Node treeNode(NodeId id, const std::string& name, NodeId parent = noNode)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = NodeKind::Tree;
    node.name = name;
    node.params.grammar.iterations = 3;
    return node;
}

inline Node groupNode(NodeId id, const std::string& name, NodeId parent = noNode)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.name = name;
    return node;
}

/// Opens a scene with these nodes, depth-first; the first one is selected.
inline void openNodes(Document& document, const std::vector<Node>& nodes)
{
    Scene scene;
    for (const Node& node : nodes) {
        const auto done =
            scene.insert({node}, node.parent, static_cast<int>(scene.children(node.parent).size()));
        QVERIFY2(done, why(done).constData());
    }
    document.reset(std::move(scene), {});
    if (!nodes.empty()) {
        Selection selection;
        selection.nodes = {nodes.front().id};
        document.setSelection(selection);
    }
}

} // namespace ramure::test
