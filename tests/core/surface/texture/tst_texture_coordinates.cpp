#include "core/base/parallel.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/scene/recipe_demo.h"
#include "core/surface/check/texture_report.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/skeleton_zoo.h"
#include "tests/support/suite.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tst_texture_coordinates {

using namespace ramure;
using namespace ramure::test;

class TestTextureCoordinates : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnAnyWarning(); }
    void invalidInput();
    void cancels();
    void stretchOfATriangle();
    void aCylinderIsUnrolledAsItIs();
    void theSameOnAnyNumberOfThreads_data() { presets(); }
    void theSameOnAnyNumberOfThreads();
    void tubesThatMeetDoNotDependOnChance();
    void tellsHowFarItIs();
    void presetsAreEven_data();
    void presetsAreEven();
    void twoSectionsAreNeverMirrored_data();
    void twoSectionsAreNeverMirrored();
    void oneIslandPerTube_data() { presets(); }
    void oneIslandPerTube();
    void childrenGoOnFromTheirParent_data() { presets(); }
    void childrenGoOnFromTheirParent();
    void oneSeamPerTube_data() { presets(); }
    void oneSeamPerTube();
    void wholeTilesGoAround_data() { presets(); }
    void wholeTilesGoAround();
    void whatIsWideIsOld_data();
    void whatIsWideIsOld();
    void limbsBeginInTheBarkOfTheStem();
    void barkAgesOnFromPieceToPiece();
    void anySkeleton();

private:
    static void presets();
    static BranchMesh meshOf(const QString& preset, int radial = 8, int length = 4);
    /// A preset with its coordinates, both with the usual options; made once.
    struct Textured
    {
        BranchMesh mesh;
        Expected<TextureCoordinates> made;
    };
    static const Textured& textured(const QString& preset);
};

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

BranchMesh cylinder(double radius, double length, int radial = 16, int divisions = 5)
{
    Skeleton skeleton;
    skeleton.add(noIndex, {0, 0, 0}, {0, length, 0}, radius, radius);
    skeleton.key.resize(1);
    BranchMeshOptions options;
    options.radialDivisions = radial;
    options.lengthDivisions = divisions;
    return buildBranchMesh(skeleton, options).value_or(BranchMesh{});
}

std::pair<Index, Index> rangeOf(const BranchMesh& mesh, std::size_t tube)
{
    return {mesh.tubes[tube].firstTriangle,
            tube + 1 < mesh.tubes.size() ? mesh.tubes[tube + 1].firstTriangle : mesh.mesh.faceCount()};
}

/// Per triangle of a tube: the piece of the texture it belongs to, as its first triangle there.
std::vector<Index> islandsOf(const BranchMesh& mesh, const TextureCoordinates& made, std::size_t tube)
{
    const auto [first, end] = rangeOf(mesh, tube);
    std::map<std::pair<Index, Index>, Index> edges; // of the texture, to their triangle
    std::vector<Index> piece(end - first);
    for (Index f = first; f < end; ++f) {
        piece[f - first] = f - first;
        for (int c = 0; c < 3; ++c)
            edges[{made.corners[f][c], made.corners[f][(c + 1) % 3]}] = f - first;
    }
    const auto pieceOf = [&piece](Index f) {
        while (piece[f] != f)
            f = piece[f];
        return f;
    };
    for (const auto& [edge, face] : edges)
        if (const auto back = edges.find({edge.second, edge.first}); back != edges.end()) {
            const Index a = pieceOf(face), b = pieceOf(back->second);
            piece[std::max(a, b)] = std::min(a, b);
        }
    for (Index f = 0; f < end - first; ++f)
        piece[f] = pieceOf(f);
    return piece;
}

bool isWhole(double number)
{
    return std::abs(number - std::round(number)) < 2e-3;
}

} // namespace

