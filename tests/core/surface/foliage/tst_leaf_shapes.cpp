#include "core/params/param_def.h"
#include "core/surface/foliage/leaf_shapes.h"
#include "core/surface/foliage/leaf_table.h"
#include "tests/support/self_intersections.h"
#include "tests/support/suite.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tst_leaf_shapes {

using namespace ramure;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<LeafShape> shapesOfPlants()
{
    std::vector<LeafShape> shapes;
    for (int i = 1; i < leafShapeCount; ++i)
        shapes.push_back(static_cast<LeafShape>(i));
    return shapes;
}

const char* nameOf(LeafShape shape)
{
    return findParam("foliage.leaf")->items[static_cast<std::size_t>(shape)].name;
}

LeafForm usual(LeafShape shape, int detail)
{
    LeafParams params;
    params.shape = shape;
    params.detail = detail;
    return leafForm(params);
}

/// What is wrong with a leaf's triangles; empty where nothing is.
std::string faultOf(const TriangleMesh& leaf)
{
    if (leaf.empty() || leaf.normals.size() != leaf.positions.size() ||
        leaf.uv.size() != leaf.positions.size() || leaf.colours.size() != leaf.triangles.size())
        return "incomplete";
    for (const glm::uvec3& t : leaf.triangles) {
        const glm::dvec3 a(leaf.positions[t.x]), b(leaf.positions[t.y]), c(leaf.positions[t.z]);
        const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
        if (!(glm::length(glm::cross(b - a, c - a)) > 1e-5 * longest * longest))
            return "a triangle without area: " + std::to_string(t.x) + " " + std::to_string(t.y) + " " +
                   std::to_string(t.z);
    }
    for (std::size_t i = 0; i < leaf.positions.size(); ++i) {
        if (!(std::abs(glm::length(leaf.normals[i]) - 1.0F) < 1e-4F))
            return "a normal that is not unit";
        if (!(leaf.uv[i].x >= -1e-6F && leaf.uv[i].x <= 1.0F + 1e-6F && leaf.uv[i].y >= -1e-6F &&
              leaf.uv[i].y <= 1.0F + 1e-6F))
            return "texture coordinates outside the picture";
    }
    return {};
}
std::string crossingsOf(const TriangleMesh& leaf)
{
    const test::SelfIntersections crossings = test::findSelfIntersections(leaf);
    return crossings.same == 0 ? std::string() : crossings.summary(leaf);
}

} // namespace

class TestLeafShapes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingIsLeftOfALeafWithoutWidth()
    {
        for (const LeafShape shape : shapesOfPlants()) {
            LeafForm form = usual(shape, 2);
            form.width = 0.0;
            QVERIFY2(leafMesh(form).empty() && leafCard(form).empty(), nameOf(shape));
            QVERIFY(!checkValue(*findParam("foliage.leafWidth"), 0.0));
        }
    }

    void thereAreEnough() { QVERIFY(shapesOfPlants().size() >= 32); }

    void leavesAreSound()
    {
        for (const LeafShape shape : shapesOfPlants())
            for (const int detail : {1, 2, 3}) {
                const TriangleMesh leaf = leafMesh(usual(shape, detail));
                const std::string fault = faultOf(leaf) + crossingsOf(leaf);
                QVERIFY2(fault.empty(), (std::string(nameOf(shape)) + ": " + fault).c_str());
                QVERIFY2(leaf.faceCount() >= 4, nameOf(shape));
                const LeafRow& row = leafRow(shape);
                if (row.family == LeafFamily::Blade && detail < 3)
                    QVERIFY2(leaf.faceCount() <= 40 + 9, nameOf(shape));
            }
    }

    /// Triangles are sound everywhere; where leaflets are bent and widened to the limits, a few cross.
    void leavesAreSoundOverTheWholeRanges()
    {
        int all = 0, crossing = 0;
        const auto limits = [](const char* key) {
            const ParamDef& def = *findParam(key);
            return std::vector<double>{def.hardMin, def.hardMax};
        };
        for (const LeafShape shape : shapesOfPlants())
            for (const double fold : limits("foliage.leafFold"))
                for (const double curl : {findParam("foliage.leafCurl")->hardMin, 0.0, 1.5, pi})
                    for (const double cup : limits("foliage.leafCup"))
                        for (const double width : limits("foliage.leafWidth"))
                            for (const int detail : {1, 2, 3}) {
                                const LeafForm form{shape, width, cup > 0.0 ? 1.0 : 0.0, fold, curl,
                                                    cup,   detail};
                                const TriangleMesh leaf = leafMesh(form);
                                const std::string fault = faultOf(leaf);
                                ++all;
                                crossing += crossingsOf(leaf).empty() ? 0 : 1;
                                QVERIFY2(fault.empty(),
                                         qPrintable(QStringLiteral("%1: fold %2 curl %3 cup %4 "
                                                                   "width %5 detail %6: %7")
                                                        .arg(nameOf(shape))
                                                        .arg(fold)
                                                        .arg(curl)
                                                        .arg(cup)
                                                        .arg(width)
                                                        .arg(detail)
                                                        .arg(fault.c_str())));
                            }
        QVERIFY2(25 * crossing <= all, qPrintable(QString::number(crossing)));
    }

    void theUpperSideLooksUp()
    {
        for (const LeafShape shape : shapesOfPlants()) {
            const LeafRow& row = leafRow(shape);
            if (row.family == LeafFamily::Tuft || (row.family == LeafFamily::Shoot && !row.flat))
                continue; // all around
            LeafForm form = usual(shape, 2);
            form.petiole = 0.0;
            const TriangleMesh leaf = leafMesh(form);
            glm::vec3 sum(0.0F);
            for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
                const glm::uvec3& c = leaf.triangles[t];
                if (leaf.colours[t] == glm::u8vec3(255))
                    sum += glm::cross(leaf.positions[c.y] - leaf.positions[c.x],
                                      leaf.positions[c.z] - leaf.positions[c.x]);
            }
            QVERIFY2(glm::normalize(sum).z > 0.6F, nameOf(shape));
        }
    }

    /// Without its petiole a leaf is one long, and its foot is where the petiole begins.
    void sizesAreThoseOfTheTable()
    {
        for (const LeafShape shape : shapesOfPlants()) {
            LeafForm form = usual(shape, 2);
            form.curl = form.fold = form.cup = 0.0;
            const TriangleMesh leaf = leafMesh(form);
            const double petiole = leafRow(shape).petiole;
            const glm::vec3 far = std::ranges::max(leaf.positions, {}, [&](const glm::vec3& p) {
                return glm::length(p - glm::vec3(0.0F, float(petiole), 0.0F));
            });
            const double length = glm::length(far - glm::vec3(0.0F, float(petiole), 0.0F));
            QVERIFY2(length > 0.8 && length < 1.35, nameOf(shape));
        }
    }

    void cardsLieWhereTheBladeIs()
    {
        for (const LeafShape shape : shapesOfPlants()) {
            const TriangleMesh card = leafCard(usual(shape, 2)), leaf = leafMesh(usual(shape, 2));
            QCOMPARE(card.faceCount(), Index(2));
            const auto wide = [](const TriangleMesh& mesh) {
                return std::ranges::max(mesh.positions, {}, &glm::vec3::x).x;
            };
            QCOMPARE(wide(card), wide(leaf));
            QVERIFY2(card.normals[0].z > 0.2F, nameOf(shape));
        }
    }
};

RAMURE_SUITE(TestLeafShapes)

} // namespace tst_leaf_shapes

#include "tst_leaf_shapes.moc"
