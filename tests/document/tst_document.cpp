#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include "tests/document/recorder.h"
#include "tests/support/suite.h"

namespace tst_document {

using namespace ramure;

using Ids = std::vector<NodeId>;
using Branches = std::vector<Index>;

static Node makeTree(NodeId id)
{
    Node node;
    node.id = id;
    node.kind = NodeKind::Tree;
    return node;
}
static Scene twoTrees()
{
    return *Scene::fromNodes({makeTree(1), makeTree(2)});
}
/// A result whose simplified skeleton has branches of these keys.
static NodeResult resultWith(const std::vector<std::uint64_t>& keys, quint64 revision, bool draft = false)
{
    auto simplified = std::make_shared<SimplifiedSkeleton>();
    for (const std::uint64_t key : keys) {
        simplified->skeleton.add(noIndex, {}, {0.0, 1.0, 0.0}, 0.1, 0.1);
        simplified->skeleton.key.back() = key;
    }
    NodeResult result;
    result.tree.simplified = simplified;
    result.revision = revision;
    result.draft = draft;
    return result;
}
static NodeResult grownResult(const char* axiom)
{
    NodeParams params;
    params.grammar.axiom = axiom;
    params.grammar.rules.clear();
    params.grammar.iterations = 0;
    NodeResult result;
    result.tree = *TreePipeline().evaluate(params, Stage::Simplified);
    result.revision = 1;
    return result;
}
static Selection branches(NodeId node, Branches list, Index active = noIndex)
{
    Selection selection;
    selection.branchNode = node;
    selection.branches = std::move(list);
    selection.activeBranch = active;
    return selection;
}

class TestDocument : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void wrongSelectionsAreRepaired();
    void resultsOfUnknownNodesAreIgnored();
    void selectionIsTold();
    void selectedBranchesFollowTheirPlaces();
    void goneNodesLeaveNothing();
    void resultsAreCurrentUntilTheShapeChanges();
    void resetIsOneNews();
    void resetOfAChangedDocument();
    void fileStateIsTold();
    void extrasSurvive();
    void diesQuietlyWithEdits();
};

void TestDocument::wrongSelectionsAreRepaired()
{
    Document document;
    document.reset(twoTrees(), {});
    Selection selection;
    selection.nodes = {2, 9, 1, 2, noNode};
    document.setSelection(selection);
    QCOMPARE(document.selection().nodes, (Ids{2, 1}));
    QCOMPARE(document.selection().activeNode(), 1u);
    document.setSelection(branches(1, {0, 1})); // nothing computed: there are no branches
    QCOMPARE(document.selection().branchNode, noNode);
    document.setResult(1, resultWith({5, 6, 7}, 1));
    document.setSelection(branches(1, {2, 7, 0, 2}, 9));
    QCOMPARE(document.selection().branches, (Branches{0, 2}));
    QCOMPARE(document.selection().activeBranch, 2u);
    document.setSelection(branches(9, {0}));
    QVERIFY(document.selection() == Selection{});
}

void TestDocument::resultsOfUnknownNodesAreIgnored()
{
    Document document;
    document.reset(twoTrees(), {});
    test::Recorder recorder(document);
    document.setResult(9, resultWith({1}, 1));
    QVERIFY(!document.result(9));
    QVERIFY(recorder.changes.empty());
    QVERIFY(!document.isCurrent(9));
    QVERIFY(!document.result(1));
}

void TestDocument::selectionIsTold()
{
    Document document;
    document.reset(twoTrees(), {});
    test::Recorder recorder(document);
    const quint64 revision = document.revision();
    Selection selection;
    selection.nodes = {1};
    document.setSelection(selection);
    const Change news = recorder.take();
    QCOMPARE(news.kinds, quint32{changeSelection});
    QCOMPARE(news.revision, revision); // no edit
    QVERIFY(!document.isModified());
    document.setSelection(selection);
    QVERIFY(recorder.changes.empty());
    QVERIFY(recorder.paired());
}

void TestDocument::selectedBranchesFollowTheirPlaces()
{
    Document document;
    document.reset(twoTrees(), {});
    document.setResult(1, grownResult("F[+F][-F][^F]"));
    document.setSelection(branches(1, {1, 3}, 1));
    test::Recorder recorder(document);
    document.setResult(1, grownResult("[^F]F[+F][-F][^F]")); // one in front: others have their old indices
    QCOMPARE(document.selection().branches, (Branches{2, 4}));
    QCOMPARE(document.selection().activeBranch, 2u);
    QCOMPARE(recorder.take().kinds, quint32{changeResults | changeSelection});
    document.setResult(2, grownResult("F")); // another tree's
    QCOMPARE(document.selection().branches, (Branches{2, 4}));
    document.setResult(1, grownResult("F"));
    QVERIFY(document.selection().branches.empty());
    document.setResult(1, NodeResult{});
    QCOMPARE(document.selection().branchNode, noNode);
    QVERIFY(recorder.paired());
}