void TestTextureCoordinates::presets()
{
    QTest::addColumn<QString>("preset");
    for (const char* name : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        QTest::newRow(name) << QString(name);
}

BranchMesh TestTextureCoordinates::meshOf(const QString& preset, int radial, int length)
{
    const Expected<Skeleton> skeleton = presetSkeleton({preset.toStdString()});
    if (!skeleton)
        return {};
    BranchMeshOptions options;
    options.radialDivisions = radial;
    options.lengthDivisions = length;
    return buildBranchMesh(*skeleton, options).value_or(BranchMesh{});
}

const TestTextureCoordinates::Textured& TestTextureCoordinates::textured(const QString& preset)
{
    static std::map<QString, Textured> all;
    const auto known = all.find(preset);
    if (known != all.end())
        return known->second;
    BranchMesh mesh = meshOf(preset);
    const ThreadLimit limit(5); // whatever the machine has
    auto made = textureCoordinates(mesh, {});
    return all.emplace(preset, Textured{std::move(mesh), std::move(made)}).first->second;
}

void TestTextureCoordinates::invalidInput()
{
    QCOMPARE(textureCoordinates({}, {}).error().code, ErrorCode::Invalid);
    BranchMesh mesh = cylinder(0.1, 1.0);
    for (const double size : {-1.0, noNumber, std::numeric_limits<double>::infinity(), 1e-9})
        QCOMPARE(textureCoordinates(mesh, {size}).error().code, ErrorCode::Invalid);
    mesh.axes.clear();
    QCOMPARE(textureCoordinates(mesh, {}).error().code, ErrorCode::Invalid);
}

void TestTextureCoordinates::cancels()
{
    std::stop_source stop;
    stop.request_stop();
    const auto made = textureCoordinates(cylinder(0.1, 1.0), {}, {stop.get_token(), {}});
    QCOMPARE(made.error().code, ErrorCode::Cancelled);
}

void TestTextureCoordinates::stretchOfATriangle()
{
    const std::array<glm::vec3, 3> place{glm::vec3(1, 1, 1), glm::vec3(3, 1, 1), glm::vec3(1, 1, -1)};
    using Uv = std::array<glm::vec2, 3>;
    QVERIFY(std::abs(textureStretch(place, Uv{glm::vec2(0, 0), {1, 0}, {0, 1}}) - 1.0) < 1e-6);
    QVERIFY(std::abs(textureStretch(place, Uv{glm::vec2(5, 5), {5, 9}, {1, 5}}) - 1.0) < 1e-6);
    QVERIFY(std::abs(textureStretch(place, Uv{glm::vec2(0, 0), {3, 0}, {0, 1}}) - 3.0) < 1e-6);
    QVERIFY(std::abs(textureStretch(place, Uv{glm::vec2(0, 0), {0, 1}, {2, 0}}) + 2.0) < 1e-6);
    // A shear of one: the golden ratio, squared.
    const double golden = 0.5 + std::sqrt(1.25);
    QVERIFY(std::abs(textureStretch(place, Uv{glm::vec2(0, 0), {1, 0}, {1, 1}}) - golden * golden) < 1e-6);
    QVERIFY(std::isinf(textureStretch(place, Uv{glm::vec2(0, 0), {1, 0}, {2, 0}})));
    const glm::vec3 point(1, 2, 3);
    QVERIFY(std::isinf(textureStretch({point, point, point}, Uv{glm::vec2(0, 0), {1, 0}, {0, 1}})));
}

void TestTextureCoordinates::aCylinderIsUnrolledAsItIs()
{
    const BranchMesh mesh = cylinder(0.5, 2.0, 64);
    const auto made = textureCoordinates(mesh, {0.1});
    QVERIFY(made);
    QCOMPARE(made->tileSize, 0.1);
    QCOMPARE(made->corners.size(), mesh.mesh.triangles.size());
    QCOMPARE(made->apart, Index(0));
    float low = 1e9f, high = -1e9f, left = 1e9f, right = -1e9f;
    for (std::size_t i = 0; i < made->uv.size(); ++i) {
        const glm::vec3 at = mesh.mesh.positions[made->vertex[i]];
        if (at.y < 0.4f || at.y > 1.6f)
            continue; // the rings in between: no caps
        left = std::min(left, made->uv[i].x);
        right = std::max(right, made->uv[i].x);
        low = std::min(low, made->uv[i].y / at.y);
        high = std::max(high, made->uv[i].y / at.y);
    }
    QVERIFY(std::abs(right - left - 31.0f) < 1e-3f); // pi m in tiles of 10 cm
    QVERIFY(low > 9.7f && high < 10.1f);
    const TextureReport report = textureReport(mesh, *made);
    QCOMPARE(report.mirrored, Index(0));
    QVERIFY(report.stretch95 < 1.08);
    QCOMPARE(report.levels.size(), std::size_t(1));
    QVERIFY(std::abs(report.levels[0].tilesPerMetre - 10.0) < 0.4);
}

void TestTextureCoordinates::theSameOnAnyNumberOfThreads()
{
    QFETCH(QString, preset);
    const auto& [mesh, onMany] = textured(preset);
    QVERIFY(onMany);
    const ThreadLimit limit(1);
    const auto onOne = textureCoordinates(mesh, {});
    QVERIFY(onOne && *onOne == *onMany);
}

/// Tubes of several sources share vertices without one growing from the other. Which thread came first
/// decided whose coordinates they got.
void TestTextureCoordinates::tubesThatMeetDoNotDependOnChance()
{
    const Scene scene = recipeDemo();
    const auto nodes = scene.nodes();
    const auto tree = std::ranges::find(nodes, std::string("Two sources on one parent"), &Node::name);
    QVERIFY(tree != nodes.end());
    TreePipeline pipeline;
    const auto grown = pipeline.evaluate((*tree).params, Stage::Mesh);
    QVERIFY(grown);
    const auto onOne = [&] {
        const ThreadLimit limit(1);
        return textureCoordinates(*grown->branches, {});
    }();
    QVERIFY(onOne);
    for (int round = 0; round < 8; ++round) {
        const ThreadLimit limit(5);
        const auto onMany = textureCoordinates(*grown->branches, {});
        QVERIFY(onMany && *onMany == *onOne);
    }
}

void TestTextureCoordinates::tellsHowFarItIs()
{
    const BranchMesh mesh = meshOf("SmallTree");
    std::vector<double> told;
    QVERIFY(textureCoordinates(mesh, {}, {{}, [&told](double fraction) { told.push_back(fraction); }}));
    QVERIFY(told.size() > 1 && told.front() > 0.0 && told.back() == 1.0);
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    std::stop_source stop;
    const Progress stopping{stop.get_token(), [&stop](double) { stop.request_stop(); }};
    QCOMPARE(textureCoordinates(mesh, {}, stopping).error().code, ErrorCode::Cancelled);
}

void TestTextureCoordinates::presetsAreEven_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<int>("length");
    QTest::addColumn<double>("good");
    for (const char* preset : {"SmallTree", "FanTree", "TinyTree", "Fern2D"})
        for (const int radial : {5, 8, 16})
            for (const int length : {4, 8})
                QTest::addRow("%s %d x %d", preset, radial, length)
                    << QString(preset) << radial << length << 0.9;
}

