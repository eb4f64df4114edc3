#include "core/base/stream_copy.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <vector>

namespace tst_stream_copy {

using namespace ramure;

class TestStreamCopy : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void copiesFromAnywhereToAnywhere();
};

void TestStreamCopy::copiesFromAnywhereToAnywhere()
{
    constexpr std::size_t room = 160;
    std::vector<unsigned char> source(room);
    for (std::size_t i = 0; i < room; ++i)
        source[i] = static_cast<unsigned char>(i + 1);
    for (std::size_t from = 0; from < 17; ++from)
        for (std::size_t to = 0; to < 17; ++to)
            for (std::size_t bytes = 0; bytes < 100; ++bytes) {
                std::vector<unsigned char> wanted(room, 0), got(room, 0);
                std::copy_n(&source[from], bytes, &wanted[to]);
                streamCopy(&got[to], &source[from], bytes);
                endStreamCopies();
                QVERIFY(got == wanted); // and nothing before or behind
            }
}

RAMURE_SUITE(TestStreamCopy)

} // namespace tst_stream_copy

#include "tst_stream_copy.moc"
