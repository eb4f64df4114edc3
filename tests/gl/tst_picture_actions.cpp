#include "core/qt/session/jobs/recompute.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/picture_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/lens_form.h"
#include "widgets/dialogs/picture_dialog.h"
#include "widgets/dialogs/picture_form.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <functional>

namespace tst_picture_actions {

using namespace ramure;

class TestPictureActions : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }

    void picturesGoToFilesAndToTheClipboard()
    {
        if (!openGlAvailable(nullptr))
            RAMURE_CANNOT_RUN("no OpenGL here");
        Preferences preferences;
        Document document;
        Recompute recompute(&document);
        test::openNodes(document, {test::treeNode(1, "Oak")});
        QVERIFY(recompute.waitForFull(test::patience(20'000)));
        test::FakeChooser chooser;
        ActionSet set;
        ViewportHost host(&document);
        PictureActions pictures(&document, &host, &preferences, &chooser, &set, nullptr);
        QSignalSpy messages(&pictures, &PictureActions::messageRaised);
        host.resize(320, 200);
        host.show();
        QVERIFY(QTest::qWaitForWindowExposed(&host));
        const auto dialog = [&host] { return host.window()->findChild<PictureDialog*>(); };
        const auto ask = [&](const std::function<void(PictureDialog&)>& choose) {
            set.find(QStringLiteral("view.savePicture"))->trigger();
            PictureDialog* asked = dialog();
            QVERIFY(asked);
            choose(*asked);
            QTRY_VERIFY(!dialog());
            QTRY_VERIFY_WITH_TIMEOUT(!pictures.job()->isRunning(), test::patience(20'000));
        };
        const auto save = [&] { ask([](PictureDialog& asked) { asked.accept(); }); };
        ask([](PictureDialog& asked) { asked.reject(); });
        QCOMPARE(chooser.saves, 0);
        save(); // and no file is chosen
        QCOMPARE(chooser.saves, 1);
        QVERIFY(chooser.reports.isEmpty() && messages.isEmpty());
        QTemporaryDir folder;
        for (const char* bad : {"tree.nonsense", "no/such/folder/tree.png"}) {
            chooser.reports.clear();
            chooser.answer = folder.filePath(QString::fromLatin1(bad));
            save();
            QCOMPARE(chooser.reports.size(), 1);
            QVERIFY(!QFile::exists(chooser.answer));
        }
        chooser.answer = folder.filePath(QStringLiteral("tree.png"));
        save();
        QCOMPARE(messages.count(), 1);
        QCOMPARE(QImage(chooser.answer).size(), QSize(320, 200));
        QCOMPARE(preferences.lastFolder(), folder.path());
        ask([](PictureDialog& asked) {
            asked.form()->findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(640);
            QCOMPARE(asked.form()->pictureSize(), QSize(640, 400)); // the view's ratio
            asked.form()->setPictureSize({1000, 400});
            asked.form()->findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(400);
            QCOMPARE(asked.form()->pictureSize(), QSize(400, 400)); // no longer
            asked.form()->setTransparent(true);
            asked.accept();
        });
        const QImage clear(chooser.answer);
        QCOMPARE(clear.size(), QSize(400, 400));
        QCOMPARE(qAlpha(clear.pixel(0, 0)), 0);
        ask([](PictureDialog& asked) { // as the last time
            QCOMPARE(asked.form()->pictureSize(), QSize(400, 400));
            QVERIFY(asked.form()->isTransparent() && !*asked.wish().grid);
            asked.reject();
        });
        QCOMPARE(messages.count(), 2);
        // A lens that is open blurs all that is not in focus, and a click in the view says what is.
        const auto sharp = [](const QImage& image) {
            double sum = 0.0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 1; x < image.width(); ++x)
                    sum += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x - 1, y)));
            return sum;
        };
        const auto picture = [&](const std::function<void(PictureDialog&)>& choose) {
            ask([&](PictureDialog& asked) {
                asked.form()->setTransparent(false);
                asked.form()->setPictureSize({320, 200});
                choose(asked);
                asked.accept();
            });
            return QImage(chooser.answer);
        };
        const QImage plain = picture([](PictureDialog&) {});
        const QImage fine =
            picture([](PictureDialog& asked) { asked.findChild<QSpinBox*>("pictureSamples")->setValue(4); });
        QVERIFY(fine != plain);
        const QImage blurred = picture([&](PictureDialog& asked) {
            QCOMPARE(asked.lensForm()->samples(), 4); // as the last time
            asked.findChild<QDoubleSpinBox*>("pictureFStop")->setValue(0.1);
            asked.lensForm()->setFocus(0.5);
        });
        QVERIFY(sharp(blurred) < 0.7 * sharp(fine));
        const QImage picked = picture([&](PictureDialog& asked) {
            QVERIFY(asked.lensForm()->lens().diameter > 0.0); // as the last time, but for the focus
            QCOMPARE(asked.lensForm()->lens().focus, 0.0);
            auto* button = asked.findChild<QPushButton*>("pictureFocusPick");
            Viewport* view = host.viewport();
            button->click();
            QVERIFY(asked.isHidden());
            QTest::keyClick(view, Qt::Key_Escape);
            QVERIFY(asked.isVisible());
            QCOMPARE(asked.lensForm()->lens().focus, 0.0);
            button->click();
            const Skeleton& skeleton = document.result(1)->tree.simplified->skeleton;
            const glm::dvec3 trunk = 0.5 * (skeleton.p0[0] + skeleton.p1[0]);
            const glm::dvec2 pixel = PickView{view->camera(), {320.0, 200.0}}.pixel(trunk).value();
            const QPoint at(int(pixel.x), int(pixel.y));
            QTRY_VERIFY(view->hitAt(at));
            QTest::mouseClick(view, Qt::LeftButton, {}, at);
            QTRY_VERIFY(asked.isVisible());
            const double before = glm::dot(view->camera().eye() - trunk, view->camera().backward());
            QVERIFY(std::abs(asked.lensForm()->lens().focus - before) < 0.05 * before);
        });
        QVERIFY(sharp(picked) > 1.1 * sharp(blurred));
        // Given up: no file, and what was there stays.
        const QDateTime before = QFileInfo(chooser.answer).lastModified();
        set.find(QStringLiteral("view.savePicture"))->trigger();
        dialog()->accept();
        pictures.job()->cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!pictures.job()->isRunning(), test::patience(20'000));
        QCOMPARE(QFileInfo(chooser.answer).lastModified(), before);
        QVERIFY(messages.last().front().toString().contains("No picture"));
        set.find(QStringLiteral("view.copyPicture"))->trigger();
        QVERIFY(messages.last().front().toString().contains("clipboard"));
        QCOMPARE(QGuiApplication::clipboard()->image().size(), QSize(320, 200));
    }

    void branchesAreSelectedByKeysInTheViewOnly()
    {
        if (!openGlAvailable(nullptr))
            RAMURE_CANNOT_RUN("no OpenGL here");
        Preferences preferences;
        Document document;
        Recompute recompute(&document);
        test::openNodes(document, {test::treeNode(1, "Oak")});
        QVERIFY(recompute.waitForFull(test::patience(20'000)));
        test::FakeChooser chooser;
        ActionSet set;
        ViewportHost host(&document);
        const PictureActions pictures(&document, &host, &preferences, &chooser, &set, nullptr);
        set.find(QStringLiteral("edit.selectAll"))->trigger();
        QVERIFY(document.selection().branches.size() > 1);
        set.find(QStringLiteral("edit.clearSelection"))->trigger();
        QVERIFY(document.selection().branches.empty());
        for (const QAction* action : pictures.selectionActions())
            QCOMPARE(action->shortcutContext(), Qt::WidgetWithChildrenShortcut);
    }
};

RAMURE_SUITE(TestPictureActions)

} // namespace tst_picture_actions

#include "tst_picture_actions.moc"