void TestTextureCoordinates::presetsAreEven()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(int, length);
    QFETCH(double, good);
    const BranchMesh mesh = meshOf(preset, radial, length);
    const auto made = textureCoordinates(mesh, {});
    QVERIFY(made);
    const TextureReport report = textureReport(mesh, *made);
    QCOMPARE(report.triangles, mesh.mesh.faceCount());
    QCOMPARE(report.mirrored, Index(0));
    QVERIFY2(report.goodShare() >= good, qPrintable(QString::number(report.goodShare())));
    QVERIFY2(made->apart <= 25 * mesh.mesh.faceCount() / 10000, qPrintable(QString::number(made->apart)));
}

void TestTextureCoordinates::twoSectionsAreNeverMirrored_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("radial");
    QTest::addColumn<double>("good");
    QTest::newRow("SmallTree") << "SmallTree" << 8 << 0.6;
    QTest::newRow("FanTree") << "FanTree" << 5 << 0.8;
    QTest::newRow("TinyTree") << "TinyTree" << 8 << 0.55;
    QTest::newRow("Fern2D") << "Fern2D" << 16 << 0.8;
}

/// Two cross-sections per branch: tubes bend where they share their ends with others.
void TestTextureCoordinates::twoSectionsAreNeverMirrored()
{
    QFETCH(QString, preset);
    QFETCH(int, radial);
    QFETCH(double, good);
    const BranchMesh mesh = meshOf(preset, radial, 2);
    const auto made = textureCoordinates(mesh, {});
    QVERIFY(made);
    const TextureReport report = textureReport(mesh, *made);
    QCOMPARE(report.mirrored, Index(0));
    QVERIFY2(report.goodShare() >= good, qPrintable(QString::number(report.goodShare())));
}

