#include "core/params/param_relevance.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/group_clipboard.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/properties_panel.h"
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <climits>

namespace tst_parameter_search {

using namespace ramure;

namespace {

const ParamDef& param(const char* key)
{
    return *findParam(key);
}

ParamValue valueOf(const Document& document, NodeId id, const ParamDef& def)
{
    return def.get(document.scene().find(id)->params);
}

} // namespace

class TestParameterSearch : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<PropertiesPanel> m_panel;

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        QSettings().clear();
        m_preferences = std::make_unique<Preferences>();
        m_document = std::make_unique<Document>();
        test::openNodes(*m_document, {test::treeNode(1, "One"), test::treeNode(2, "Two")});
        m_panel = std::make_unique<PropertiesPanel>(m_document.get(), m_preferences.get());
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
    }

    void theEmptyPageIsTranslated()
    {
        m_document->setSelection({});
        const auto text = [&] {
            PropertiesPanel panel(m_document.get(), m_preferences.get());
            return panel.findChild<QLabel*>(QStringLiteral("hint"), Qt::FindDirectChildrenOnly)->text();
        };
        const QString english = text();
        m_preferences->language.set(QStringLiteral("fr"));
        {
            const Language language(*m_preferences);
            QVERIFY2(text() != english && !text().isEmpty(), qPrintable(text()));
        }
        QCOMPARE(text(), english);
    }

    void searchFindsByNameGroupAndKey()
    {
        auto* search = m_panel->findChild<QLineEdit*>();
        const auto shown = [&](const char* key) {
            return m_panel->row(param(key))->isVisibleTo(m_panel.get());
        };
        search->setText(QStringLiteral("radialDiv"));
        QVERIFY(shown("sections.radialDivisions"));
        QVERIFY(!shown("turtle.alpha"));
        search->setText(QStringLiteral("foliage seed"));
        QVERIFY(shown("foliage.seed"));
        QVERIFY(!shown("grammar.seed"));
        search->setText(QStringLiteral("no such thing"));
        QVERIFY(!shown("foliage.seed"));
        search->clear();
        QVERIFY(shown("turtle.alpha"));
    }

    void whatHasNoEffectIsHidden()
    {
        Node one = test::treeNode(1, "One"), two = test::treeNode(2, "Two");
        one.kind = two.kind = NodeKind::Primitive;
        one.params.primitive.shape = two.params.primitive.shape = PrimitiveShape::Box;
        test::openNodes(*m_document, {one, two});
        const auto isShown = [&](const char* key) { return !m_panel->row(param(key))->isHidden(); };
        QVERIFY(isShown("primitive.size") && !isShown("primitive.radius") && !isShown("primitive.sides"));
        QVERIFY(edit::setParam(*m_document, {1}, param("primitive.shape"), EnumValue{"sphere"}));
        QVERIFY(!isShown("primitive.size") && isShown("primitive.radius") && !isShown("primitive.height"));
        m_document->undo();
        QVERIFY(isShown("primitive.size") && !isShown("primitive.radius"));
        m_panel->findChild<QLineEdit*>()->setText(QStringLiteral("primitive.radius"));
        QVERIFY(!isShown("primitive.radius"));
    }

    /// No row of a parameter that cannot act takes an edit, whatever is selected and searched for.
    void onlyWhatActsIsOffered()
    {
        Node grammar = test::treeNode(1, "Grammar"), penn = test::treeNode(2, "Weber and Penn");
        penn.params.generator.kind = EditOperation::WeberPenn;
        test::openNodes(*m_document, {grammar, penn});
        auto* search = m_panel->findChild<QLineEdit*>();
        for (const std::vector<NodeId>& nodes : {std::vector<NodeId>{1}, {2}, {1, 2}}) {
            m_document->setSelection({nodes, noNode, {}, noIndex});
            for (const char* words : {"", "turn", "leaves", "seed", "radius"}) {
                search->setText(QLatin1String(words));
                int offered = 0;
                for (const ParamDef& def : paramTable()) {
                    const bool act = std::ranges::all_of(
                        nodes, [&](NodeId id) { return acts(m_document->scene().find(id)->params, def); });
                    const ParamRow* row = m_panel->row(def);
                    const bool takes = row->isVisibleTo(m_panel.get()) && row->editor()->isEnabled();
                    QVERIFY2(act || !takes, def.key);
                    offered += int(takes);
                }
                QVERIFY2(offered > 0, words);
            }
        }
    }

    /// A row that a number turns off keeps its place: the rows below do not move under the pointer.
    void whatANumberTurnsOffIsGrey()
    {
        const ParamDef& def = param("sections.radialDivisions");
        ParamRow* row = m_panel->row(def);
        QVERIFY(row->isVisibleTo(m_panel.get()) && row->editor()->isEnabled());
        QVERIFY(
            edit::setParam(*m_document, {1}, param("mesh.targetTriangles"), ParamValue(std::int64_t{5000})));
        QVERIFY(row->isVisibleTo(m_panel.get()) && !row->editor()->isEnabled());
        QVERIFY(row->editor()->toolTip().contains(QStringLiteral("no effect now: another value")));
        m_document->undo();
        QVERIFY(row->editor()->isEnabled() &&
                !row->editor()->toolTip().contains(QStringLiteral("no effect")));
    }

    void whatASwitchTurnsOffNamesTheSwitch()
    {
        for (const auto& [key, owner] : {std::pair{"grammar.seed", "grammar.stochastic"},
                                         std::pair{"simplify.rotationThreshold", "simplify.enabled"}}) {
            const QString why =
                QStringLiteral("no effect while “%1” is off").arg(QLatin1String(param(owner).label));
            const ParamRow* row = m_panel->row(param(key));
            QVERIFY(edit::setParam(*m_document, {1}, param(owner), ParamValue(false)) &&
                    !row->editor()->isEnabled());
            QVERIFY2(row->editor()->toolTip().contains(why), qPrintable(row->editor()->toolTip()));
            QVERIFY(edit::setParam(*m_document, {1}, param(owner), ParamValue(true)) &&
                    !row->editor()->toolTip().contains(why));
        }
    }

    void whatIsFoundNowhereCanBeCleared()
    {
        auto* search = m_panel->findChild<QLineEdit*>();
        auto* clear = m_panel->findChild<QPushButton*>(QStringLiteral("clearSearch"));
        const auto* empty = m_panel->findChild<QLabel*>(QStringLiteral("hint"), Qt::FindDirectChildrenOnly);
        QVERIFY(!clear->isVisible());
        search->setText(QStringLiteral("no such thing"));
        QVERIFY(clear->isVisible() && empty->text().contains(search->text()));
        m_document->setSelection({}); // another sentence
        QVERIFY(!clear->isVisible() && empty->isVisible());
        Selection again;
        again.nodes = {2};
        m_document->setSelection(again);
        QVERIFY(clear->isVisible() && empty->text().contains(search->text()));
        clear->click();
        QVERIFY(search->text().isEmpty() && !clear->isVisible() && !empty->isVisible());
        QVERIFY(m_panel->row(param("turtle.alpha"))->isVisibleTo(m_panel.get()));
    }

    void whatIsCalledSoStandsFirst()
    {
        auto* search = m_panel->findChild<QLineEdit*>();
        const auto top = [&](const char* key) {
            const ParamRow* row = m_panel->row(param(key));
            QCoreApplication::sendPostedEvents(); // layouts
            return row->mapTo(m_panel.get(), QPoint()).y();
        };
        const bool before = top("turtle.alpha") < top("foliage.seed");
        search->setText(QStringLiteral("length"));
        const QStringList words{QStringLiteral("length")};
        int firstCalled = INT_MAX, firstOther = INT_MAX;
        for (const ParamDef& def : paramTable()) {
            const ParamRow* row = m_panel->row(def);
            if (!row->isVisibleTo(m_panel.get()))
                continue;
            int& first = row->isCalled(words) ? firstCalled : firstOther;
            first = std::min(first, top(def.key));
        }
        QVERIFY(firstOther < INT_MAX && firstCalled < firstOther);
        search->clear();
        QCOMPARE(top("turtle.alpha") < top("foliage.seed"), before);
    }

    void enterGoesFromTheSearchToWhatItFound()
    {
        auto* search = m_panel->findChild<QLineEdit*>();
        search->setFocus();
        QTest::keyClicks(search, "no such thing");
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(search->hasFocus());
        search->selectAll();
        QTest::keyClicks(search, "lengthDiv");
        QTest::keyClick(search, Qt::Key_Return);
        QWidget* field = QApplication::focusWidget();
        QVERIFY(m_panel->row(param("sections.lengthDivisions"))->isAncestorOf(field));
        QTest::keyClicks(field, "7"); // in the place of what was there
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(valueOf(*m_document, 1, param("sections.lengthDivisions")) == ParamValue(std::int64_t{7}));
    }

    /// Reset, copy and paste of a group leave rows alone that a search hides.
    void commandsOnAGroupActOnWhatIsFound()
    {
        const ParamDef &seen = param("turtle.alpha"), &hidden = param("turtle.decay");
        QVERIFY(edit::setParam(*m_document, {1}, seen, ParamValue(0.3)));
        QVERIFY(edit::setParam(*m_document, {1}, hidden, ParamValue(0.7)));
        auto* turtle = m_panel->findChild<GroupSection*>(QStringLiteral("group/Turtle"));
        m_panel->findChild<QLineEdit*>()->setText(QStringLiteral("turtle.alpha"));
        QVERIFY(!m_panel->row(hidden)->isVisibleTo(m_panel.get()));
        emit turtle->copyRequested();
        const auto copied = readParamList(QGuiApplication::clipboard()->text());
        QVERIFY(copied && copied->size() == 1 && copied->front().first == &seen);
        emit turtle->resetRequested();
        QVERIFY(valueOf(*m_document, 1, seen) == defaultValue(seen));
        QVERIFY(valueOf(*m_document, 1, hidden) == ParamValue(0.7));
        QGuiApplication::clipboard()->setText(
            writeParamList({{&seen, ParamValue(0.4)}, {&hidden, ParamValue(0.9)}}));
        emit turtle->pasteRequested();
        QVERIFY(valueOf(*m_document, 1, seen) == ParamValue(0.4));
        QVERIFY(valueOf(*m_document, 1, hidden) == ParamValue(0.7));
    }
};

RAMURE_SUITE(TestParameterSearch)

} // namespace tst_parameter_search

#include "tst_parameter_search.moc"
