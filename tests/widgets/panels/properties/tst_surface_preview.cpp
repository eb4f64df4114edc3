// What a leaf, a fruit and a bark look like, beside the numbers that make them.
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/properties/surface_pictures.h"
#include "widgets/panels/properties/surface_preview.h"
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

namespace tst_surface_preview {

using namespace ramure;

namespace {

constexpr int size = 64;

/// Share of the pixels that show something.
double covered(const QImage& picture)
{
    int opaque = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            opaque += qAlpha(picture.pixel(x, y)) > 0 ? 1 : 0;
    return double(opaque) / (picture.width() * picture.height());
}

} // namespace

class TestSurfacePreview : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }

    void everyLeafIsShown()
    {
        QSet<QByteArray> seen;
        for (int shape = 0; shape < leafShapeCount; ++shape) {
            LeafParams leaf;
            leaf.shape = static_cast<LeafShape>(shape);
            const QImage picture = leafPicture(leaf, false, size);
            QCOMPARE(picture.size(), QSize(size, size));
            QVERIFY2(covered(picture) > 0.01 && covered(picture) < 0.95, qPrintable(QString::number(shape)));
            QCOMPARE(leafPicture(leaf, false, size), picture);
            seen.insert(
                QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
        }
        QCOMPARE(seen.size(), qsizetype{leafShapeCount});
        LeafParams flat;
        flat.shape = LeafShape::Maple;
        QVERIFY(leafPicture(flat, true, size) != leafPicture(flat, false, size)); // autumn
        flat.width = 0.0;
        QCOMPARE(covered(leafPicture(flat, false, size)), 0.0); // nothing to see, and nothing breaks
    }

    void everyFruitIsShown()
    {
        QSet<QByteArray> seen;
        for (int kind = 0; kind < fruitKindCount; ++kind) {
            FruitParams fruit;
            fruit.kind = static_cast<FruitKind>(kind);
            const QImage picture = fruitPicture(fruit, size);
            QCOMPARE(picture.size(), QSize(size, size));
            QVERIFY2(covered(picture) > 0.01 && covered(picture) < 0.95, qPrintable(QString::number(kind)));
            QCOMPARE(fruitPicture(fruit, size), picture);
            seen.insert(
                QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
        }
        QCOMPARE(seen.size(), qsizetype{fruitKindCount});
        FruitParams apple;
        apple.kind = FruitKind::Apple;
        const QImage before = fruitPicture(apple, size);
        apple.stalk = 2.0;
        QVERIFY(covered(fruitPicture(apple, size)) < covered(before)); // smaller beside its long stalk
        apple.size = 0.0;
        fruitPicture(apple, size); // nothing breaks
    }

    void everyBarkIsShown()
    {
        for (int family = 0; family <= static_cast<int>(BarkFamily::Ribbed); ++family) {
            BarkParams bark;
            bark.family = static_cast<BarkFamily>(family);
            const QImage picture = barkPicture(barkMaterial(bark), size);
            QCOMPARE(picture.size(), QSize(2 * size, size));
            QCOMPARE(qAlpha(picture.pixel(0, 0)), 0); // beside the ball
            QCOMPARE(qAlpha(picture.pixel(size / 2, size / 2)), 255);
            QCOMPARE(qAlpha(picture.pixel(3 * size / 2, size / 2)), 255);
            // Lit from the upper left.
            const auto light = [&](int left, int top) {
                int sum = 0;
                for (int y = top; y < top + size / 4; ++y)
                    for (int x = left; x < left + size / 4; ++x)
                        sum += qGray(picture.pixel(x, y));
                return sum;
            };
            QVERIFY(light(size / 4, size / 4) > light(size / 2, size / 2));
        }
        std::stop_source stop;
        stop.request_stop();
        BarkParams bark;
        bark.family = BarkFamily::Furrowed;
        QVERIFY(barkPicture(barkMaterial(bark), 1024, {stop.get_token(), {}}).isNull());
    }

    void theySeeWhatIsChosen()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(*presetParams("TinyTree"));
        using Surface = SurfacePreview::Surface;
        for (const auto surface : {Surface::Leaf, Surface::Fruit, Surface::Bark}) {
            QWidget window;
            auto* preview = new SurfacePreview(&trees.document(), surface, &window);
            window.show();
            QVERIFY(preview->isHidden());
            preview->setNode(tree);
            QVERIFY(preview->isVisible());
            QTRY_VERIFY(!preview->picture().isNull());
            const QImage before = preview->picture();
            const auto set = [&](const char* key, ParamValue value) {
                return edit::setParam(trees.document(), {tree}, *findParam(key), std::move(value))
                    .has_value();
            };
            QVERIFY(surface == Surface::Leaf    ? set("foliage.leafFold", 1.0)
                    : surface == Surface::Fruit ? set("foliage.fruit", EnumValue{"pear"})
                                                : set("bark.moss", 0.8));
            QTRY_VERIFY(preview->picture() != before);
            trees.document().undo();
            QTRY_VERIFY(preview->picture() == before);
            preview->setNode(noNode);
            QVERIFY(preview->isHidden());
        }
    }
    void theyShowPicturesOfFiles()
    {
        QTemporaryDir folder;
        QImage blue(32, 32, QImage::Format_RGB32);
        blue.fill(Qt::blue);
        const QString file = folder.filePath(QStringLiteral("blue.png"));
        QVERIFY(blue.save(file));
        PictureParams pictures;
        pictures.colour = QFile::encodeName(file).toStdString();
        for (const auto shape : {LeafShape::Faithful, LeafShape::Birch}) {
            LeafParams leaf;
            leaf.shape = shape;
            const QColor middle = leafPicture(leaf, false, 64, pictures).pixelColor(32, 36);
            QVERIFY(middle.blue() > 80 && middle.red() < 30 && middle.green() < 30);
        }
        for (const auto kind : {FruitKind::Faithful, FruitKind::Apple}) {
            FruitParams fruit;
            fruit.kind = kind;
            const QColor middle = fruitPicture(fruit, 64, pictures).pixelColor(30, 40);
            QVERIFY(middle.blue() > 80 && middle.red() < 30 && middle.green() < 30);
        }
        const QImage ball = barkPicture(barkMaterial({}, pictures), 64);
        QVERIFY(ball.pixelColor(32, 32).blue() > 80 && ball.pixelColor(96, 32).blue() > 80);
        pictures.colour += ".gone";
        const QImage checks = barkPicture(barkMaterial({}, pictures), 64);
        int magenta = 0;
        for (int x = 64; x < 128; ++x)
            magenta += checks.pixelColor(x, 32).red() > 100 && checks.pixelColor(x, 32).green() < 30 ? 1 : 0;
        QVERIFY(magenta > 16 && magenta < 48);
    }
    void onlyALeafHasALargerView()
    {
        test::TreeDocument trees;
        const SurfacePreview bark(&trees.document(), SurfacePreview::Surface::Bark, nullptr);
        QVERIFY(!bark.largerButton());
        SurfacePreview leaf(&trees.document(), SurfacePreview::Surface::Leaf, nullptr);
        QSignalSpy asked(&leaf, &SurfacePreview::largerRequested);
        leaf.setNode(trees.add(*presetParams("TinyTree")));
        leaf.show();
        QTest::mouseClick(leaf.largerButton(), Qt::LeftButton);
        QTest::mouseDClick(&leaf, Qt::LeftButton, {}, {5, 5});
        QCOMPARE(asked.size(), 2);
    }
};

RAMURE_SUITE(TestSurfacePreview)

} // namespace tst_surface_preview

#include "tst_surface_preview.moc"
