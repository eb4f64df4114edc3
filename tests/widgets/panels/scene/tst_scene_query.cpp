#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/scene/scene_query.h"

namespace tst_scene_query {

using namespace ramure;

class TestSceneQuery : public QObject
{
    Q_OBJECT
private:
    test::TreeDocument m_trees;
    std::unique_ptr<BranchRows> m_rows;

    std::vector<Index> found(const QString& text)
    {
        const auto query = SceneQuery::parse(text);
        return query ? query->matches(*m_rows, BranchNames()) : std::vector<Index>{noIndex};
    }
    template <class Holds> std::vector<Index> those(Holds holds)
    {
        std::vector<Index> wanted;
        for (Index branch = 0; branch < m_rows->skeleton().size(); ++branch) {
            if (holds(branch))
                wanted.push_back(branch);
        }
        return wanted;
    }

private slots:
    void initTestCase()
    {
        const NodeId tree = m_trees.add(test::smallForks());
        QVERIFY(tree != noNode);
        m_rows = std::make_unique<BranchRows>(m_trees.document().result(tree)->tree);
        QVERIFY(m_rows->skeleton().size() > 10);
    }
    void init() { test::failOnAnyWarning(); }

    void unfinishedQuestionsAreErrors_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"length >", "> 3", "weight > 3", "order = two", "oak < 2", "length > 3 s"})
            QTest::newRow(text) << QString::fromLatin1(text);
    }
    void unfinishedQuestionsAreErrors()
    {
        QFETCH(QString, text);
        const auto query = SceneQuery::parse(text);
        // A word behind the number is a word of the name.
        if (text.endsWith(u's')) {
            QVERIFY(query);
            return;
        }
        QVERIFY(!query);
        QCOMPARE(query.error().code, ErrorCode::Syntax);
    }

    void nothingAskedFindsNothing()
    {
        for (const char* text : {"", "   "}) {
            const auto query = SceneQuery::parse(QString::fromLatin1(text));
            QVERIFY(query && query->isEmpty());
            QVERIFY(!query->matchesNode(QStringLiteral("Oak")));
            QVERIFY(query->matches(*m_rows, BranchNames()).empty());
        }
    }

    void namesAreFoundInAnyCase()
    {
        const auto query = SceneQuery::parse(QStringLiteral("oAk 2"));
        QVERIFY(query);
        QVERIFY(query->matchesNode(QStringLiteral("Old oak 12")));
        QVERIFY(!query->matchesNode(QStringLiteral("Old oak")));
        QCOMPARE(found(QStringLiteral("number = 12")), std::vector<Index>{12});
        // Words alone ask for axes, with a condition for branches.
        const BranchNames names;
        const auto fits = [](const QString& name) {
            return name.contains(QStringLiteral("limb"), Qt::CaseInsensitive) && name.contains(u'2');
        };
        std::vector<Index> axes;
        for (Index axis = 0; axis < m_rows->axisCount(); ++axis) {
            if (fits(names.axis(*m_rows, axis)))
                axes.push_back(axis);
        }
        QVERIFY(!axes.empty() && axes.size() < m_rows->axisCount());
        QCOMPARE(found(QStringLiteral("2 LIMB")), axes);
        QCOMPARE(found(QStringLiteral("Limb 2 length > 0")),
                 those([&](Index b) { return fits(names.branch(*m_rows, b)); }));
    }

    void comparisonsFilterBranches()
    {
        const Skeleton& bones = m_rows->skeleton();
        QCOMPARE(found(QStringLiteral("terminal")), those([&](Index b) { return m_rows->forks(b) == 0; }));
        QCOMPARE(found(QStringLiteral("children>=3")), those([&](Index b) { return m_rows->forks(b) >= 3; }));
        QCOMPARE(found(QStringLiteral("order = 1")), those([&](Index b) { return bones.level[b] == 1; }));
        QCOMPARE(found(QStringLiteral("ord != 1")), those([&](Index b) { return bones.level[b] != 1; }));
        const auto lengthOf = [&](Index b) { return m_rows->length(m_rows->axisOf(b)); }; // of the limb
        const double length = lengthOf(bones.size() - 1) + 0.001;
        const auto shorter = those([&](Index b) { return lengthOf(b) < length; });
        QVERIFY(!shorter.empty());
        QCOMPARE(found(QStringLiteral("length < %1").arg(length, 0, 'g', 12)), shorter);
        QCOMPARE(found(QStringLiteral("length<%1 mm").arg(length * 1000, 0, 'g', 12)), shorter);
        QCOMPARE(found(QStringLiteral("length<%1cm").arg(length * 100, 0, 'g', 12).replace(u'.', u',')),
                 shorter);
        const auto both = those([&](Index b) { return bones.level[b] == 2 && m_rows->forks(b) == 0; });
        QCOMPARE(found(QStringLiteral("order=2 terminal")), both);
        const double radius = bones.a0[0];
        QCOMPARE(found(QStringLiteral("radius ≥ %1").arg(radius, 0, 'g', 17)),
                 those([&](Index b) { return bones.a0[b] >= radius; }));
    }

    void aCountNeedsNoSign()
    {
        const Skeleton& bones = m_rows->skeleton();
        QCOMPARE(found(QStringLiteral("order 2")), found(QStringLiteral("order = 2")));
        QCOMPARE(found(QStringLiteral("Children 0")), found(QStringLiteral("terminal")));
        const auto shortTwigs =
            those([&](Index b) { return bones.level[b] == 2 && m_rows->length(m_rows->axisOf(b)) < 0.3; });
        QVERIFY(!shortTwigs.empty());
        QCOMPARE(found(QStringLiteral("order 2 length < 0.3")), shortTwigs);
        for (const char* text : {"seaorder 2", "order 2b", "ord 2"}) // names
            QVERIFY(!SceneQuery::parse(QString::fromLatin1(text))->findsBranches());
    }

    void nodesHaveNoQuantities()
    {
        const auto query = SceneQuery::parse(QStringLiteral("oak order = 1"));
        QVERIFY(query && !query->matchesNode(QStringLiteral("Oak")));
    }
};

RAMURE_SUITE(TestSceneQuery)

} // namespace tst_scene_query

#include "tst_scene_query.moc"
