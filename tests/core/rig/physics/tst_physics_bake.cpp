#include "core/rig/physics/physics_bake.h"
#include "tests/core/rig/physics/physics_support.h"
#include "tests/support/suite.h"
#include <QFile>
#include <QTemporaryDir>

namespace tst_physics_bake {

using namespace ramure;

class TestPhysicsBake : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    std::shared_ptr<const TreeBody> m_body = test::presetTree("TinyTree").body();

    [[nodiscard]] QString name(const char* file) const { return m_folder.filePath(QLatin1String(file)); }
    [[nodiscard]] std::string path(const char* file) const { return name(file).toStdString(); }
    [[nodiscard]] QByteArray bytes(const char* file) const
    {
        QFile in(name(file));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    void write(const char* file, const QByteArray& content) const
    {
        QFile out(name(file));
        if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
            qFatal("cannot write");
    }
    /// Loads and says the error; the cache stays as it was.
    Error refused(const char* file)
    {
        PhysicsCache cache(m_body, {});
        if (!cache.seek(25))
            qFatal("seek");
        const PhysicsState before = cache.state();
        const auto loaded = loadBake(cache, path(file));
        if (loaded)
            qWarning("loaded");
        if (!test::sameBits(cache.state(), before) || cache.stateOf(25) != StepState::Cached)
            qWarning("the cache is another");
        return loaded ? Error() : loaded.error();
    }
    PhysicsCache& busyCache(PhysicsCache& cache)
    {
        PhysicsParams params;
        params.mode = PhysicsMode::Faithful;
        cache.setParams(params, 100);
        cache.setPull(Pull{2, 0.5, {1.0, 2.0, 3.0}, 1.0}, 30);
        cache.setPull(std::nullopt, 60);
        cache.shakeOff(1, 40);
        return cache;
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badFilesAreRefused()
    {
        PhysicsCache cache(m_body, {});
        QVERIFY(saveBake(busyCache(cache), 123, path("good")));
        const QByteArray good = bytes("good");
        QCOMPARE(refused("none").code, ErrorCode::Io);
        QCOMPARE(refused("none").file, path("none"));
        QCOMPARE(refused(".").code, ErrorCode::Io);
        write("bad", {});
        QCOMPARE(refused("bad").code, ErrorCode::Syntax);
        write("bad", "RAMRPHYT" + good.mid(8));
        QVERIFY(refused("bad").message().ends_with("not a file of baked motion"));
        QByteArray newer = good;
        newer[8] = 3;
        write("bad", newer);
        QCOMPARE(refused("bad").code, ErrorCode::Version);
        for (const qsizetype length : {qsizetype(8), qsizetype(16), qsizetype(24), qsizetype(32),
                                       qsizetype(1000), good.size() - 8, good.size() - 1}) {
            write("bad", good.left(length));
            QCOMPARE(refused("bad").code, ErrorCode::Syntax);
        }
        write("bad", good + "x");
        QCOMPARE(refused("bad").code, ErrorCode::Syntax);
        Random random(1, RandomStream::Test);
        for (int i = 0; i < 200; ++i) {
            QByteArray damaged = good;
            const auto at = 24 + qsizetype(random.below(std::uint32_t(good.size() - 24)));
            damaged[at] = char(damaged[at] ^ char(1 << random.below(8)));
            write("bad", damaged);
            QVERIFY(refused("bad").message().find("checksum") != std::string::npos);
        }
    }

    /// Values that cannot be, under a checksum that is right.
    void impossibleValuesAreRefused()
    {
        PhysicsCache cache(m_body, {});
        QVERIFY(saveBake(busyCache(cache), 123, path("good")));
        const QByteArray good = bytes("good");
        Random random(2, RandomStream::Test);
        int refusals = 0;
        for (int i = 0; i < 400; ++i) {
            QByteArray other = good;
            const auto words = (good.size() - 32) / 8;
            auto* data = reinterpret_cast<std::uint64_t*>(other.data()) + 3;
            const std::uint64_t wild[] = {
                0, 1, 7, ~std::uint64_t(0), std::uint64_t(1) << 40, 0x7FF0000000000000ull};
            // Mostly in the first words: counts and steps stand there.
            const auto at = i % 2 == 0 ? random.below(80) : random.below(std::uint32_t(words));
            data[at] = wild[random.below(6)];
            std::uint64_t sum = 2;
            for (qsizetype w = 0; w < words; ++w)
                sum = mixBits(sum * 0x9E3779B97F4A7C15ull + data[w] + 1);
            data[words] = sum;
            write("bad", other);
            PhysicsCache into(m_body, {});
            const auto loaded = loadBake(into, path("bad"));
            refusals += !loaded;
            if (loaded) {
                QVERIFY(into.seek(124));
                QVERIFY(test::allFinite(into.state()));
            }
        }
        QVERIFY2(refusals > 150, QByteArray::number(refusals));
    }

    /// Version 1 lacks the last word of each set of parameters; its trees started unloaded.
    void theOldVersionIsRead()
    {
        PhysicsParams params;
        params.settled = false;
        PhysicsCache cache(m_body, params);
        QVERIFY(saveBake(cache, 123, path("new")));
        const QByteArray now = bytes("new");
        std::vector<std::uint64_t> words(std::size_t(now.size()) / 8);
        std::memcpy(words.data(), now.data(), std::size_t(now.size()));
        // Head 3, tree 2, checkpoints, changes, step, then the parameters in one word each.
        std::size_t fields = 0;
        visitFields(params, [&fields](const auto&) { ++fields; });
        words.erase(words.begin() + 8 + std::ptrdiff_t(fields) - 1);
        words[1] = 1;
        --words[2];
        words.back() = 1;
        for (std::size_t i = 3; i + 1 < words.size(); ++i)
            words.back() = mixBits(words.back() * 0x9E3779B97F4A7C15ull + words[i] + 1);
        write("old", {reinterpret_cast<const char*>(words.data()), qsizetype(words.size() * 8)});
        QVERIFY(readBakeLabel(path("old"))->params == params);
        PhysicsCache into(m_body, {});
        QVERIFY(!loadBake(into, PhysicsParams(), path("old")));
        QVERIFY(loadBake(into, params, path("old")));
        QVERIFY(into.script() == cache.script());
        QCOMPARE(into.stateOf(123), StepState::Cached);
        QVERIFY(into.seek(123));
        QVERIFY(test::sameBits(into.state(), cache.state()));
    }

    void anotherTreeIsRefused()
    {
        PhysicsCache cache(test::presetTree("TinyTree").body(false), {});
        QVERIFY(saveBake(cache, 20, path("bare")));
        QVERIFY(refused("bare").message().find("another tree") != std::string::npos);
    }

    void unwritablePlacesAreRefused()
    {
        PhysicsCache cache(m_body, {});
        const auto saved = saveBake(cache, 1'000'000, path("none/x"));
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::Io);
        QCOMPARE(cache.step(), 0); // found before the long work
    }

    void cancelledSavesLeaveTheOldFile()
    {
        write("old", "old");
        PhysicsCache cache(m_body, {});
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(saveBake(cache, 100, path("old"), {stop.get_token(), {}}).error().code,
                 ErrorCode::Cancelled);
        QCOMPARE(bytes("old"), QByteArray("old"));
    }

    void comesBackBitByBit()
    {
        PhysicsCache cache(m_body, {});
        QVERIFY(saveBake(busyCache(cache), 333, path("run")));
        PhysicsCache back(m_body, test::faithful());
        const auto loaded = loadBake(back, path("run"));
        QVERIFY2(loaded, test::why(loaded));
        QVERIFY(back.script() == cache.script());
        QCOMPARE(back.ranges(0, 400),
                 (std::vector<StepRange>{{0, 333, StepState::Cached}, {334, 400, StepState::Missing}}));
        Random random(3, RandomStream::Test);
        for (int i = 0; i < 50; ++i) {
            const int step = int(random.below(400));
            QVERIFY(back.seek(step) && cache.seek(step));
            QVERIFY(test::sameBits(back.state(), cache.state()));
        }
        QVERIFY(saveBake(back, 333, path("again")));
        QCOMPARE(bytes("again"), bytes("run"));
    }
};

RAMURE_SUITE(TestPhysicsBake)

} // namespace tst_physics_bake

#include "tst_physics_bake.moc"