/// Whatever its seam does, a tube without its caps is one piece in the texture.
void TestTextureCoordinates::oneIslandPerTube()
{
    QFETCH(QString, preset);
    const auto& [mesh, made] = textured(preset);
    QVERIFY(made);
    std::size_t whole = 0;
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        std::map<Index, std::size_t> sizes;
        for (const Index piece : islandsOf(mesh, *made, t))
            ++sizes[piece];
        // Discs have no more triangles than the mesh has sides.
        whole += std::count_if(sizes.begin(), sizes.end(), [](const auto& p) { return p.second > 8; }) == 1;
    }
    QVERIFY2(whole * 1000 >= 995 * mesh.tubes.size(),
             qPrintable(QString("%1 of %2").arg(whole).arg(mesh.tubes.size())));
}

/// All but limbs that leave a thicker sibling to its side: their bark begins at their feet.
void TestTextureCoordinates::childrenGoOnFromTheirParent()
{
    QFETCH(QString, preset);
    const auto& [mesh, made] = textured(preset);
    QVERIFY(made);
    std::size_t shared = 0;
    std::vector<std::map<Index, glm::vec2>> tubes(mesh.tubes.size());
    std::map<Index, std::size_t> tubeOf;
    std::set<Index> limbs;
    for (const ForkVertex& fork : mesh.forkVertices)
        if (fork.branch[2] == noIndex && fork.weight[0] == 0.0F)
            limbs.insert(fork.branch[0]);
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        tubeOf[mesh.tubes[t].branch] = t;
        const auto [first, end] = rangeOf(mesh, t);
        for (Index f = first; f < end; ++f)
            for (int c = 0; c < 3; ++c)
                tubes[t].try_emplace(mesh.mesh.triangles[f][c], made->uv[made->corners[f][c]]);
        if (mesh.tubes[t].parent == noIndex || limbs.contains(mesh.tubes[t].branch))
            continue;
        const std::map<Index, glm::vec2>& parent = tubes[tubeOf[mesh.tubes[t].parent]];
        for (const auto& [vertex, uv] : tubes[t])
            if (const auto there = parent.find(vertex); there != parent.end()) {
                ++shared;
                QVERIFY(isWhole(double(uv.x) - double(there->second.x)));
                QCOMPARE(uv.y, there->second.y);
            }
    }
    QVERIFY(shared > mesh.tubes.size());
}

/// What is torn in a tube, apart from the discs of its ends, is one short path from the front to the end:
/// along the tube and not around it.
void TestTextureCoordinates::oneSeamPerTube()
{
    QFETCH(QString, preset);
    const auto& [mesh, made] = textured(preset);
    QVERIFY(made);
    std::size_t single = 0, brief = 0;
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        const auto [first, end] = rangeOf(mesh, t);
        const std::vector<Index> piece = islandsOf(mesh, *made, t);
        std::map<Index, std::size_t> sizes;
        for (const Index p : piece)
            ++sizes[p];
        const Index tube = std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) {
                               return a.second < b.second;
                           })->first;
        std::map<std::pair<Index, Index>, std::pair<Index, Index>> edges; // to their coordinates
        for (Index f = first; f < end; ++f)
            for (int c = 0; c < 3 && piece[f - first] == tube; ++c)
                edges[{mesh.mesh.triangles[f][c], mesh.mesh.triangles[f][(c + 1) % 3]}] = {
                    made->corners[f][c], made->corners[f][(c + 1) % 3]};
        std::map<Index, int> torn; // per vertex: edges
        std::size_t count = 0;
        for (const auto& [edge, uv] : edges) {
            const auto back = edges.find({edge.second, edge.first});
            if (edge.first > edge.second || back == edges.end() ||
                (uv.first == back->second.second && uv.second == back->second.first))
                continue;
            ++count;
            ++torn[edge.first];
            ++torn[edge.second];
        }
        // Each vertex of a path has two edges, but for its ends.
        const auto has = [&torn](int n) {
            return std::count_if(torn.begin(), torn.end(), [n](const auto& v) { return v.second == n; });
        };
        single += has(1) == 2 && std::size_t(has(1) + has(2)) == torn.size() && torn.size() == count + 1;
        brief += count <= 5 ? 1 : 0;
    }
    QCOMPARE(single, mesh.tubes.size());
    QCOMPARE(brief, mesh.tubes.size());
}

