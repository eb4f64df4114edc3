#include "core/qt/session/jobs/variations.h"

#include "core/generators/variety.h"
#include "core/io/csv_table.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_file.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <set>

namespace tst_variations {

using namespace ramure;

/// Seeds and values of many trees from one, and their table.
class TestVariations : public QObject
{
    Q_OBJECT

    static VariedParam param(const char* key, double from, double to) { return {findParam(key), from, to}; }
    static Node birch()
    {
        Node tree;
        tree.kind = NodeKind::Tree;
        tree.name = "Birch";
        tree.params = *presetParams("SilverBirch1995");
        return tree;
    }
    static QStringList filesIn(const QTemporaryDir& folder)
    {
        return QDir(folder.path()).entryList(QDir::Files);
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void valuesOutOfRangeAreErrors()
    {
        const Variation bad{3, {{findParam("foliage.leafSize"), -1.0}}};
        const auto params = variedParams(birch().params, bad);
        QVERIFY(!params);
        QCOMPARE(params.error().path, std::string("foliage.leafSize"));
    }
    void whatCannotBeWrittenIsAnError()
    {
        const QTemporaryDir folder;
        QVERIFY(!saveVariations(birch(), spreadVariations({}, 1, 2), folder.filePath("none/t.csv")));
        QCOMPARE(filesIn(folder), QStringList());
    }
    /// Of every preset: numbers, flags and choices, within what they may be, and around what they are.
    void usualRangesHoldTheValueAndAreAllowed()
    {
        for (const Preset& preset : presets())
            for (const ParamDef& def : paramTable()) {
                if (!canVary(preset.params, def))
                    continue;
                QVERIFY2(!(def.flags & paramSeed), def.key);
                const VariedParam range = usualRange(preset.params, def);
                QVERIFY2(range.from <= range.to, def.key);
                for (const Variation& each : spreadVariations({range}, 1, 7)) {
                    const auto params = variedParams(preset.params, each);
                    QVERIFY2(params, def.key);
                    QVERIFY2(def.get(*params) == each.values.front().second, def.key);
                }
            }
        QVERIFY(!canVary(birch().params, *findParam("grammar.seed")));
        QVERIFY(!canVary(birch().params, *findParam("primitive.radius"))); // of boxes
    }
    void valuesAreSpreadEvenlyAndStayWithTheirParameter()
    {
        constexpr int count = 40;
        const VariedParam size = param("foliage.leafSize", 2.0, 1.0); // ends in any order
        const VariedParam density = param("foliage.leavesDensity", 3, 6);
        const auto alone = spreadVariations({size}, 5, count);
        QVERIFY(alone == spreadVariations({size}, 5, count));
        QVERIFY(alone != spreadVariations({size}, 6, count));
        const auto both = spreadVariations({density, size, param("mesh.clampOvershoot", 0, 0)}, 5, count);
        std::set<int> parts;
        std::multiset<std::int64_t> densities;
        int flags = 0;
        for (std::size_t i = 0; i < both.size(); ++i) {
            QCOMPARE(both[i].seed, std::int64_t(5 + i));
            QVERIFY(both[i].values[1] == alone[i].values[0]);
            const double value = std::get<double>(alone[i].values[0].second);
            QVERIFY(value >= 1.0 && value <= 2.0);
            parts.insert(int(std::floor((value - 1.0) * count - 1e-9)));
            densities.insert(std::get<std::int64_t>(both[i].values[0].second));
            flags += std::get<bool>(both[i].values[2].second) ? 1 : 0;
        }
        QVERIFY(int(parts.size()) >= count - 2); // five digits may round one into its neighbour
        for (int i = 3; i <= 6; ++i)
            QCOMPARE(densities.count(i), std::size_t(count / 4));
        QCOMPARE(flags, count / 2);
    }
    void aTreeTakesOverWhatWasTouched()
    {
        const NodeParams like = birch().params;
        const ParamDef* size = findParam("foliage.leafSize");
        const ParamDef* detail = findParam("foliage.leafDetail");
        const Variation one{7, {{size, 1.5}}};
        NodeParams tree = *variedParams(like, {9, {{detail, std::int64_t(3)}}}); // another was opened before
        for (const auto& [def, value] : valuesOf(like, one, {size, detail}))
            QVERIFY(setParam(tree, *def, value));
        QVERIFY(tree == *variedParams(like, one));
        QVERIFY(tree == [&] {
            NodeParams expected = reseeded(like, 7);
            expected.leaf.size = 1.5;
            return expected;
        }());
    }
    void theTableIsReadBack()
    {
        const QTemporaryDir folder;
        const auto first = spreadVariations({param("foliage.leafSize", 0.5, 2.0)}, 1, 3);
        auto rows = first;
        const auto others = spreadVariations({param("foliage.leafDetail", 1, 3)}, 8, 2);
        rows.insert(rows.end(), others.begin(), others.end());
        QFile mine(folder.filePath("my birch-tree.ramure")); // stays as it is
        QVERIFY(mine.open(QIODevice::WriteOnly));
        QVERIFY(saveVariations(birch(), rows, folder.filePath("my birch.csv")));
        QCOMPARE(filesIn(folder),
                 QStringList({"my birch-tree-2.ramure", "my birch-tree.ramure", "my birch.csv"}));
        const auto table = readCsv(folder.filePath("my birch.csv").toStdString());
        QVERIFY(table);
        QCOMPARE(table->columns,
                 std::vector<std::string>({"input", "seed", "foliage.leafSize", "foliage.leafDetail"}));
        QCOMPARE(table->rows.size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto& cells = table->rows[i].cells;
            QCOMPARE(cells[0], std::string("my birch-tree-2.ramure"));
            QCOMPARE(cells[1], std::to_string(rows[i].seed));
            QCOMPARE(cells[i < 3 ? 2 : 3], formatValue(rows[i].values[0].second));
            QVERIFY(cells[i < 3 ? 3 : 2].empty());
        }
        const auto tree = loadProjectFile(folder.filePath("my birch-tree-2.ramure"));
        QVERIFY(tree);
        QVERIFY(tree->scene.nodes().front().params == birch().params);
    }
};

RAMURE_SUITE(TestVariations)

} // namespace tst_variations

#include "tst_variations.moc"
