#include "widgets/panels/validation/validation_panel.h"

#include "core/evaluate/evaluator.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/shape_checks.h"
#include "core/scene/object_mesh.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/only_branch.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/validation/analysis_strip.h"
#include "widgets/panels/validation/kind_texts.h"
#include "widgets/panels/validation/report_text.h"
#include "widgets/panels/validation/report_view.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QHideEvent>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int leastPanel = 160;
constexpr quint32 meshNews =
    changeSelection | changeResults | changeReset | changeNodeState | changeStructure;

/// The node whose mesh is looked at: that of the selected branches, the active one, or, while a group or
/// nothing is selected, the one before; else the first tree, else the first of all.
NodeId nodeToShow(const Document& document, NodeId before)
{
    const auto canHave = [](const Node& node) { return node.kind == NodeKind::Tree || isShape(node.kind); };
    const auto hasMesh = [&](NodeId id) {
        const Node* node = document.scene().find(id);
        return node && canHave(*node);
    };
    for (const NodeId id : {document.selection().branchNode, document.selection().activeNode(), before})
        if (hasMesh(id))
            return id;
    NodeId first = noNode;
    for (const Node& node : document.scene().nodes()) {
        if (node.kind == NodeKind::Tree)
            return node.id;
        if (first == noNode && canHave(node))
            first = node.id;
    }
    return first;
}

} // namespace

struct ValidationPanel::Private
{
    Private(ValidationPanel* panel, Document* ofDocument, Analysis* ofMeshes)
        : q(panel)
        , document(ofDocument)
        , analysis(ofMeshes)
        , shapes(ofDocument)
    {
    }

    void build();
    QWidget* buildHead(QWidget* parent);
    QWidget* buildExplanation(QWidget* parent);
    void refresh();
    void showNode();
    void showSummary();
    void explain();
    void activate(const QModelIndex& index);
    void selectBranch(Index branch);
    void highlight(DefectPlace place, const QModelIndex& index);
    void showCollision(const Collision& collision, const QModelIndex& index);
    /// The check of the node, wherever it comes from; null where there is none yet.
    [[nodiscard]] const NodeResult* result() const;
    [[nodiscard]] std::shared_ptr<const MeshAnalysis> findings() const;
    [[nodiscard]] bool isShapeShown() const;
    [[nodiscard]] CheckedShape shape() const;
    void leave();

    ValidationPanel* q;
    Document* document;
    Analysis* analysis;
    ShapeChecks shapes;
    AnalysisStrip* strip = nullptr;
    QStackedWidget* pages = nullptr;
    EmptyPage* empty = nullptr;
    QWidget* content = nullptr; ///< is scrolled
    StatusBadge* badge = nullptr;
    QLabel* name = nullptr;
    QLabel* headline = nullptr;
    QLabel* details = nullptr;
    QToolButton* copy = nullptr;
    ReportModel* model = nullptr;
    ReportView* view = nullptr;
    QLabel* explanation = nullptr;
    NodeId node = noNode;
    std::optional<MeshVerdict> verdict; ///< on the mesh that is shown
    bool highlighted = false;           ///< a defect was handed to the viewport
};

ValidationPanel::ValidationPanel(Document* document, QWidget* parent)
    : ValidationPanel(document, nullptr, parent)
{
}

ValidationPanel::ValidationPanel(Document* document, Analysis* analysis, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(this, document, analysis))
{
    setObjectName(QStringLiteral("validationPanel"));
    d->build();
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(meshNews))
            d->refresh();
    });
    if (analysis)
        connect(analysis, &Analysis::changed, this, [this](NodeId tree) {
            if (tree == d->node)
                d->refresh();
        });
    connect(&d->shapes, &ShapeChecks::changed, this, [this](NodeId shape) {
        if (shape == d->node && shape != noNode)
            d->showNode();
    });
}

ValidationPanel::~ValidationPanel() = default;