/// Corners of one vertex differ by the same whole number of tiles from a tube's front to its end.
void TestTextureCoordinates::wholeTilesGoAround()
{
    QFETCH(QString, preset);
    const auto& [mesh, made] = textured(preset);
    QVERIFY(made);
    std::size_t seams = 0;
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        const auto [first, end] = rangeOf(mesh, t);
        const std::vector<Index> piece = islandsOf(mesh, *made, t);
        std::map<Index, std::map<Index, std::set<Index>>> uses; // by piece and vertex
        for (Index f = first; f < end; ++f)
            for (int c = 0; c < 3; ++c)
                uses[piece[f - first]][mesh.mesh.triangles[f][c]].insert(made->corners[f][c]);
        std::set<double> around;
        for (const auto& [island, vertices] : uses)
            for (const auto& [vertex, coordinates] : vertices) {
                if (coordinates.size() < 2)
                    continue;
                const glm::vec2 a = made->uv[*coordinates.begin()],
                                b = made->uv[*std::next(coordinates.begin())];
                QCOMPARE(a.y, b.y);
                const double tiles = std::abs(double(a.x) - double(b.x));
                QVERIFY(isWhole(tiles));
                around.insert(std::round(tiles));
                ++seams;
            }
        QVERIFY(around.size() <= 1 && (around.empty() || *around.begin() >= 2.0));
    }
    QVERIFY(seams > 2 * mesh.tubes.size());
}

void TestTextureCoordinates::whatIsWideIsOld_data()
{
    QTest::addColumn<QString>("preset");
    for (const char* name :
         {"SmallTree", "FanTree", "TinyTree"}) // of the fern some axes pass by their own start
        QTest::newRow(name) << QString(name);
}

/// A twig that starts on the end of thick wood has bark as old as that where it is as wide: no pale patch.
void TestTextureCoordinates::whatIsWideIsOld()
{
    QFETCH(QString, preset);
    const BranchMesh& mesh = textured(preset).mesh;
    const TextureCoordinates& made = *textured(preset).made;
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t) {
        const BranchCurve& curve = mesh.axes[t].curve;
        const auto [first, end] = rangeOf(mesh, t);
        for (Index f = first; f < end; ++f)
            for (int c = 0; c < 3; ++c) {
                const Index corner = made.corners[f][c];
                const glm::dvec3 place(mesh.mesh.positions[made.vertex[corner]]);
                double away = std::numeric_limits<double>::max();
                for (int i = 0; i <= 48; ++i)
                    away = std::min(
                        away,
                        glm::length(place -
                                    hermite(curve.h0, curve.h1, curve.v0, curve.v1, double(i) / 48.0).point));
                QVERIFY(double(made.radius[corner]) > 0.7 * away);
            }
    }
}

