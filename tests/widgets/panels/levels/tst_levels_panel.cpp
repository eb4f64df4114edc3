#include "tests/support/waits.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "core/session/level_export.h"
#include "core/session/job.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/level_form.h"
#include "widgets/base/number_slider.h"
#include "widgets/base/preferences.h"
#include "widgets/panels/levels/level_view.h"
#include "widgets/panels/levels/levels_panel.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <atomic>

using namespace ramure;
using State = LevelWatch::State;

/// The panel of levels of detail.
class TestLevelsPanel : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = 30'000;
    test::OwnSettings m_settings;

    /// A panel that looks at a document with a small tree.
    struct Bench
    {
        Preferences preferences;
        test::TreeDocument trees;
        NodeId tree = noNode;
        std::unique_ptr<LevelsPanel> panel;

        explicit Bench(const char* preset = "TinyTree", LevelWatch::Function function = {})
        {
            if (preset)
                tree = trees.add(*presetParams(preset), "Oak");
            if (function)
                panel = std::make_unique<LevelsPanel>(
                    &trees.document(), new LevelWatch(&trees.document(), std::move(function)), &preferences);
            else
                panel = std::make_unique<LevelsPanel>(&trees.document(), &preferences);
            panel->watch()->setRest(0);
            panel->resize(384, 640);
            panel->show();
        }
        [[nodiscard]] State state() const { return panel->watch()->state(); }
        [[nodiscard]] bool isDone() const { return state() == State::Done; }
        [[nodiscard]] QString cell(int row, int column) const
        {
            return panel->table()->model()->index(row, column).data().toString();
        }
        [[nodiscard]] int rows() const { return panel->table()->model()->rowCount(); }
        template <class T> [[nodiscard]] T* part(const char* name) const
        {
            return panel->findChild<T*>(QLatin1String(name));
        }
        void setBudgets(const QString& text, int count) const
        {
            part<QSpinBox>("levelCount")->setValue(count);
            part<QLineEdit>("levelBudgets")->setText(text);
        }
        [[nodiscard]] QString problem() const
        {
            const auto* label = part<QLabel>("problem");
            return label && label->isVisible() ? label->text() : QString();
        }
    };

private slots:
    void init()
    {
        QSettings().clear();
        test::failOnWidgetWarning();
    }
    void sizes()
    {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        for (QWidget* w : bench.panel->findChildren<QWidget*>())
            qInfo() << w->metaObject()->className() << w->objectName() << w->minimumSizeHint() << w->minimumSize() << w->isVisible();
        qInfo() << bench.panel->minimumSizeHint();
    }
};

QTEST_MAIN(TestLevelsPanel)
#include "tst_levels_panel.moc"
