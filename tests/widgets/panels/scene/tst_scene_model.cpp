#include "tests/widgets/base/fixture.h"
#include "widgets/panels/scene/scene_model.h"
#include <QAbstractItemModelTester>
#include <random>

namespace tst_scene_model {

using namespace ramure;

namespace {

/// A result with a skeleton of \p count branches: a chain with a fork at every third.
NodeResult resultWith(Index count, double length = 1.0)
{
    auto simplified = std::make_shared<SimplifiedSkeleton>();
    Skeleton& bones = simplified->skeleton;
    for (Index i = 0; i < count; ++i) {
        const Index parent = i == 0 ? noIndex : i % 3 == 0 ? i / 3 - 1 + (i < 6 ? 1 : 0) : i - 1;
        const glm::dvec3 from = parent == noIndex ? glm::dvec3(0.0) : bones.p1[parent];
        bones.add(parent, from, from + glm::dvec3(0.0, length, 0.0), 0.1, 0.09, i % 4);
        bones.key[i] = i + 100;
    }
    NodeResult result;
    result.tree.simplified = std::move(simplified);
    return result;
}

/// The rows that the model shows, as a test reads them: one text per row, depth-first, with its depth.
QStringList shownRows(const SceneModel& model, const QModelIndex& parent = {}, int depth = 0)
{
    QStringList rows;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        rows += QString(depth, u'.') + index.data().toString();
        rows += shownRows(model, index, depth + 1);
    }
    return rows;
}

/// The first child of the branch's own level, which leads it on.
Index leadingOn(const Skeleton& bones, Index branch)
{
    for (Index child = branch + 1; child < bones.size(); ++child)
        if (bones.parent[child] == branch && bones.level[child] == bones.level[branch])
            return child;
    return noIndex;
}

/// An axis and what springs from it, said in another way than the model does it.
struct ExpectedAxis
{
    const Skeleton& bones;
    int order = 0, number = 1, aboveNumber = 0;
    double along = 0.0;

    [[nodiscard]] QString name() const
    {
        const QString metres = QLocale().toString(along, 'f', along < 0.995 ? 2 : 1) + QStringLiteral(" m ");
        switch (order) {
        case 0:
            return QStringLiteral("Trunk");
        case 1:
            return QStringLiteral("Limb %1 of the trunk, ").arg(number) + metres + QStringLiteral("up");
        default:
            const QString words = order == 2   ? QStringLiteral("Bough %1 of limb %2, ")
                                  : order == 3 ? QStringLiteral("Twig %1 of bough %2, ")
                                               : QStringLiteral("Twig %1 of twig %2, ");
            return words.arg(number).arg(aboveNumber) + metres + QStringLiteral("along");
        }
    }
    [[nodiscard]] QStringList rows(Index foot, int depth) const
    {
        std::vector<Index> chain;
        for (Index branch = foot; branch != noIndex; branch = leadingOn(bones, branch))
            chain.push_back(branch);
        QStringList rows{QString(depth, u'.') + name()};
        if (chain.size() > 1)
            rows += QString(depth + 1, u'.') + QStringLiteral("%1 branch(es)").arg(chain.size());
        for (std::size_t i = 0; i < chain.size() && chain.size() > 1; ++i)
            rows += QString(depth + 2, u'.') + QStringLiteral("Branch %1 of %2").arg(i + 1).arg(chain.size());
        ExpectedAxis below{bones, order + 1, 1, number, 0.0};
        for (const Index branch : chain) {
            below.along += bones.length(branch);
            for (Index child = branch + 1; child < bones.size(); ++child) {
                if (bones.parent[child] != branch || child == leadingOn(bones, branch))
                    continue;
                rows += below.rows(child, depth + 1);
                ++below.number;
            }
        }
        return rows;
    }
};

QStringList expectedTrunks(const Skeleton& bones, int depth)
{
    QStringList rows;
    for (Index branch = 0; branch < bones.size(); ++branch)
        if (bones.parent[branch] == noIndex)
            rows += ExpectedAxis{bones}.rows(branch, depth);
    return rows;
}

/// The first row whose count is not that of the rows below it.
QString wrongCount(const SceneModel& model, const QModelIndex& parent = {})
{
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        const QString told = index.siblingAtColumn(SceneModel::ChildrenColumn).data().toString();
        if (told != (model.rowCount(index) == 0 ? QString() : QLocale().toString(model.rowCount(index))))
            return index.data().toString() + u':' + told;
        if (const QString below = wrongCount(model, index); !below.isEmpty())
            return below;
    }
    return {};
}