/// Where it leaves a stem a limb's bark is as old as the stem's, some diameters on as old as it is thick.
void TestTextureCoordinates::limbsBeginInTheBarkOfTheStem()
{
    constexpr double stem = 0.2, thin = 0.04;
    Skeleton skeleton;
    const Index foot = skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, stem, stem);
    skeleton.add(foot, {0, 1, 0}, {0, 2, 0}, stem, stem);
    const Index limb = skeleton.add(foot, {0, 1, 0}, {2, 1.5, 0}, thin, thin);
    skeleton.key.resize(3);
    const auto mesh = buildBranchMesh(skeleton, {});
    QVERIFY(mesh);
    const auto made = textureCoordinates(*mesh, {});
    QVERIFY(made);
    double oldest = 0.0, youngest = stem;
    for (std::size_t t = 0; t < mesh->tubes.size(); ++t) {
        const auto [first, end] = rangeOf(*mesh, t);
        for (Index f = first; mesh->tubes[t].branch == limb && f < end; ++f)
            for (int c = 0; c < 3; ++c) {
                const double radius = made->radius[made->corners[f][c]];
                oldest = std::max(oldest, radius);
                youngest = std::min(youngest, radius);
            }
    }
    QVERIFY2(oldest > 0.9 * stem && oldest < 1.01 * stem, qPrintable(QString::number(oldest)));
    QVERIFY2(youngest < 1.1 * thin, qPrintable(QString::number(youngest)));
}

/// Pieces of a limb that are shorter than its bark takes to become its own pass on how old it is.
void TestTextureCoordinates::barkAgesOnFromPieceToPiece()
{
    constexpr double stem = 0.2, thin = 0.05;
    Skeleton skeleton;
    const Index foot = skeleton.add(noIndex, {0, 0, 0}, {0, 1, 0}, stem, stem);
    skeleton.add(foot, {0, 1, 0}, {0, 2, 0}, stem, stem);
    constexpr int pieces = 24;
    for (int i = 0; i < pieces; ++i) {
        const Index below = i == 0 ? foot : static_cast<Index>(skeleton.size() - 1);
        skeleton.add(below, {0.1 * i, 1, 0}, {0.1 * (i + 1), 1, 0}, thin, thin);
    }
    skeleton.key.resize(skeleton.size());
    const auto mesh = buildBranchMesh(skeleton, {});
    QVERIFY(mesh);
    const auto made = textureCoordinates(*mesh, {});
    QVERIFY(made);
    std::map<Index, std::pair<double, double>> ages; // of the vertices of the limb: the least, the most
    double youngest = stem;
    for (std::size_t t = 0; t < mesh->tubes.size(); ++t) {
        const auto [first, end] = rangeOf(*mesh, t);
        for (Index f = first; mesh->tubes[t].branch > 1 && f < end; ++f)
            for (int c = 0; c < 3; ++c) {
                const Index corner = made->corners[f][c];
                const double radius = made->radius[corner];
                auto& [least, most] = ages.try_emplace(made->vertex[corner], radius, radius).first->second;
                least = std::min(least, radius);
                most = std::max(most, radius);
                youngest = std::min(youngest, radius);
            }
    }
    for (const auto& [vertex, age] : ages)
        QVERIFY2(age.second <= 1.05 * age.first,
                 qPrintable(QStringLiteral("%1 and %2 m").arg(age.first).arg(age.second)));
    QVERIFY2(youngest < 1.1 * thin, qPrintable(QString::number(youngest)));
}

void TestTextureCoordinates::anySkeleton()
{
    for (std::uint64_t seed = 0; seed < fuzzCount(240); ++seed) {
        const Specimen wild = specimen(seed);
        const auto mesh = buildBranchMesh(wild.skeleton, wild.meshOptions());
        if (!mesh)
            continue;
        const auto made = textureCoordinates(*mesh, {});
        if (!made) {
            QCOMPARE(made.error().code, ErrorCode::Invalid); // radii too far apart
            continue;
        }
        for (const glm::vec2& uv : made->uv)
            QVERIFY2(std::isfinite(uv.x) && std::isfinite(uv.y),
                     qPrintable(QString::fromStdString(wild.name)));
        for (std::size_t f = 0; f < mesh->mesh.triangles.size(); ++f)
            for (int c = 0; c < 3; ++c)
                QCOMPARE(made->vertex[made->corners[f][c]], mesh->mesh.triangles[f][c]);
        const TextureReport report = textureReport(*mesh, *made);
        QVERIFY2(report.mirrored == 0, qPrintable(QString::fromStdString(wild.name)));
    }
}

RAMURE_SUITE(TestTextureCoordinates)

} // namespace tst_texture_coordinates

#include "tst_texture_coordinates.moc"