void ValidationPanel::Private::build()
{
    auto* outer = layoutOf<QVBoxLayout>(q);
    pages = new QStackedWidget(q);
    outer->addWidget(pages);
    empty = new EmptyPage(pages);
    pages->addWidget(empty);

    auto* scroll = new QScrollArea(pages); // on a low screen
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    content = new QWidget(scroll);
    scroll->setWidget(content);
    auto* layout = layoutOf<QVBoxLayout>(content, 0);
    layout->addWidget(buildHead(content));
    if (analysis) {
        strip = new AnalysisStrip(analysis, content);
        strip->setShapes(&shapes);
        layout->addWidget(strip);
        QObject::connect(strip, &AnalysisStrip::separateRequested, q, &ValidationPanel::separateRequested);
    }
    auto* splitter = new QSplitter(Qt::Vertical, content);
    splitter->setChildrenCollapsible(false);
    model = new ReportModel(q);
    view = new ReportView(model, splitter);
    splitter->addWidget(view);
    splitter->addWidget(buildExplanation(splitter));
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({300, 130});
    layout->addWidget(splitter, 1);
    pages->addWidget(scroll);

    QObject::connect(view, &ReportView::chosen, q, [this](const QModelIndex& index) { activate(index); });
    QObject::connect(view, &ReportView::left, q, [this] { leave(); });
    QObject::connect(view->selectionModel(), &QItemSelectionModel::currentChanged, q, [this] { explain(); });
    QObject::connect(model, &QAbstractItemModel::modelReset, q, [this] {
        leave();
        explain();
    });
    QObject::connect(copy, &QToolButton::clicked, q, &ValidationPanel::copyReport);
    empty->setText(tr("The check of a mesh is shown here. The scene has no mesh."));
    copy->setToolTip(tr("Copy the report as text"));
    copy->setAccessibleName(copy->toolTip());
    view->setAccessibleName(tr("Defects and repairs"));
    q->setAccessibleName(tr("Mesh check"));
}

QWidget* ValidationPanel::Private::buildHead(QWidget* parent)
{
    auto* head = new QWidget(parent);
    auto* row = layoutOf<QHBoxLayout>(head, 10, {12, 8, 8, 8});
    badge = new StatusBadge(head);
    row->addWidget(badge, 0, Qt::AlignTop);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(2);
    headline = named(new QLabel(head), "panelTitle");
    headline->setWordWrap(true);
    name = named(new QLabel(head), "checkedNode");
    name->setTextFormat(Qt::PlainText);
    name->setForegroundRole(QPalette::PlaceholderText);
    details = named(new QLabel(head), "reportDetails");
    details->setTextFormat(Qt::PlainText);
    details->setWordWrap(true);
    details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    texts->addWidget(headline);
    texts->addWidget(name);
    texts->addWidget(details);
    row->addLayout(texts, 1);
    copy = named(new QToolButton(head), "copyReport");
    copy->setIcon(icon("copy"));
    copy->setAutoRaise(true);
    row->addWidget(copy, 0, Qt::AlignTop);
    return head;
}

QWidget* ValidationPanel::Private::buildExplanation(QWidget* parent)
{
    auto* scroll = new QScrollArea(parent);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumHeight(48);
    explanation = named(new QLabel(scroll), "explanation");
    explanation->setTextFormat(Qt::RichText);
    explanation->setWordWrap(true);
    explanation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    explanation->setContentsMargins(12, 4, 12, 8);
    explanation->setTextInteractionFlags(Qt::TextSelectableByMouse);
    scroll->setWidget(explanation);
    return scroll;
}

void ValidationPanel::Private::refresh()
{
    if (!q->isVisible())
        return; // showEvent catches up
    const NodeId shown = nodeToShow(*document, node);
    if (shown != node)
        leave();
    node = shown;
    pages->setCurrentIndex(node == noNode ? 0 : 1);
    shapes.lookAt(isShapeShown() ? node : noNode);
    showNode();
}

void ValidationPanel::Private::showNode()
{
    const NodeResult* checked = result();
    if (checked && !checked->error)
        model->setSource({checked->tree.report, checked->tree.branches, checked->tree, findings()});
    else
        model->setSource({});
    view->setVisible(model->rowCount() > 0);
    view->setColumnHidden(ReportModel::BranchColumn, isShapeShown());
    if (strip)
        strip->setNode(node, isShapeShown());
    showSummary();
}

bool ValidationPanel::Private::isShapeShown() const
{
    const Node* shown = document->scene().find(node);
    return shown && isShape(shown->kind);
}

CheckedShape ValidationPanel::Private::shape() const
{
    if (!isShapeShown())
        return CheckedShape::Tree;
    const Node* shown = document->scene().find(node);
    return isOpenSurface(*shown) ? CheckedShape::Open : CheckedShape::Solid;
}

const NodeResult* ValidationPanel::Private::result() const
{
    if (!isShapeShown())
        return document->result(node);
    const auto outcome = shapes.outcome();
    return outcome ? &outcome->result : nullptr;
}

std::shared_ptr<const MeshAnalysis> ValidationPanel::Private::findings() const
{
    if (isShapeShown()) {
        const auto outcome = shapes.outcome();
        return outcome ? outcome->analysis : nullptr;
    }
    return analysis ? analysis->findings(node) : nullptr;
}