/// The same, from the document.
QStringList expectedRows(const Document& document, NodeId parent = noNode, int depth = 0)
{
    QStringList rows;
    for (const NodeId id : document.scene().children(parent)) {
        rows += QString(depth, u'.') + QString::fromStdString(document.scene().find(id)->name);
        rows += expectedRows(document, id, depth + 1);
        const NodeResult* result = document.result(id);
        if (result && result->tree.simplified)
            rows += expectedTrunks(result->tree.simplified->skeleton, depth + 1);
    }
    return rows;
}

/// A result of what the parameters say, for every tree that has none or an older one.
void computeTrees(Document& document, TreePipeline& pipeline)
{
    for (const Node& node : std::vector<Node>(document.scene().nodes())) {
        if (node.kind != NodeKind::Tree || document.isCurrent(node.id))
            continue;
        NodeResult result;
        result.revision = document.revision();
        if (auto tree = pipeline.evaluate(node.params, Stage::Simplified))
            result.tree = *tree;
        else
            result.error = tree.error();
        document.setResult(node.id, std::move(result));
    }
}

Node bushNode(const QString& name)
{
    Node node = test::treeNode(1, name.toStdString());
    node.params.grammar.axiom = std::string("AF");
    node.params.grammar.rules = "A -> F[+A][-FF]F";
    node.params.grammar.iterations = 1;
    return node;
}

/// Keeps its own copy of the rows, made of nothing but the model's signals.
class Shadow : public QObject
{
public:
    explicit Shadow(SceneModel* model)
        : m_model(model)
    {
        reset();
        connect(model, &QAbstractItemModel::modelReset, this, &Shadow::reset);
        connect(model, &QAbstractItemModel::layoutChanged, this,
                &Shadow::reset); // other lengths, other names
        connect(model, &QAbstractItemModel::rowsInserted, this,
                [this](const QModelIndex& parent, int from, int to) {
                    for (int row = from; row <= to; ++row)
                        at(parent)->insert(row, read(m_model->index(row, 0, parent)));
                });
        connect(
            model, &QAbstractItemModel::rowsRemoved, this,
            [this](const QModelIndex& parent, int from, int to) { at(parent)->remove(from, to - from + 1); });
        connect(model, &QAbstractItemModel::rowsAboutToBeMoved, this,
                [this](const QModelIndex& from, int row, int, const QModelIndex& to, int target) {
                    m_taken = at(from)->at(row);
                    m_from = path(from);
                    m_to = path(to);
                    m_row = row;
                    m_target = target - (from == to && row < target ? 1 : 0);
                });
        connect(model, &QAbstractItemModel::rowsMoved, this, [this] {
            // The paths were those of before: a row that goes may shift the way to its new parent.
            QList<int> to = m_to;
            if (to.size() > m_from.size() && std::equal(m_from.begin(), m_from.end(), to.begin()) &&
                to[m_from.size()] > m_row)
                --to[m_from.size()];
            follow(m_from)->removeAt(m_row);
            follow(to)->insert(m_target, m_taken);
        });
        connect(model, &QAbstractItemModel::dataChanged, this,
                [this](const QModelIndex& from, const QModelIndex& to) {
                    for (int row = from.row(); row <= to.row(); ++row)
                        (*at(from.parent()))[row].name =
                            from.siblingAtRow(row).siblingAtColumn(0).data().toString();
                });
    }

