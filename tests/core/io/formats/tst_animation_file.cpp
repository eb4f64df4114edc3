#include "core/io/formats/text/animation_file.h"
#include "core/math/random.h"
#include "tests/support/suite.h"

namespace tst_animation_file {

using namespace ramure;

static Expected<AnimationFile> parsed(std::string_view text, CubicMeaning cubic = CubicMeaning::Automatic)
{
    return parseAnimation(text, "x.animation", cubic);
}

static const Track& numbers(const AnimationFile& file, ChannelPart part, std::uint8_t component)
{
    return std::get<Track>(*file.animation.find({part, component, 0}));
}

static const OrientationTrack& turns(const AnimationFile& file)
{
    return std::get<OrientationTrack>(*file.animation.find({ChannelPart::GlobalOrientation, 0, 0}));
}

static bool notes(const AnimationFile& file, const char* part)
{
    return std::any_of(file.notes.begin(), file.notes.end(), [part](const Note& note) {
        return note.message().find(part) != std::string::npos && note.file == "x.animation";
    });
}

static const std::string rest = ",0,0,0,0,0,0,1,1,1,1\n";

class TestAnimationFile : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badLinesAreRefusedWithTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::newRow("too few columns") << QByteArray("0,LINEAR,0,0,0,0,0,0,1,1,1,1\n1,LINEAR,0,0\n") << 2;
        QTest::newRow("decimal commas") << QByteArray("0,5,LINEAR,0,0,0,0,0,0,1,1,1,1\n") << 1;
        QTest::newRow("nan") << QByteArray("0,LINEAR,nan,0,0,0,0,0,1,1,1,1\n") << 1;
        QTest::newRow("inf") << QByteArray("0,LINEAR,0,0,0,0,0,0,1,inf,1,1\n") << 1;
        QTest::newRow("no number") << QByteArray("0,LINEAR,a,0,0,0,0,0,1,1,1,1\n") << 1;
        QTest::newRow("empty cell") << QByteArray("0,LINEAR,,0,0,0,0,0,1,1,1,1\n") << 1;
        QTest::newRow("time") << QByteArray("1e300,LINEAR,0,0,0,0,0,0,1,1,1,1\n") << 1;
        QTest::newRow("zero quaternion") << QByteArray("\n0,LINEAR,0,0,0,0,0,0,0,1,1,1\n") << 2;
        QTest::newRow("columns of ours") << QByteArray("0,LINEAR,0,0,0,0,0,0,1,1,1,1,AUTO,1,1,1\n") << 1;
        QTest::newRow("rate") << QByteArray("# fps=many\n") << 1;
    }
    void badLinesAreRefusedWithTheirPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        const auto file = parsed(text.toStdString());
        QVERIFY(!file);
        QCOMPARE(file.error().line, line);
        QCOMPARE(file.error().file, std::string("x.animation"));
    }
    void anEmptyFileDoesNotMove()
    {
        for (const char* text : {"", "\n\n", "\xEF\xBB\xBF", "# nothing\r\n"}) {
            const auto file = parsed(text);
            QVERIFY2(file, test::why(file));
            QVERIFY(file->animation.empty());
            QVERIFY(notes(*file, "no keys"));
        }
    }
    void markAndLineEndsDoNotMatter()
    {
        const auto plain = parsed("0,LINEAR" + rest + "1,LINEAR" + rest);
        const auto odd =
            parsed("\xEF\xBB\xBF 0 , LINEAR,0,0,0, 0,0,0,1,1,1,+1 \r\n\r\n1,LINEAR,0,0,0,0,0,0,1,1,1,1");
        QVERIFY2(plain && odd, test::why(odd));
        QVERIFY(plain->animation == odd->animation);
    }
    void zUpBecomesYUp()
    {
        const auto file = parsed("0.5,LINEAR,1,2,3,0.5,0.1,0.2,0.8366600265340756,4,5,6\n");
        QVERIFY2(file, test::why(file));
        const auto at = [&](ChannelPart part) {
            return glm::dvec3(valueAt(numbers(*file, part, 0), 0.5), valueAt(numbers(*file, part, 1), 0.5),
                              valueAt(numbers(*file, part, 2), 0.5));
        };
        QVERIFY(at(ChannelPart::GlobalTranslation) == glm::dvec3(1.0, 3.0, -2.0));
        QVERIFY(at(ChannelPart::GlobalScale) == glm::dvec3(4.0, 6.0, 5.0));
        const glm::dquat q = valueAt(turns(*file), 0.5);
        QVERIFY(std::abs(q.w - 0.83666003) + std::abs(q.x - 0.5) + std::abs(q.y - 0.2) + std::abs(q.z + 0.1) <
                1e-7);
    }
    void keysAreSortedAndTheLastOfTwoCounts()
    {
        const auto file = parsed("2,LINEAR,2,0,0,0,0,0,1,1,1,1\n-1,LINEAR,1,0,0,0,0,0,1,1,1,1\n"
                                 "2,LINEAR,3,0,0,0,0,0,1,1,1,1\n");
        QVERIFY2(file, test::why(file));
        QCOMPARE(file->keyCount, std::size_t(2));
        QCOMPARE(valueAt(numbers(*file, ChannelPart::GlobalTranslation, 0), 2.0), 3.0);
        QCOMPARE(valueAt(numbers(*file, ChannelPart::GlobalTranslation, 0), -1.0), 1.0);
        QVERIFY(notes(*file, "not in order"));
        QVERIFY(notes(*parsed("1,LINEAR" + rest + "1,LINEAR" + rest), "at one time"));
    }
    void unknownModesAreTheSpline()
    {
        const auto file = parsed("0,WOBBLE" + rest + "1,WOBBLE" + rest);
        QVERIFY2(file, test::why(file));
        QVERIFY(numbers(*file, ChannelPart::GlobalScale, 0).keys()[0].mode == KeyMode::Cubic);
        QVERIFY(notes(*file, "WOBBLE"));
        QCOMPARE(file->notes.size(), std::size_t(1)); // said once
    }
    void whatCubicMeansIsSaid()
    {
        const std::string text = "0,CUBIC" + rest + "1,CUBIC" + rest;
        const auto modeOf = [](const Expected<AnimationFile>& file) {
            return numbers(*file, ChannelPart::GlobalScale, 0).keys()[0].mode;
        };
        QVERIFY(modeOf(parsed(text)) == KeyMode::Cubic);
        QVERIFY(notes(*parsed(text), "CUBIC"));
        QVERIFY(modeOf(parsed(text, CubicMeaning::Easing)) == KeyMode::CubicEase);
        QVERIFY(modeOf(parsed("# ramure-animation 1\n" + text)) == KeyMode::CubicEase);
        QVERIFY(modeOf(parsed("# ramure-animation 1\n" + text, CubicMeaning::Spline)) == KeyMode::Cubic);
    }
    void quaternionsBecomeUnits()
    {
        const auto file = parsed("0,LINEAR,0,0,0,0,0,3,4,1,1,1\n1,LINEAR,0,0,0,0,0,-0.6,-0.8,1,1,1\n");
        QVERIFY2(file, test::why(file));
        QVERIFY(notes(*file, "no unit"));
        const glm::dquat q = valueAt(turns(*file), 0.5); // the same turn with the other sign: it stays
        QVERIFY(std::abs(std::abs(q.w) - 0.8) < 1e-12 && std::abs(std::abs(q.y) - 0.6) < 1e-12);
    }
    void negativeAndZeroScalesAreKept()
    {
        const auto file = parsed("0,LINEAR,0,0,0,0,0,0,1,-1,0,1\n");
        QVERIFY2(file, test::why(file));
        QCOMPARE(valueAt(numbers(*file, ChannelPart::GlobalScale, 0), 0.0), -1.0);
        QCOMPARE(valueAt(numbers(*file, ChannelPart::GlobalScale, 2), 0.0), 0.0);
    }
    void aLoopThatJumpsIsSaid()
    {
        const std::string text = "# ramure-animation 1\n# loop=2\n0,LINEAR" + rest;
        QVERIFY(notes(*parsed(text + "2,LINEAR,1,0,0,0,0,0,1,1,1,1\n"), "loop jumps"));
        const auto fine = parsed(text + "1,LINEAR,1,0,0,0,0,0,1,1,1,1\n2,LINEAR" + rest);
        QVERIFY(!notes(*fine, "loop jumps"));
        QCOMPARE(valueAt(numbers(*fine, ChannelPart::GlobalTranslation, 0), 11.0), 1.0);
    }
    void hundredThousandKeys()
    {
        std::string text;
        for (int i = 0; i < 100'000; ++i)
            text += std::to_string(i) + ",BEZIER," + std::to_string(i % 7) + ",0,0,0,0,0,1,1,1,1\n";
        const auto file = parsed(text);
        QVERIFY2(file, test::why(file));
        QCOMPARE(file->keyCount, std::size_t(100'000));
        QCOMPARE(valueAt(numbers(*file, ChannelPart::GlobalTranslation, 0), 99'999.0), 99'999 % 7 + 0.0);
    }
    void whatIsWrittenReadsBackAsTheSame()
    {
        Random random(1, RandomStream::Test);
        for (int run = 0; run < 100; ++run) {
            const int count = 1 + int(random.below(6));
            std::vector<KeyShape> shapes;
            for (int i = 0; i < count; ++i) {
                KeyShape shape;
                shape.time = ticksOf(i + random.range(0.0, 0.9));
                do
                    shape.mode = static_cast<KeyMode>(random.below(keyModeCount));
                while (shape.mode == KeyMode::Cubic); // the format has no word for the spline
                shape.easing = static_cast<Easing>(random.below(easingCount));
                shape.before = shape.behind = HandleType::Free;
                shape.period = random.range(0.0, 2.0);
                shapes.push_back(shape);
            }
            const auto handle = [&] { return Handle{random.range(0.0, 0.5), random.range(-1.0, 1.0)}; };
            const auto fill = [&](auto track, auto&& value) {
                using KeyType = typename decltype(track)::KeyKind;
                std::vector<KeyType> keys;
                for (const KeyShape& shape : shapes) {
                    KeyType key;
                    static_cast<KeyShape&>(key) = shape;
                    value(key);
                    keys.push_back(key);
                }
                return AnyTrack(*decltype(track)::fromKeys(keys));
            };
            NodeAnimation animation;
            for (const ChannelPart part : {ChannelPart::GlobalTranslation, ChannelPart::GlobalScale})
                for (std::uint8_t c = 0; c < 3; ++c)
                    animation.set({part, c, 0}, fill(Track(), [&](Key& key) {
                                      key.value = random.range(-5.0, 5.0);
                                      key.in = {-handle().dt, handle().dv};
                                      key.out = handle();
                                  }));
            AnyTrack turn = fill(OrientationTrack(), [&](OrientationKey& key) {
                key.value = {random.range(0.2, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0), 0.3};
                for (std::size_t c = 0; c < 4; ++c) {
                    key.in[c] = {-handle().dt, handle().dv};
                    key.out[c] = handle();
                }
            });
            std::get<OrientationTrack>(turn).blend = OrientationBlend::Components;
            animation.set({ChannelPart::GlobalOrientation, 0, 0}, std::move(turn));
            bool baked = true;
            const std::string text = animationText(animation, 30.0, "Big parent", &baked);
            QVERIFY(!baked);
            const auto back = parsed(text);
            QVERIFY2(back, test::why(back));
            QCOMPARE(back->parent, std::string("Big parent"));
            QCOMPARE(back->framesPerSecond, 30.0);
            for (int i = 0; i < 40; ++i) {
                const double t = random.range(-1.0, count + 1.0);
                const glm::dmat4 a = transformAt(animation, ChannelPart::GlobalTranslation, t);
                const glm::dmat4 b = transformAt(back->animation, ChannelPart::GlobalTranslation, t);
                for (int c = 0; c < 4; ++c)
                    QVERIFY(glm::length(a[c] - b[c]) < 1e-9);
            }
        }
    }
    void channelsThatDifferAreSampled()
    {
        NodeAnimation animation;
        Key a, b;
        b.time = ticksPerSecond;
        b.value = 2.0;
        animation.set({ChannelPart::GlobalTranslation, 0, 0}, AnyTrack(*Track::fromKeys({a, b})));
        b.time = 2 * ticksPerSecond;
        animation.set({ChannelPart::GlobalTranslation, 1, 0}, AnyTrack(*Track::fromKeys({a, b})));
        bool baked = false;
        const auto back = parsed(animationText(animation, 24.0, {}, &baked));
        QVERIFY(baked);
        QVERIFY2(back, test::why(back));
        for (int frame = 0; frame <= 48; ++frame) {
            const glm::dmat4 is = transformAt(back->animation, ChannelPart::GlobalTranslation, frame / 24.0);
            const glm::dmat4 was = transformAt(animation, ChannelPart::GlobalTranslation, frame / 24.0);
            QVERIFY(glm::length(is[3] - was[3]) < 1e-9);
        }
    }
};

RAMURE_SUITE(TestAnimationFile)

} // namespace tst_animation_file

#include "tst_animation_file.moc"
