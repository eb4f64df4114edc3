// Keys in shared pages: the same as a plain list after any edits, and what is not edited is shared.
#include "core/math/random.h"
#include "core/rig/tracks/key_list.h"
#include "core/rig/tracks/track.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_key_list {

using namespace ramure;

namespace {

Key keyAt(Ticks time, double value)
{
    Key key;
    key.time = time;
    key.value = value;
    return key;
}

std::vector<Key> row(std::size_t count, Ticks step = 10)
{
    std::vector<Key> keys;
    for (std::size_t i = 0; i < count; ++i)
        keys.push_back(keyAt(Ticks(i) * step, double(i)));
    return keys;
}

void compare(const KeyList<Key>& list, const std::vector<Key>& plain)
{
    QCOMPARE(list.size(), plain.size());
    QCOMPARE(list.empty(), plain.empty());
    QVERIFY(std::equal(list.begin(), list.end(), plain.begin(), plain.end()));
    QVERIFY(list.toVector() == plain);
    bool sameTimes = true;
    for (std::size_t i = 0; i < plain.size(); ++i)
        sameTimes = sameTimes && list.timeOf(i) == plain[i].time;
    QVERIFY(sameTimes);
    std::size_t along = 0;
    while (along < list.size()) {
        const std::span<const Key> run = list.runFrom(along);
        QVERIFY(std::equal(run.begin(), run.end(), plain.begin() + std::ptrdiff_t(along)));
        along += run.size();
    }
    if (!plain.empty()) {
        QVERIFY(list.front() == plain.front());
        QVERIFY(list.back() == plain.back());
    }
    KeyList<Key> fresh;
    fresh.assign(plain);
    QVERIFY(fresh == list);
    QVERIFY(list == fresh);
}

void compareSearch(const KeyList<Key>& list, const std::vector<Key>& plain, Ticks time)
{
    const auto earlier = [](const Key& key, Ticks wanted) { return key.time < wanted; };
    const auto at = std::lower_bound(plain.begin(), plain.end(), time, earlier) - plain.begin();
    QCOMPARE(list.lowerBound(time), std::size_t(at));
    const auto behind = std::lower_bound(plain.begin(), plain.end(), time + 1, earlier) - plain.begin();
    QCOMPARE(list.upperBound(double(time)), std::size_t(behind));
    QCOMPARE(list.upperBound(double(time) + 0.5), std::size_t(behind));
}

} // namespace