    [[nodiscard]] QStringList rows() const { return flat(m_rows, 0); }

private:
    struct Row
    {
        QString name;
        QList<Row> children;
    };

    Row read(const QModelIndex& index)
    {
        Row row{index.data().toString(), {}};
        for (int i = 0; i < m_model->rowCount(index); ++i)
            row.children += read(m_model->index(i, 0, index));
        return row;
    }
    void reset()
    {
        m_rows.clear();
        for (int i = 0; i < m_model->rowCount(); ++i)
            m_rows += read(m_model->index(i, 0));
    }
    static QList<int> path(QModelIndex index)
    {
        QList<int> rows;
        for (; index.isValid(); index = index.parent())
            rows.prepend(index.row());
        return rows;
    }
    QList<Row>* follow(const QList<int>& rows)
    {
        QList<Row>* list = &m_rows;
        for (const int row : rows)
            list = &(*list)[row].children;
        return list;
    }
    QList<Row>* at(const QModelIndex& index) { return follow(path(index)); }
    static QStringList flat(const QList<Row>& rows, int depth)
    {
        QStringList texts;
        for (const Row& row : rows) {
            texts += QString(depth, u'.') + row.name;
            texts += flat(row.children, depth + 1);
        }
        return texts;
    }

    SceneModel* m_model;
    QList<Row> m_rows;
    Row m_taken;
    QList<int> m_from, m_to;
    int m_row = 0, m_target = 0;
};

} // namespace

