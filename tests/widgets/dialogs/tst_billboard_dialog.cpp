#include "tests/widgets/base/fixture.h"
#include "widgets/actions/billboard_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/billboard_dialog.h"
#include "widgets/view/viewport_host.h"
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace tst_billboard_dialog {

using namespace ramure;

class TestBillboardDialog : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

    template <class T> static T* part(const BillboardDialog& dialog, const char* name)
    {
        return dialog.findChild<T*>(QLatin1String(name));
    }
    static void choose(const BillboardDialog& dialog, const char* name, int row)
    {
        part<QComboBox>(dialog, name)->setCurrentIndex(row);
    }
    static bool maySave(const BillboardDialog& dialog)
    {
        return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->isEnabled();
    }

private slots:
    void init() { test::failOnWidgetWarning(); }

    void badSettingsAreAsUsual()
    {
        const BillboardDialog dialog(
            false, {{"size", 300}, {"cards", 99}, {"views", -1}, {"selection", true}, {"atlas", "what"}});
        QCOMPARE(dialog.wish().size, 2048);
        QCOMPARE(dialog.wish().cards, mostCards);
        QCOMPARE(dialog.wish().views, leastViews);
        QVERIFY(!dialog.isSelectionOnly() && !part<QCheckBox>(dialog, "billboardSelection")->isEnabled());
    }
    void atlasesThatDoNotFitAreRefusedWithTheReason()
    {
        BillboardDialog dialog(false, {{"atlas", true}});
        dialog.show();
        const auto* problem = part<QLabel>(dialog, "problem");
        auto* views = part<QSpinBox>(dialog, "billboardViews");
        QVERIFY(maySave(dialog) && problem->isHidden());
        views->setValue(7);
        QVERIFY(!maySave(dialog));
        QVERIFY(problem->isVisible());
        QVERIFY2(problem->text().contains("2048 px") && problem->text().contains("2, 4, 8, 16, 32"),
                 qPrintable(problem->text()));
        views->setValue(32);
        QVERIFY(maySave(dialog) && problem->isHidden());
        choose(dialog, "billboardSize", 0); // 256
        QVERIFY(!maySave(dialog));
        QVERIFY2(problem->text().contains("8 px") && problem->text().contains("2, 4, 8, 16."),
                 qPrintable(problem->text()));
        choose(dialog, "billboardKind", 0); // cards have no views
        QVERIFY(maySave(dialog) && problem->isHidden());
    }
    void whatTheKindDoesNotHaveIsHidden()
    {
        BillboardDialog dialog(true, {});
        dialog.show();
        const auto shows = [&dialog](const char* name) { return part<QWidget>(dialog, name)->isVisible(); };
        QVERIFY(!dialog.wish().isAtlas && !dialog.isFolder());
        QVERIFY(shows("billboardCards") && shows("billboardLying") && shows("billboardFiles"));
        QVERIFY(!shows("billboardViews"));
        choose(dialog, "billboardFiles", 1);
        QVERIFY(dialog.isFolder());
        choose(dialog, "billboardFiles", 0);
        choose(dialog, "billboardKind", 1);
        QVERIFY(dialog.wish().isAtlas && dialog.isFolder());
        QVERIFY(!shows("billboardCards") && !shows("billboardLying") && !shows("billboardFiles"));
        QVERIFY(shows("billboardViews") && shows("billboardSize") && shows("billboardSelection"));
    }
    void settingsComeBack()
    {
        const QVariantMap kept{{"atlas", true}, {"size", 512},    {"cards", 5},       {"lying", true},
                               {"views", 16},   {"folder", true}, {"selection", true}};
        const BillboardDialog dialog(true, kept);
        QCOMPARE(dialog.settings(), kept);
        const BillboardWish wish = dialog.wish();
        QVERIFY(wish.isAtlas && wish.lying);
        QCOMPARE(wish.size, 512);
        QCOMPARE(wish.cards, 5);
        QCOMPARE(wish.views, 16);
        const BillboardDialog usual(true, {});
        QCOMPARE(usual.wish().cards, 2);
        QCOMPARE(usual.wish().views, 8);
        QCOMPARE(usual.wish().size, 2048);
    }
    void withoutOpenGlTheActionSaysSo()
    {
        Preferences preferences;
        Document document;
        test::openNodes(document, {test::treeNode(1, "Oak")});
        test::FakeChooser chooser;
        ActionSet set;
        ViewportHost host(&document);
        const BillboardActions billboards(&document, &host, &preferences, &chooser, &set, nullptr);
        QVERIFY(!host.viewport());
        QVERIFY(!set.find("file.billboard")->isEnabled());
        QVERIFY2(set.find("file.billboard")->toolTip().contains("OpenGL"),
                 qPrintable(set.find("file.billboard")->toolTip()));
    }
};

RAMURE_SUITE(TestBillboardDialog)

} // namespace tst_billboard_dialog

#include "tst_billboard_dialog.moc"
