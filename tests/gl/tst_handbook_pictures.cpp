// The pictures of the handbook, taken from the real window in both languages. With RAMURE_HANDBOOK set to the
// handbook's folder (./dev pictures) they are written there; without, they only have to be possible and small
// enough.
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/file_actions.h"
#include "widgets/actions/help_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/dialogs/palette/palette.h"
#include "widgets/panels/animation/key_model.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include "widgets/window/main_window.h"
#include "widgets/window/status_panel.h"
#include <QBuffer>
#include <QDockWidget>
#include <QLineEdit>
#include <QPainter>
#include <QSignalSpy>
#include <QUndoStack>
#include <algorithm>
#include <array>
#include <map>

namespace tst_handbook_pictures {

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(120'000);
constexpr qsizetype largestFile = 100 * 1024;
constexpr QSize windowSize(1040, 660);
constexpr int layoutDepth = 10;

/// The colours that most points have, told apart by five bits each.
QList<QRgb> commonColours(const QImage& picture, qsizetype most)
{
    constexpr QRgb fiveBits = 0xf8f8f8;
    std::map<QRgb, int> counts;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            ++counts[picture.pixel(x, y) & fiveBits];
    std::vector<std::pair<int, QRgb>> byCount;
    for (const auto& [colour, count] : counts)
        byCount.emplace_back(-count, colour);
    std::ranges::sort(byCount);
    QList<QRgb> colours;
    for (std::size_t i = 0; i < byCount.size() && colours.size() < most; ++i)
        colours += byCount[i].second | 0xff040404; // their middle
    return colours;
}

/// 256 colours are enough for a window and make a third of the bytes; a picture of many leaves gets fewer.
QByteArray pngOf(const QImage& picture)
{
    constexpr qsizetype mostColours = 256, leastColours = 16;
    const QList<QRgb> colours = commonColours(picture, mostColours);
    QByteArray bytes;
    for (qsizetype count = mostColours; count >= leastColours; count /= 2) {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly | QIODevice::Truncate);
        picture
            .convertToFormat(QImage::Format_Indexed8, colours.mid(0, count),
                             Qt::ThresholdDither | Qt::AvoidDither)
            .save(&buffer, "PNG", 0);
        if (bytes.size() <= largestFile)
            break;
    }
    return bytes;
}

} // namespace