class TestSceneModel : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void aNodeOfAnUnknownKindIsGrey()
    {
        Node odd;
        odd.id = 1;
        odd.kind = NodeKind::Unknown;
        odd.name = "Sky";
        Document document;
        document.reset(*Scene::fromNodes({odd}), {});
        const SceneModel model(&document);
        const QModelIndex row = model.nodeIndex(1);
        QCOMPARE(row.data(Qt::ForegroundRole).value<QColor>(),
                 QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
        QVERIFY(row.data(Qt::ToolTipRole).toString().contains(QStringLiteral("does not know")));
    }
    void emptyScenesHaveNoRows()
    {
        Document document;
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);
        QVERIFY(!model.nodeIndex(7).isValid());
        QVERIFY(!model.branchIndex(7, 0).isValid());
        QCOMPARE(model.nodeAt({}), noNode);
        QVERIFY(model.branchesAt({}).empty());
    }

    void rowsAreNodesInTheirOrder()
    {
        Document document;
        test::openNodes(document,
                        {test::groupNode(1, "A"), test::treeNode(2, "B", 1), test::treeNode(3, "C")});
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(shownRows(model), QStringList({"A", ".B", "C"}));
        QCOMPARE(model.nodeIndex(2).parent(), model.nodeIndex(1));
        QCOMPARE(model.nodeAt(model.nodeIndex(3)), NodeId(3));
        QCOMPARE(model.index(0, SceneModel::VisibleColumn).data(Qt::AccessibleTextRole).toString(),
                 QStringLiteral("Visible"));
    }

    void branchesComeWhenAskedFor()
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, "T"), test::groupNode(2, "G", 1)});
        SceneModel model(&document);
        document.setResult(1, resultWith(10));
        const QModelIndex tree = model.nodeIndex(1);
        QCOMPARE(model.rowCount(tree), 1); // the group
        QVERIFY(model.canFetchMore(tree));
        model.fetchMore(tree);
        QCOMPARE(model.rowCount(tree), 2);
        QVERIFY(!model.canFetchMore(tree));
        // Not before: the tester fetches what it can.
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QModelIndex trunk = model.index(1, 0, tree);
        QCOMPARE(model.branchesAt(trunk).front(), Index(0));
        QCOMPARE(model.nodeAt(trunk), NodeId(1));
        for (Index branch = 0; branch < 10; ++branch) {
            const QModelIndex index = model.branchIndex(1, branch);
            QCOMPARE(model.branchesAt(index).size(), std::size_t(1));
            QCOMPARE(model.branchesAt(index).front(), branch);
            QCOMPARE(model.index(index.row(), 0, index.parent()), index);
        }
        QVERIFY(!model.branchIndex(1, 10).isValid());
        QVERIFY(!model.axisIndex(1, model.branches(1)->axisCount()).isValid());
    }

    /// A trunk of three with two limbs, the lower of two branches with a bough at each: whoever leads on is
    /// no child, and whoever springs from it is one.
    void axesHaveTheirAxesBelow()
    {
        auto simplified = std::make_shared<SimplifiedSkeleton>();
        Skeleton& bones = simplified->skeleton;
        const Index parents[] = {noIndex, 0, 1, 0, 3, 3, 4, 1}, levels[] = {0, 0, 0, 1, 1, 2, 2, 1};
        for (Index i = 0; i < 8; ++i) {
            const glm::dvec3 from = parents[i] == noIndex ? glm::dvec3(0.0) : bones.p1[parents[i]];
            bones.add(parents[i], from, from + glm::dvec3(0.0, 0.6, 0.0), 0.1, 0.09, levels[i]);
            bones.key[i] = i + 1;
        }
        NodeResult result;
        result.tree.simplified = std::move(simplified);
        Document document;
        test::openNodes(document, {test::treeNode(1, "T")});
        document.setResult(1, std::move(result));
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.fetchMore(model.nodeIndex(1));
        QCOMPARE(shownRows(model),
                 QStringList({"T", ".Trunk", "..3 branch(es)", "...Branch 1 of 3", "...Branch 2 of 3",
                              "...Branch 3 of 3", "..Limb 1 of the trunk, 0.60 m up", "...2 branch(es)",
                              "....Branch 1 of 2", "....Branch 2 of 2", "...Bough 1 of limb 1, 0.60 m along",
                              "...Bough 2 of limb 1, 1.2 m along", "..Limb 2 of the trunk, 1.2 m up"}));
        QCOMPARE(wrongCount(model), QString());
        const QModelIndex limb = model.axisIndex(1, model.branches(1)->axisOf(4));
        QCOMPARE(std::vector<Index>(model.branchesAt(limb).begin(), model.branchesAt(limb).end()),
                 (std::vector<Index>{3, 4}));
        QCOMPARE(limb.siblingAtColumn(SceneModel::LengthColumn).data().toString(),
                 QLocale().toString(1.2, 'f', 3));
        QCOMPARE(limb.siblingAtColumn(SceneModel::ChildrenColumn).data().toString(), QStringLiteral("3"));
        QCOMPARE(model.names().branch(*model.branches(1), 4),
                 QStringLiteral("Limb 1 of the trunk, 0.60 m up, branch 2 of 2"));
        QVERIFY(limb.data(Qt::ToolTipRole).toString().endsWith(QStringLiteral("\nTrunk")));
        QVERIFY(model.nodeIndex(1).data(Qt::ToolTipRole).toString().contains(QStringLiteral("8 branch(es)")));
    }

    void anotherTreeReplacesTheBranches()
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, "T")});
        document.setResult(1, resultWith(10));
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.fetchMore(model.nodeIndex(1));
        Shadow shadow(&model);
        QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
        document.setResult(1, resultWith(10, 2.0)); // same branches, other lengths
        QCOMPARE(removed.count(), 0);
        QCOMPARE(model.branchIndex(1, 3, SceneModel::LengthColumn).data().toString(),
                 QLocale().toString(2.0, 'f', 3));
        document.setResult(1, resultWith(25));
        QCOMPARE(removed.count(), 1);
        QCOMPARE(shadow.rows(), shownRows(model));
        QVERIFY(model.branchIndex(1, 24).isValid());
        document.setResult(1, NodeResult());
        QCOMPARE(model.rowCount(model.nodeIndex(1)), 0);
        QCOMPARE(shadow.rows(), shownRows(model));
    }

    void countsAreToldWhenTheyChange()
    {
        // Without a change of rows, too: of a tree that nobody has unfolded.
        for (const bool unfolded : {false, true}) {
            Document document;
            test::openNodes(document, {test::treeNode(1, "T"), test::groupNode(2, "G")});
            SceneModel model(&document);
            if (unfolded)
                model.fetchMore(model.nodeIndex(1));
            const QModelIndex cell = model.nodeIndex(1, SceneModel::ChildrenColumn);
            QCOMPARE(cell.data().toString(), QString());
            QSignalSpy told(&model, &QAbstractItemModel::dataChanged);
            document.setResult(1, resultWith(10));
            QCOMPARE(told.count(), 1);
            QCOMPARE(told.front().front().toModelIndex(), cell);
            QCOMPARE(cell.data().toString(), QStringLiteral("1"));
            document.setResult(1, resultWith(25)); // another tree, with one trunk again
            QCOMPARE(told.count(), 1);
            QVERIFY(edit::moveNode(document, 2, 1, 0, false));
            QCOMPARE(cell.data().toString(), QStringLiteral("2"));
            QVERIFY(told.count() > 1);
            document.setResult(1, NodeResult());
            QCOMPARE(cell.data().toString(), QStringLiteral("1"));
        }
    }

    void hundredThousandBranchesTakeNoTime()
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, "T")});
        document.setResult(1, resultWith(100'000));
        SceneModel model(&document);
        const QModelIndex last = model.branchIndex(1, 99'999);
        QCOMPARE(model.branchesAt(last).back(), Index(99'999));
        QCOMPARE(model.branches(1)->find(100 + 4711), std::optional<Index>(4711));
        QVERIFY(!model.branches(1)->find(5));
    }

    void namesAndStatesAreEditedThroughCommands()
    {
        Document document;
        test::openNodes(document, {test::treeNode(1, "T")});
        SceneModel model(&document);
        QVERIFY(model.setData(model.nodeIndex(1), QStringLiteral(" Oak "), Qt::EditRole));
        QCOMPARE(model.nodeIndex(1).data().toString(), QStringLiteral("Oak"));
        QVERIFY(model.setData(model.nodeIndex(1, SceneModel::VisibleColumn), false, Qt::EditRole));
        QVERIFY(!document.scene().find(1)->visible);
        QVERIFY(model.setData(model.nodeIndex(1, SceneModel::LockedColumn), true, Qt::EditRole));
        QCOMPARE(document.undoStack()->count(), 3);
        QSignalSpy refused(&model, &SceneModel::refused);
        QVERIFY(!model.setData(model.nodeIndex(1), QStringLiteral("Elm"), Qt::EditRole));
        QCOMPARE(refused.count(), 1);
        QVERIFY(!(model.flags(model.nodeIndex(1)) & Qt::ItemIsEditable));
        QVERIFY(!(model.flags(model.nodeIndex(1)) & Qt::ItemIsDragEnabled));
    }

    void draggingMovesNodes()
    {
        Document document;
        test::openNodes(document, {test::groupNode(1, "A"), test::treeNode(2, "B"), test::treeNode(3, "C"),
                                   test::treeNode(4, "D", 1)});
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const auto drop = [&](const QModelIndexList& what, int row, const QModelIndex& where) {
            const std::unique_ptr<QMimeData> data(model.mimeData(what));
            return data && model.dropMimeData(data.get(), Qt::MoveAction, row, 0, where);
        };
        QVERIFY(drop({model.nodeIndex(2), model.nodeIndex(3)}, -1, model.nodeIndex(1)));
        QCOMPARE(shownRows(model), QStringList({"A", ".D", ".B", ".C"}));
        QCOMPARE(document.undoStack()->count(), 1);
        QVERIFY(drop({model.nodeIndex(3)}, 0, model.nodeIndex(1)));
        QCOMPARE(shownRows(model), QStringList({"A", ".C", ".D", ".B"}));
        QVERIFY(drop({model.nodeIndex(3)}, 2, model.nodeIndex(1))); // between D and B
        QCOMPARE(shownRows(model), QStringList({"A", ".D", ".C", ".B"}));
        QVERIFY(!drop({model.nodeIndex(1)}, -1, model.nodeIndex(2))); // below itself
        QVERIFY(!drop({}, -1, model.nodeIndex(2)));
        while (document.undoStack()->canUndo())
            document.undo();
        QCOMPARE(shownRows(model), QStringList({"A", ".D", "B", "C"}));
    }

    void thousandRandomEditsAreFollowed()
    {
        Document document;
        test::openNodes(document, {test::groupNode(1, "root")});
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const Shadow shadow(&model);
        TreePipeline pipeline;
        QSignalSpy replaced(&model, &SceneModel::branchesReplaced);
        std::mt19937 random(7);
        const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
        for (int step = 0; step < 1000; ++step) {
            const auto& nodes = document.scene().nodes();
            const NodeId node = nodes.empty()
                                    ? noNode
                                    : nodes[static_cast<std::size_t>(any(static_cast<int>(nodes.size())))].id;
            const NodeId other =
                nodes.empty() || any(4) == 0
                    ? noNode
                    : nodes[static_cast<std::size_t>(any(static_cast<int>(nodes.size())))].id;
            const QString name = QStringLiteral("n%1").arg(step);
            switch (any(12)) {
            case 9:
                (void)edit::insertNodes(document, {bushNode(name)}, node, any(5));
                break;
            case 10:
                (void)edit::setParam(document, {node}, *findParam("grammar.iterations"),
                                     std::int64_t{any(3)});
                break;
            case 11:
                (void)edit::setParam(document, {node}, *findParam("turtle.alpha"), 0.1 + 0.1 * any(5));
                break;
            case 0:
            case 1:
                (void)edit::insertNodes(document, {test::groupNode(1, name.toStdString())}, node, any(5));
                break;
            case 2:
                if (document.scene().nodes().size() > 30 || any(4) == 0)
                    (void)edit::removeNodes(document, {node});
                break;
            case 3:
            case 4:
                (void)edit::moveNode(document, node, other, any(5), false);
                break;
            case 5:
                (void)edit::setNodeName(document, node, QStringLiteral("r%1").arg(step));
                break;
            case 6:
                (void)edit::duplicateNodes(document, {node});
                break;
            case 7:
                document.undo();
                break;
            default:
                document.redo();
                break;
            }
            // Sometimes edits come before the trees of the last ones are there.
            if (any(5) != 0)
                computeTrees(document, pipeline);
            for (const Node& each : document.scene().nodes())
                (void)model.fetchBranches(each.id);
            const QStringList expected = expectedRows(document);
            QCOMPARE(shownRows(model), expected);
            QCOMPARE(shadow.rows(), expected);
            QCOMPARE(wrongCount(model), QString());
        }
        QVERIFY(document.scene().nodes().size() > 5);
        QVERIFY(replaced.count() > 50);
    }

    void anotherDocumentStartsAnew()
    {
        Document document;
        test::openNodes(document, {test::groupNode(1, "A")});
        SceneModel model(&document);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        test::openNodes(document, {test::treeNode(4, "X"), test::treeNode(9, "Y", 4)});
        QCOMPARE(shownRows(model), QStringList({"X", ".Y"}));
    }
};

RAMURE_SUITE(TestSceneModel)

} // namespace tst_scene_model

#include "tst_scene_model.moc"