void ValidationPanel::Private::showSummary()
{
    const Node* shown = document->scene().find(node);
    const ReportSummary state = ReportTexts::summary(result(), findings().get(), shape());
    verdict = state.verdict;
    badge->setStatus(state.status);
    badge->setAccessibleName(state.headline);
    headline->setText(state.headline);
    details->setText(state.details);
    name->setText(shown ? QString::fromStdString(shown->name) : QString());
    explain();
}

void ValidationPanel::Private::explain()
{
    const QModelIndex current = view->currentIndex();
    QString text;
    if (current.isValid())
        text = KindTexts::rich(model->textOf(model->kind(current)));
    else if (verdict == MeshVerdict::Crossing)
        text = KindTexts::rich(KindTexts::crossed());
    else if (verdict == MeshVerdict::Clean)
        text = KindTexts::rich(shape() == CheckedShape::Tree    ? KindTexts::clean()
                               : shape() == CheckedShape::Solid ? KindTexts::cleanSolid()
                                                                : KindTexts::cleanSurface());
    else if (model->rowCount() > 0)
        text = KindTexts::rich(
            {tr("What this means"), tr("Choose a kind above to read its meaning and its effect."), {}, {}});
    explanation->setText(text);
}

void ValidationPanel::Private::activate(const QModelIndex& index)
{
    const ReportSource& source = model->source();
    if (const RepairNote* note = model->repair(index)) {
        leave();
        return selectBranch(note->branch);
    }
    if (!source.branches)
        return;
    const TriangleMesh& mesh = source.branches->mesh;
    const glm::dmat4 world = EvaluatedScene(document->scene()).transforms(node).geometry;
    if (const Defect* defect = model->defect(index)) {
        const DefectPlace place = defectPlace(mesh, *defect, world);
        selectBranch(defectBranch(mesh, *defect));
        highlight(place, index);
    } else if (const FacePair* pair = model->crossing(index)) {
        const DefectPlace place = facesPlace(mesh, {pair->first, pair->second}, world);
        selectBranch(faceBranch(mesh, pair->first));
        highlight(place, index);
    } else if (const WorstFace* face = model->thinTriangle(index)) {
        const DefectPlace place = facesPlace(mesh, {face->face, noIndex}, world);
        selectBranch(faceBranch(mesh, face->face));
        highlight(place, index);
    } else if (const Collision* collision = model->collision(index)) {
        showCollision(*collision, index);
    }
}

/// Both branches are selected; the point where they cross is framed with the thicker one around it.
void ValidationPanel::Private::showCollision(const Collision& collision, const QModelIndex& index)
{
    const auto simplified = model->source().tree.simplified;
    if (!simplified || std::max(collision.first, collision.second) >= simplified->skeleton.size())
        return;
    const Skeleton& skeleton = simplified->skeleton;
    const double thick = std::max(skeleton.a0[collision.first], skeleton.a0[collision.second]);
    const DefectPlace place = pointPlace(collision.place, std::max(6.0 * thick, 4.0 * collision.depth),
                                         EvaluatedScene(document->scene()).transforms(node).geometry);
    document->setSelection({{node}, node, {collision.first, collision.second}, collision.first});
    highlight(place, index);
}

/// \param index of its row, which names it.
void ValidationPanel::Private::highlight(DefectPlace place, const QModelIndex& index)
{
    place.label = model->textOf(model->kind(index)).name + u'\n' +
                  index.siblingAtColumn(0).data(Qt::DisplayRole).toString();
    highlighted = true;
    emit q->defectActivated(node, place);
}

void ValidationPanel::Private::selectBranch(Index branch)
{
    if (branch != noIndex)
        document->setSelection(onlyBranch(node, branch));
}

void ValidationPanel::Private::leave()
{
    if (!highlighted)
        return;
    highlighted = false;
    emit q->defectLeft();
}

QSize ValidationPanel::minimumSizeHint() const
{
    // What scrolls only up and down must not be cut at the side.
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {d->content->minimumSizeHint().width() + bar, leastPanel};
}

QSize ValidationPanel::sizeHint() const
{
    return {340, 420};
}

void ValidationPanel::copyReport()
{
    if (d->node == noNode)
        return;
    const Node* shown = d->document->scene().find(d->node);
    const QString name = shown ? QString::fromStdString(shown->name) : QString();
    QGuiApplication::clipboard()->setText(
        ReportTexts::whole(name, d->result(), d->findings().get(), d->shape()));
    emit messageRaised(tr("Report copied as text"));
}

void ValidationPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    d->refresh();
}

/// Nobody looks at the shape any more. A window that is only minimised comes back as it was.
void ValidationPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    d->shapes.lookAt(noNode);
    if (!event->spontaneous())
        d->leave();
}

} // namespace ramure