class TestHandbookPictures : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    test::FakeChooser m_chooser;
    std::unique_ptr<Preferences> m_preferences;
    std::unique_ptr<Language> m_language;
    std::unique_ptr<Theme> m_theme;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Recompute> m_recompute;
    std::unique_ptr<MainWindow> m_window;
    QString m_folder; ///< of the pictures of this language; empty: they are not kept

    Viewport* view() { return m_window->viewportHost()->viewport(); }
    void raise(const char* name)
    {
        auto* dock = m_window->findChild<QDockWidget*>(QString::fromLatin1(name));
        dock->show();
        dock->raise();
    }
    bool isDrawn()
    {
        if (!m_recompute->waitForFull(patienceMs))
            return false;
        QSignalSpy drawn(view(), &Viewport::frameDrawn);
        view()->update();
        return QTest::qWaitFor([&] { return !drawn.isEmpty() && !view()->work().picture; }, patienceMs);
    }
    /// The window as it is, with \p above drawn where it stands.
    void take(const char* name, QWidget* above = nullptr)
    {
        QVERIFY2(isDrawn(), name);
        for (int depth = 0; depth < layoutDepth; ++depth) // each layout asks the one around it
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QImage picture = m_window->grab().toImage();
        if (above) {
            QPainter painter(&picture);
            painter.drawPixmap(m_window->mapFromGlobal(above->pos()), above->grab());
        }
        const QByteArray bytes = pngOf(picture);
        QVERIFY2(bytes.size() > 1000 && bytes.size() <= largestFile,
                 qPrintable(QString::number(bytes.size())));
        const QString file = QLatin1String(name) + QStringLiteral(".png");
        if (!m_folder.isEmpty()) {
            QFile out(m_folder + u'/' + file);
            QVERIFY2(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size(), name);
        }
        QVERIFY2(
            QFile::exists(QStringLiteral(":/handbook/%1/pictures/%2").arg(m_preferences->language(), file)) ||
                !m_folder.isEmpty(),
            name); // some page may show it
    }
    void set(const char* key, const ParamValue& value)
    {
        std::vector<NodeId> nodes;
        for (const Node& node : m_document->scene().nodes())
            nodes.push_back(node.id);
        QVERIFY(edit::setParam(*m_document, nodes, *findParam(key), value, 0));
    }

    void wholeWindow()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
        take("window");
        m_window->help()->showPalette();
        QTest::keyClicks(m_window->help()->palette()->findChild<QLineEdit*>(),
                         m_preferences->language() == u"fr" ? QStringLiteral("branches")
                                                            : QStringLiteral("branch"));
        take("find", m_window->help()->palette());
        m_window->help()->palette()->close();
    }
    void tenOaks()
    {
        constexpr int inRow = 5;
        constexpr double apart = 2.6;
        std::vector<Node> nodes;
        for (int i = 0; i < 2 * inRow; ++i) {
            Node node;
            node.id = NodeId(i + 1);
            node.kind = NodeKind::Tree;
            node.name = "oak " + std::to_string(i + 1);
            node.params = *presetParams("FanTree");
            node.params.grammar.stochastic = true;
            node.params.grammar.seed = i + 1;
            node.params.grammar.iterations = 6;
            node.params.foliage.leavesDensity = 3;
            node.params.foliage.applesProbability = 0.0;
            node.params.tree.translation = {apart * (i % inRow), 0.0, -apart * double(i / inRow)};
            nodes.push_back(node);
        }
        test::openNodes(*m_document, nodes);
        QVERIFY(isDrawn());
        view()->frameAll();
        take("ten-oaks");
    }
    void hillside()
    {
        std::vector<Node> nodes(5);
        constexpr NodeId scatter = 2;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].id = NodeId(i + 1);
            nodes[i].name = std::array{"Terrain", "Scatter", "Birch", "Oak", "Pine"}[i];
        }
        nodes[0].kind = NodeKind::Terrain;
        nodes[0].params.terrain.size = 90.0;
        nodes[0].params.terrain.height = 6.0;
        nodes[0].params.terrain.depth = 3.0;
        nodes[0].params.surface.color = {0.34, 0.42, 0.2};
        nodes[1].kind = NodeKind::Scatter;
        nodes[1].params.scatter.count = 260;
        nodes[1].params.scatter.spacing = 3.0;
        nodes[1].params.scatter.clusters = 0.8;
        constexpr const char* species[] = {"SilverBirch1995", "EnglishOak1995", "ScotsPine1995"};
        for (std::size_t i = 2; i < nodes.size(); ++i) {
            nodes[i].kind = NodeKind::Tree;
            nodes[i].parent = scatter;
            nodes[i].params = *presetParams(species[i - 2]);
            nodes[i].params.weberPenn.scale *= 0.45;
        }
        test::openNodes(*m_document, nodes);
        QVERIFY(isDrawn());
        view()->frameAll();
        Selection selected;
        selected.nodes = {scatter};
        m_document->setSelection(selected);
        take("hillside");
    }
    void bonsai()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
        set("grammar.iterations", std::int64_t(6));
        set("turtle.decay", 0.94);
        set("foliage.leavesCutoff", 0.0);
        raise("validationDock");
        QVERIFY(isDrawn());
        view()->frameAll();
        QTRY_COMPARE_WITH_TIMEOUT(m_window->status()->badgeState(), QStringLiteral("closed"), patienceMs);
        take("print-bonsai");
        raise("propertiesDock");
    }
    /// A limb on its way, the mouse still held.
    void bending()
    {
        QVERIFY(m_window->files()->newFromPreset(QStringLiteral("SmallTree")));
        set("grammar.iterations", std::int64_t(6));
        set("foliage.leavesCutoff", 0.0);
        QVERIFY(isDrawn());
        view()->frameAll();
        QVERIFY(isDrawn());
        const NodeId tree = m_document->scene().nodes().front().id;
        const Skeleton& skeleton = m_document->result(tree)->tree.simplified->skeleton;
        const auto longest = std::ranges::max_element(skeleton.p1, {}, [](const auto& p) { return p.x; });
        const auto branch = static_cast<std::size_t>(longest - skeleton.p1.begin());
        const glm::dvec3 middle = 0.5 * (glm::dvec3(skeleton.p0[branch]) + glm::dvec3(skeleton.p1[branch]));
        const double aspect = double(view()->width()) / view()->height();
        const glm::dvec2 ndc = *view()->camera().project(middle, aspect);
        const QPointF from(0.5 * (ndc.x + 1.0) * view()->width(), 0.5 * (1.0 - ndc.y) * view()->height());
        const QPointF to = from + QPointF(60, 110);
        const auto send = [this](QEvent::Type type, QPointF at, Qt::MouseButton button,
                                 Qt::MouseButtons held) {
            QMouseEvent event(type, at, view()->mapToGlobal(at), button, held, Qt::ControlModifier);
            QCoreApplication::sendEvent(view(), &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!view()->work().pick, patienceMs);
        send(QEvent::MouseMove, 0.5 * (from + to), Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_document->isModified(), patienceMs);
        take("bend-limb");
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
    void fromBlender()
    {
        QVERIFY(m_window->files()->newFromDemo(QStringLiteral("MovingTree")));
        raise("keysDock");
        m_window->keyModel()->setAllNodes(true);
        QVERIFY(isDrawn());
        view()->frameAll();
        take("blender-and-back");
        m_window->keyModel()->setAllNodes(false);
        raise("timelineDock");
    }

private slots:
    void pictures_data()
    {
        QTest::addColumn<QString>("language");
        // That they can be taken is shown by one language.
        if (qEnvironmentVariableIsSet("RAMURE_HANDBOOK"))
            QTest::newRow("en") << QStringLiteral("en");
        QTest::newRow("fr") << QStringLiteral("fr");
    }
    void pictures()
    {
        if (!openGlAvailable())
            RAMURE_CANNOT_RUN("no OpenGL on this display");
        QFETCH(const QString, language);
        test::failOnWidgetWarning();
        QSettings().clear();
        m_folder.clear();
        if (const QString handbook = qEnvironmentVariable("RAMURE_HANDBOOK"); !handbook.isEmpty()) {
            m_folder = handbook + QLatin1String(language == u"fr" ? "/fr/pictures" : "/pictures");
            QVERIFY(QDir().mkpath(m_folder));
        }
        m_preferences = std::make_unique<Preferences>();
        m_preferences->language.set(language);
        m_preferences->theme.set(ThemeChoice::Light);
        m_language = std::make_unique<Language>(*m_preferences);
        m_theme = std::make_unique<Theme>(qApp, m_preferences.get());
        m_document = std::make_unique<Document>();
        m_recompute = std::make_unique<Recompute>(m_document.get());
        m_window = std::make_unique<MainWindow>(m_document.get(), m_recompute.get(), m_preferences.get(),
                                                &m_chooser);
        m_window->resize(windowSize);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        for (const auto step : {&TestHandbookPictures::wholeWindow, &TestHandbookPictures::tenOaks,
                                &TestHandbookPictures::hillside, &TestHandbookPictures::bonsai,
                                &TestHandbookPictures::bending, &TestHandbookPictures::fromBlender}) {
            m_document->markSaved();
            (this->*step)();
            if (QTest::currentTestFailed())
                break;
        }
        m_document->markSaved();
        m_window.reset();
        m_recompute.reset();
        m_document.reset();
        m_theme.reset();
        m_language.reset();
    }
};

RAMURE_SUITE(TestHandbookPictures)

} // namespace tst_handbook_pictures

#include "tst_handbook_pictures.moc"
