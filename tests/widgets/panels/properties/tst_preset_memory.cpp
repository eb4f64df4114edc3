#include "core/scene/preset_scene.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace tst_preset_memory {

using namespace ramure;

/// What the panel calls changed, and where its arrows lead, hangs on the preset that a tree came from.
class TestPresetMemory : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<PropertiesPanel> m_panel;

    ParamRow* row(const char* key) { return m_panel->row(*findParam(key)); }
    const NodeParams& params(NodeId id) { return m_document->scene().find(id)->params; }
    void open(const std::vector<const char*>& presets)
    {
        std::vector<Node> nodes;
        for (const char* preset : presets) {
            nodes.push_back(*presetTree(preset));
            nodes.back().id = static_cast<NodeId>(nodes.size());
        }
        test::openNodes(*m_document, nodes);
    }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        m_panel = std::make_unique<PropertiesPanel>(m_document.get(), m_preferences.get());
        m_panel->show();
    }
    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
        m_preferences.reset();
    }

    void aFreshPresetIsUnchanged()
    {
        for (const char* preset : {"SmallTree", "FanTree", "TinyTree", "Fern2D"}) {
            open({preset});
            for (const ParamDef& def : paramTable()) {
                QVERIFY2(!m_panel->row(def)->isChanged(), def.key);
                QVERIFY2(m_panel->row(def)->resetButton()->isHidden(), def.key);
            }
            for (const GroupSection* section : m_panel->findChildren<GroupSection*>())
                QVERIFY(
                    !section->findChild<QToolButton*>(QStringLiteral("groupHeading"))->text().contains(u'•'));
        }
    }

    void resetGivesThePresetsValue()
    {
        open({"FanTree"});
        const NodeParams fresh = params(1);
        for (const char* key : {"grammar.rules", "turtle.theta"}) {
            const ParamDef& def = *findParam(key);
            QVERIFY(edit::setParam(*m_document, {1}, def, defaultValue(def))); // SmallTree's: not the fan's
            QVERIFY(row(key)->isChanged());
            QVERIFY(row(key)->resetButton()->toolTip().contains(QStringLiteral("FanTree")));
            row(key)->resetButton()->click();
            QVERIFY(!row(key)->isChanged());
        }
        QVERIFY(params(1) == fresh);
        QVERIFY(row("turtle.theta")->editor()->toolTip().contains(QStringLiteral("In FanTree")));
        QVERIFY(!row("turtle.alpha")->editor()->toolTip().contains(QStringLiteral("FanTree"))); // the default
        QVERIFY(!row("turtle.alpha")->resetButton()->toolTip().contains(QStringLiteral("FanTree")));
    }

    void treesOfSeveralPresetsGetTheirOwnBack()
    {
        open({"FanTree", "Fern2D"});
        const NodeParams fan = params(1), fern = params(2);
        Selection both;
        both.nodes = {1, 2};
        m_document->setSelection(both);
        QVERIFY(!row("turtle.theta")->isChanged()); // they differ, but neither was changed
        QVERIFY(edit::setParam(*m_document, {1, 2}, *findParam("turtle.theta"), 1.0));
        QVERIFY(edit::setParam(*m_document, {1, 2}, *findParam("turtle.alpha"), 1.0));
        const int steps = m_document->undoStack()->count();
        row("turtle.theta")->resetButton()->click();
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        QCOMPARE(params(1).turtle.theta, fan.turtle.theta);
        QCOMPARE(params(2).turtle.theta, fern.turtle.theta);
        auto* section = m_panel->findChild<GroupSection*>(QStringLiteral("group/Turtle"));
        emit section->resetRequested();
        QCOMPARE(m_document->undoStack()->count(), steps + 2);
        QVERIFY(params(1) == fan && params(2) == fern);
    }

    void whatIsTypedAsThePresetsValueIsIt()
    {
        open({"FanTree"}); // 0.15 rad: shown as 8.59°
        QVERIFY(edit::setParam(*m_document, {1}, *findParam("turtle.theta"), 1.0));
        auto* field = row("turtle.theta")->findChild<QAbstractSpinBox*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLocale().toString(8.59));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(params(1).turtle.theta, 0.15);
        QVERIFY(!row("turtle.theta")->isChanged());
    }
};

RAMURE_SUITE(TestPresetMemory)

} // namespace tst_preset_memory

#include "tst_preset_memory.moc"