void TestDocument::goneNodesLeaveNothing()
{
    Document document;
    document.reset(twoTrees(), {});
    document.setResult(1, resultWith({10}, 1));
    Selection selection = branches(1, {0});
    selection.nodes = {2, 1};
    document.setSelection(selection);
    QVERIFY(edit::removeNodes(document, {1}));
    QVERIFY(!document.result(1));
    QCOMPARE(document.selection().nodes, (Ids{2}));
    QVERIFY(document.selection().branches.empty());
    document.undo();
    QVERIFY(!document.isCurrent(1));
    QCOMPARE(document.shapeRevision(1), document.revision());
}

void TestDocument::resultsAreCurrentUntilTheShapeChanges()
{
    Document document;
    document.reset(twoTrees(), {});
    QVERIFY(!document.isCurrent(1));
    document.setResult(1, resultWith({1}, document.revision(), true));
    QVERIFY(!document.isCurrent(1)); // a draft
    document.setResult(1, resultWith({1}, document.revision()));
    QVERIFY(document.isCurrent(1));
    QVERIFY(edit::setParam(document, {1}, *findParam("tree.translation"), glm::dvec3(1.0)));
    QVERIFY(edit::setNodeName(document, 1, "x"));
    QVERIFY(edit::setParam(document, {2}, *findParam("turtle.alpha"), 0.5));
    QVERIFY(document.isCurrent(1));
    QVERIFY(edit::setParam(document, {1}, *findParam("turtle.alpha"), 0.5));
    QVERIFY(!document.isCurrent(1));
    NodeResult failed;
    failed.error = Error{};
    failed.revision = document.revision();
    document.setResult(1, failed);
    QVERIFY(document.isCurrent(1)); // the answer is known: there is none
    document.undo();
    QVERIFY(!document.isCurrent(1));
}

void TestDocument::resetIsOneNews()
{
    Document document;
    test::Recorder recorder(document);
    document.reset(twoTrees(), "/a.ramure");
    const Change news = recorder.take();
    QVERIFY(news.has(changeReset));
    QCOMPARE(news.nodes, (Ids{1, 2}));
    QCOMPARE(news.firstStale, Stage::Symbols);
    QCOMPARE(document.filePath(), "/a.ramure");
    QCOMPARE(document.shapeRevision(2), news.revision);
    QVERIFY(recorder.paired());
}

void TestDocument::resetOfAChangedDocument()
{
    Document document;
    document.reset(twoTrees(), "/a.ramure");
    document.setResult(1, resultWith({1}, 1));
    Selection selection;
    selection.nodes = {1};
    document.setSelection(selection);
    QVERIFY(edit::setNodeName(document, 1, "x"));
    test::Recorder recorder(document);
    document.reset({}, {});
    QVERIFY(recorder.take().has(changeReset));
    QVERIFY(recorder.paired());
    QVERIFY(!document.isModified());
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!document.result(1));
    QVERIFY(document.selection().nodes.empty());
    QVERIFY(document.filePath().isEmpty());
}

void TestDocument::fileStateIsTold()
{
    Document document;
    document.reset(twoTrees(), {});
    test::Recorder recorder(document);
    QVERIFY(edit::setNodeName(document, 1, "x"));
    QCOMPARE(recorder.changes.back().kinds, quint32{changeFile});
    recorder.changes.clear();
    document.setFilePath("/b.ramure");
    document.setFilePath("/b.ramure");
    QCOMPARE(recorder.take().kinds, quint32{changeFile});
    document.markSaved();
    QCOMPARE(recorder.take().kinds, quint32{changeFile});
    QVERIFY(!document.isModified());
    QVERIFY(recorder.paired());
}

void TestDocument::extrasSurvive()
{
    Document document;
    const QByteArray bytes =
        R"({"camera":[1,2],"format":"ramure","nodes":[{"id":1,"kind":"tree"}],"version":1})";
    auto project = readProject(bytes);
    QVERIFY2(project, test::why(project));
    document.reset(project->scene, {}, project->extras);
    QVERIFY(writeProject(document.project()).contains("camera"));
    document.reset({}, {});
    QVERIFY(!writeProject(document.project()).contains("camera"));
}

void TestDocument::diesQuietlyWithEdits()
{
    auto document = std::make_unique<Document>();
    document->reset(twoTrees(), {});
    QVERIFY(edit::setNodeName(*document, 1, "x"));
    test::Recorder recorder(*document);
    document.reset();
    QVERIFY(recorder.changes.empty());
}

RAMURE_SUITE(TestDocument)

} // namespace tst_document

#include "tst_document.moc"
