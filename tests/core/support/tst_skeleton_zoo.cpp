#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>

namespace tst_skeleton_zoo {

using namespace ramure;
using namespace ramure::test;

class TestSkeletonZoo : public QObject
{
    Q_OBJECT
private slots:
    void init() { failOnAnyWarning(); }
    void invariantsHold();
    void sameSeedSameAnimal();
    void familiesAreWhatTheySay();
};

void TestSkeletonZoo::invariantsHold()
{
    for (std::uint64_t number = 0; number < 100 * zooFamilyCount; ++number) {
        const Specimen s = specimen(number);
        const Skeleton& k = s.skeleton;
        QVERIFY2(!k.empty(), s.name.c_str());
        for (Index i = 0; i < k.size(); ++i) {
            const bool finite = std::isfinite(k.p0[i].x + k.p0[i].y + k.p0[i].z) &&
                                std::isfinite(k.p1[i].x + k.p1[i].y + k.p1[i].z) &&
                                std::isfinite(k.a0[i] + k.a1[i]);
            QVERIFY2(finite && k.a0[i] >= 0.0 && k.a1[i] >= 0.0, s.name.c_str());
            QVERIFY2(k.parent[i] == noIndex || (k.parent[i] < i && k.p0[i] == k.p1[k.parent[i]]),
                     s.name.c_str());
        }
    }
}

void TestSkeletonZoo::sameSeedSameAnimal()
{
    for (std::uint64_t number = 0; number < 2 * zooFamilyCount; ++number) {
        QCOMPARE(specimen(number).skeleton, specimen(number).skeleton);
        QVERIFY(!(specimen(number).skeleton == specimen(number + zooFamilyCount * 1000).skeleton));
    }
}

void TestSkeletonZoo::familiesAreWhatTheySay()
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SkeletonStats bush = skeletonStats(zooSkeleton(ZooFamily::Bush, seed));
        QVERIFY(bush.maxChildren >= 21 && bush.maxChildren <= 64);
        QVERIFY(skeletonStats(zooSkeleton(ZooFamily::Roots, seed)).roots >= 2);
        QVERIFY(skeletonStats(zooSkeleton(ZooFamily::FewChildren, seed)).maxChildren <= 5);
        QCOMPARE(zooSkeleton(ZooFamily::ZeroRoots, seed).length(0), 0.0);
        const Skeleton chain = zooSkeleton(ZooFamily::DeepChain, seed);
        QVERIFY(*std::max_element(chain.level.begin(), chain.level.end()) >= 20);
        const Skeleton back = zooSkeleton(ZooFamily::Antiparallel, seed);
        bool found = false;
        for (Index i = 1; i < back.size(); ++i) {
            const glm::dvec3 a = back.p1[i] - back.p0[i],
                             b = back.p1[back.parent[i]] - back.p0[back.parent[i]];
            found = found || glm::dot(a, b) <= -(1.0 - 1e-12) * glm::length(a) * glm::length(b);
        }
        QVERIFY(found);
    }
}

RAMURE_SUITE(TestSkeletonZoo)

} // namespace tst_skeleton_zoo

#include "tst_skeleton_zoo.moc"