class TestKeyList : public QObject
{
    Q_OBJECT
private slots:
    void anEmptyListHasNothing()
    {
        KeyList<Key> list;
        compare(list, {});
        QCOMPARE(list.lowerBound(0), std::size_t(0));
        QCOMPARE(list.upperBound(0.0), std::size_t(0));
        list.splice(0, 0, {});
        list.assign({});
        list.overwrite(0, {});
        compare(list, {});
        const std::vector<Key> keys = row(3);
        list.splice(0, 0, keys);
        compare(list, keys);
        list.splice(0, 3, {});
        compare(list, {});
    }
    void searchesFindWhatAPlainListFinds()
    {
        for (const std::size_t count : {1U, 2U, 511U, 512U, 513U, 1024U, 5000U}) {
            const std::vector<Key> keys = row(count);
            KeyList<Key> list;
            list.assign(keys);
            compare(list, keys);
            for (const Ticks time : {Ticks(-1), Ticks(0), Ticks(1), Ticks(count) * 5, Ticks(count) * 5 + 3,
                                     Ticks(count) * 10 - 10, Ticks(count) * 10})
                compareSearch(list, keys, time);
        }
    }
    void anyEditsGiveWhatAPlainListGives()
    {
        Random random(11, RandomStream::Test);
        for (int round = 0; round < 8; ++round) {
            std::vector<Key> plain = row(random.below(4000), 100);
            KeyList<Key> list;
            list.assign(plain);
            for (int edit = 0; edit < 40; ++edit) {
                const auto size = std::uint32_t(plain.size());
                const std::size_t first = random.below(size + 1);
                const std::size_t most = random.below(5) == 0 ? 1500 : 3;
                const std::size_t last =
                    std::min<std::size_t>(size, first + random.below(std::uint32_t(most)));
                const KeyList<Key> before = list;
                const std::vector<Key> plainBefore = plain;
                const auto from = plain.begin() + std::ptrdiff_t(first),
                           to = plain.begin() + std::ptrdiff_t(last);
                if (random.below(2) == 0) {
                    std::vector<Key> changed(from, to);
                    for (Key& key : changed)
                        key.value += random.range(-1.0, 1.0);
                    std::copy(changed.begin(), changed.end(), from);
                    list.overwrite(first, changed);
                } else {
                    // The times of the others need not fit: nothing is searched here.
                    const std::vector<Key> added = row(random.below(std::uint32_t(most)));
                    plain.insert(plain.erase(from, to), added.begin(), added.end());
                    list.splice(first, last, added);
                }
                compare(list, plain);
                QCOMPARE(list == before, plain == plainBefore);
                QVERIFY(before.toVector() == plainBefore); // copies stay as they were
            }
        }
    }
    void scatteredKeysAreChangedInTheirPlaces()
    {
        Random random(12, RandomStream::Test);
        std::vector<Key> plain = row(3000);
        KeyList<Key> list;
        list.assign(plain);
        std::vector<std::size_t> indices;
        std::vector<Key> changed;
        for (std::size_t i = random.below(50); i < plain.size(); i += 1 + random.below(700)) {
            indices.push_back(i);
            plain[i].value = -1.0;
            plain[i].time += 3;
            changed.push_back(plain[i]);
        }
        list.overwrite(indices, changed);
        compare(list, plain);
    }
    void whatIsNotEditedIsShared()
    {
        const std::vector<Key> keys = row(100'000);
        KeyList<Key> list;
        list.assign(keys);
        const auto shared = [](const KeyList<Key>& a, const KeyList<Key>& b) {
            std::size_t same = 0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                const Ticks time = a[i].time;
                const std::size_t other = b.lowerBound(time);
                same += other < b.size() && &b[other] == &a[i] ? 1 : 0;
            }
            return same;
        };
        constexpr std::size_t most = 2 * KeyList<Key>::mostInPage;
        KeyList<Key> other = list;
        QCOMPARE(shared(list, other), keys.size());
        other.splice(50'000, 50'001, {});
        QVERIFY(shared(list, other) >= keys.size() - most);
        const Key inserted = keyAt(777'777, 5.0);
        other.splice(other.lowerBound(777'777), other.lowerBound(777'777),
                     std::span<const Key>(&inserted, 1));
        QVERIFY(shared(list, other) >= keys.size() - 2 * most);
        other = list;
        std::vector<Key> all = keys;
        all[12'345].value = 0.5;
        other.assign(all);
        QVERIFY(shared(list, other) >= keys.size() - most);
    }
    /// Edits of a track go by these pages: the result does not depend on how it was reached.
    void longTracksAreEditedAsShortOnesAre()
    {
        Random random(13, RandomStream::Test);
        std::vector<Key> keys = row(2500, ticksPerSecond / 24);
        for (Key& key : keys) {
            key.value = random.range(-1.0, 1.0);
            key.mode = KeyMode::Bezier;
            key.before = key.behind = random.below(3) == 0 ? HandleType::Auto : HandleType::AutoClamped;
        }
        Track track = *Track::fromKeys(keys);
        for (int edit = 0; edit < 40; ++edit) {
            std::vector<Key> all = track.keys().toVector();
            std::vector<std::size_t> gone;
            for (std::uint32_t k = 1 + random.below(20); k-- > 0;)
                gone.push_back(random.below(std::uint32_t(all.size() + 3)));
            track.erase(gone);
            std::vector<Key> left;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (std::find(gone.begin(), gone.end(), i) == gone.end())
                    left.push_back(all[i]);
            QVERIFY(track == *Track::fromKeys(left));
            const auto which = std::size_t(random.below(std::uint32_t(track.size())));
            Key thrown = track.keys()[which];
            thrown.time = Ticks(random.below(2600)) * ticksPerSecond / 24 + Ticks(random.below(2));
            left = track.keys().toVector();
            left.erase(left.begin() + std::ptrdiff_t(which));
            std::erase_if(left, [&](const Key& key) { return key.time == thrown.time; });
            left.push_back(thrown);
            const std::vector<std::size_t> indices{which};
            QVERIFY(track.replace(indices, std::span<const Key>(&thrown, 1)));
            QVERIFY(track == *Track::fromKeys(left));
        }
    }
    /// A curve that stops going round settles at both its ends.
    void aRoundThatIsOpenedIsSmoothLikeAnyOther()
    {
        std::vector<Key> keys;
        for (int i = 0; i <= 8; ++i) {
            keys.push_back(keyAt(i * ticksPerSecond, i % 8 == 0 ? 0.0 : std::sin(double(i))));
            keys.back().mode = KeyMode::Bezier;
            keys.back().before = keys.back().behind = HandleType::Auto;
        }
        const auto round = [&] {
            Track track = *Track::fromKeys(keys);
            track.loop = 8 * ticksPerSecond;
            track.settleEnds();
            return track;
        };
        QVERIFY(round().goesRound());
        const auto verify = [](const Track& track) {
            QVERIFY(!track.goesRound());
            Track plain = *Track::fromKeys(track.keys().toVector());
            QVERIFY(plain.keys() == track.keys());
        };
        Track track = round();
        const std::vector<std::size_t> last{8};
        track.erase(last);
        verify(track);
        track = round();
        Key moved = track.keys().back();
        moved.time += ticksPerSecond / 2;
        QVERIFY(track.replace(last, std::span<const Key>(&moved, 1)));
        verify(track);
        track = round();
        QVERIFY(track.insert(keyAt(9 * ticksPerSecond, 1.0)));
        verify(track);
    }
};

RAMURE_SUITE(TestKeyList)

} // namespace tst_key_list

#include "tst_key_list.moc"
